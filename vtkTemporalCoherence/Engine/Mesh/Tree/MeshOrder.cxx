// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Tree/MeshOrder.h"

#include "Mesh/Tree/HilbertCurve.h"
#include "Mesh/Tree/MeshSteps.h"
#include "Mesh/Tree/RadixSort.h"
#include "Scene/Parallel.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <limits>

namespace TemporalCoherence
{
namespace
{

/// Layout of sort keys: the place of a cell's centre along the curve in the upper bits, and the
/// cell's number below. So keys are unique, and their order is unambiguous.
struct KeyLayout
{
  int NumberBits = 0; ///< of a cell
  int AxisBits = 0;   ///< of the place along each axis

  KeyLayout(std::int64_t allCells, std::int64_t sortedCells)
  {
    const auto bitsFor = [](std::int64_t count)
    {
      int bits = 1;
      for (; count >> bits != 0; ++bits)
      {
      }
      return bits;
    };
    this->NumberBits = bitsFor(allCells);
    // Eight times as many places along each axis as if cells were spread evenly, at least 2^10.
    const int wanted = std::max(10, bitsFor(sortedCells) / 3 + 3);
    this->AxisBits = std::min((64 - this->NumberBits) / 3, wanted);
  }

  int PlaceBits() const { return 3 * this->AxisBits; }
  std::uint32_t NumberOf(std::uint64_t key) const
  {
    return static_cast<std::uint32_t>(key & ((std::uint64_t(1) << this->NumberBits) - 1));
  }
};

/// Places along a Hilbert curve through a cube around a box.
class Curve
{
public:
  Curve(const PointBox& box, const KeyLayout& layout)
    : Low(box.Low)
    , Layout(layout)
  {
    const glm::dvec3 size = box.High - box.Low;
    const double longest = std::max({ size.x, size.y, size.z });
    this->Last = static_cast<double>((std::uint64_t(1) << layout.AxisBits) - 1);
    // The quotient may overflow where points are that close; then all lie at the last place.
    this->PerLength = longest > 0.0 ? (this->Last + 1.0) / longest : 0.0;
    this->PerLength = std::min(this->PerLength, std::numeric_limits<double>::max());
  }

  std::uint64_t KeyOf(const glm::dvec3& centre, std::uint32_t number) const
  {
    const glm::dvec3 place = glm::min((centre - this->Low) * this->PerLength, this->Last);
    const std::uint64_t along = HilbertCurve::NumberOf(static_cast<std::uint32_t>(place.x),
      static_cast<std::uint32_t>(place.y), static_cast<std::uint32_t>(place.z),
      this->Layout.AxisBits);
    return along << this->Layout.NumberBits | number;
  }

private:
  glm::dvec3 Low;
  KeyLayout Layout;
  double Last, PerLength;
};

/// The centre of the box around points.
glm::dvec3 CentreOf(const std::array<glm::dvec3, 8>& points, int count)
{
  PointBox box;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
  {
    box.Widen(points[i]);
  }
  return 0.5 * (box.Low + box.High);
}

/// Runs up to this length stay as they are, although the curve cannot separate their cells: half a
/// leaf.
constexpr std::int64_t ShortRun = 32;

/// All threads together sort a run with more cells.
constexpr std::int64_t LongRun = 1 << 18;

/// Each curve divides the box around a run 2^10 times or more along each axis. Points that this
/// many curves cannot separate count as equal.
constexpr int MostCurves = 5;

struct Run
{
  std::int64_t Begin, End;
};

/// Sorts runs of cells with equal places along a curve again, along curves through the runs' own
/// boxes.
class RunSorter
{
public:
  RunSorter(const MeshReader& reader, const KeyLayout& layout)
    : Reader(reader)
    , Layout(layout)
  {
  }

  /// Sort the runs among the sorted keys begin .. end - 1, in parallel.
  /// \param curve how many curves they are sorted along
  void SortRuns(
    SortKeys& keys, SortKeys& spare, std::int64_t begin, std::int64_t end, int curve = 1) const;

private:
  template <typename Work>
  void ForEachRun(
    const std::uint64_t* keys, std::int64_t begin, std::int64_t end, const Work& work) const;
  glm::dvec3 CentreOf(std::uint64_t key) const;
  bool Renew(std::uint64_t* keys, std::int64_t begin, std::int64_t end) const;
  void SortAlone(std::uint64_t* keys, std::int64_t begin, std::int64_t end, int curve) const;

  const MeshReader& Reader;
  KeyLayout Layout;
};

/// Call `work(begin, end)` for the keys with equal places, if there are many.
template <typename Work>
void RunSorter::ForEachRun(
  const std::uint64_t* keys, std::int64_t begin, std::int64_t end, const Work& work) const
{
  const int shift = this->Layout.NumberBits;
  while (end - begin > ShortRun)
  {
    const std::uint64_t place = keys[begin] >> shift;
    // Most runs are short: one look ahead tells.
    if (keys[begin + ShortRun] >> shift != place)
    {
      do
      {
        ++begin;
      } while (keys[begin] >> shift == place);
      continue;
    }
    const auto* const last = std::partition_point(keys + begin + ShortRun, keys + end,
      [&](std::uint64_t key) { return key >> shift == place; });
    const std::int64_t next = last - keys;
    // The work may change keys.
    work(begin, next);
    begin = next;
  }
}

glm::dvec3 RunSorter::CentreOf(std::uint64_t key) const
{
  std::array<glm::dvec3, 8> points;
  const int count = this->Reader.ReadPoints(this->Layout.NumberOf(key), points);
  return TemporalCoherence::CentreOf(points, count);
}

void RunSorter::SortRuns(
  SortKeys& keys, SortKeys& spare, std::int64_t begin, std::int64_t end, int curve) const
{
  std::vector<Run> shorter;
  this->ForEachRun(keys.data(), begin, end,
    [&](std::int64_t first, std::int64_t last)
    {
      if (last - first <= LongRun)
      {
        shorter.push_back({ first, last });
      }
      else if (curve < MostCurves && this->Renew(keys.data(), first, last))
      {
        SortByRadix(keys, spare, first, last, this->Layout.NumberBits, this->Layout.PlaceBits());
        this->SortRuns(keys, spare, first, last, curve + 1);
      }
    });
  ParallelFor(static_cast<std::int64_t>(shorter.size()), 16,
    [&](std::int64_t i)
    {
      const Run& run = shorter[static_cast<std::size_t>(i)];
      this->SortAlone(keys.data(), run.Begin, run.End, curve);
    });
}

/// Give keys the places on a curve through their own box.
/// \return false if it has no size
bool RunSorter::Renew(std::uint64_t* keys, std::int64_t begin, std::int64_t end) const
{
  PointBox box;
  for (std::int64_t i = begin; i < end; ++i)
  {
    box.Widen(this->CentreOf(keys[i]));
  }
  if (box.Low == box.High)
  {
    return false;
  }
  const Curve curve(box, this->Layout);
  const auto renew = [&](std::int64_t i)
  { keys[i] = curve.KeyOf(this->CentreOf(keys[i]), this->Layout.NumberOf(keys[i])); };
  if (end - begin > LongRun)
  {
    ParallelFor(end - begin, 1 << 12, [&](std::int64_t i) { renew(begin + i); });
    return true;
  }
  for (std::int64_t i = begin; i < end; ++i)
  {
    renew(i);
  }
  return true;
}

/// Sort one run by the calling thread.
void RunSorter::SortAlone(
  std::uint64_t* keys, std::int64_t begin, std::int64_t end, int curve) const
{
  if (curve < MostCurves && this->Renew(keys, begin, end))
  {
    std::sort(keys + begin, keys + end);
    this->ForEachRun(keys, begin, end,
      [&](std::int64_t first, std::int64_t last)
      { this->SortAlone(keys, first, last, curve + 1); });
  }
}

/// Make the keys of the cells of a chunk that have volume.
void MakeKeys(
  const MeshReader& reader, const CellChunk& chunk, const Curve& curve, std::uint64_t* keys)
{
  const MeshPart& part = reader.PartAt(chunk.Part);
  std::array<glm::dvec3, 8> points;
  for (std::int64_t cell = chunk.Begin; cell < chunk.End; ++cell)
  {
    const int count = MeshReader::ReadPoints(part, cell, points);
    if (count != 0)
    {
      const auto number = static_cast<std::uint32_t>(chunk.First + cell - chunk.Begin);
      *keys++ = curve.KeyOf(CentreOf(points, count), number);
    }
  }
}

}

CellNumbers OrderCells(const MeshReader& reader, const std::vector<CellChunk>& chunks,
  const ReportProgress& progress, bool& isStopped)
{
  PointBox box;
  std::vector<std::int64_t> first;
  std::int64_t cells = 0;
  for (const CellChunk& chunk : chunks)
  {
    box.Widen(chunk.Box);
    first.push_back(cells);
    cells += chunk.NumberOfCells;
  }
  const KeyLayout layout(reader.NumberOfCells(), cells);
  SortKeys keys(static_cast<std::size_t>(cells));
  if (cells > 0)
  {
    const Curve curve(box, layout);
    isStopped = !InSteps(static_cast<std::int64_t>(chunks.size()), PartOf(progress, 0.0, 0.4),
      [&](std::int64_t i)
      {
        const auto at = static_cast<std::size_t>(i);
        MakeKeys(reader, chunks[at], curve, keys.data() + first[at]);
      });
  }
  if (isStopped)
  {
    return {};
  }
  {
    SortKeys spare(static_cast<std::size_t>(cells));
    SortByRadix(keys, spare, 0, cells, layout.NumberBits, layout.PlaceBits());
    RunSorter(reader, layout).SortRuns(keys, spare, 0, cells);
  }
  CellNumbers numbers(static_cast<std::size_t>(cells));
  ParallelFor(cells, 1 << 14,
    [&](std::int64_t i)
    {
      const auto at = static_cast<std::size_t>(i);
      numbers[at] = layout.NumberOf(keys[at]);
    });
  isStopped = progress && !progress(1.0);
  return numbers;
}

std::size_t MemoryToOrder(std::int64_t cells)
{
  return 2 * sizeof(std::uint64_t) * static_cast<std::size_t>(cells);
}

}
