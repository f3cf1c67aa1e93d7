// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsRectilinear_h
#define TemporalCoherence_KernelsRectilinear_h

#include "Scene/Difference.h"
#include "Scene/GridCoordinates.h"
#include "Shade/KernelsGradients.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// Gradients of a rectilinear field at points, in the widest vectors of the machine. Every kind of
/// vectors gives bit-identical results.
namespace GradientKernels
{

/// Find the cells of hits, to the end of the last vector.
void FindGridCells(const GridCoordinates& grid, const glm::dmat4& indexFromWorld,
  const HitRays& rays, CellPoints<double>& found);

/// The samples around the cells of a tile's points, from which the gradients at the cells' corners
/// are computed.
struct GridCells
{
  /// [axis][sample along the axis][edge along the axis]. Sample 0 lies before the cell, 1 and 2 on
  /// its faces, 3 behind the cell. Edges have numbers first other axis + 2 second other axis.
  using Samples = std::array<std::array<std::array<double, 4>, 4>, 3>;
  /// Distances between subtracted samples, at the two faces across each axis.
  using Distances = std::array<std::array<double, 2>, 3>;

  std::size_t Count = 0;
  std::array<Samples, RayBatch::Capacity> Around;
  std::array<Distances, RayBatch::Capacity> Between;
  /// Differences from the isovalue, by cell.
  std::array<DifferenceInDouble, RayBatch::Capacity> FromIsovalue;
};

/// Find gradients: central differences at the corners of cells, interpolated to the points.
/// \param cells    of each point, to the end of the last vector
/// \param largest  that gradients are clamped to
/// \param gradients result, per unit of index space
void InterpolateInGrid(const GridCells& around, const Array<std::int32_t>& cells,
  const CellPoints<double>& points, double largest, Vectors& gradients);

}

}

#endif
