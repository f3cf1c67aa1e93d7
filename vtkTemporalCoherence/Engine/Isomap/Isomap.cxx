// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/Isomap.h"

#include "Isomap/TileGroups.h"
#include "Lattice/RegionClipper.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace TemporalCoherence
{
namespace
{

/// The band of a group that holds an isovalue, or null.
template <typename Bands>
auto FindIn(Bands& bands, double isovalue) -> decltype(bands.data())
{
  const auto found = std::find_if(bands.begin(), bands.end(),
    [isovalue](const GroupBand& band) { return band.Values.Holds(isovalue); });
  return found != bands.end() ? &*found : nullptr;
}

}

bool Isomap::CanHold(const Field& field)
{
  constexpr int largest = std::numeric_limits<CellIndex::value_type>::max();
  return field.HasCells() && field.Shape->Abilities().Isomaps &&
    glm::all(glm::lessThanEqual(field.Dimensions, glm::ivec3(largest)));
}

double Isomap::SmallestTolerance(const Field& field, const IndexTransform& transform)
{
  const glm::dmat3 edges(transform.WorldFromIndex);
  const glm::dvec3 cells(field.Dimensions - 1);
  double longest = 0.0;
  for (const glm::dvec3 side : { glm::dvec3(1.0, 1.0, 1.0), glm::dvec3(-1.0, 1.0, 1.0),
         glm::dvec3(1.0, -1.0, 1.0), glm::dvec3(1.0, 1.0, -1.0) })
  {
    longest = std::max(longest, glm::length(edges * (side * cells)));
  }
  const double steps = std::numeric_limits<decltype(Knot::Distance)>::max();
  const double finest = longest * KnotGrid::StepsOfTolerance / steps;
  return std::max(FinestTolerance, finest / field.Shape->VoxelSizeIn(transform).Shortest);
}

KnotForm Isomap::FormFor(const FrameKey& key, const Options& options)
{
  // Tracing layers behind a translucent surface begins at its distance, which must be exact.
  if (key.Isosurfaces().IsTranslucent())
  {
    return {};
  }
  // With nearest interpolation there are no curves to fit. Behind hidden cells, distances may jump,
  // and in meshes anywhere.
  const bool isFitted = key.Samples.Between == Interpolation::Linear && !key.Samples.Hidden &&
    !key.Samples.Shape->Abilities().IsMesh && options.Tolerance > 0.0 &&
    options.Tolerance >= SmallestTolerance(key.Samples, key.Transform);
  if (!isFitted)
  {
    return { 0.0, options.HasNormals };
  }
  const double voxel = key.Samples.Shape->VoxelSizeIn(key.Transform).Shortest;
  return { options.Tolerance * voxel, options.HasNormals, KnotGrid::LargestFor(options.Tolerance) };
}

bool Isomap::IsOf(const FrameKey& key, const Options& options) const
{
  return this->IsBegun && this->KnotsAre == FormFor(key, options) &&
    this->Key.Samples == key.Samples && this->Key.Transform == key.Transform &&
    this->Key.Region == key.Region && this->Key.View == key.View &&
    this->Key.Isosurfaces().Mode == key.Isosurfaces().Mode;
}

std::size_t Isomap::FixedMemory(const FrameKey& key)
{
  return NumberOfGroups(key.View.Size) * sizeof(std::vector<GroupBand>);
}

void Isomap::Begin(const FrameKey& key, const Options& options)
{
  this->Release();
  this->Key = key;
  this->KnotsAre = FormFor(key, options);
  this->Groups.resize(NumberOfGroups(key.View.Size));
  this->IsBegun = true;
  this->Count();
}

void Isomap::MoveTo(const Field& now, const Field& before)
{
  if (this->Key.Samples == before)
  {
    this->Key.Samples = now;
  }
}

std::size_t Isomap::Pieces() const
{
  return this->Key.Region.IsConvex() ? 1 : RegionClipper::MostPieces;
}

const GroupBand* Isomap::Find(std::size_t group, double isovalue) const
{
  return FindIn(this->Groups[group], isovalue);
}

bool Isomap::Covers(std::size_t group, const std::vector<double>& isovalues) const
{
  return std::all_of(isovalues.begin(), isovalues.end(),
    [&](double isovalue) { return this->Find(group, isovalue) != nullptr; });
}

bool Isomap::Covers(const std::vector<double>& isovalues) const
{
  for (std::size_t group = 0; group < this->Groups.size(); ++group)
  {
    if (!this->Covers(group, isovalues))
    {
      return false;
    }
  }
  return this->IsBegun;
}

bool Isomap::Holds(const ValueBand& values) const
{
  return this->IsBegun &&
    std::all_of(this->Groups.begin(), this->Groups.end(),
      [&](const std::vector<GroupBand>& group)
      {
        return std::any_of(group.begin(), group.end(),
          [&](const GroupBand& band) { return IsWithin(values, band.Values); });
      });
}

void Isomap::ForgetAsked()
{
  for (std::vector<GroupBand>& group : this->Groups)
  {
    for (GroupBand& band : group)
    {
      band.IsAsked = false;
    }
  }
}

void Isomap::MarkAsked(const ValueBand& values)
{
  for (std::vector<GroupBand>& group : this->Groups)
  {
    for (GroupBand& band : group)
    {
      band.IsAsked |= IsWithin(values, band.Values);
    }
  }
}

void Isomap::Add(std::size_t group, GroupBand&& band)
{
  this->Groups[group].push_back(std::move(band));
}

void Isomap::AddToAll(std::vector<GroupBand>&& bands)
{
  for (std::vector<GroupBand>& group : this->Groups)
  {
    group.reserve(group.size() + 1);
  }
  for (std::size_t group = 0; group < this->Groups.size(); ++group)
  {
    this->Groups[group].push_back(std::move(bands[group]));
  }
  this->Count();
}

void Isomap::MarkUsed(const std::vector<double>& isovalues, std::uint64_t frame)
{
  for (std::vector<GroupBand>& group : this->Groups)
  {
    for (const double isovalue : isovalues)
    {
      GroupBand* const used = FindIn(group, isovalue);
      if (used)
      {
        used->LastUse = frame;
      }
    }
  }
}

std::size_t Isomap::MemoryOf(const Which& which) const
{
  std::size_t bytes = 0;
  for (const std::vector<GroupBand>& group : this->Groups)
  {
    for (const GroupBand& band : group)
    {
      bytes += which(band) ? band.Memory : 0;
    }
  }
  return bytes;
}

bool Isomap::Trim(std::size_t limit, const Which& which)
{
  std::size_t taken = this->MemoryOf(which);
  if (taken <= limit)
  {
    return false;
  }
  std::vector<GroupBand*> oldest;
  for (std::vector<GroupBand>& group : this->Groups)
  {
    for (GroupBand& band : group)
    {
      if (which(band))
      {
        oldest.push_back(&band);
      }
    }
  }
  std::stable_sort(oldest.begin(), oldest.end(),
    [](const GroupBand* a, const GroupBand* b) { return a->LastUse < b->LastUse; });
  for (GroupBand* const band : oldest)
  {
    if (taken <= limit)
    {
      break;
    }
    taken -= band->Memory;
    band->Values = { 1.0, 0.0 }; // holds nothing: it goes
  }
  this->Drop([](const GroupBand& band) { return band.Values.Low > band.Values.High; });
  return true;
}

void Isomap::Drop(const Which& which)
{
  for (std::vector<GroupBand>& group : this->Groups)
  {
    group.erase(std::remove_if(group.begin(), group.end(), which), group.end());
  }
  this->Count();
}

const TileBounds* Isomap::FindBounds(std::size_t isovalue, const ValueBand& band) const
{
  const bool isKept = isovalue < this->Bounds.size();
  return isKept && IsWithin(band, this->Bounds[isovalue].Values) ? &this->Bounds[isovalue].Tiles
                                                                 : nullptr;
}

void Isomap::ResizeBounds(std::size_t isovalues)
{
  if (isovalues != this->Bounds.size())
  {
    this->Bounds.resize(isovalues);
    this->Count();
  }
}

void Isomap::KeepBounds(std::size_t isovalue, BandBounds&& bounds)
{
  this->Bounds[isovalue] = std::move(bounds);
  this->Count();
}

void Isomap::DropBounds()
{
  std::vector<BandBounds>().swap(this->Bounds);
  this->Count();
}

std::size_t Isomap::MemoryOfBounds() const
{
  std::size_t bytes = 0;
  for (const BandBounds& bounds : this->Bounds)
  {
    bytes += bounds.Tiles.MemoryInBytes();
  }
  return bytes;
}

void Isomap::Count()
{
  this->Memory = (this->IsBegun ? FixedMemory(this->Key) : 0) + this->MemoryOfBounds();
  this->Knots = this->Bands = 0;
  for (const std::vector<GroupBand>& group : this->Groups)
  {
    for (const GroupBand& band : group)
    {
      this->Memory += band.Memory;
      this->Knots += band.NumberOfKnots;
      ++this->Bands;
    }
  }
}

}
