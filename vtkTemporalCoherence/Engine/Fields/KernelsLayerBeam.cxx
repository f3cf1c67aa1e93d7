// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Fields/LayerBeam.h"

#include <algorithm>
#include <array>

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Fields/KernelsLayerBeam.cxx"
#include <hwy/foreach_target.h>

#include "Fields/KernelsBeamTree-inl.h"
#include "Fields/KernelsLayerNotes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace BeamKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// One bit for each lane.
template <class D>
HWY_INLINE std::uint64_t BitsIn(D d, hn::Mask<D> mask)
{
  std::uint8_t bits[8] = { 0 };
  hn::StoreMaskBits(d, mask, bits);
  return static_cast<std::uint64_t>(bits[0]) | static_cast<std::uint64_t>(bits[1]) << 8;
}

/// A vector of rays in a cell.
template <typename Real>
struct alignas(64) CellPaths
{
  Real Begin[3][WidestVector], End[3][WidestVector]; ///< in the coordinates of the cell
  double Enter[WidestVector], Leave[WidestVector];
  std::uint64_t Which;   ///< one bit for each that goes through it
  std::uint64_t IsFirst; ///< where a walk begins in the cell
};

/// Where cubics along these cross zero.
template <typename Real>
struct alignas(64) CellCrossings
{
  Real Cubic[4][WidestVector];
  std::uint64_t Begins, Any, One; ///< SignChanges, one bit for each ray
};

/// Finds the surfaces that the rays of a beam meet in cells. Single precision, with the margin of
/// the beam, only leaves out rays that do not pass a cell.
/// \tparam IsPlain that of the beam
/// \tparam Lattice tells where cells lie (KernelsLattice-inl.h)
template <typename Real, bool IsPlain, class Lattice>
class LayerCells
{
public:
  LayerCells(const LayerTask& task, const Lattice& places, LayerBeamScene<Real>& scene,
    TileBeam& beam, LayerBatch& layers)
    : Task(task)
    , Places(places)
    , Scene(scene)
    , Beam(beam)
    , Notes(task.Rays, layers)
  {
  }

  /// Test cells of a leaf, one bit each in the order in which the beam meets them.
  HWY_INLINE void TestCells(const glm::ivec3& leaf, std::uint64_t cells)
  {
    const TileBeam& beam = this->Beam;
    const auto reach = this->Places.ReachIn(leaf, 1);
    for (; cells != 0; cells &= cells - 1)
    {
      const int cell = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero64(cells)) ^ beam.Flip;
      if (reach.Of(cell) >= beam.Around.Offset[TileBeam::Across])
      {
        this->TestCell(leaf + glm::ivec3(cell & 3, cell >> 2 & 3, cell >> 4));
      }
    }
  }

  /// \return one bit for each ray that must walk
  std::uint64_t Finish()
  {
    this->Notes.Finish();
    return this->Notes.UnclearRays();
  }

private:
  /// Search a cell for the rays that may pass it.
  void TestCell(const glm::ivec3& cell)
  {
    const std::uint64_t passing = this->FindPassing(cell) & this->Notes.LiveRays();
    if (passing == 0)
    {
      return;
    }
    this->Beam.CellsPassed += static_cast<std::int64_t>(hwy::PopCount(passing));
    bool isNearer = false;
    if (this->Task.AreOneByOne)
    {
      ForEachRay(
        passing, [&](std::size_t ray) HWY_ATTR { isNearer |= this->SearchFor(cell, ray); });
    }
    else
    {
      std::size_t count = 0;
      const CellLevel<Real>* const levels = this->Scene.Read(cell, count);
      for (std::size_t i = 0; i < RayBatch::Capacity; i += WidestVector)
      {
        const std::uint64_t which = passing >> i & 0xffffu;
        if (which != 0)
        {
          this->FindPaths(cell, which, i);
          isNearer |= this->SearchLevels(cell, levels, count, i);
        }
      }
    }
    if (isNearer)
    {
      this->FindDepth();
    }
  }

  /// One bit for each ray that may pass a cell on its walk.
  HWY_INLINE std::uint64_t FindPassing(const glm::ivec3& cell) const
  {
    const TileBeam& beam = this->Beam;
    const typename Lattice::Cell box = this->Places.CellAt(cell);
    float planes[2][3];
    for (std::size_t a = 0; a < 3; ++a)
    {
      const bool isBack = beam.Flip >> (2 * a) & 1;
      const float low = box.Low(a) - beam.Margin, high = box.High(a) + beam.Margin;
      planes[0][a] = isBack ? high : low;
      planes[1][a] = isBack ? low : high;
    }
    std::uint64_t passing = 0;
    for (std::size_t i = 0; i < RayBatch::Capacity; i += hn::Lanes(Floats()))
    {
      V enter = Set(-TileBeam::Never), leave = Set(TileBeam::Never);
      for (std::size_t a = 0; a < 3; ++a)
      {
        const V inverse = Load(&beam.Inverse[a][i]);
        if constexpr (IsPlain)
        {
          const V toOrigin = Load(&beam.ToOrigin[a][i]);
          enter = hn::Max(enter, hn::MulAdd(Set(planes[0][a]), inverse, toOrigin));
          leave = hn::Min(leave, hn::MulAdd(Set(planes[1][a]), inverse, toOrigin));
        }
        else
        {
          const V origin = Load(&beam.Origin[a][i]);
          enter = hn::Max(enter, hn::Mul(hn::Sub(Set(planes[0][a]), origin), inverse));
          leave = hn::Min(leave, hn::Mul(hn::Sub(Set(planes[1][a]), origin), inverse));
        }
      }
      const M isAhead = hn::Le(enter, hn::Min(leave, Load(&beam.Behind[i])));
      passing |= BitsOf(hn::And(isAhead, hn::Ge(leave, Load(&beam.WalkBegin[i])))) << i;
    }
    return passing;
  }

  /// Find the paths of rays through a cell, from ray i on.
  /// \param which of them may pass it
  HWY_INLINE void FindPaths(const glm::ivec3& cell, std::uint64_t which, std::size_t i)
  {
    const hn::CappedTag<double, WidestVector / 2> d;
    using Vector = hn::Vec<decltype(d)>;
    const RayBatch& rays = this->Task.Rays;
    constexpr std::uint64_t lanes = (std::uint64_t(1) << hn::MaxLanes(d)) - 1;
    CellPaths<Real>& paths = this->Paths;
    Vector place[3];
    for (int a = 0; a < 3; ++a)
    {
      place[a] = hn::Set(d, static_cast<double>(cell[a]));
    }
    paths.Which = paths.IsFirst = 0;
    for (std::size_t j = 0; j < WidestVector; j += hn::Lanes(d))
    {
      if ((which >> j & lanes) == 0)
      {
        continue;
      }
      const std::size_t from = i + j;
      segments::RayVector<Vector> lines;
      for (std::size_t a = 0; a < 3; ++a)
      {
        lines.Origin[a] = hn::LoadU(d, &rays.Origin[a][from]);
        lines.Direction[a] = hn::LoadU(d, &rays.Direction[a][from]);
        lines.Inverse[a] = hn::LoadU(d, &rays.Inverse[a][from]);
      }
      lines.Begin = hn::LoadU(d, &rays.Begin[from]);
      lines.End = hn::LoadU(d, &rays.End[from]);
      const auto path = segments::FindPath(d, lines, place);
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
      paths.Which |= BitsIn(d, hn::And(hn::Lt(path.Enter, path.Leave), isOnWalk)) << j;
      paths.IsFirst |= BitsIn(d, hn::Le(path.Enter, begin)) << j;
    }
    paths.Which &= which;
    paths.IsFirst &= paths.Which;
  }

  /// Find out where rays may pass an isovalue in a cell.
  HWY_INLINE void FindCrossings(
    const Corners<Real>& corners, std::uint64_t which, CellCrossings<Real>& found) const
  {
    const hn::CappedTag<Real, WidestVector> d;
    using Vector = hn::Vec<decltype(d)>;
    constexpr std::uint64_t lanes = (std::uint64_t(1) << hn::MaxLanes(d)) - 1;
    const CellPaths<Real>& paths = this->Paths;
    found.Begins = found.Any = found.One = 0;
    Vector samples[8];
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      samples[corner] = hn::Set(d, corners[corner]);
    }
    for (std::size_t j = 0; j < WidestVector; j += hn::Lanes(d))
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
      found.Begins |= BitsIn(d, changes.Begins) << j;
      found.Any |= BitsIn(d, changes.Any) << j;
      found.One |= BitsIn(d, changes.One) << j;
    }
    found.Any &= which;
    found.One &= which;
  }

  /// Note where some rays of a vector cross an isovalue.
  /// \return true if one of them is full or opaque then
  HWY_INLINE bool NoteCrossings(
    const CellCrossings<Real>& found, std::uint64_t which, std::int16_t surface, std::size_t i)
  {
    bool isDone = false;
    const std::uint64_t one = found.One & which;
    ForEachRay(this->Task.IsSolid ? one & ~found.Begins : one,
      [&](std::size_t lane) HWY_ATTR
      {
        const Real b[4] = { found.Cubic[0][lane], found.Cubic[1][lane], found.Cubic[2][lane],
          found.Cubic[3][lane] };
        const HitKind kind = found.Begins >> lane & 1u ? HitKind::Exit : HitKind::Entry;
        const bool isLast = this->Notes.Note(
          i + lane, surface, kind, b, this->Paths.Enter[lane], this->Paths.Leave[lane]);
        isDone |= this->EndIf(isLast, i + lane);
      });
    ForEachRay(found.Any & ~found.One & which,
      [&](std::size_t lane) HWY_ATTR
      {
        CellSurfaces all;
        this->FindSeveral(found, lane, surface, all);
        isDone |= this->EndIf(this->Notes.Note(i + lane, all), i + lane);
      });
    return isDone;
  }

  /// Find where a ray crosses an isovalue that it may cross several times.
  void FindSeveral(const CellCrossings<Real>& found, std::size_t lane, std::int16_t surface,
    CellSurfaces& all) const
  {
    const double enter = this->Paths.Enter[lane], leave = this->Paths.Leave[lane];
    bool isInside = found.Begins >> lane & 1u;
    VisitCrossings(Cubic<Real>{ found.Cubic[0][lane], found.Cubic[1][lane], found.Cubic[2][lane],
                     found.Cubic[3][lane] },
      [&](Real share)
      {
        isInside = !isInside;
        if (isInside || !this->Task.IsSolid)
        {
          all.All[all.Count++] = { enter + static_cast<double>(share) * (leave - enter),
            isInside ? HitKind::Entry : HitKind::Exit, surface };
        }
        return false;
      });
  }

  /// Search a cell for rays from i on, whose paths are known.
  /// \return true if one of them is full or opaque then
  HWY_INLINE bool SearchLevels(
    const glm::ivec3& cell, const CellLevel<Real>* levels, std::size_t count, std::size_t i)
  {
    // Where a walk begins in the cell, what is before that does not count. Of several isovalues it
    // has to be known which one a ray meets first.
    const std::uint64_t which = this->Paths.Which;
    std::uint64_t oneByOne = count > MostLevels ? which : this->Paths.IsFirst, met = 0;
    count = count > MostLevels ? 0 : count;
    for (std::size_t level = 0; level < count; ++level)
    {
      CellCrossings<Real>& found = this->Crossings[level];
      this->FindCrossings(levels[level].Corners, which & ~oneByOne, found);
      oneByOne |= met & found.Any;
      met |= found.Any;
    }
    bool isDone = false;
    for (std::size_t level = 0; level < count; ++level)
    {
      isDone |= this->NoteCrossings(this->Crossings[level], ~oneByOne, levels[level].Surface, i);
    }
    ForEachRay(
      oneByOne, [&](std::size_t lane) HWY_ATTR { isDone |= this->SearchFor(cell, i + lane); });
    return isDone;
  }

  /// Let the scene search a cell for one ray. \return true if it is full or opaque then
  bool SearchFor(const glm::ivec3& cell, std::size_t ray)
  {
    CellSurfaces found;
    this->Scene.SearchCell(cell, ray, found);
    return this->EndIf(this->Notes.Note(ray, found), ray);
  }

  /// End a ray if it is full or opaque.
  HWY_INLINE bool EndIf(bool isDone, std::size_t ray)
  {
    if (isDone)
    {
      this->Beam.Behind[ray] = -TileBeam::Never;
    }
    return isDone;
  }

  /// Move the plane across the beam to where all that matters ends.
  void FindDepth()
  {
    TileBeam& beam = this->Beam;
    V depth = Set(-1e30f);
    for (std::size_t i = 0; i < beam.Count; i += hn::Lanes(Floats()))
    {
      const V along = hn::Mul(Load(&beam.Behind[i]), Load(&beam.PerDepth[i]));
      depth = hn::Max(depth, hn::Add(Load(&beam.AtDepth[i]), along));
    }
    beam.Around.Offset[TileBeam::Across] =
      -(hn::GetLane(hn::MaxOfLanes(Floats(), depth)) + 4.0f * beam.Margin);
  }

  static constexpr std::size_t MostLevels = 4;

  const LayerTask& Task;
  const Lattice& Places;
  LayerBeamScene<Real>& Scene;
  TileBeam& Beam;
  LayerNotes<Real> Notes;
  CellPaths<Real> Paths;
  CellCrossings<Real> Crossings[MostLevels];
};

template <bool IsPlain, typename Real, class Lattice>
std::uint64_t SearchIn(const Lattice& lattice, const LayerTask& task, LayerBeamScene<Real>& scene,
  TileBeam& beam, LayerBatch& layers)
{
  using Search = LayerCells<Real, IsPlain, Lattice>;
  Search search(task, lattice, scene, beam, layers);
  BeamTree<Search, Lattice>(task.Active, scene, lattice, beam, search).Visit();
  return search.Finish();
}

template <typename Real>
std::uint64_t SearchAll(
  const LayerTask& task, LayerBeamScene<Real>& scene, TileBeam& beam, LayerBatch& layers)
{
  const UniformLattice lattice(beam);
  return beam.IsPlain ? SearchIn<true>(lattice, task, scene, beam, layers)
                      : SearchIn<false>(lattice, task, scene, beam, layers);
}

std::uint64_t LayersFloat(
  const LayerTask& task, LayerBeamScene<float>& scene, TileBeam& beam, LayerBatch& layers)
{
  return SearchAll(task, scene, beam, layers);
}

std::uint64_t LayersDouble(
  const LayerTask& task, LayerBeamScene<double>& scene, TileBeam& beam, LayerBatch& layers)
{
  if (task.Grid)
  {
    return SearchIn<false>(RectilinearLattice(beam, *task.Grid), task, scene, beam, layers);
  }
  return SearchAll(task, scene, beam, layers);
}

}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{
namespace BeamKernels
{
HWY_EXPORT(LayersFloat);
HWY_EXPORT(LayersDouble);
}

std::uint64_t SearchLayers(
  const LayerTask& task, LayerBeamScene<float>& scene, TileBeam& beam, LayerBatch& layers)
{
  using namespace BeamKernels;
  return HWY_DYNAMIC_DISPATCH(LayersFloat)(task, scene, beam, layers);
}

std::uint64_t SearchLayers(
  const LayerTask& task, LayerBeamScene<double>& scene, TileBeam& beam, LayerBatch& layers)
{
  using namespace BeamKernels;
  return HWY_DYNAMIC_DISPATCH(LayersDouble)(task, scene, beam, layers);
}

}
#endif
