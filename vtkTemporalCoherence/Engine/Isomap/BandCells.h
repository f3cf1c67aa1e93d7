// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BandCells_h
#define TemporalCoherence_BandCells_h

#include "Isomap/BandTracer.h"
#include "Lattice/CellRoot.h"
#include "Lattice/CellSamples.h"
#include "Scene/Difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <type_traits>

namespace TemporalCoherence
{

/// Positions of the directions in arrays.
constexpr auto Rising = static_cast<std::size_t>(ValueDirection::Rising);
constexpr auto Falling = static_cast<std::size_t>(ValueDirection::Falling);

/// The farthest progress of a cell's samples in both directions.
template <typename Real>
struct CellReach
{
  std::array<Real, NumberOfDirections> Corner;
  Real Error;    ///< rounding error between two ways to compute a value of the field
  bool IsFinite; ///< all samples are finite
};

/// The cells of a band, for any geometry (TracedCells.h).
template <typename T, typename Geometry>
struct BandCells
{
  using Real = typename Geometry::Real;
  using Value = typename Geometry::Value;
  static constexpr Real Infinity = std::numeric_limits<Real>::infinity();

  BandCells(const BandScene& scene, const Geometry& shape)
    : Scene(scene)
    , Shape(shape)
    , Samples(scene.Samples)
    , Scale(scene.Samples.Type, scene.Band, scene.FiniteRange)
    , FromLowest(scene.Band.Low, scene.FiniteRange, Scale.Isovalues)
    , Span(static_cast<Real>(this->Scale.Span))
    , Count(scene.Samples.Dimensions - 1)
    , IsSolid(scene.Mode == SurfaceMode::Threshold)
  {
  }

  /// Read a cell, as differences from the band's lowest isovalue.
  CellReach<Real> Read(const glm::ivec3& cell, Corners<Real>& corners) const
  {
    const std::array<T, 8> samples = this->Samples.Read(cell);
    CellReach<Real> reach{ {}, Real(0), true };
    Real lowest = Infinity, highest = -Infinity;
    for (std::size_t i = 0; i < 8; ++i)
    {
      corners[i] = this->FromLowest(static_cast<Value>(samples[i]));
      lowest = std::min(lowest, corners[i]);
      highest = std::max(highest, corners[i]);
    }
    constexpr Real rounding = 16 * std::numeric_limits<Real>::epsilon();
    reach.Error = rounding * (std::max(std::abs(lowest), std::abs(highest)) + this->Span);
    if constexpr (std::is_floating_point_v<T>)
    {
      for (const T sample : samples)
      {
        if (!std::isfinite(sample))
        {
          // A non-finite sample's difference depends on the isovalue, so its progress is unbounded.
          reach.IsFinite = false;
          (sample > T(0) ? highest : lowest) = sample > T(0) ? Infinity : -Infinity;
        }
      }
    }
    reach.Corner = { highest, this->Span - lowest };
    return reach;
  }

  /// Key of the progress of a value in a cell.
  BandScale::Key KeyOf(Real progress, const CellReach<Real>& cell) const
  {
    return this->Scale.KeyOf(static_cast<double>(progress) + static_cast<double>(cell.Error));
  }

  BandScene Scene;
  Geometry Shape;
  CellSamples<T> Samples;
  BandScale Scale;
  Difference<Value> FromLowest;
  Real Span;
  glm::ivec3 Count; ///< of cells along each axis
  bool IsSolid;
};

}

#endif
