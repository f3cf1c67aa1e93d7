// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Passages/PassageSearch.h"

#include "Passages/KernelsPassedCells.h"

#include <algorithm>
#include <limits>

namespace TemporalCoherence
{
namespace
{

/// Words of one bit for each row.
std::size_t WordsFor(std::size_t rows)
{
  return (rows + 63) / 64;
}

}

PassageSearch::PassageSearch(
  const SurfaceTracer& tracer, const RayBatch& rays, std::size_t most, LayerBatch& layers)
  : Tracer(tracer)
  , Rays(rays)
  , Layers(layers)
{
  this->Streams.reserve(most);
  this->Batches.reserve(most);
}

void PassageSearch::Add(std::size_t surface, const TileKnots& knots, PassageKey key)
{
  this->MayBeCapped |= knots.Passages.MayBeCapped;
  if (!knots.Passages.Rows.IsEmpty())
  {
    this->Streams.push_back({ &knots.Passages, key, knots.Unresolved });
    this->Batches.emplace_back().Surface = surface;
    this->Truncated |= knots.Unresolved;
  }
}

std::uint64_t PassageSearch::Search()
{
  if (this->MayBeCapped)
  {
    this->Tracer.AppendCaps(this->Rays, this->Layers);
  }
  if (!this->Streams.empty())
  {
    this->Collect();
  }
  for (std::uint64_t ahead = this->Layers.Open; !this->Candidates.empty() && ahead != 0;)
  {
    ForEachRay(ahead,
      [&](std::size_t ray)
      {
        if (this->Next[ray] != this->End[ray])
        {
          this->TakeNext(ray);
        }
        else
        {
          ahead &= ~(std::uint64_t(1) << ray);
        }
      });
    ahead &= this->Layers.Open & ~this->Unclear;
  }
  if (!this->Candidates.empty())
  {
    this->Flush();
  }
  return (this->Truncated | this->Unclear) & this->Layers.Open;
}

/// Collect the candidates of all open rays.
void PassageSearch::Collect()
{
  std::size_t rows = 0, words = 0;
  for (const Stream& stream : this->Streams)
  {
    rows += stream.Table->Rows.NumberOfRows();
    words += WordsFor(stream.Table->Rows.NumberOfRows());
  }
  this->Candidates.reserve(rows);
  std::vector<std::uint64_t> holding(words);
  std::uint64_t* next = holding.data();
  for (const Stream& stream : this->Streams)
  {
    const PassageTable::RowsOfRays& table = stream.Table->Rows;
    FindHolding(table.Get<1>(), table.Get<2>(), table.NumberOfRows(), stream.Wanted, next);
    next += WordsFor(table.NumberOfRows());
  }
  for (std::size_t ray = 0; ray < static_cast<std::size_t>(this->Rays.Count); ++ray)
  {
    const std::size_t first = this->Candidates.size();
    next = holding.data();
    for (std::size_t stream = 0; stream < this->Streams.size() && this->Layers.IsOpen(ray);
         ++stream)
    {
      this->CollectOf(ray, static_cast<std::uint16_t>(stream), next);
      next += WordsFor(this->Streams[stream].Table->Rows.NumberOfRows());
    }
    if (this->Streams.size() > 1)
    {
      this->MergeOf(ray, first);
    }
    this->Next[ray] = static_cast<std::uint32_t>(first);
    this->End[ray] = static_cast<std::uint32_t>(this->Candidates.size());
  }
}

/// Those of one isovalue. \param words one bit for each row that holds it
void PassageSearch::CollectOf(std::size_t ray, std::uint16_t stream, const std::uint64_t* words)
{
  const PassageTable::RowsOfRays& table = this->Streams[stream].Table->Rows;
  const std::uint16_t* const cells = table.Get<0>();
  const std::size_t begin = table.Begin(ray), end = table.Begin(ray + 1);
  for (std::size_t row = begin; row < end; row = (row / 64 + 1) * 64)
  {
    std::uint64_t left = words[row / 64] >> row % 64 << row % 64;
    left = end / 64 > row / 64 ? left : left & ((std::uint64_t(1) << end % 64) - 1);
    for (; left != 0; left &= left - 1)
    {
      const std::size_t at = row / 64 * 64 + hwy::Num0BitsBelowLS1Bit_Nonzero64(left);
      this->Candidates.push_back({ cells[at], stream });
    }
  }
}

/// Bring the candidates of all isovalues, from number `first` on, into their order along a ray.
void PassageSearch::MergeOf(std::size_t ray, std::size_t first)
{
  const auto begin = this->Candidates.begin() + static_cast<std::ptrdiff_t>(first);
  const auto end = this->Candidates.end();
  std::sort(begin, end,
    [&](const Candidate& a, const Candidate& b)
    {
      const CellIndex &ofA = this->CellOf(a), &ofB = this->CellOf(b);
      const int placeOfA = this->PlaceAlong(ray, ofA), placeOfB = this->PlaceAlong(ray, ofB);
      return placeOfA != placeOfB ? placeOfA < placeOfB
        : ofA != ofB              ? ofA < ofB
                                  : a.Stream < b.Stream;
    });
  if (this->Truncated >> ray & 1u)
  {
    this->CutOff(ray, first);
  }
}

/// Leave out what does not lie before the last passage that is stored of an isovalue. Of cells at
/// the same place along a ray it is not known which one the ray meets first.
void PassageSearch::CutOff(std::size_t ray, std::size_t first)
{
  int last = std::numeric_limits<int>::max();
  for (const Stream& stream : this->Streams)
  {
    if (stream.Truncated >> ray & 1u)
    {
      const PassageTable& table = *stream.Table;
      const std::uint16_t cell = table.Rows.Get<0>()[table.Rows.Begin(ray + 1) - 1];
      last = std::min(last, this->PlaceAlong(ray, table.Cells[cell]));
    }
  }
  while (this->Candidates.size() > first &&
    this->PlaceAlong(ray, this->CellOf(this->Candidates.back())) >= last)
  {
    this->Candidates.pop_back();
  }
}

/// How far along a ray a cell lies among those that the ray passes, in cells.
int PassageSearch::PlaceAlong(std::size_t ray, const CellIndex& cell) const
{
  int place = 0;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const int at = cell[a];
    place += this->Rays.Direction[a][ray] < 0.0 ? -at : at;
  }
  return place;
}

/// Take the next cell of a ray, for all isovalues that it holds.
void PassageSearch::TakeNext(std::size_t ray)
{
  if (this->Streams.size() == 1)
  {
    PassedCells& batch = this->Batches.front();
    batch.Append(ray, this->CellOf(this->Candidates[this->Next[ray]++]));
    if (batch.Count == RayBatch::Capacity)
    {
      this->Flush();
    }
    return;
  }
  const CellIndex cell = this->CellOf(this->Candidates[this->Next[ray]]);
  bool isFirst = true, isFull = false;
  for (; this->Next[ray] != this->End[ray]; ++this->Next[ray], isFirst = false)
  {
    const Candidate& next = this->Candidates[this->Next[ray]];
    if (this->CellOf(next) != cell)
    {
      break;
    }
    PassedCells& batch = this->Batches[next.Stream];
    this->Order.push_back({ next.Stream, static_cast<std::uint8_t>(batch.Count), !isFirst });
    batch.Append(ray, cell);
    isFull |= batch.Count == RayBatch::Capacity;
  }
  if (isFull)
  {
    this->Flush(); // what is noted of one cell is decided together
  }
}

/// Search what is noted, and append what is found.
void PassageSearch::Flush()
{
  for (PassedCells& batch : this->Batches)
  {
    if (batch.Count > 0)
    {
      this->Tracer.SearchPassed(this->Rays, batch);
      this->Layers.CellsRead += batch.Count;
    }
  }
  if (this->Streams.size() == 1)
  {
    this->DecideAll(this->Batches.front());
  }
  for (std::size_t i = 0; i < this->Order.size();)
  {
    i = this->DecideCell(i);
  }
  this->Order.clear();
  for (PassedCells& batch : this->Batches)
  {
    batch.Count = 0;
  }
}

/// Append what rays meet of the only isovalue.
void PassageSearch::DecideAll(const PassedCells& found)
{
  const std::uint64_t all = found.Count > 0
    ? ~std::uint64_t(0) >> (RayBatch::Capacity - static_cast<std::size_t>(found.Count))
    : 0;
  ForEachRay((found.One | found.Open) & all,
    [&](std::size_t place)
    {
      const std::size_t ray = found.Ray[place];
      if (!this->GoesOn(ray))
      {
        return;
      }
      if (found.Open >> place & 1u)
      {
        this->AppendIn(ray, found.CellAt(place));
      }
      else
      {
        this->Append(ray, found, place);
      }
    });
}

/// Append what a ray meets in a cell of several isovalues. \param first number of the cell's first
/// note \return number of the next cell's first note
std::size_t PassageSearch::DecideCell(std::size_t first)
{
  const Taken* met = nullptr;
  int count = 0;
  bool isOpen = false;
  std::size_t end = first;
  do
  {
    const Taken& taken = this->Order[end];
    const PassedCells& found = this->Batches[taken.Stream];
    if (found.One >> taken.Place & 1u)
    {
      met = &taken;
      ++count;
    }
    isOpen |= (found.Open >> taken.Place & 1u) != 0;
    ++end;
  } while (end < this->Order.size() && this->Order[end].IsSameCell);

  const PassedCells& cells = this->Batches[this->Order[first].Stream];
  const std::size_t place = this->Order[first].Place, ray = cells.Ray[place];
  if (!this->GoesOn(ray))
  {
    return end;
  }
  if (isOpen || count > 1)
  {
    this->AppendIn(ray, cells.CellAt(place)); // it has to be known which one the ray meets first
  }
  else if (count == 1)
  {
    this->Append(ray, this->Batches[met->Stream], met->Place);
  }
  return end;
}

/// Append a surface of a ray.
void PassageSearch::Append(std::size_t ray, const PassedCells& found, std::size_t place)
{
  const double distance = found.Distance[place];
  if (this->Layers.IsClearlyBehind(ray, distance))
  {
    const HitKind kind = found.Exits >> place & 1u ? HitKind::Exit : HitKind::Entry;
    this->Layers.Append(ray, distance, kind, static_cast<std::int16_t>(found.Surface));
  }
  else
  {
    this->Unclear |= std::uint64_t(1) << ray;
  }
}

/// Append all that a ray meets in a cell.
void PassageSearch::AppendIn(std::size_t ray, const glm::ivec3& cell)
{
  const bool isClear = this->Tracer.AppendIn(this->Rays, ray, cell, this->Layers);
  this->Unclear |= static_cast<std::uint64_t>(!isClear) << ray;
}

}
