// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Tracing/MeshBandRays.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace TemporalCoherence
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr auto Rising = static_cast<std::size_t>(ValueDirection::Rising);
constexpr auto Falling = static_cast<std::size_t>(ValueDirection::Falling);

/// Rounding errors between two ways to compute a value, relative to the largest value.
constexpr double Rounding = 256.0 * std::numeric_limits<double>::epsilon();

}

MeshBandRays::MeshBandRays(const BandScene& scene, const RayBatch& rays)
  : Scene(scene)
  , Rays(rays)
  , Scale(scene.Samples.Type, scene.Band, scene.FiniteRange)
  , IsSolid(scene.Mode == SurfaceMode::Threshold)
  , Knots(rays, scene.Form, this->Scale)
  , Entries(static_cast<std::size_t>(rays.Count), -std::numeric_limits<float>::infinity())
{
  for (Progress& progress : this->OfRay)
  {
    progress.Reached = { -Infinity, this->IsSolid ? Infinity : -Infinity };
  }
  // Rays enter a solid only upwards, so a solid's rays end as soon as they are above the band.
  this->Below.fill(this->IsSolid ? -Infinity : Infinity);
  this->Above.fill(Infinity);
  this->Ends = rays.WalkEnd;
}

double MeshBandRays::ErrorOf(const MeshPassage& passage) const
{
  const double largest = std::max(std::abs(passage.Low), std::abs(passage.High));
  return Rounding * (largest + this->Scale.Span);
}

void MeshBandRays::Append(const MeshPassage& passage)
{
  const double error = this->ErrorOf(passage);
  const bool isOutside = passage.High + error < 0.0 || passage.Low - error > this->Scale.Span;
  if (passage.IsSimple && isOutside && !this->IsSolid)
  {
    return;
  }
  this->Ahead.push_back(passage);
  if (passage.IsSimple)
  {
    this->Narrow(passage, error);
  }
}

/// A ray ends as soon as it has reached both sides of the band. (If it left the mesh in between,
/// the last passage tells whether it jumps. So passages beside the band end no ray.)
void MeshBandRays::Narrow(const MeshPassage& passage, double error)
{
  const std::size_t ray = passage.Ray;
  const auto take = [&](double value, double at)
  {
    if (value < -error)
    {
      this->Below[ray] = std::min(this->Below[ray], at);
    }
    else if (value - error > this->Scale.Span)
    {
      this->Above[ray] = std::min(this->Above[ray], at);
    }
  };
  if (!passage.BeginsHere)
  {
    take(passage.AtIn, std::max(passage.In, this->Rays.Begin[ray]));
  }
  take(passage.AtOut, passage.Out);
  this->Ends[ray] = std::min(this->Ends[ray], std::max(this->Below[ray], this->Above[ray]));
}

/// Sort passages by their rays, and along each ray. They come nearly in order, so insertion is
/// fast.
void MeshBandRays::Sort()
{
  std::array<std::uint32_t, RayBatch::Capacity + 1> next{};
  for (const MeshPassage& passage : this->Ahead)
  {
    ++next[passage.Ray + std::size_t(1)];
  }
  std::partial_sum(next.begin(), next.end(), next.begin());
  const std::array<std::uint32_t, RayBatch::Capacity + 1> begins = next;
  this->Order.resize(this->Ahead.size());
  const auto isBefore = [this](const Entry& a, const Entry& b)
  { return a.In != b.In ? a.In < b.In : this->Ahead[a.At].Place < this->Ahead[b.At].Place; };
  for (std::uint32_t i = 0; i < this->Ahead.size(); ++i)
  {
    const MeshPassage& passage = this->Ahead[i];
    const Entry entry{ passage.In, i };
    std::uint32_t at = next[passage.Ray]++;
    for (; at > begins[passage.Ray] && isBefore(entry, this->Order[at - 1]); --at)
    {
      this->Order[at] = this->Order[at - 1];
    }
    this->Order[at] = entry;
  }
}

bool MeshBandRays::GoOnTo(const RayBatch::Array<double>& distances)
{
  this->Sort();
  this->Kept.clear();
  for (const Entry& entry : this->Order)
  {
    const MeshPassage& passage = this->Ahead[entry.At];
    const bool isDone = (this->Done >> passage.Ray & 1u) != 0;
    if (this->Overlaps(passage))
    {
      this->GiveUp(passage.Ray);
    }
    else if (!isDone && passage.In < distances[passage.Ray])
    {
      this->TakeNote(passage);
    }
    else if (!isDone)
    {
      this->Kept.push_back(passage);
    }
  }
  this->Ahead.swap(this->Kept);
  return this->Knots.MemoryInBytes() <= this->Scene.MemoryLimit;
}

void MeshBandRays::GiveUp(std::size_t ray)
{
  this->Knots.GiveUp(ray);
  this->Done |= std::uint64_t(1) << ray;
  this->Ends[ray] = -Infinity;
}

/// Note the value where a ray enters its first cell. (Solids are capped there, whatever the value.)
void MeshBandRays::Enter(const MeshPassage& passage, double error)
{
  Progress& progress = this->OfRay[passage.Ray];
  progress.HasEntered = true;
  if (this->IsSolid)
  {
    return;
  }
  if (passage.AtIn + error >= 0.0)
  {
    this->Entries[passage.Ray] = this->Scale.Stored(passage.AtIn);
    this->HasEntries = true;
  }
  if (passage.AtIn - error > this->Scale.Span)
  {
    progress.Reached[Rising] = Infinity;
  }
  if (passage.AtIn + error < 0.0)
  {
    progress.Reached[Falling] = Infinity;
  }
}

/// True if a ray enters a cell before it left the previous cells, or at the entry of the last cell.
bool MeshBandRays::Overlaps(const MeshPassage& passage) const
{
  // Distances of a face differ by rounding errors from cell to cell.
  constexpr double slack = 1e-9;
  const Progress& progress = this->OfRay[passage.Ray];
  return passage.In < progress.Left - slack * std::abs(progress.Left) ||
    passage.In <= progress.Came + slack * std::abs(progress.Came);
}

/// True if a ray left the mesh, and enters it again at a value that skips isovalues of the band:
/// values changed sides without a crossing.
bool MeshBandRays::Jumps(const MeshPassage& passage, double error) const
{
  const Progress& progress = this->OfRay[passage.Ray];
  if (!progress.HasEntered || this->IsSolid || passage.BeginsHere)
  {
    return false;
  }
  const double highest = progress.Reached[Rising];
  const double lowest = this->Scale.Span - progress.Reached[Falling];
  return std::min(passage.AtIn, this->Scale.Span) - std::max(highest, 0.0) > error ||
    std::min(lowest, this->Scale.Span) - std::max(passage.AtIn, 0.0) > error;
}

void MeshBandRays::TakeNote(const MeshPassage& passage)
{
  Progress& progress = this->OfRay[passage.Ray];
  progress.Came = passage.In;
  progress.Left = std::max(progress.Left, passage.Out);
  const double error = this->ErrorOf(passage);
  if (!passage.IsSimple || (passage.BeginsHere && !this->IsSolid) || this->Jumps(passage, error))
  {
    this->GiveUp(passage.Ray);
    return;
  }
  if (!progress.HasEntered)
  {
    this->Enter(passage, error);
  }
  const std::array<double, NumberOfDirections> most = { passage.High,
    this->Scale.Span - passage.Low };
  // A ray that begins in the cell does not pass the value at its entry.
  const double atIn = passage.BeginsHere ? passage.AtOut : passage.AtIn;
  const std::array<double, NumberOfDirections> passed = { std::max(atIn, passage.AtOut),
    this->Scale.Span - std::min(atIn, passage.AtOut) };
  for (std::size_t direction = 0; direction < NumberOfDirections; ++direction)
  {
    double& reached = progress.Reached[direction];
    if (reached == Infinity || !(most[direction] > reached))
    {
      continue;
    }
    // If the ray has reached the last key, earlier cells hold all isovalues up to this key.
    // Otherwise they only might hold them, so this cell needs a knot, too.
    BandScale::Key& last = progress.Noted[direction];
    const BandScale::Key key = std::max(last, this->Scale.KeyOf(most[direction] + error));
    if (key > last || this->Scale.KeyOf(reached + error) < key)
    {
      last = key;
      this->Knots.AddCell(direction, passage.Ray, key, passage.Place, passage.In);
    }
    const bool isDone = passed[direction] - error > this->Scale.Span;
    reached = isDone ? Infinity : std::max(reached, passed[direction]);
  }
  const bool isDone = progress.Reached[Rising] == Infinity && progress.Reached[Falling] == Infinity;
  this->Done |= static_cast<std::uint64_t>(isDone) << passage.Ray;
}

void MeshBandRays::HandOver(TileKnots& knots)
{
  const BandScene& scene = this->Scene;
  this->Knots.HandOver({ scene.Samples, scene.Normals, scene.FiniteRange, scene.Transform }, knots);
  if (this->HasEntries)
  {
    knots.Entries = std::move(this->Entries);
  }
}

}
