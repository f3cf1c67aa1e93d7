// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTemporalCoherencePicker.h"

#include "vtkTemporalCoherenceGPUVolumeRayCastMapper.h"
#include "vtkTemporalCoherenceVolumeMapper.h"
#include "vtkTemporalCoherenceVolumeMapperInternals.h"

#include "vtkCell.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLODProp3D.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredData.h"
#include "vtkStructuredGrid.h"
#include "vtkTransform.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkTemporalCoherencePicker);

namespace
{

/// The mapper of isosurfaces: `mapper` itself or its inner mapper; null if VTK's mapper draws.
vtkTemporalCoherenceVolumeMapper* SurfacesOf(vtkAbstractVolumeMapper* mapper)
{
  if (auto* holder = vtkTemporalCoherenceGPUVolumeRayCastMapper::SafeDownCast(mapper))
  {
    return holder->GetDrewIsosurfaces() ? holder->GetIsosurfaceMapper() : nullptr;
  }
  return vtkTemporalCoherenceVolumeMapper::SafeDownCast(mapper);
}

vtkVolumeProperty* PropertyOf(vtkProp3D* prop)
{
  vtkVolumeProperty* property = nullptr;
  if (auto* volume = vtkVolume::SafeDownCast(prop))
  {
    property = volume->GetProperty();
  }
  else if (auto* levels = vtkLODProp3D::SafeDownCast(prop))
  {
    levels->GetLODProperty(levels->GetPickLODID(), &property);
  }
  return property;
}

/// True if the superclass can read the drawn array in memory, without checks of its own: the active
/// point scalars of an image, complete and in standard layout.
bool CanBePickedByVtk(vtkTemporalCoherenceVolumeMapper* mapper)
{
  auto* image = vtkImageData::SafeDownCast(mapper->GetDataSetInput());
  vtkDataArray* const active = image ? image->GetPointData()->GetScalars() : nullptr;
  int isOfCells = 0;
  return active && active->HasStandardMemoryLayout() &&
    active->GetNumberOfTuples() == image->GetNumberOfPoints() &&
    active ==
    vtkAbstractMapper::GetScalars(image, mapper->GetScalarMode(), mapper->GetArrayAccessMode(),
      mapper->GetArrayId(), mapper->GetArrayName(), isOfCells);
}

/// A point of a line: 0 and 1 are its ends.
void PointAt(const double p1[3], const double p2[3], double share, double point[3])
{
  for (int i = 0; i < 3; ++i)
  {
    point[i] = p1[i] + share * (p2[i] - p1[i]);
  }
}

/// A world normal in the coordinates of a mapper: normals transform by the transposed inverse.
void NormalIn(vtkMatrix4x4* worldFromMapper, const glm::dvec3& normal, double made[3])
{
  for (int i = 0; i < 3; ++i)
  {
    made[i] = worldFromMapper->GetElement(0, i) * normal[0] +
      worldFromMapper->GetElement(1, i) * normal[1] + worldFromMapper->GetElement(2, i) * normal[2];
  }
  vtkMath::Normalize(made);
}

/// The cell along an axis that holds a coordinate, and the position in it. A coordinate that
/// rounding put outside counts as on the border.
int FindCell(vtkDataArray* axis, double x, double& share)
{
  const vtkIdType last = axis->GetNumberOfTuples() - 2;
  const bool rises = axis->GetComponent(0, 0) <= axis->GetComponent(last + 1, 0);
  vtkIdType cell = 0;
  while (cell < last && (axis->GetComponent(cell + 1, 0) <= x) == rises)
  {
    ++cell;
  }
  const double first = axis->GetComponent(cell, 0), next = axis->GetComponent(cell + 1, 0);
  share = first == next ? 0.0 : std::min(std::max((x - first) / (next - first), 0.0), 1.0);
  return static_cast<int>(cell);
}

}

//------------------------------------------------------------------------------
void vtkTemporalCoherencePicker::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IsovalueIndex: " << this->IsovalueIndex << endl;
}

//------------------------------------------------------------------------------
void vtkTemporalCoherencePicker::ResetPickInfo()
{
  this->Superclass::ResetPickInfo();
  this->IsovalueIndex = -1;
}

//------------------------------------------------------------------------------
double vtkTemporalCoherencePicker::IntersectVolumeWithLine(const double p1[3], const double p2[3],
  double t1, double t2, vtkProp3D* prop, vtkAbstractVolumeMapper* mapper)
{
  vtkTemporalCoherenceVolumeMapper* const surfaces = SurfacesOf(mapper);
  const bool picksCropping = surfaces && this->PickCroppingPlanes && surfaces->GetCropping();
  vtkVolumeProperty* property = surfaces ? PropertyOf(prop) : nullptr;
  if (!property || picksCropping)
  {
    return this->Superclass::IntersectVolumeWithLine(p1, p2, t1, t2, prop, mapper);
  }
  if (!(t1 < t2))
  {
    return VTK_DOUBLE_MAX;
  }

  // The prop may be a part of an assembly, or a level of detail: trace a volume with the transform
  // that the picker was given for the prop.
  vtkNew<vtkVolume> volume;
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(this->Transform->GetMatrix());
  volume->SetUserMatrix(matrix);
  volume->SetProperty(property);
  double begin[3], end[3];
  PointAt(p1, p2, t1, begin);
  PointAt(p1, p2, t2, end);
  this->Transform->TransformPoint(begin, begin);
  this->Transform->TransformPoint(end, end);
  if (surfaces->GetBlendMode() != vtkVolumeMapper::ISOSURFACE_BLEND)
  {
    const bool isFinite = std::isfinite(vtkMath::Distance2BetweenPoints(begin, end));
    return isFinite && CanBePickedByVtk(surfaces) && surfaces->Internal->CanDraw(volume)
      ? this->Superclass::IntersectVolumeWithLine(p1, p2, t1, t2, prop, mapper)
      : VTK_DOUBLE_MAX;
  }
  const auto found = surfaces->Internal->FindOnLine(volume, begin, end);
  if (!found)
  {
    return VTK_DOUBLE_MAX;
  }
  const double length = std::sqrt(vtkMath::Distance2BetweenPoints(begin, end));
  const double t = t1 + found->Hit.Distance / length * (t2 - t1);
  if (!(t < this->GlobalTMin))
  {
    return t; // something else is nearer
  }

  this->ResetPickInfo();
  this->Mapper = mapper;
  this->IsovalueIndex = found->IsovaluePlace;
  PointAt(p1, p2, t, this->MapperPosition);
  NormalIn(matrix, found->Hit.Normal, this->MapperNormal);
  const TemporalCoherence::CellOrigin& cell = found->Cell;
  if (cell.Data)
  {
    this->CompositeDataSet = vtkCompositeDataSet::SafeDownCast(surfaces->GetDataObjectInput());
    this->FlatBlockIndex = this->CompositeDataSet ? cell.Block : -1;
  }
  this->SetPickedData(cell.Data ? cell.Data : surfaces->GetDataSetInput(), cell.Cell);
  this->CroppingPlaneId = this->FindCroppingPlane(surfaces, p1, p2, t1, t2, t);
  return t;
}

//------------------------------------------------------------------------------
/// Set the picked data, and its picked cell and point.
/// \param cellId of a mesh; otherwise -1
void vtkTemporalCoherencePicker::SetPickedData(vtkDataSet* data, vtkIdType cellId)
{
  this->DataSet = data;
  if (data && cellId >= 0)
  {
    this->SetCellPickInfo(data, cellId);
  }
  else if (data)
  {
    this->SetDataPickInfo(data);
  }
}

//------------------------------------------------------------------------------
/// Find the cell and the point of the data at the mapper's position.
void vtkTemporalCoherencePicker::SetDataPickInfo(vtkDataSet* data)
{
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    double index[3];
    image->TransformPhysicalPointToContinuousIndex(this->MapperPosition, index);
    this->SetImageDataPickInfo(index, image->GetExtent());
    return;
  }
  auto* grid = vtkRectilinearGrid::SafeDownCast(data);
  if (!grid || grid->GetNumberOfCells() == 0 || grid->GetDataDimension() != 3)
  {
    return;
  }
  vtkDataArray* axes[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
    grid->GetZCoordinates() };
  int extent[6];
  grid->GetExtent(extent);
  for (int i = 0; i < 3; ++i)
  {
    this->CellIJK[i] = extent[2 * i] + FindCell(axes[i], this->MapperPosition[i], this->PCoords[i]);
    this->PointIJK[i] = this->CellIJK[i] + (this->PCoords[i] >= 0.5);
  }
  this->PointId = vtkStructuredData::ComputePointIdForExtent(extent, this->PointIJK);
  this->CellId = vtkStructuredData::ComputeCellIdForExtent(extent, this->CellIJK);
  this->SubId = 0;
}

//------------------------------------------------------------------------------
/// Set the picked cell of a mesh, and its point nearest to the mapper's position.
void vtkTemporalCoherencePicker::SetCellPickInfo(vtkDataSet* data, vtkIdType cellId)
{
  const double* at = this->MapperPosition;
  this->CellId = cellId;
  this->PointId =
    TemporalCoherence::NearestPointOf({ data, 0, cellId }, glm::dvec3(at[0], at[1], at[2]));
  vtkCell* const cell = data->GetCell(cellId);
  std::vector<double> weights(static_cast<std::size_t>(cell->GetNumberOfPoints()));
  double nearest[3], distance;
  cell->EvaluatePosition(at, nearest, this->SubId, this->PCoords, distance, weights.data());
  if (auto* grid = vtkStructuredGrid::SafeDownCast(data))
  {
    const int* extent = grid->GetExtent();
    vtkStructuredData::ComputeCellStructuredCoordsForExtent(cellId, extent, this->CellIJK);
    vtkStructuredData::ComputePointStructuredCoordsForExtent(this->PointId, extent, this->PointIJK);
  }
}

//------------------------------------------------------------------------------
/// The last cropping plane that the line passes before the hit; or -1.
int vtkTemporalCoherencePicker::FindCroppingPlane(vtkTemporalCoherenceVolumeMapper* mapper,
  const double p1[3], const double p2[3], double t1, double t2, double tHit)
{
  auto* image = vtkImageData::SafeDownCast(mapper->GetDataSetInput());
  if (!image || !mapper->GetCropping())
  {
    return -1;
  }
  // As in vtkVolumePicker, the box and the cropping planes lie along the axes of the mapper's
  // coordinates. With a direction matrix they do not.
  if (!image->GetDirectionMatrix()->IsIdentity())
  {
    return -1;
  }
  double begin[3], end[3], bounds[6];
  image->TransformPhysicalPointToContinuousIndex(p1, begin);
  image->TransformPhysicalPointToContinuousIndex(p2, end);
  const double* planes = mapper->GetCroppingRegionPlanes();
  const double* origin = image->GetOrigin();
  const double* spacing = image->GetSpacing();
  const int* extent = image->GetExtent();
  for (int i = 0; i < 3; ++i)
  {
    const double a = (planes[2 * i] - origin[i]) / spacing[i];
    const double b = (planes[2 * i + 1] - origin[i]) / spacing[i];
    bounds[2 * i] = std::max(std::min(a, b), static_cast<double>(extent[2 * i]));
    bounds[2 * i + 1] = std::min(std::max(a, b), static_cast<double>(extent[2 * i + 1]));
    if (bounds[2 * i] > bounds[2 * i + 1])
    {
      return -1;
    }
  }

  constexpr int MostSegments = 16; // as in the superclass
  int extentPlane, segments = 0, planeIds[MostSegments];
  double from[MostSegments], to[MostSegments], entry[MostSegments];
  vtkVolumePicker::ClipLineWithCroppingRegion(bounds, extent, mapper->GetCroppingRegionFlags(),
    begin, end, t1, t2, extentPlane, segments, from, to, entry, planeIds);
  for (int i = 0; i < segments; ++i)
  {
    constexpr double tolerance = 1e-9; // the hit may lie on the plane itself
    if (from[i] - tolerance <= tHit && tHit <= to[i] + tolerance)
    {
      return entry[i] > t1 ? planeIds[i] : -1;
    }
  }
  return -1;
}
VTK_ABI_NAMESPACE_END
