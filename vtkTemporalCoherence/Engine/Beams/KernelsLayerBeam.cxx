// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Beams/LayerBeam.h"

#include <algorithm>
#include <array>
#include <cmath>

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Beams/KernelsLayerBeam.cxx"
#include <hwy/foreach_target.h>

#include "Beams/KernelsBeamTree-inl.h"
#include "Beams/KernelsHull-inl.h"
#include "Beams/KernelsLayerNotes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace BeamKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Between which distances rays may be in a cell.
struct CellPassages
{
  float Enter[RayBatch::Capacity], Leave[RayBatch::Capacity];
};

/// Finds the surfaces that the rays of a beam meet in cells. Single precision only leaves out rays
/// that do not pass a cell, or for which it proves that they meet nothing there.
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
    VisitInOrder(this->Places, this->Beam, cells, leaf, 1,
      [&](const glm::ivec3& place) HWY_ATTR { this->TestCell(leaf + place); });
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
    const typename Lattice::Cell box = this->Places.CellAt(cell);
    CellPassages passages;
    const std::uint64_t passing = this->FindPassing(box, passages) & this->Notes.LiveRays();
    if (passing == 0)
    {
      return;
    }
    this->Beam.CellsPassed += static_cast<std::int64_t>(hwy::PopCount(passing));
    bool isNearer = false;
    if (this->Task.HasCaps)
    {
      ForEachRay(
        passing, [&](std::size_t ray) HWY_ATTR { isNearer |= this->SearchFor(cell, ray); });
    }
    else
    {
      this->Scene.Read(cell, this->Levels);
      const std::uint64_t open = this->FindOpen(box, passages, passing);
      isNearer = open != 0 && this->SearchCell(cell, open);
    }
    if (isNearer)
    {
      MoveAcrossIfNearer(this->Beam);
    }
  }

  /// One bit for each ray that may pass a cell on its walk.
  HWY_INLINE std::uint64_t FindPassing(
    const typename Lattice::Cell& box, CellPassages& passages) const
  {
    const TileBeam& beam = this->Beam;
    const CellFaces faces(box, beam.Margin, beam.Flip);
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
          enter = hn::Max(enter, hn::MulAdd(Set(faces.Near[a]), inverse, toOrigin));
          leave = hn::Min(leave, hn::MulAdd(Set(faces.Far[a]), inverse, toOrigin));
        }
        else
        {
          const V origin = Load(&beam.Origin[a][i]);
          enter = hn::Max(enter, hn::Mul(hn::Sub(Set(faces.Near[a]), origin), inverse));
          leave = hn::Min(leave, hn::Mul(hn::Sub(Set(faces.Far[a]), origin), inverse));
        }
      }
      if (!IsPlain)
      {
        enter = hn::Max(enter, Load(&beam.Begin[i]));
      }
      const M isAhead = hn::Le(enter, hn::Min(leave, Load(&beam.Behind[i])));
      passing |= BitsOf(hn::And(isAhead, hn::Ge(leave, Load(&beam.WalkBegin[i])))) << i;
      hn::StoreU(enter, Floats(), passages.Enter + i);
      hn::StoreU(leave, Floats(), passages.Leave + i);
    }
    return passing;
  }

  /// One bit for each ray that may cross an isovalue in a cell. (CellSearch tells why.)
  HWY_INLINE std::uint64_t FindOpen(
    const typename Lattice::Cell& box, const CellPassages& passages, std::uint64_t passing) const
  {
    const TileBeam& beam = this->Beam;
    const float margin = beam.Margin * box.LargestShare();
    constexpr float most = 0x1p-5f;
    if (!(margin < most && this->Levels.AreAll()))
    {
      return this->Levels.Count > 0 ? passing : 0; // single precision tells nothing
    }
    std::uint64_t open = 0;
    for (std::size_t level = 0; level < this->Levels.Count; ++level)
    {
      const CellValues values = ValuesOf(InFloat(this->Levels.All[level].Corners));
      const V error = Set(values.Largest * (16.0f * margin + 0x1p-13f) + 1e-30f);
      for (std::size_t i = 0; i < RayBatch::Capacity; i += hn::Lanes(Floats()))
      {
        constexpr std::size_t lanes = hn::MaxLanes(Floats());
        const std::uint64_t which = passing >> i & ((std::uint64_t(1) << lanes) - 1);
        if (which == 0)
        {
          continue;
        }
        const M isPassed = MaskOf(which);
        const V enter = hn::IfThenElseZero(isPassed, Load(passages.Enter + i));
        const V leave = hn::IfThenElseZero(isPassed, Load(passages.Leave + i));
        V at[3], step[3];
        FindPathsIn(box, beam, enter, leave, i, at, step);
        const Coefficients b = CubicsAlong(values, at, step);
        const M isOutside = hn::Or(hn::Lt(b.Largest, hn::Neg(error)), hn::Gt(b.Smallest, error));
        const M isOpen = hn::AndNot(isOutside, isPassed);
        open |= BitsOf(hn::AndNot(this->CanOnlyExit(b, error, enter, leave, i), isOpen)) << i;
      }
    }
    return open;
  }

  /// Those of some rays that surely enter no solid in a cell, as the field falls along them. What
  /// is searched is as long as what was tested, but for the slack at both ends: at least half of
  /// it. So its coefficients fall, too, half as much at least: by more than rounding may move them,
  /// and their signs change once at most.
  HWY_INLINE M CanOnlyExit(const Coefficients& b, V error, V enter, V leave, std::size_t i) const
  {
    if (!(IsPlain && this->Task.IsSolid))
    {
      return hn::Lt(error, error);
    }
    const TileBeam& beam = this->Beam;
    const V end = hn::Min(leave, hn::Sub(Load(&beam.End[i]), Set(2.0f * beam.Margin)));
    const V slack = Load(&beam.Slack[i]), quarter = hn::Mul(Set(0.25f), hn::Sub(leave, enter));
    const M isLong = hn::And(hn::Lt(slack, quarter), hn::Lt(hn::Sub(leave, end), quarter));
    return hn::And(isLong, hn::Lt(b.LargestRise, hn::Mul(Set(-8.0f), error)));
  }

  /// Corners in single precision, in any unit.
  static std::array<float, 8> InFloat(const std::array<float, 8>& corners) { return corners; }
  static std::array<float, 8> InFloat(const std::array<double, 8>& corners)
  {
    double largest = 0.0;
    for (const double corner : corners)
    {
      largest = std::max(largest, std::abs(corner));
    }
    std::array<float, 8> shares;
    for (std::size_t i = 0; i < shares.size(); ++i)
    {
      shares[i] = static_cast<float>(corners[i] / largest);
    }
    return shares;
  }

  static CellValues ValuesOf(const std::array<float, 8>& corners)
  {
    CellValues values;
    for (std::size_t row = 0; row < 4; ++row)
    {
      values.Set(row, corners[2 * row], corners[2 * row + 1]);
    }
    return values;
  }

  /// Search a cell for some rays. \return true if one of them is full or opaque then
  HWY_INLINE bool SearchCell(const glm::ivec3& cell, std::uint64_t which)
  {
    bool isDone = false;
    if (this->Task.Grid)
    {
      ForEachRay(which, [&](std::size_t ray) HWY_ATTR { isDone |= this->SearchFor(cell, ray); });
      return isDone;
    }
    for (std::size_t i = 0; i < RayBatch::Capacity; i += RowOfRays)
    {
      const std::uint64_t inRow = which >> i & 0xffu;
      if (inRow != 0)
      {
        FindPaths(this->Task.Rays, i, inRow, cell, this->Paths);
        isDone |= this->SearchLevels(cell, i);
      }
    }
    return isDone;
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
  HWY_INLINE bool SearchLevels(const glm::ivec3& cell, std::size_t i)
  {
    // Where a walk begins in the cell, what is before that does not count. Of several isovalues it
    // has to be known which one a ray meets first.
    const std::uint64_t which = this->Paths.Which;
    const bool areMany = this->Levels.Count > MostLevels;
    const std::size_t count = areMany ? 0 : this->Levels.Count;
    const std::array<CellLevel<Real>, CellLevels<Real>::Most + 1>& levels = this->Levels.All;
    std::uint64_t oneByOne = areMany ? which : this->Paths.IsFirst, met = 0;
    for (std::size_t level = 0; level < count; ++level)
    {
      CellCrossings<Real>& found = this->Crossings[level];
      FindCrossings(this->Paths, levels[level].Corners, which & ~oneByOne, found);
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
    this->Scene.SearchCell(cell, ray, this->Notes.Known(), found);
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

  static constexpr std::size_t MostLevels = 4;

  const LayerTask& Task;
  const Lattice& Places;
  LayerBeamScene<Real>& Scene;
  TileBeam& Beam;
  LayerNotes<Real> Notes;
  CellLevels<Real> Levels; ///< of the present cell
  CellPaths<Real> Paths{}; ///< lanes without a ray hold finite numbers, too
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
