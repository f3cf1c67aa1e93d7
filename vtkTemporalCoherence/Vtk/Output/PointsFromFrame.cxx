// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Output/PointsFromFrame.h"

#include "Scene/Parallel.h"
#include "Window/PixelHit.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <numeric>

namespace TemporalCoherence
{
namespace
{

/// Rows per task.
constexpr std::int64_t RowGrain = 16;

/// The number of hits before each row; the last number is the total.
std::vector<vtkIdType> CountHits(const Frame& frame)
{
  std::vector<vtkIdType> before(static_cast<std::size_t>(frame.Size.y) + 1, 0);
  ParallelFor(frame.Size.y, RowGrain,
    [&](std::int64_t row)
    {
      const SurfaceIndex* const first =
        frame.Isovalues.data() + IndexOfPixel(frame, 0, static_cast<int>(row));
      before[static_cast<std::size_t>(row) + 1] =
        frame.Size.x - std::count(first, first + frame.Size.x, Frame::NoSurface);
    });
  std::partial_sum(before.begin(), before.end(), before.begin());
  return before;
}

/// An array with room for `tuples`, as a new attribute of the points.
template <typename Array>
auto* AddArray(vtkPolyData* points, const char* name, int components, vtkIdType tuples)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  points->GetPointData()->AddArray(array);
  return array->GetPointer(0);
}

/// One vertex for each point.
void AddVertices(vtkIdType count, vtkPolyData* points)
{
  vtkNew<vtkTypeInt64Array> offsets, ids;
  offsets->SetNumberOfValues(count + 1);
  ids->SetNumberOfValues(count);
  std::iota(offsets->GetPointer(0), offsets->GetPointer(0) + count + 1, vtkTypeInt64(0));
  std::iota(ids->GetPointer(0), ids->GetPointer(0) + count, vtkTypeInt64(0));
  vtkNew<vtkCellArray> vertices;
  // Versions of VTK differ in which array types they accept.
  vertices->SetData(static_cast<vtkDataArray*>(offsets), static_cast<vtkDataArray*>(ids));
  points->SetVerts(vertices);
}

}

void WritePoints(
  const Frame& frame, const FrameKey& key, const std::vector<int>& places, vtkPolyData* points)
{
  const std::vector<vtkIdType> before = CountHits(frame);
  const vtkIdType count = before.back();
  vtkNew<vtkPolyData> made;
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(count);
  double* const positions = coordinates->GetPointer(0);
  float* const normals = AddArray<vtkFloatArray>(made, "Normals", 3, count);
  double* const isovalues = AddArray<vtkDoubleArray>(made, "Isovalue", 1, count);
  int* const indices = AddArray<vtkIntArray>(made, "IsovalueIndex", 1, count);
  unsigned char* const colors = AddArray<vtkUnsignedCharArray>(made, "Color", 4, count);
  AddVertices(count, made);

  ParallelFor(frame.Size.y, RowGrain,
    [&](std::int64_t row)
    {
      const int y = static_cast<int>(row);
      vtkIdType at = before[static_cast<std::size_t>(row)];
      for (int x = 0; x < frame.Size.x; ++x)
      {
        const std::size_t pixel = IndexOfPixel(frame, x, y);
        if (frame.Isovalues[pixel] == Frame::NoSurface)
        {
          continue;
        }
        const auto surface = static_cast<std::size_t>(frame.Isovalues[pixel]);
        const glm::dvec3 position = PositionOfHit(frame, key.View, x, y);
        for (int axis = 0; axis < 3; ++axis)
        {
          positions[3 * at + axis] = position[axis];
          normals[3 * at + axis] = frame.Normals[pixel][axis];
        }
        isovalues[at] = key.Isosurfaces().Isovalues[surface];
        indices[at] = places[surface];
        std::copy(frame.Colors[pixel].begin(), frame.Colors[pixel].end(), colors + 4 * at);
        ++at;
      }
    });

  vtkNew<vtkPoints> all;
  all->SetData(coordinates);
  made->SetPoints(all);
  made->GetPointData()->SetActiveNormals("Normals");
  made->GetPointData()->SetActiveScalars("Color");
  points->ShallowCopy(made);
}

}
