// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_HitCells_h
#define TemporalCoherence_HitCells_h

#include "Mesh/Cells/CellPoints.h"
#include "Mesh/Cells/KernelsCellGradients.h"
#include "Mesh/Tracing/KernelsDistinct.h"
#include "Mesh/Tracing/MeshPlaces.h"
#include "Mesh/Tree/MeshTree.h"
#include "Scene/RayBatch.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// The cells of the hits of a tile, each once.
struct HitCells
{
  static constexpr std::size_t Most = RayBatch::Capacity;
  static constexpr std::uint8_t None = MeshKernels::PointsInCells::NoCell;

  std::size_t Count = 0;
  std::array<CellNumber, Most> Numbers;
  std::array<MeshCell, Most> Cells;
  RayBatch::Array<std::uint8_t> OfHit; ///< the place of its cell, or None

  /// \param hits    number of them
  /// \param known   their cells, or NoCell; null: unknown
  /// \param placeOf tells where a hit lies in the mesh, if its cell is not known
  template <typename PlaceOf>
  HitCells(const MeshTree& tree, std::size_t hits, const RayBatch::Array<CellNumber>* known,
    const PlaceOf& placeOf)
  {
    RayBatch::Array<CellNumber> numbers;
    numbers.fill(NoCell);
    std::uint64_t inCells = 0;
    for (std::size_t i = 0; i < hits; ++i)
    {
      numbers[i] = known ? (*known)[i] : FindCellAt(tree, placeOf(i));
      inCells |= static_cast<std::uint64_t>(numbers[i] != NoCell) << i;
    }
    DistinctCells distinct;
    FindDistinct(numbers, inCells, distinct);
    this->Count = distinct.Count;
    this->OfHit.fill(None);
    for (std::size_t cell = 0; cell < this->Count; ++cell)
    {
      this->Numbers[cell] = distinct.Numbers[cell];
      ForEachRay(distinct.Rays[cell],
        [&](std::size_t hit) { this->OfHit[hit] = static_cast<std::uint8_t>(cell); });
    }
    tree.Reader().ReadAll(this->Numbers, this->Count, this->Cells);
  }

  /// Call visit(hit, part, cell, points, weights) for hits in cells: the part of the mesh, the cell
  /// in it, and the points of the cell with their weights in interpolation.
  /// \param places of the hits in these cells
  template <typename Visit>
  void ForEachHit(
    const MeshTree& tree, const MeshKernels::PointsInCells& places, const Visit& visit) const
  {
    std::size_t last = Most, part = 0;
    std::int64_t inPart = 0;
    MeshCellPoints points;
    for (std::size_t i = 0; i < places.Count; ++i)
    {
      const std::size_t cell = places.Cell[i];
      if (cell == None)
      {
        continue;
      }
      if (cell != last)
      {
        tree.Reader().Locate(this->Numbers[cell], part, inPart);
        points = MeshReader::FindPoints(tree.Reader().PartAt(part), inPart);
        last = cell;
      }
      const std::array<double, 8> weights = MeshKernels::WeightsAt(
        this->Cells[cell], { places.At[0][i], places.At[1][i], places.At[2][i] });
      visit(i, part, inPart, points, weights);
    }
  }
};

}

#endif
