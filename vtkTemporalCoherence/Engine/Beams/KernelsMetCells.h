// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsMetCells_h
#define TemporalCoherence_KernelsMetCells_h

#include "Beams/TileBeam.h"
#include "Trace/CellRoot.h"
#include "Trace/SegmentBatch.h"

#include <array>
#include <cstdint>

namespace TemporalCoherence
{

/// Something of each cell that a beam has read.
template <typename T>
using OfReadCells = std::array<T, BeamScene::MostCells>;

/// The cells of rays, by their numbers; TileBeam::NoCell for none.
using CellNumbers = RayBatch::Array<std::int32_t>;

/// Set the cells of segments, one for each ray of a tile, from tables, in the widest vectors of the
/// machine. Rays without a cell get that of number 0.
/// \return one bit for each ray with a cell
std::uint64_t GatherPlaces(
  const OfReadCells<glm::ivec3>& places, const CellNumbers& cells, SegmentBatch<float>& segments);
std::uint64_t GatherPlaces(
  const OfReadCells<glm::ivec3>& places, const CellNumbers& cells, SegmentBatch<double>& segments);

/// Where a cell lies: its first corner and its last.
using CellCorners = std::array<glm::dvec3, 2>;

/// The same for cells between any coordinates.
std::uint64_t GatherPlaces(
  const OfReadCells<CellCorners>& boxes, const CellNumbers& cells, SegmentBatch<double>& segments);

/// The same for the corners of those segments that are wanted.
void GatherCorners(const OfReadCells<Corners<float>>& differences, const CellNumbers& cells,
  SegmentBatch<float>& segments);
void GatherCorners(const OfReadCells<Corners<double>>& differences, const CellNumbers& cells,
  SegmentBatch<double>& segments);

}

#endif
