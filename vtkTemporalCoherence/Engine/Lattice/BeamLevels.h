// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BeamLevels_h
#define TemporalCoherence_BeamLevels_h

#include "Lattice/SurfaceTracer.h"
#include "Scene/Difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace TemporalCoherence
{

/// The isovalues of a scene in the form that beams test. All tiles share them.
/// \tparam T type of which differences from isovalues are taken
template <typename T>
struct BeamLevels
{
  explicit BeamLevels(const TraceScene& scene)
  {
    const std::vector<double>& isovalues = scene.Isosurfaces.Isovalues;
    // Differences from an isovalue far from all samples would lose precision.
    const double middle = 0.5 * scene.FiniteRange.x + 0.5 * scene.FiniteRange.y;
    const auto base = std::min_element(isovalues.begin(), isovalues.end(),
      [&](double a, double b) { return std::abs(a - middle) < std::abs(b - middle); });
    const IsovalueScale scale = IsovalueScale::For<T>({ *base, *base }, scene.FiniteRange);
    const double largest = scale.LargestFrom(*base, scene.FiniteRange);
    this->Base = static_cast<std::size_t>(base - isovalues.begin());
    this->Unit = sizeof(RealOf<T>) == sizeof(double) && largest > 0.0
      ? std::ldexp(1.0, std::min(-std::ilogb(largest), 1000))
      : 1.0;
    for (const double isovalue : isovalues)
    {
      // Beyond the difference of any sample: unscaled in float, in units of the largest in double.
      constexpr double most = sizeof(RealOf<T>) == sizeof(float) ? 4e30 : 1e12;
      const double offset = (scale.Scaled(isovalue) - scale.Scaled(*base)) * this->Unit;
      this->Isovalues.push_back(static_cast<float>(std::min(std::max(offset, -most), most)));
    }
  }

  /// True if a cell's differences from the base serve all isovalues. The difference of a non-finite
  /// sample depends on the isovalue.
  /// \tparam Sample type of the samples
  template <typename Sample>
  bool AreTold(const std::array<Sample, 8>& samples) const
  {
    return this->AreAlwaysTold<Sample>() ||
      std::all_of(samples.begin(), samples.end(),
        [](Sample sample) { return std::isfinite(static_cast<double>(sample)); });
  }

  /// True if AreTold holds for all cells.
  template <typename Sample>
  bool AreAlwaysTold() const
  {
    return !std::is_floating_point_v<Sample> || this->Isovalues.size() == 1;
  }

  std::size_t Base;             ///< position of the isovalue that differences are taken from
  double Unit;                  ///< factor of all differences
  std::vector<float> Isovalues; ///< as scaled differences from the base
};

}

#endif
