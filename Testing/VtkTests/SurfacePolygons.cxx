// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfacePolygons.h"

#include <vtkAppendPolyData.h>
#include <vtkCellData.h>
#include <vtkClipPolyData.h>
#include <vtkColorTransferFunction.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkContourFilter.h>
#include <vtkContourValues.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkImageReslice.h>
#include <vtkMatrix4x4.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRectilinearGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVolumeMapper.h>
#include <vtkVolumeProperty.h>

#include <array>
#include <map>
#include <tuple>

namespace
{

/// The component that is drawn: of independent ones that of the largest weight, else the first.
int ComponentOf(vtkVolumeProperty* property, int count)
{
  int component = 0;
  for (int i = 1; property->GetIndependentComponents() && i < count; ++i)
  {
    component =
      property->GetComponentWeight(i) > property->GetComponentWeight(component) ? i : component;
  }
  return component;
}

/// An image without arrays whose points are the centres of an image's cells.
vtkSmartPointer<vtkDataSet> CentersOf(vtkImageData* image)
{
  const auto centers = vtkSmartPointer<vtkImageData>::New();
  const int* extent = image->GetExtent();
  double origin[3];
  image->TransformContinuousIndexToPhysicalPoint(
    extent[0] + 0.5, extent[2] + 0.5, extent[4] + 0.5, origin);
  centers->SetExtent(
    0, extent[1] - extent[0] - 1, 0, extent[3] - extent[2] - 1, 0, extent[5] - extent[4] - 1);
  centers->SetOrigin(origin);
  centers->SetSpacing(image->GetSpacing());
  centers->SetDirectionMatrix(image->GetDirectionMatrix());
  return centers;
}

/// The trilinear interpolant of an image at more points, as far as memory is no concern: triangles
/// between the samples themselves lie beside the surface by more than a pixel where a voxel is
/// large.
vtkSmartPointer<vtkImageData> Refined(vtkImageData* image)
{
  constexpr vtkIdType mostPoints = 40000000;
  int factor = 4;
  while (factor > 1 && image->GetNumberOfPoints() * factor * factor * factor > mostPoints)
  {
    --factor;
  }
  if (factor == 1)
  {
    return image;
  }
  std::array<int, 6> extent;
  image->GetExtent(extent.data());
  vtkNew<vtkImageData> indices; // reslicing knows nothing of directions
  indices->SetExtent(extent.data());
  indices->GetPointData()->SetScalars(image->GetPointData()->GetScalars());
  for (int& bound : extent)
  {
    bound *= factor;
  }
  vtkNew<vtkImageReslice> refine;
  refine->SetInputData(indices);
  refine->SetOutputOrigin(0.0, 0.0, 0.0);
  refine->SetOutputSpacing(1.0 / factor, 1.0 / factor, 1.0 / factor);
  refine->SetOutputExtent(extent.data());
  refine->SetInterpolationModeToLinear();
  refine->Update();
  const vtkSmartPointer<vtkImageData> refined = refine->GetOutput();
  const double* spacing = image->GetSpacing();
  refined->SetOrigin(image->GetOrigin());
  refined->SetSpacing(spacing[0] / factor, spacing[1] / factor, spacing[2] / factor);
  refined->SetDirectionMatrix(image->GetDirectionMatrix());
  return refined;
}

vtkSmartPointer<vtkPolyData> ContoursOf(vtkDataSet* field, double isovalue)
{
  if (auto* image = vtkImageData::SafeDownCast(field))
  {
    vtkNew<vtkFlyingEdges3D> contours;
    contours->SetInputData(Refined(image));
    contours->SetValue(0, isovalue);
    contours->ComputeScalarsOff();
    contours->Update();
    return contours->GetOutput();
  }
  vtkNew<vtkContourFilter> contours;
  contours->SetInputData(field);
  contours->SetValue(0, isovalue);
  contours->ComputeScalarsOff();
  contours->Update();
  return contours->GetOutput();
}

/// Whether an array of ghosts hides a cell, or one of its points.
bool IsHidden(vtkDataSet* part, vtkIdType cell)
{
  const char* const name = vtkDataSetAttributes::GhostArrayName();
  if (auto* ghosts = vtkUnsignedCharArray::SafeDownCast(part->GetCellData()->GetArray(name)))
  {
    if (ghosts->GetValue(cell) != 0)
    {
      return true;
    }
  }
  if (auto* ghosts = vtkUnsignedCharArray::SafeDownCast(part->GetPointData()->GetArray(name)))
  {
    vtkNew<vtkIdList> points;
    part->GetCellPoints(cell, points);
    for (vtkIdType i = 0; i < points->GetNumberOfIds(); ++i)
    {
      if (ghosts->GetValue(points->GetId(i)) & vtkDataSetAttributes::HIDDENPOINT)
      {
        return true;
      }
    }
  }
  return false;
}

/// Take away the triangles in hidden cells.
void RemoveHidden(vtkPolyData* polygons, vtkDataSet* part)
{
  const char* const name = vtkDataSetAttributes::GhostArrayName();
  if (!part->GetCellData()->GetArray(name) && !part->GetPointData()->GetArray(name))
  {
    return;
  }
  polygons->BuildLinks();
  for (vtkIdType triangle = 0; triangle < polygons->GetNumberOfCells(); ++triangle)
  {
    double bounds[6], parameters[3], weights[8];
    polygons->GetCellBounds(triangle, bounds);
    double center[3] = { (bounds[0] + bounds[1]) / 2, (bounds[2] + bounds[3]) / 2,
      (bounds[4] + bounds[5]) / 2 };
    int subId = 0;
    const vtkIdType cell =
      part->FindCell(center, nullptr, nullptr, -1, 0.0, subId, parameters, weights);
    if (cell < 0 || IsHidden(part, cell)) // vtkUniformGrid does not find hidden cells
    {
      polygons->DeleteCell(triangle);
    }
  }
  polygons->RemoveDeletedCells();
}

/// The contours of a field of a part, kept from one frame to the next.
vtkSmartPointer<vtkPolyData> VisibleContoursOf(
  vtkDataSet* part, vtkDataSet* field, int component, double isovalue)
{
  static std::map<std::tuple<vtkDataSet*, vtkMTimeType, int, double>, vtkSmartPointer<vtkPolyData>>
    kept;
  vtkSmartPointer<vtkPolyData>& polygons = kept[{ part, part->GetMTime(), component, isovalue }];
  if (!polygons)
  {
    polygons = ContoursOf(field, isovalue);
    RemoveHidden(polygons, part);
  }
  return polygons;
}

/// What lies on the side of a plane across an axis.
vtkSmartPointer<vtkPolyData> SideOf(
  vtkSmartPointer<vtkPolyData> polygons, int axis, double position, bool isAbove)
{
  vtkNew<vtkPlane> plane;
  double origin[3] = {}, normal[3] = {};
  origin[axis] = position;
  normal[axis] = isAbove ? 1.0 : -1.0;
  plane->SetOrigin(origin);
  plane->SetNormal(normal);
  vtkNew<vtkClipPolyData> clip;
  clip->SetInputData(polygons);
  clip->SetClipFunction(plane);
  clip->Update();
  return clip->GetOutput();
}

/// What the mapper's regions leave.
vtkSmartPointer<vtkPolyData> Cropped(
  const vtkSmartPointer<vtkPolyData>& polygons, vtkVolumeMapper* mapper)
{
  if (!mapper->GetCropping())
  {
    return polygons;
  }
  const double* planes = mapper->GetCroppingRegionPlanes();
  vtkNew<vtkAppendPolyData> kept;
  kept->AddInputData(vtkNew<vtkPolyData>());
  for (int region = 0; region < 27; ++region)
  {
    if (!(mapper->GetCroppingRegionFlags() & (1 << region)))
    {
      continue;
    }
    const std::array<int, 3> at = { region % 3, region / 3 % 3, region / 9 };
    vtkSmartPointer<vtkPolyData> piece = polygons;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int part = at[static_cast<std::size_t>(axis)];
      piece = part > 0 ? SideOf(piece, axis, planes[2 * axis + part - 1], true) : piece;
      piece = part < 2 ? SideOf(piece, axis, planes[2 * axis + part], false) : piece;
    }
    kept->AddInputData(piece);
  }
  kept->Update();
  return kept->GetOutput();
}

vtkSmartPointer<vtkActor> MakeActor(
  vtkVolume* volume, vtkPolyData* polygons, int component, double isovalue)
{
  auto* volumeMapper = vtkVolumeMapper::SafeDownCast(volume->GetMapper());
  vtkVolumeProperty* from = volume->GetProperty();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(polygons);
  mapper->ScalarVisibilityOff();
  mapper->SetClippingPlanes(volumeMapper->GetClippingPlanes());
  const auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  volume->ComputeMatrix();
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(volume->GetMatrix());
  actor->SetUserMatrix(matrix);
  vtkProperty* property = actor->GetProperty();
  if (from->GetColorChannels(component) == 3)
  {
    property->SetColor(from->GetRGBTransferFunction(component)->GetColor(isovalue));
  }
  else
  {
    const double gray = from->GetGrayTransferFunction(component)->GetValue(isovalue);
    property->SetColor(gray, gray, gray);
  }
  property->SetSpecularColor(1.0, 1.0, 1.0);
  property->SetOpacity(from->GetScalarOpacity(component)->GetValue(isovalue));
  property->SetLighting(from->GetShade(component) != 0);
  property->SetInterpolationToPhong();
  property->SetAmbient(from->GetShade(component) ? from->GetAmbient(component) : 0.0);
  property->SetDiffuse(from->GetShade(component) ? from->GetDiffuse(component) : 1.0);
  property->SetSpecular(from->GetSpecular(component));
  property->SetSpecularPower(from->GetSpecularPower(component));
  return actor;
}

}

std::vector<vtkDataSet*> PartsOf(vtkVolume* volume)
{
  vtkAbstractVolumeMapper* mapper = volume->GetMapper();
  if (mapper->GetNumberOfInputConnections(0) == 0)
  {
    return {};
  }
  mapper->GetInputAlgorithm(0, 0)->Update();
  vtkDataObject* input = mapper->GetInputDataObject(0, 0);
  std::vector<vtkDataSet*> parts;
  if (auto* blocks = vtkCompositeDataSet::SafeDownCast(input))
  {
    const auto at = vtkSmartPointer<vtkCompositeDataIterator>::Take(blocks->NewIterator());
    for (at->InitTraversal(); !at->IsDoneWithTraversal(); at->GoToNextItem())
    {
      input = at->GetCurrentDataObject();
      if (auto* part = vtkDataSet::SafeDownCast(input))
      {
        parts.push_back(part);
      }
    }
  }
  else if (auto* part = vtkDataSet::SafeDownCast(input))
  {
    parts.push_back(part);
  }
  return parts;
}

ScalarField FieldOf(vtkVolume* volume, vtkDataSet* part)
{
  vtkAbstractVolumeMapper* mapper = volume->GetMapper();
  int isOfCells = 0;
  vtkDataArray* scalars = vtkAbstractMapper::GetScalars(part, mapper->GetScalarMode(),
    mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), isOfCells);
  auto* image = vtkImageData::SafeDownCast(part);
  if (!scalars || (isOfCells && !image) || !(image || vtkRectilinearGrid::SafeDownCast(part)))
  {
    return {};
  }
  const int component = ComponentOf(volume->GetProperty(), scalars->GetNumberOfComponents());
  vtkNew<vtkDoubleArray> values;
  values->SetName("values");
  values->SetNumberOfTuples(scalars->GetNumberOfTuples());
  values->CopyComponent(0, scalars, component);
  vtkSmartPointer<vtkDataSet> field;
  if (isOfCells)
  {
    field = CentersOf(image);
  }
  else
  {
    field.TakeReference(part->NewInstance());
    field->CopyStructure(part);
  }
  field->GetPointData()->SetScalars(values);
  return { field, component };
}

std::vector<vtkSmartPointer<vtkActor>> MakePolygons(vtkVolume* volume)
{
  std::vector<vtkSmartPointer<vtkActor>> actors;
  vtkVolumeProperty* property = volume->GetProperty();
  vtkContourValues* isovalues = property->GetIsoSurfaceValues();
  for (vtkDataSet* part : PartsOf(volume))
  {
    const auto [field, component] = FieldOf(volume, part);
    for (int i = 0; field && i < isovalues->GetNumberOfContours(); ++i)
    {
      const double isovalue = isovalues->GetValue(i);
      if (property->GetScalarOpacity(component)->GetValue(isovalue) > 0.0)
      {
        const vtkSmartPointer<vtkPolyData> polygons =
          Cropped(VisibleContoursOf(part, field, component, isovalue),
            vtkVolumeMapper::SafeDownCast(volume->GetMapper()));
        actors.push_back(MakeActor(volume, polygons, component, isovalue));
      }
    }
  }
  return actors;
}
