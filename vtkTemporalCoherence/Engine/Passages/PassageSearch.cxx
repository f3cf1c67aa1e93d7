// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Passages/PassageSearch.h"

#include <algorithm>
#include <limits>

namespace TemporalCoherence
{

PassageSearch::PassageSearch(
  const SurfaceTracer& tracer, const RayBatch& rays, std::size_t most, LayerBatch& layers)
  : Tracer(tracer)
  , Rays(rays)
  , Layers(layers)
{
  this->Streams.reserve(most);
}

void PassageSearch::Add(std::size_t surface, const TileKnots& knots, BandScale::Key key)
{
  this->MayBeCapped |= knots.MayBeCapped;
  const PassageTable& table = knots.Passages;
  if (table.IsEmpty())
  {
    return;
  }
  Stream& stream = this->Streams.emplace_back();
  stream.Low = table.Get<0>();
  stream.High = table.Get<1>();
  stream.Cells = table.Get<2>();
  stream.Wanted = key;
  stream.Truncated = knots.Unresolved;
  stream.Found.Surface = surface;
  for (std::size_t ray = 0; ray < static_cast<std::size_t>(this->Rays.Count); ++ray)
  {
    stream.Next[ray] = static_cast<std::uint32_t>(table.Begin(ray));
    stream.End[ray] = static_cast<std::uint32_t>(table.Begin(ray + 1));
  }
}

std::uint64_t PassageSearch::Search()
{
  if (this->MayBeCapped)
  {
    this->Tracer.AppendCaps(this->Rays, this->Layers);
  }
  this->Order.reserve(this->Streams.size() * RayBatch::Capacity);
  std::uint64_t ahead = this->Layers.Open;
  while (ahead != 0)
  {
    ForEachRay(ahead,
      [&](std::size_t ray)
      {
        const bool goesOn =
          this->Streams.size() == 1 ? this->TakeNext(ray) : this->TakeNextOfMany(ray);
        ahead &= ~(static_cast<std::uint64_t>(!goesOn) << ray);
      });
    ahead &= this->Layers.Open & ~this->Unclear;
  }
  this->Flush();
  return (this->Ended | this->Unclear) & this->Layers.Open;
}

/// Take the next passage of a ray, if there is only one isovalue. \return false if there is none
bool PassageSearch::TakeNext(std::size_t ray)
{
  Stream& stream = this->Streams.front();
  if (!stream.Find(ray))
  {
    this->Ended |= stream.Truncated & std::uint64_t(1) << ray;
    return false;
  }
  this->Take(0, ray, false);
  return true;
}

/// The same of several isovalues: the next cell, and all of them that it holds.
bool PassageSearch::TakeNextOfMany(std::size_t ray)
{
  const CellIndex* next = nullptr;
  int nearest = std::numeric_limits<int>::max();
  for (Stream& stream : this->Streams)
  {
    if (stream.Find(ray))
    {
      const int place = this->PlaceAlong(ray, stream.CellOf(ray));
      next = place < nearest ? &stream.CellOf(ray) : next;
      nearest = std::min(nearest, place);
    }
    else if (stream.Truncated >> ray & 1u)
    {
      this->Ended |= std::uint64_t(1) << ray; // others may lie behind what is not stored
      return false;
    }
  }
  if (!next)
  {
    return false;
  }
  const CellIndex cell = *next;
  bool isFirst = true;
  for (std::size_t i = 0; i < this->Streams.size(); ++i)
  {
    Stream& stream = this->Streams[i];
    if (stream.Next[ray] < stream.End[ray] && stream.CellOf(ray) == cell)
    {
      this->Take(i, ray, !isFirst);
      isFirst = false;
    }
  }
  return true;
}

/// How far along a ray a cell lies, among those that the ray passes: in cells from the first one.
int PassageSearch::PlaceAlong(std::size_t ray, const CellIndex& cell) const
{
  int place = 0;
  for (std::size_t a = 0; a < 3; ++a)
  {
    place += this->Rays.Direction[a][ray] < 0.0 ? -cell[a] : cell[a];
  }
  return place;
}

/// Note the present passage of a ray, and go on behind it.
void PassageSearch::Take(std::size_t stream, std::size_t ray, bool isSameCell)
{
  // What is noted of one cell is decided together.
  if (!isSameCell && this->IsFull())
  {
    this->Flush();
  }
  Stream& from = this->Streams[stream];
  this->Order.push_back({ static_cast<std::uint16_t>(stream),
    static_cast<std::uint8_t>(from.Found.Count), isSameCell });
  from.Found.Append(ray, from.CellOf(ray));
  ++from.Next[ray];
}

/// True if there is no room for another cell.
bool PassageSearch::IsFull() const
{
  return std::any_of(this->Streams.begin(), this->Streams.end(),
    [](const Stream& stream) { return stream.Found.Count == RayBatch::Capacity; });
}

/// Search what is noted, and append what is found.
void PassageSearch::Flush()
{
  for (Stream& stream : this->Streams)
  {
    if (stream.Found.Count > 0)
    {
      this->Tracer.SearchPassed(this->Rays, stream.Found);
    }
  }
  this->Layers.CellsRead += static_cast<std::int64_t>(this->Order.size());
  for (std::size_t i = 0; i < this->Order.size();)
  {
    i = this->Decide(i);
  }
  this->Order.clear();
  for (Stream& stream : this->Streams)
  {
    stream.Found.Count = 0;
  }
}

/// Append what a ray meets in a cell. \param first number of its first candidate
/// \return number of the next cell's first candidate
std::size_t PassageSearch::Decide(std::size_t first)
{
  const PassedCells* met = nullptr;
  std::size_t place = 0;
  int count = 0;
  bool isOpen = false;
  std::size_t end = first;
  do
  {
    const PassedCells& found = this->Streams[this->Order[end].Stream].Found;
    const std::uint8_t at = this->Order[end].Place;
    if (found.One >> at & 1u)
    {
      met = &found;
      place = at;
      ++count;
    }
    isOpen |= (found.Open >> at & 1u) != 0;
    ++end;
  } while (end < this->Order.size() && this->Order[end].IsSameCell);

  const PassedCells& cells = this->Streams[this->Order[first].Stream].Found;
  const std::size_t inCells = this->Order[first].Place, ray = cells.Ray[inCells];
  if (!this->Layers.IsOpen(ray) || (this->Unclear >> ray & 1u))
  {
    return end;
  }
  bool isClear = true;
  if (isOpen || count > 1)
  {
    isClear = this->Tracer.AppendIn(this->Rays, ray, cells.CellAt(inCells), this->Layers);
  }
  else if (count == 1)
  {
    const double distance = met->Distance[place];
    isClear = this->Layers.IsClearlyBehind(ray, distance);
    if (isClear)
    {
      const HitKind kind = met->Exits >> place & 1u ? HitKind::Exit : HitKind::Entry;
      this->Layers.Append(ray, distance, kind, static_cast<std::int16_t>(met->Surface));
    }
  }
  this->Unclear |= static_cast<std::uint64_t>(!isClear) << ray;
  return end;
}

}
