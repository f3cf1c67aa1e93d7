// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Tree/MeshOrder.h"

#include "Mesh/Tree/MeshKeys.h"
#include "Mesh/Tree/MeshRuns.h"
#include "Mesh/Tree/MeshSteps.h"

#include <array>

namespace TemporalCoherence
{
namespace
{

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
