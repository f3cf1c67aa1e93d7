// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsMetCells_h
#define TemporalCoherence_KernelsMetCells_h

#include "Lattice/CellRoot.h"
#include "Lattice/SegmentBatch.h"
#include "Lattice/TileBeam.h"

#include <array>
#include <cstdint>

namespace TemporalCoherence
{

/// One value for each cell that a beam has read.
template <typename T>
using OfReadCells = std::array<T, BeamScene::MostCells>;

/// The number of each ray's cell; TileBeam::NoCell for none.
using CellNumbers = RayBatch::Array<std::int32_t>;

/// Set the cells of segments, one for each ray of a tile, from tables, in the widest vectors of the
/// machine. Rays without a cell get cell number 0.
/// \return one bit for each ray with a cell
std::uint64_t GatherPlaces(
  const OfReadCells<glm::ivec3>& places, const CellNumbers& cells, SegmentBatch<float>& segments);
std::uint64_t GatherPlaces(
  const OfReadCells<glm::ivec3>& places, const CellNumbers& cells, SegmentBatch<double>& segments);

/// The first and the last corner of a cell.
using CellCorners = std::array<glm::dvec3, 2>;

/// Gather the boxes of rectilinear cells.
std::uint64_t GatherPlaces(
  const OfReadCells<CellCorners>& boxes, const CellNumbers& cells, SegmentBatch<double>& segments);

/// Gather the corners of the wanted segments.
void GatherCorners(const OfReadCells<Corners<float>>& differences, const CellNumbers& cells,
  SegmentBatch<float>& segments);
void GatherCorners(const OfReadCells<Corners<double>>& differences, const CellNumbers& cells,
  SegmentBatch<double>& segments);

}

#endif
