// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Surfaces_h
#define TemporalCoherence_Surfaces_h

#include "Scene/ArrayLooks.h"
#include "Scene/Field.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// Which crossings of an isovalue are its surface.
enum class SurfaceMode : std::uint8_t
{
  Crossing, ///< the field passes the isovalue in either direction; solids are not capped
  Threshold ///< where the solid field >= isovalue begins; it is capped where it is clipped
};

/// Opacity by gradient magnitude. It multiplies the opacity of a surface.
struct GradientOpacity
{
  /// Gradient magnitude, ascending, and opacity in [0, 1]. Linear between nodes, constant beyond.
  /// If empty, the opacity is 1.
  std::vector<glm::dvec2> Nodes;

  /// Scales a gradient of index space to one per mean sample distance: the mean sample distance,
  /// divided by the sample distance along each axis.
  glm::dvec3 PerStep{ 1.0 };

  double At(double gradientMagnitude) const
  {
    const auto next = std::upper_bound(this->Nodes.begin(), this->Nodes.end(), gradientMagnitude,
      [](double value, const glm::dvec2& node) { return value < node.x; });
    if (next == this->Nodes.begin() || next == this->Nodes.end())
    {
      return next == this->Nodes.begin() ? next->y : (next - 1)->y;
    }
    const glm::dvec2& last = *(next - 1);
    return last.y + (next->y - last.y) * (gradientMagnitude - last.x) / (next->x - last.x);
  }
};

inline bool operator==(const GradientOpacity& a, const GradientOpacity& b)
{
  return a.Nodes == b.Nodes && (a.Nodes.empty() || a.PerStep == b.PerStep);
}

/// The isosurfaces to draw. Their order carries no meaning, and no isovalue occurs twice.
struct Surfaces
{
  std::vector<double> Isovalues; ///< finite
  SurfaceMode Mode = SurfaceMode::Crossing;
  std::vector<double> Opacities{}; ///< one for each isovalue, in (0, 1]; empty: all are opaque
  GradientOpacity ByGradient{};
  /// Opacities at the values of an array. They multiply the others. Null: none.
  std::shared_ptr<const ArrayOpacities> ByArray{};

  /// True if opacity differs from place to place on a surface. Only shading knows it.
  bool HasOpacityByPlace() const { return !this->ByGradient.Nodes.empty() || this->ByArray; }

  /// True if some surface may be translucent.
  bool IsTranslucent() const { return !this->Opacities.empty() || this->HasOpacityByPlace(); }
};

/// True if rays meet the same surfaces, whatever their opacities.
inline bool AreMetAlike(const Surfaces& a, const Surfaces& b)
{
  return a.Isovalues == b.Isovalues && a.Mode == b.Mode;
}

inline bool operator==(const Surfaces& a, const Surfaces& b)
{
  return AreMetAlike(a, b) && a.Opacities == b.Opacities && a.ByGradient == b.ByGradient &&
    AreSame(a.ByArray, b.ByArray);
}

/// Isovalues from Low to High, both included.
struct ValueBand
{
  double Low, High;

  bool Holds(double isovalue) const { return this->Low <= isovalue && isovalue <= this->High; }
};

inline bool operator==(const ValueBand& a, const ValueBand& b)
{
  return a.Low == b.Low && a.High == b.High;
}

inline bool IsWithin(const ValueBand& inner, const ValueBand& outer)
{
  return outer.Holds(inner.Low) && outer.Holds(inner.High);
}

/// Opacities of isovalues for compositing. Empty if all are opaque, or if only shading knows them.
inline std::vector<float> AlphasOf(const Surfaces& surfaces)
{
  std::vector<float> alphas;
  for (std::size_t i = 0; i < surfaces.Opacities.size() && !surfaces.HasOpacityByPlace(); ++i)
  {
    alphas.push_back(static_cast<float>(surfaces.Opacities[i]));
  }
  return alphas;
}

/// A sample is *inside* where its difference from the isovalue is not negative.
template <typename Real>
bool IsInside(Real difference)
{
  return difference >= Real(0);
}

}

#endif
