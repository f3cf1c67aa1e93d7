// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "World/Inputs.h"

#include "World/Arrays.h"

#include <vtkCellData.h>
#include <vtkNew.h>
#include <vtkOverlappingAMR.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStructuredPoints.h>
#include <vtkTable.h>
#include <vtkTrivialProducer.h>
#include <vtkUniformGrid.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVersionMacros.h>

#include <algorithm>
#include <climits>
#include <cmath>
#include <random>

namespace Fuzz
{
namespace Inputs
{
namespace
{

// Since VTK 9.6 images lay out coordinates along each axis: a negative number of points ends the
// program, and a long axis takes memory.
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
constexpr int MostMissing = 1;
constexpr int LongestAxis = 1 << 21;
#else
constexpr int MostMissing = 2;
constexpr int LongestAxis = INT_MAX - 1;
#endif

struct Extent
{
  int Of[6];
};

/// Mostly a few samples along each axis.
Extent MakeExtent(World& world)
{
  Bytes& from = world.From;
  Extent extent;
  for (int axis = 0; axis < 3; ++axis)
  {
    const int first = from.OneIn(6) ? from.Pick(25) - 12 : 0;
    extent.Of[2 * axis] = first;
    extent.Of[2 * axis + 1] = first + 3 + from.Pick(8);
  }
  if (from.OneIn(10))
  {
    const int thin = from.Pick(3);
    extent.Of[2 * thin + 1] =
      extent.Of[2 * thin] + std::max(from.Pick(3) - (from.OneIn(8) ? 2 : 0), -MostMissing);
  }
  if (from.OneIn(25))
  {
    const int lengths[] = { 40, 70, 17, 129, 300 };
    const int axis = from.Pick(3);
    extent.Of[2 * axis + 1] = extent.Of[2 * axis] + from.OneOf(lengths);
    extent.Of[(2 * axis + 3) % 6] = extent.Of[(2 * axis + 2) % 6] + 2;
  }
  if (from.IsWild() && from.OneIn(3))
  {
    // Where numbers of samples or extents end; as long as few samples are asked for.
    const int axis = from.Pick(3);
    const int length = extent.Of[2 * axis + 1] - extent.Of[2 * axis];
    const int firsts[] = { INT_MAX - length, INT_MIN, INT_MIN + 1, 1 << 30, -(1 << 30) };
    extent.Of[2 * axis] = from.OneOf(firsts);
    extent.Of[2 * axis + 1] = extent.Of[2 * axis] + length;
  }
  return extent;
}

void PlaceImage(World& world, vtkImageData* image)
{
  Bytes& from = world.From;
  double spacing[3] = { 1.0, 1.0, 1.0 }, origin[3] = { 0.0, 0.0, 0.0 };
  for (int axis = 0; axis < 3; ++axis)
  {
    if (from.OneIn(4))
    {
      spacing[axis] = from.Number(0.3, 2.5);
    }
    spacing[axis] *= from.OneIn(30) ? -1.0 : 1.0;
    origin[axis] = from.OneIn(4) ? from.Number(-9.0, 9.0) : 0.0;
  }
  if (from.OneIn(30))
  {
    const double scales[] = { 1e-3, 1e3, 1e-9, 1e9, 1e-30, 1e30 };
    const double scale = from.OneOf(scales);
    for (int axis = 0; axis < 3; ++axis)
    {
      spacing[axis] *= scale;
    }
    world.IsTame = false;
  }
  image->SetSpacing(spacing);
  image->SetOrigin(origin);
  Story::Tell("  spacing ", spacing[0], ", ", spacing[1], ", ", spacing[2], ", origin ", origin[0],
    ", ", origin[1], ", ", origin[2]);
  if (from.OneIn(10))
  {
    double m[9] = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };
    switch (from.Pick(5))
    {
      case 0:
        m[0] = -1.0;
        break;
      case 1:
        m[0] = m[4] = 0.6, m[1] = -0.8, m[3] = 0.8;
        break;
      case 2:
        m[0] = m[4] = m[8] = 0.0, m[1] = m[5] = m[6] = 1.0;
        break;
      case 3:
        m[1] = from.Number(-2.0, 2.0);
        break;
      default:
        for (double& value : m)
        {
          value = from.Number(-1.0, 1.0);
        }
        break;
    }
    image->SetDirectionMatrix(m);
    Story::Tell("  direction ", m[0], ' ', m[1], ' ', m[2], ", ", m[3], ' ', m[4], ' ', m[5], ", ",
      m[6], ' ', m[7], ' ', m[8]);
  }
}

}

vtkSmartPointer<vtkImageData> MakeImage(World& world)
{
  Bytes& from = world.From;
  vtkSmartPointer<vtkImageData> image = vtkSmartPointer<vtkImageData>::New();
  if (from.OneIn(12))
  {
    image = vtkSmartPointer<vtkUniformGrid>::New();
  }
  else if (from.OneIn(30))
  {
    image = vtkSmartPointer<vtkStructuredPoints>::New();
  }
  Extent extent = MakeExtent(world);
  image->SetExtent(extent.Of);
  int points[3], cells[3];
  image->GetDimensions(points);
  Story::Tell("  a ", image->GetClassName(), " of ", points[0], " x ", points[1], " x ", points[2],
    " from ", extent.Of[0], ", ", extent.Of[2], ", ", extent.Of[4]);
  PlaceImage(world, image);
  for (int axis = 0; axis < 3; ++axis)
  {
    points[axis] = std::max(points[axis], 0);
    cells[axis] = points[axis] > 1 ? points[axis] - 1 : points[axis];
  }
  const bool onCells = from.OneIn(6);
  const auto array = Arrays::Make(world, Arrays::PlacesOf(onCells ? cells : points));
  Arrays::Survey(world, array);
  (onCells ? static_cast<vtkDataSetAttributes*>(image->GetCellData()) : image->GetPointData())
    ->SetScalars(array);
  if (from.OneIn(12))
  {
    const auto other = Arrays::Make(world, Arrays::PlacesOf(points));
    image->GetPointData()->AddArray(other);
  }
  if (from.IsWild() && from.OneIn(4))
  {
    // Few samples for many points.
    const int huge[] = { 1 << 10, 1 << 16, 1 << 21, LongestAxis, 100000 };
    for (int axis = 0; axis < 3; ++axis)
    {
      extent.Of[2 * axis] = 0;
      extent.Of[2 * axis + 1] = from.OneOf(huge);
    }
    image->SetExtent(extent.Of);
    Story::Tell(
      "  which claims to reach to ", extent.Of[1], ", ", extent.Of[3], ", ", extent.Of[5]);
  }
  else
  {
    if (from.OneIn(15))
    {
      Arrays::AddGhosts(world, image->GetPointData(), image->GetNumberOfPoints());
    }
    if (from.OneIn(15))
    {
      Arrays::AddGhosts(world, image->GetCellData(), image->GetNumberOfCells());
    }
  }
  return image;
}

vtkSmartPointer<vtkDataObject> MakeLabels(World& world)
{
  Bytes& from = world.From;
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(5 + from.Pick(16), 5 + from.Pick(16), 5 + from.Pick(16));
  PlaceImage(world, image);
  const int types[] = { VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT, VTK_ID_TYPE };
  const auto labels =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(from.OneOf(types)));
  labels->SetName("Scalars");
  const double waves = from.Between(1.0, 9.0), noise = from.OneIn(3) ? 3.0 : 0.0;
  std::mt19937 engine(static_cast<unsigned>(from.Next()));
  for (const auto& [x, y, z] : Arrays::PlacesOf(image, false))
  {
    const double random = static_cast<double>(engine()) / 4294967296.0;
    const double value = 3.0 + 3.0 * std::sin(waves * x) * std::cos(waves * y + z) + noise * random;
    labels->InsertNextTuple1(std::clamp(std::floor(value), 0.0, 7.0));
  }
  image->GetPointData()->SetScalars(labels);
  const auto other = Arrays::Make(world, Arrays::PlacesOf(image, false));
  other->SetName("other");
  image->GetPointData()->AddArray(other);
  world.Low = 0.0;
  world.High = 7.0;
  return image;
}

vtkSmartPointer<vtkDataObject> MakeAny(World& world)
{
  Bytes& from = world.From;
  world.IsTame = world.IsTame && from.Wildness == 0;
  const int kind = from.Pick(20);
  if (kind < 13)
  {
    return MakeImage(world);
  }
  if (kind < 16)
  {
    return MakeGrid(world);
  }
  if (kind < 19)
  {
    return MakeBlocks(world);
  }
  if (!from.IsWild())
  {
    return MakeImage(world);
  }
  switch (from.Pick(7))
  {
    case 0:
      return vtkSmartPointer<vtkPolyData>::New();
    case 1:
      return vtkSmartPointer<vtkUnstructuredGrid>::New();
    case 2:
      return vtkSmartPointer<vtkTable>::New();
    case 3:
      return vtkSmartPointer<vtkOverlappingAMR>::New();
    case 4:
      return vtkSmartPointer<vtkImageData>::New();
    default:
      return nullptr;
  }
}

void Show(World& world, vtkDataObject* data)
{
  Bytes& from = world.From;
  Story::Tell("  is the input: ", data ? data->GetClassName() : "(null)");
  if (data && from.OneIn(4))
  {
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(data);
    world.Subject->SetInputConnection(producer->GetOutputPort());
  }
  else if (!data && from.OneIn(2))
  {
    world.Subject->RemoveAllInputs();
  }
  else
  {
    world.Subject->SetInputDataObject(data);
  }
  if (data && from.OneIn(3))
  {
    world.Shelf.emplace_back(data);
    if (world.Shelf.size() > 4)
    {
      world.Shelf.erase(world.Shelf.begin());
    }
  }
}

}
}
