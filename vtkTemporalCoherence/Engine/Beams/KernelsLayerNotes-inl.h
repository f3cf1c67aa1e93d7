// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The layers that rays of a beam meet in cells: that there are such, and then where.
// Included by kernels once for each kind of vectors, hence the guard that turns over.
#if defined(TemporalCoherence_KernelsLayerNotes_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsLayerNotes_inl_h
#undef TemporalCoherence_KernelsLayerNotes_inl_h
#else
#define TemporalCoherence_KernelsLayerNotes_inl_h
#endif

#include "Beams/LayerBeam.h"

#include "Trace/KernelsSegment-inl.h"

#include <array>
#include <cmath>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace BeamKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;
namespace segments = SegmentKernels::HWY_NAMESPACE;

/// Rays that are searched together: a row of a tile.
constexpr std::size_t RowOfRays = 8;

/// A row of rays in a cell.
template <typename Real>
struct alignas(64) CellPaths
{
  Real Begin[3][RowOfRays], End[3][RowOfRays]; ///< in the coordinates of the cell
  double Enter[RowOfRays], Leave[RowOfRays];
  std::uint64_t Which;   ///< one bit for each that goes through it
  std::uint64_t IsFirst; ///< where a walk begins in the cell
};

/// Where cubics along these cross zero.
template <typename Real>
struct alignas(64) CellCrossings
{
  Real Cubic[4][RowOfRays];
  std::uint64_t Begins, Any, One; ///< SignChanges, one bit for each ray
};

/// Find the paths of a row of rays through a cell, from ray i on, as on walks.
/// \param which of them may pass it
template <typename Real>
HWY_INLINE void FindPaths(const RayBatch& rays, std::size_t i, std::uint64_t which,
  const glm::ivec3& cell, CellPaths<Real>& paths)
{
  const hn::CappedTag<double, RowOfRays> d;
  using Vector = hn::Vec<decltype(d)>;
  constexpr std::uint64_t lanes = (std::uint64_t(1) << hn::MaxLanes(d)) - 1;
  Vector place[3];
  for (int a = 0; a < 3; ++a)
  {
    place[a] = hn::Set(d, static_cast<double>(cell[a]));
  }
  std::uint64_t isOn = 0, isFirst = 0;
  for (std::size_t j = 0; j < RowOfRays; j += hn::Lanes(d))
  {
    if ((which >> j & lanes) == 0)
    {
      continue;
    }
    const std::size_t from = i + j;
    const auto path = segments::FindPath(d, segments::LoadRays(d, rays, from), place);
    for (std::size_t a = 0; a < 3; ++a)
    {
      segments::StoreAs(path.Begin[a], &paths.Begin[a][j]);
      segments::StoreAs(path.End[a], &paths.End[a][j]);
    }
    hn::StoreU(path.Enter, d, &paths.Enter[j]);
    hn::StoreU(path.Leave, d, &paths.Leave[j]);
    const Vector begin = hn::LoadU(d, &rays.WalkBegin[from]);
    const auto isOnWalk =
      hn::And(hn::Ge(path.Leave, begin), hn::Lt(path.Enter, hn::LoadU(d, &rays.WalkEnd[from])));
    isOn |= BitsIn(d, hn::And(hn::Lt(path.Enter, path.Leave), isOnWalk)) << j;
    isFirst |= BitsIn(d, hn::Le(path.Enter, begin)) << j;
  }
  paths.Which = isOn & which;
  paths.IsFirst = isFirst & paths.Which;
}

/// Find out where rays may pass an isovalue in a cell.
template <typename Real>
HWY_INLINE void FindCrossings(const CellPaths<Real>& paths, const std::array<Real, 8>& corners,
  std::uint64_t which, CellCrossings<Real>& found)
{
  const hn::CappedTag<Real, RowOfRays> d;
  using Vector = hn::Vec<decltype(d)>;
  constexpr std::uint64_t lanes = (std::uint64_t(1) << hn::MaxLanes(d)) - 1;
  std::uint64_t begins = 0, any = 0, one = 0;
  Vector samples[8];
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    samples[corner] = hn::Set(d, corners[corner]);
  }
  for (std::size_t j = 0; j < RowOfRays; j += hn::Lanes(d))
  {
    if ((which >> j & lanes) == 0)
    {
      continue;
    }
    Vector begin[3], end[3], b[4];
    for (std::size_t a = 0; a < 3; ++a)
    {
      begin[a] = hn::Load(d, &paths.Begin[a][j]);
      end[a] = hn::Load(d, &paths.End[a][j]);
    }
    segments::CubicsBetween(d, samples, begin, end, b);
    const auto changes = segments::FindChanges(d, b);
    for (std::size_t c = 0; c < 4; ++c)
    {
      hn::Store(b[c], d, &found.Cubic[c][j]);
    }
    begins |= BitsIn(d, changes.Begins) << j;
    any |= BitsIn(d, changes.Any) << j;
    one |= BitsIn(d, changes.One) << j;
  }
  found.Begins = begins;
  found.Any = any & which;
  found.One = one & which;
}

/// Notes which surface a ray meets next, and later finds where, for whole vectors of notes at once.
/// So it is known at once when a ray is full or opaque, but most of the work is done on vectors
/// without gaps.
template <typename Real>
class LayerNotes
{
public:
  LayerNotes(const RayBatch& rays, LayerBatch& layers)
    : Rays(rays)
    , Layers(layers)
    , Live(layers.Open)
    , Count(layers.Count)
    , Transmittance(layers.Transmittance)
  {
  }

  /// One bit for each ray that may meet more surfaces.
  std::uint64_t LiveRays() const { return this->Live; }

  /// Note that a ray meets a surface where a cubic crosses zero once.
  /// \param b of its coefficients
  /// \param enter, leave where the ray enters the cell and leaves it
  /// \return true if it is full or opaque then
  HWY_INLINE bool Note(std::size_t ray, std::int16_t surface, HitKind kind, const Real b[4],
    double enter, double leave)
  {
    if (this->Total == Capacity)
    {
      this->Finish();
    }
    const std::size_t at = this->Total++;
    for (std::size_t c = 0; c < 4; ++c)
    {
      this->Cubic[c][at] = b[c];
    }
    this->Enter[at] = enter;
    this->Leave[at] = leave;
    this->Ray[at] = static_cast<std::uint8_t>(ray);
    this->Surface[at] = surface;
    this->Kind[at] = kind;
    ++this->Count[ray];
    if (this->Layers.Alphas)
    {
      this->Transmittance[ray] = PassedBehind(
        this->Transmittance[ray], this->Layers.Alphas[static_cast<std::size_t>(surface)]);
    }
    if (this->Count[ray] < this->Layers.Limit && this->Transmittance[ray] != 0.0f)
    {
      return false;
    }
    this->Live &= ~(std::uint64_t(1) << ray);
    return true;
  }

  /// Layers that are known: those that are noted are not among them.
  const LayerBatch& Known() const { return this->Layers; }

  /// Note all that a ray meets in a cell. \return true if it is full or opaque then
  bool Note(std::size_t ray, const CellSurfaces& found)
  {
    // A cubic that crosses zero where it is known to.
    constexpr Real known[4] = { Real(-1), Real(-1), Real(1), Real(1) };
    for (std::size_t i = 0; i < found.Count; ++i)
    {
      const CellSurfaces::Met& met = found.All[i];
      if (this->Note(ray, met.Surface, met.Kind, known, met.Distance, met.Distance))
      {
        return true;
      }
    }
    return false;
  }

  /// Find where surfaces are, and append them to the layers of their rays.
  void Finish()
  {
    this->FindDistances();
    for (std::size_t i = 0; i < this->Total; ++i)
    {
      const std::size_t ray = this->Ray[i];
      const std::uint64_t bit = std::uint64_t(1) << ray;
      if (this->Unclear & bit)
      {
        continue;
      }
      const double last = this->Layers.LastDistance[ray], distance = this->Enter[i];
      // Farther behind the last than rounding may move either.
      constexpr double share = 0x1p-49;
      if (distance - last > share * std::abs(distance) && last < this->Rays.WalkEnd[ray])
      {
        this->Layers.Append(ray, distance, this->Kind[i], this->Surface[i]);
      }
      else
      {
        this->Unclear |= bit;
        this->Live &= ~bit;
      }
    }
    this->Total = 0;
  }

  /// One bit for each ray whose surfaces are too close together.
  std::uint64_t UnclearRays() const { return this->Unclear; }

private:
  static constexpr std::size_t Capacity = 256;
  template <typename T>
  using List = std::array<T, Capacity + WidestVector>;

  /// Replace Enter by the distance of the surface.
  HWY_INLINE void FindDistances()
  {
    const hn::CappedTag<Real, WidestVector> d;
    const auto all = hn::Eq(hn::Zero(d), hn::Zero(d));
    this->FillLastVector();
    alignas(64) Real shares[WidestVector];
    for (std::size_t i = 0; i < this->Total; i += hn::Lanes(d))
    {
      hn::Vec<decltype(d)> b[4];
      for (std::size_t c = 0; c < 4; ++c)
      {
        b[c] = hn::LoadU(d, &this->Cubic[c][i]);
      }
      hn::StoreU(segments::RefineCrossings<Real>(d, b, all), d, shares);
      for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
      {
        const double enter = this->Enter[i + lane];
        this->Enter[i + lane] =
          enter + static_cast<double>(shares[lane]) * (this->Leave[i + lane] - enter);
      }
    }
  }

  /// So that no lane is uninitialised.
  HWY_INLINE void FillLastVector()
  {
    const std::size_t end = WholeVectors(this->Total);
    for (std::size_t i = this->Total; i < end; ++i)
    {
      for (std::size_t c = 0; c < 4; ++c)
      {
        this->Cubic[c][i] = Real(c < 2 ? -1 : 1);
      }
      this->Enter[i] = this->Leave[i] = 0.0;
    }
  }

  const RayBatch& Rays;
  LayerBatch& Layers;
  std::uint64_t Live, Unclear = 0;
  // With what is noted:
  RayBatch::Array<std::uint8_t> Count;
  RayBatch::Array<float> Transmittance;

  std::size_t Total = 0;
  std::array<List<Real>, 4> Cubic;
  List<double> Enter, Leave;
  List<std::uint8_t> Ray;
  List<std::int16_t> Surface;
  List<HitKind> Kind;
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
