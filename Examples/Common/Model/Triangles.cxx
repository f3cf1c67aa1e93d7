// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Model/Triangles.h"

#include "Files/Arrays.h"
#include "Files/OneScalar.h"
#include "Files/Reading.h"
#include "Program/Quoted.h"
#include "Program/Silence.h"
#include "Program/UserError.h"

#include <vtkAppendPolyData.h>
#include <vtkClipPolyData.h>
#include <vtkContourFilter.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPLYWriter.h>
#include <vtkPlane.h>
#include <vtkSTLWriter.h>
#include <vtkTransform.h>
#include <vtkTransformPolyDataFilter.h>
#include <vtkXMLPolyDataWriter.h>

namespace
{

vtkSmartPointer<vtkPolyData> ClippedBy(vtkPolyData* triangles, vtkPlane* plane)
{
  vtkNew<vtkClipPolyData> clip;
  clip->SetInputData(triangles);
  clip->SetClipFunction(plane);
  clip->Update();
  return clip->GetOutput();
}

// In the data's own space.
vtkSmartPointer<vtkPolyData> CroppedTo(vtkSmartPointer<vtkPolyData> triangles, const double* box)
{
  for (int side = 0; side < 6; ++side)
  {
    Point origin = {}, normal = {};
    const auto axis = static_cast<std::size_t>(side / 2);
    origin[axis] = box[side];
    normal[axis] = side % 2 == 0 ? 1.0 : -1.0;
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(origin.data());
    plane->SetNormal(normal.data());
    triangles = ClippedBy(triangles, plane);
  }
  return triangles;
}

template <typename Writer>
bool Write(vtkPolyData* triangles, const std::string& path)
{
  const Silence silence;
  vtkNew<Writer> writer;
  writer->SetInputData(triangles);
  writer->SetFileName(path.c_str());
  return writer->Write() == 1 && !silence.HeardErrors();
}

}

vtkSmartPointer<vtkPolyData> TrianglesOf(const Volume& volume, int component, const Look& look)
{
  if (volume.Bricks)
  {
    throw UserError("Triangles of " + Quoted(volume.Name) +
      " are not exported, as the volume is read as it is needed; export those of a smaller copy.");
  }
  const Silence silence; // filters tell of each flat cell
  vtkNew<vtkAppendPolyData> all;
  for (vtkDataSet* set : DataSetsOf(volume.Data))
  {
    vtkNew<vtkContourFilter> contour;
    int count = 0;
    for (const Marker& surface : look.Surfaces)
    {
      if (surface.IsVisible)
      {
        contour->SetValue(count++, surface.Value);
      }
    }
    const auto scalars = WithOneScalar(set, volume.Array, component);
    if (scalars && count > 0)
    {
      contour->SetInputData(scalars);
      contour->Update();
      all->AddInputData(contour->GetOutput());
    }
  }
  vtkSmartPointer<vtkPolyData> triangles = vtkSmartPointer<vtkPolyData>::New();
  if (all->GetNumberOfInputConnections(0) > 0)
  {
    all->Update();
    triangles = all->GetOutput();
  }
  if (look.Values[Row::Cropping] != 0.0)
  {
    triangles = CroppedTo(triangles, &look.Values[Row::Crop]);
  }
  if (volume.Placement)
  {
    vtkNew<vtkTransform> transform;
    transform->SetMatrix(volume.Placement);
    vtkNew<vtkTransformPolyDataFilter> place;
    place->SetInputData(triangles);
    place->SetTransform(transform);
    place->Update();
    triangles = place->GetOutput();
  }
  if (look.Values[Row::Clipping] != 0.0)
  {
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(look.Clip.Origin.data());
    plane->SetNormal(look.Clip.Normal.data());
    triangles = ClippedBy(triangles, plane);
  }
  if (triangles->GetNumberOfCells() == 0)
  {
    throw UserError("There are no triangles, as no surface is seen; choose another isovalue.");
  }
  return triangles;
}

void WriteTriangles(vtkPolyData* triangles, const std::string& path)
{
  const std::string name = LowerCase(path);
  bool isWritten = false;
  if (EndsWith(name, ".stl"))
  {
    isWritten = Write<vtkSTLWriter>(triangles, path);
  }
  else if (EndsWith(name, ".ply"))
  {
    isWritten = Write<vtkPLYWriter>(triangles, path);
  }
  else if (EndsWith(name, ".vtp"))
  {
    isWritten = Write<vtkXMLPolyDataWriter>(triangles, path);
  }
  else
  {
    throw UserError(
      Quoted(path) + " is no file of triangles; name one that ends with .stl, .ply or .vtp.");
  }
  if (!isWritten)
  {
    throw UserError(Quoted(path) + " could not be written; make room, or name another file.");
  }
}
