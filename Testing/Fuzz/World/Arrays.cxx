// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "World/Arrays.h"

#include <vtkBitArray.h>
#include <vtkDataSet.h>
#include <vtkDataSetAttributes.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkRectilinearGrid.h>
#include <vtkSOADataArrayTemplate.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace Fuzz
{
namespace Arrays
{
namespace
{

const int Types[] = { VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_FLOAT, VTK_DOUBLE, VTK_UNSIGNED_SHORT,
  VTK_CHAR, VTK_SIGNED_CHAR, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
  VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT, VTK_UNSIGNED_CHAR };

bool IsOfWholeNumbers(int type)
{
  return type != VTK_FLOAT && type != VTK_DOUBLE;
}

template <typename Array>
vtkSmartPointer<vtkDataArray> New()
{
  return vtkSmartPointer<Array>::New();
}

/// An empty array of some type; rarely one that cannot be drawn.
vtkSmartPointer<vtkDataArray> NewArray(World& world)
{
  Bytes& from = world.From;
  if (from.OneIn(12))
  {
    switch (from.Pick(5))
    {
      case 0:
        return New<vtkSOADataArrayTemplate<float>>();
      case 1:
        return New<vtkSOADataArrayTemplate<short>>();
      case 2:
        return New<vtkSOADataArrayTemplate<double>>();
      case 3:
        return New<vtkSOADataArrayTemplate<unsigned char>>();
      default:
        return from.IsWild() ? New<vtkBitArray>() : New<vtkSOADataArrayTemplate<long long>>();
    }
  }
  return vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(from.OneOf(Types)));
}

/// What samples look like.
class Formula
{
public:
  Formula(World& world, int type)
    : Engine(static_cast<unsigned>(world.From.Pick(1 << 16)))
    , Kind(world.From.Pick(8))
    , Phase(world.From.Between(0.0, 6.0))
    , Share(world.From.IsWild() ? world.From.Between(0.001, 0.4) : 0.0)
    , From(world.From)
  {
    const bool isOfBytes =
      type == VTK_UNSIGNED_CHAR || type == VTK_CHAR || type == VTK_SIGNED_CHAR || type == VTK_BIT;
    const double scales[] = { 1.0, 0.02, 300.0, 1e-6 };
    this->Scale = isOfBytes ? 1.0 : world.From.OneOf(scales);
    if (IsOfWholeNumbers(type))
    {
      this->Scale = std::max(this->Scale, 0.02);
    }
    else if (world.From.IsWild())
    {
      this->Scale = std::ldexp(1.0, world.From.Pick(2000) - 1000);
    }
    this->Odd = world.From.Wild();
    world.IsTame = world.IsTame && this->Share == 0.0 && std::abs(this->Scale) < 1e4;
  }

  double At(double x, double y, double z)
  {
    if (this->Share > 0.0 && this->Random() < this->Share)
    {
      return this->Random() < 0.5 ? this->Odd : this->From.Wild();
    }
    return this->Scale * this->Plain(x, y, z);
  }

private:
  double Random() { return static_cast<double>(this->Engine()) / 4294967296.0; }

  double Plain(double x, double y, double z)
  {
    const double ball = 100.0 - 90.0 * std::sqrt(x * x + y * y + z * z);
    const double waves =
      50.0 + 25.0 * std::sin(5.0 * x + this->Phase) * std::cos(4.0 * y) + 20.0 * z;
    switch (this->Kind)
    {
      case 0:
      case 1:
        return ball;
      case 2:
        return waves;
      case 3:
        return std::floor(4.0 * this->Random()) * 25.0;
      case 4:
        return 100.0 * this->Random();
      case 5:
        return 20.0 * std::floor(waves / 20.0);
      case 6:
        return 50.0 + 40.0 * x + 9.0 * y;
      default:
        return this->Phase < 1.0 ? 50.0 : this->Random() < 0.1 ? 100.0 : 0.0;
    }
  }

  std::mt19937 Engine;
  int Kind;
  double Phase, Scale = 1.0, Share, Odd = 0.0;
  Bytes& From;
};

/// Within what the array's type can hold: other conversions mean nothing.
double Fitting(vtkDataArray* array, double value)
{
  if (!IsOfWholeNumbers(array->GetDataType()))
  {
    const bool isHuge = std::abs(value) > std::numeric_limits<float>::max();
    const bool isHugeFloat = array->GetDataType() == VTK_FLOAT && isHuge && std::isfinite(value);
    return isHugeFloat ? std::copysign(std::numeric_limits<double>::infinity(), value) : value;
  }
  const double low = array->GetDataTypeMin(), high = array->GetDataTypeMax();
  // The largest numbers of 64 bits are no doubles.
  const double inside = high > 9e15 ? high * (1.0 - 1e-15) : high;
  return std::isnan(value) ? 0.0 : std::floor(std::min(std::max(value, low), inside));
}

void Fill(World& world, vtkDataArray* array, const Places& places, double share)
{
  Formula formula(world, array->GetDataType());
  std::mt19937 chosen(static_cast<unsigned>(world.From.Next()));
  const std::size_t count =
    std::min(places.size(), static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t at = 0; at < count; ++at)
  {
    if (share < 1.0 && static_cast<double>(chosen()) / 4294967296.0 >= share)
    {
      continue;
    }
    const auto [x, y, z] = places[at];
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      const double value = formula.At(x, y, z);
      array->SetComponent(
        static_cast<vtkIdType>(at), c, Fitting(array, c % 2 ? 100.0 - value : value));
    }
  }
}

}

Places PlacesOf(const int dimensions[3])
{
  constexpr std::size_t most = 1000000; // images may claim to have many more
  const auto centred = [&](int i, int axis)
  { return dimensions[axis] > 1 ? 2.0 * i / (dimensions[axis] - 1) - 1.0 : 0.0; };
  Places places;
  for (int k = 0; k < dimensions[2] && places.size() < most; ++k)
  {
    for (int j = 0; j < dimensions[1] && places.size() < most; ++j)
    {
      for (int i = 0; i < dimensions[0] && places.size() < most; ++i)
      {
        places.push_back({ centred(i, 0), centred(j, 1), centred(k, 2) });
      }
    }
  }
  return places;
}

namespace
{

Places PlacesInMesh(vtkDataSet* data, bool onCells)
{
  double box[6], bounds[6];
  data->GetBounds(box);
  const vtkIdType count = onCells ? data->GetNumberOfCells() : data->GetNumberOfPoints();
  Places places;
  for (vtkIdType i = 0; i < count; ++i)
  {
    std::array<double, 3> place{};
    if (onCells)
    {
      data->GetCellBounds(i, bounds);
      place = { 0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]),
        0.5 * (bounds[4] + bounds[5]) };
    }
    else
    {
      data->GetPoint(i, place.data());
    }
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const double low = box[2 * axis], high = box[2 * axis + 1];
      const double s = high > low ? 2.0 * (place[axis] - low) / (high - low) - 1.0 : 0.0;
      place[axis] = std::isfinite(s) ? s : 0.0;
    }
    places.push_back(place);
  }
  return places;
}

}

Places PlacesOf(vtkDataSet* data, bool onCells)
{
  // Lattices may lack coordinates.
  int points[3], cells[3];
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    image->GetDimensions(points);
  }
  else if (auto* grid = vtkRectilinearGrid::SafeDownCast(data))
  {
    grid->GetDimensions(points);
  }
  else
  {
    return PlacesInMesh(data, onCells);
  }
  std::transform(points, points + 3, cells, [](int n) { return n > 1 ? n - 1 : n; });
  return PlacesOf(onCells ? cells : points);
}

vtkSmartPointer<vtkDataArray> Make(World& world, const Places& places)
{
  Bytes& from = world.From;
  const vtkSmartPointer<vtkDataArray> array = NewArray(world);
  const int components[] = { 1, 1, 1, 1, 1, 1, 2, 3, 4, 5, 9 };
  array->SetNumberOfComponents(from.OneOf(components));
  auto count = static_cast<vtkIdType>(places.size());
  if (from.IsWild())
  {
    const vtkIdType lengths[] = { count - 1, count + 1, 0, 1, count / 2, 2 * count };
    count = std::max<vtkIdType>(from.OneOf(lengths), 0);
  }
  const char* names[] = { "Scalars", nullptr, "pressure", "", "vtkGhostType" };
  array->SetName(names[from.IsWild() ? from.Pick(5) : from.Pick(2)]);
  array->SetNumberOfTuples(count);
  if (count > 0)
  {
    array->Fill(0.0);
  }
  Fill(world, array, places, 1.0);
  Story::Tell("  an array '", array->GetName() ? array->GetName() : "(none)", "' of ",
    array->GetClassName(), ", ", count, " tuples of ", array->GetNumberOfComponents(),
    array->GetNumberOfTuples() > 0 ? " from " : "",
    array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0) : 0.0);
  return array;
}

void Rewrite(World& world, vtkDataArray* array, const Places& places, bool all)
{
  const double shares[] = { 0.01, 0.1, 0.001, 0.5 };
  Fill(world, array, places, all ? 1.0 : world.From.OneOf(shares));
}

void AddGhosts(World& world, vtkDataSetAttributes* attributes, vtkIdType count)
{
  Bytes& from = world.From;
  if (count < 0 || count > 1000000)
  {
    return;
  }
  const bool isWrong = from.IsWild();
  vtkSmartPointer<vtkDataArray> array = New<vtkUnsignedCharArray>();
  if (isWrong && from.OneIn(3))
  {
    array = New<vtkFloatArray>();
  }
  array->SetNumberOfComponents(isWrong && from.OneIn(3) ? 2 : 1);
  const vtkIdType wrong[] = { count - 1, 0, count + 1, 1 };
  array->SetNumberOfTuples(isWrong ? std::max<vtkIdType>(from.OneOf(wrong), 0) : count);
  array->SetName(vtkDataSetAttributes::GhostArrayName());
  std::mt19937 engine(static_cast<unsigned>(from.Pick(1 << 16)));
  const double chances[] = { 0.05, 0.3, 0.0, 1.0, 0.9 };
  const double chance = from.OneOf(chances);
  const unsigned bits = from.OneIn(3) ? 255u : from.OneIn(2) ? 3u : 34u;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      const bool isFlagged = static_cast<double>(engine()) / 4294967296.0 < chance;
      const unsigned flags = static_cast<unsigned>(engine()) & bits;
      array->SetComponent(i, c, isFlagged ? flags : 0);
    }
  }
  attributes->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  attributes->AddArray(array);
  Story::Tell("  a ghost array of ", array->GetClassName(), " for ", count, ": ",
    array->GetNumberOfTuples(), " x ", array->GetNumberOfComponents(), ", share ", chance,
    ", bits ", bits);
}

void Survey(World& world, vtkDataArray* array)
{
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
  {
    const double value = array->GetComponent(i, 0);
    if (std::isfinite(value) && std::abs(value) < 1e30)
    {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  world.Low = low <= high ? low : 0.0;
  world.High = low <= high ? high : 100.0;
}

}
}
