// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The light of cells in which emission is linear in the value, at two places of each path. Kernels
// include this file once for each kind of vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsEvenLight_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsEvenLight_inl_h
#undef TemporalCoherence_KernelsEvenLight_inl_h
#else
#define TemporalCoherence_KernelsEvenLight_inl_h
#endif

#include "Volumes/Beams/KernelsBeamPaths-inl.h"
#include "Volumes/Beams/KernelsEvenCells-inl.h"
#include "Volumes/Medium/KernelsEmittingSegments-inl.h"
#include "Volumes/Medium/KernelsLight-inl.h"
#include "Volumes/Medium/KernelsStretch-inl.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace EmissionKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Error from linear emission, in light that reaches the viewer: in a cell, and along a whole ray.
/// Errors add up, as a function bends to the same side in all cells.
constexpr float EmissionTolerance = 1.0f / 2048.0f, ToleranceOfRay = 1.0f / 64.0f;

/// While the error of a ray so far is below this, each cell gets the whole EmissionTolerance, so
/// that a function that bends in a few cells costs nothing.
constexpr float FreelyOff = 1.0f / 192.0f;

/// Error in a cell behind that limit, relative to its emitted light. The emitted light of a ray
/// sums up to less than 1.
constexpr float ToleranceOfDepth = 1.0f / 128.0f;

/// Error of quadrature at two points, in units of the tolerance, per squared turn of the normal.
/// The turn is 1 - the cosine of the angle between the points.
constexpr float MissedOfTurn = 600.0f;

/// Error per unit of light change between the two places, weighted by how differently the halves of
/// the segment let light through.
constexpr float MissedOfEdge = 5000.0f;

/// Limits for light at two places: the fourth power of the optical depth times the transmittance in
/// front, and the optical depth itself.
constexpr float MostFourthPower = 0.35f, MostEvenDepth = 2.0f;

/// Light of a vector of rays in a cell with linear emission.
struct EvenLight
{
  V Passed, Color[3];
  V Extinction[2]; ///< at the places of a pair
  V Depth;         ///< optical depth
  V Off;           ///< error of the light from linear emission
  M IsEven;        ///< linear emission is exact enough: Passed is right
  M IsRight;       ///< Passed and Color are right

  /// t of the centre of emission.
  HWY_INLINE V CentreOf(const CellPaths& paths) const
  {
    const Floats d;
    const V all = hn::Add(hn::Add(this->Extinction[0], this->Extinction[1]), hn::Set(d, 1e-30f));
    const V share = hn::Add(hn::Set(d, PlacePair::First),
      hn::Mul(hn::Set(d, PlacePair::Second - PlacePair::First), hn::Div(this->Extinction[1], all)));
    return hn::Add(paths.Enter, hn::Mul(share, paths.Length));
  }
};

/// Finds the light of cells with linear emission.
template <std::size_t Colors>
class EvenShader
{
public:
  /// \param cells that a ray may pass
  EvenShader(const EmittingVolume& volume, const LitRays& lit, int cells)
    : Emitting(volume)
    , Sharpness(volume.Sharpness())
    , OffInCell(std::min(EmissionTolerance, ToleranceOfRay / static_cast<float>(cells)))
  {
    for (std::size_t i = 0; i < RayBatch::Capacity; i += hn::Lanes(Floats()))
    {
      std::int32_t numbers[WidestVector];
      hn::StoreU(hn::Iota(Integers(), static_cast<std::int32_t>(i)), Integers(), numbers);
      this->Vectors[i / hn::MaxLanes(Floats())] = RayVectors(volume, lit, numbers);
    }
  }

  HWY_INLINE EvenLight FindLight(const EvenCell& cell, M passes, const CellPaths& paths) const
  {
    const Floats d;
    const V half = hn::Set(d, 0.5f), first = hn::Set(d, PlacePair::First),
            second = hn::Set(d, PlacePair::Second);
    V a[3], b[3];
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      a[axis] = hn::Add(paths.Begin[axis], hn::Mul(first, paths.Across[axis]));
      b[axis] = hn::Add(paths.Begin[axis], hn::Mul(second, paths.Across[axis]));
    }
    const V valueA = cell.Value.At(a), valueB = cell.Value.At(b);
    const V zero = hn::Zero(d);
    const V emittedA = hn::Max(cell.Emitted.At(0, valueA), zero);
    const V emittedB = hn::Max(cell.Emitted.At(0, valueB), zero);
    EvenLight light;
    light.Depth = hn::Mul(hn::Mul(half, paths.Length), hn::Add(emittedA, emittedB));
    const V square = hn::Mul(light.Depth, light.Depth);
    const V off = hn::Mul(hn::Mul(hn::Set(d, cell.Emitted.Off), paths.Length), paths.Shown);
    const V most = hn::Set(d, EmissionTolerance);
    const V ofDepth = hn::Mul(hn::Mul(light.Depth, paths.Shown), hn::Set(d, ToleranceOfDepth));
    const V least = hn::Min(hn::Max(ofDepth, hn::Set(d, this->OffInCell)), most);
    const M isEarly = hn::And(hn::Gt(light.Depth, zero), hn::Lt(paths.Off, hn::Set(d, FreelyOff)));
    light.Off = hn::IfThenElseZero(hn::Gt(light.Depth, zero), off);
    const V mayBeOff = hn::IfThenElse(isEarly, most, least);
    light.IsEven =
      hn::And(hn::And(hn::Le(off, mayBeOff), hn::Le(light.Depth, hn::Set(d, MostEvenDepth))),
        hn::Le(hn::Mul(hn::Mul(square, square), paths.Shown), hn::Set(d, MostFourthPower)));
    if (!this->Emitting.ByGradient.Opacities.empty())
    {
      light.IsEven = hn::Lt(half, zero);
    }
    light.IsRight = light.IsEven;
    light.Extinction[0] = emittedA;
    light.Extinction[1] = emittedB;
    light.Passed = ExpOfLittle(hn::Min(light.Depth, hn::Set(d, MostEvenDepth)));
    if (hn::AllFalse(d, hn::And(light.IsRight, passes)))
    {
      light.Color[0] = light.Color[1] = light.Color[2] = zero;
      return light;
    }
    this->AddLight(cell, paths, { a, b }, { valueA, valueB }, { emittedA, emittedB }, light);
    return light;
  }

private:
  /// Two places on each path.
  struct Places
  {
    const V* At[2];
  };
  struct Pair
  {
    V Of[2];
  };

  HWY_INLINE void AddLight(const EvenCell& cell, const CellPaths& paths, const Places& places,
    const Pair& values, const Pair& emitted, EvenLight& light) const
  {
    const Floats d;
    const V half = hn::Set(d, 0.5f), most = hn::Set(d, MostEvenDepth);
    // The optical depth in front of each place, for linear extinction.
    const V bend = hn::Mul(hn::Mul(hn::Set(d, 0.5f * PlacePair::FromMiddle), paths.Length),
      hn::Sub(emitted.Of[1], emitted.Of[0]));
    const V before[2] = { hn::Sub(hn::Mul(light.Depth, hn::Set(d, PlacePair::First)), bend),
      hn::Sub(hn::Mul(light.Depth, hn::Set(d, PlacePair::Second)), bend) };
    ReflectedLight<V, Colors> lit[2];
    if (this->Emitting.Lights)
    {
      light.IsRight =
        hn::And(light.IsRight, this->Shine(cell, paths, places, light.Depth, emitted, lit));
    }
    else
    {
      LightLine<Colors> own;
      own.SetUnlit();
      std::copy_n(own.At, 2, lit);
    }
    for (V& color : light.Color)
    {
      color = hn::Zero(d);
    }
    for (std::size_t place = 0; place < 2; ++place)
    {
      const V passed = ExpOfLittle(hn::Min(hn::Max(before[place], hn::Zero(d)), most));
      const V weight = hn::Mul(hn::Mul(half, paths.Length), passed);
      for (std::size_t c = 0; c < 3; ++c)
      {
        const std::size_t color = Colors == 1 ? 0 : c;
        const V own = cell.Emitted.At(c + 1, values.Of[place]);
        const V sum = hn::Add(hn::Mul(own, lit[place].Matt[color]),
          hn::Mul(emitted.Of[place], lit[place].Shine[color]));
        const V shown = hn::Min(hn::Max(sum, hn::Zero(d)), emitted.Of[place]);
        light.Color[c] = hn::Add(light.Color[c], hn::Mul(weight, shown));
      }
    }
  }

  /// Find the light at two places.
  /// \return rays for which two places are exact enough
  HWY_INLINE M Shine(const EvenCell& cell, const CellPaths& paths, const Places& places, V depth,
    const Pair& emitted, ReflectedLight<V, Colors> lit[2]) const
  {
    const Floats d;
    const RayVectors& rays = this->Vectors[paths.Ray / hn::MaxLanes(d)];
    const float shares[2] = { PlacePair::First, PlacePair::Second };
    V normals[2][3], points[2][3];
    for (std::size_t place = 0; place < 2; ++place)
    {
      rays.PointAt(
        hn::Add(paths.Enter, hn::Mul(hn::Set(d, shares[place]), paths.Length)), points[place]);
      for (std::size_t a = 0; a < 3; ++a)
      {
        normals[place][a] = cell.Toward[a].At(places.At[place]);
      }
    }
    const V cosine = CosineOfEnds(normals[0], normals[1]);
    MakeUnit(normals[0]);
    MakeUnit(normals[1]);
    const LitPoints at[2] = { { normals[0], rays.Direction, points[0] },
      { normals[1], rays.Direction, points[1] } };
    const V hidden = ReflectBoth<Colors, V>(*this->Emitting.Lights, at, lit);
    // The error of two places grows with the fourth power of the angle.
    const V seen = hn::Mul(paths.Shown, hn::Min(depth, hn::Set(d, 1.0f)));
    const V turn =
      hn::Mul(hn::Set(d, this->Sharpness), TurnOf(CosineBetween(normals[0], normals[1]), cosine));
    const V ofTurn = hn::Mul(hn::Mul(turn, turn), hn::Set(d, MissedOfTurn));
    const V change = hn::Mul(paths.Length, hn::Abs(hn::Sub(emitted.Of[1], emitted.Of[0])));
    const V uneven = hn::Add(hn::Mul(depth, depth), change);
    const V ofEdge =
      hn::Mul(hn::Mul(hidden, paths.Shown), hn::Mul(uneven, hn::Set(d, MissedOfEdge)));
    return hn::Le(hn::Add(hn::Mul(ofTurn, seen), ofEdge), hn::Set(d, 1.0f));
  }

  const EmittingVolume& Emitting;
  float Sharpness;
  float OffInCell; ///< tolerance in any cell
  RayVectors Vectors[RayBatch::Capacity / hn::MaxLanes(Floats())];
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
