// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/LayerBeam.h"

#include <algorithm>
#include <array>
#include <cmath>

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Lattice/KernelsLayerBeam.cxx"
#include <hwy/foreach_target.h>

#include "Lattice/KernelsBeamTree-inl.h"
#include "Lattice/KernelsHull-inl.h"
#include "Lattice/KernelsSegment-inl.h"

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

/// Load indices for gathers into vectors of D.
template <class D>
HWY_INLINE hn::Vec<hn::RebindToSigned<D>> PlacesFor(D, const std::int32_t* numbers)
{
  const hn::RebindToSigned<D> di;
  if constexpr (sizeof(hn::TFromD<D>) == sizeof(std::int32_t))
  {
    return hn::LoadU(di, numbers);
  }
  else
  {
    return hn::PromoteTo(di, hn::LoadU(hn::Rebind<std::int32_t, D>(), numbers));
  }
}

/// Gather a vector of rays of a batch.
template <class D>
HWY_INLINE segments::RayVector<hn::Vec<D>> GatherRays(
  D d, const RayBatch& rays, hn::Vec<hn::RebindToSigned<D>> at)
{
  segments::RayVector<hn::Vec<D>> gathered;
  for (std::size_t a = 0; a < 3; ++a)
  {
    gathered.Origin[a] = hn::GatherIndex(d, rays.Origin[a].data(), at);
    gathered.Direction[a] = hn::GatherIndex(d, rays.Direction[a].data(), at);
    gathered.Inverse[a] = hn::GatherIndex(d, rays.Inverse[a].data(), at);
  }
  gathered.Begin = hn::GatherIndex(d, rays.Begin.data(), at);
  gathered.End = hn::GatherIndex(d, rays.End.data(), at);
  return gathered;
}

/// Crossings of a vector of pairs of a ray and a cell. Words have one bit for each pair.
template <typename Real>
struct alignas(64) CellCrossings
{
  Real Begin[3][WidestVector], End[3][WidestVector]; ///< in the coordinates of the cell
  double Enter[WidestVector], Leave[WidestVector];
  Real Cubic[4][WidestVector];    ///< along the ray in the cell
  Real Share[WidestVector];       ///< of the path, where the cubic crosses zero if it does so once
  std::uint64_t Which;            ///< the ray goes through the cell
  std::uint64_t IsFirst;          ///< and its walk begins in the cell
  std::uint64_t Begins, Any, One; ///< SignChanges
};

/// Collects pairs of a ray and a cell that may hold surfaces, and searches whole vectors of pairs
/// at once: the pairs of one cell would leave most lanes empty.
template <typename Real>
class LayerNotes
{
public:
  LayerNotes(const LayerTask& task, LayerBeamScene<Real>& scene, LayerBatch& layers)
    : Task(task)
    , Scene(scene)
    , Layers(layers)
  {
  }

  /// One bit for each ray that may meet more surfaces behind the cells searched so far.
  std::uint64_t LiveRays() const { return this->Layers.Open & ~this->Unclear; }

  /// Note rays that may cross one isovalue in a cell, but no other isovalue.
  void Note(const glm::ivec3& cell, const CellLevel<Real>& level, std::uint64_t which)
  {
    this->NoteIn(cell, level.Surface, level.Corners, which);
  }

  /// Note rays that may cross any isovalues in a cell.
  void Note(const glm::ivec3& cell, std::uint64_t which)
  {
    this->NoteIn(cell, Frame::NoSurface, {}, which);
  }

  /// True if the pairs must be searched before the next cell.
  bool IsFull() const { return this->Total >= Full; }

  /// Search the pairs, and append the surfaces found to the rays' layers. Rays that become full or
  /// opaque are no longer live.
  void Search()
  {
    // On grids and for caps a cubic does not suffice, so the scene searches all cells.
    const bool areCubics = !(this->Task.Grid || this->Task.HasCaps);
    this->FillLastVector();
    for (std::size_t i = 0; i < this->Total; i += WidestVector)
    {
      if (areCubics)
      {
        this->FindPaths(i);
        this->FindCrossings(i);
      }
      this->AppendFound(i, areCubics);
    }
    this->Total = this->Cells = 0;
  }

  /// One bit for each ray whose surfaces lie too close together to sort.
  std::uint64_t UnclearRays() const { return this->Unclear; }

private:
  static constexpr std::size_t Full = 64;
  static constexpr std::size_t Capacity =
    Full + RayBatch::Capacity; ///< one cell adds a tile's rays at most
  template <typename T>
  using List = std::array<T, Capacity>;

  HWY_INLINE void NoteIn(const glm::ivec3& cell, SurfaceIndex surface,
    const std::array<Real, 8>& corners, std::uint64_t which)
  {
    if (which == 0)
    {
      return;
    }
    const std::size_t number = this->Cells++;
    this->Place[number] = cell;
    this->Surface[number] = surface;
    this->Corners[number] = corners;
    for (; which != 0; which &= which - 1)
    {
      const std::size_t at = this->Total++;
      this->Ray[at] = static_cast<std::int32_t>(hwy::Num0BitsBelowLS1Bit_Nonzero64(which));
      this->Cell[at] = static_cast<std::int32_t>(number);
    }
  }

  /// Repeat the first pair, so that no lane is uninitialised.
  void FillLastVector()
  {
    for (std::size_t i = this->Total; i < WholeVectors(this->Total); ++i)
    {
      this->Ray[i] = this->Ray[0];
      this->Cell[i] = this->Cell[0];
    }
  }

  /// Find the paths of a vector of pairs from pair i on, with the arithmetic of walks.
  HWY_INLINE void FindPaths(std::size_t i)
  {
    const hn::CappedTag<double, WidestVector> d;
    const hn::Rebind<std::int32_t, decltype(d)> dn;
    std::uint64_t isOn = 0, isFirst = 0;
    for (std::size_t j = 0; j < WidestVector; j += hn::Lanes(d))
    {
      const auto ray = PlacesFor(d, &this->Ray[i + j]);
      const auto number = hn::Mul(hn::LoadU(dn, &this->Cell[i + j]), hn::Set(dn, 3));
      hn::Vec<decltype(d)> cell[3];
      for (int a = 0; a < 3; ++a)
      {
        cell[a] = hn::PromoteTo(d, hn::GatherIndex(dn, &this->Place[0][a], number));
      }
      const auto path = segments::FindPath(d, GatherRays(d, this->Task.Rays, ray), cell);
      for (std::size_t a = 0; a < 3; ++a)
      {
        segments::StoreAs(path.Begin[a], &this->Found.Begin[a][j]);
        segments::StoreAs(path.End[a], &this->Found.End[a][j]);
      }
      hn::StoreU(path.Enter, d, &this->Found.Enter[j]);
      hn::StoreU(path.Leave, d, &this->Found.Leave[j]);
      const auto begin = hn::GatherIndex(d, this->Task.Rays.WalkBegin.data(), ray);
      const auto end = hn::GatherIndex(d, this->Task.Rays.WalkEnd.data(), ray);
      const auto isOnWalk = hn::And(hn::Ge(path.Leave, begin), hn::Lt(path.Enter, end));
      isOn |= BitsIn(d, hn::And(hn::Lt(path.Enter, path.Leave), isOnWalk)) << j;
      isFirst |= BitsIn(d, hn::Le(path.Enter, begin)) << j;
    }
    this->Found.Which = isOn;
    this->Found.IsFirst = isFirst;
  }

  /// Find the crossings of a vector of pairs from pair i on, along the paths of FindPaths.
  HWY_INLINE void FindCrossings(std::size_t i)
  {
    const hn::CappedTag<Real, WidestVector> d;
    CellCrossings<Real>& found = this->Found;
    std::uint64_t begins = 0, any = 0, one = 0;
    for (std::size_t j = 0; j < WidestVector; j += hn::Lanes(d))
    {
      hn::Vec<decltype(d)> corners[8], begin[3], end[3], b[4];
      const auto number = hn::ShiftLeft<3>(PlacesFor(d, &this->Cell[i + j]));
      for (std::size_t corner = 0; corner < 8; ++corner)
      {
        corners[corner] = hn::GatherIndex(d, &this->Corners[0][corner], number);
      }
      for (std::size_t a = 0; a < 3; ++a)
      {
        begin[a] = hn::Load(d, &found.Begin[a][j]);
        end[a] = hn::Load(d, &found.End[a][j]);
      }
      segments::CubicsBetween(d, corners, begin, end, b);
      const auto changes = segments::FindChanges(d, b);
      for (std::size_t c = 0; c < 4; ++c)
      {
        hn::Store(b[c], d, &found.Cubic[c][j]);
      }
      hn::Store(segments::RefineCrossings<Real>(d, b, changes.One), d, &found.Share[j]);
      begins |= BitsIn(d, changes.Begins) << j;
      any |= BitsIn(d, changes.Any) << j;
      one |= BitsIn(d, changes.One) << j;
    }
    found.Begins = begins;
    found.Any = any;
    found.One = one;
  }

  /// Append the surfaces found from pair i on. Each ray's pairs are sorted along the ray.
  HWY_INLINE void AppendFound(std::size_t i, bool areCubics)
  {
    const std::size_t count = std::min(this->Total - i, WidestVector);
    std::uint64_t which = (std::uint64_t(1) << count) - 1;
    if (areCubics)
    {
      which &= this->Found.Which;
    }
    ForEachRay(which,
      [&](std::size_t lane) HWY_ATTR
      {
        const auto ray = static_cast<std::size_t>(this->Ray[i + lane]);
        if ((this->LiveRays() >> ray & 1u) == 0)
        {
          return;
        }
        const auto cell = static_cast<std::size_t>(this->Cell[i + lane]);
        // SearchCell ignores surfaces before a walk's begin in the cell, and sorts crossings of
        // several isovalues.
        if (!areCubics || this->Surface[cell] == Frame::NoSurface ||
          (this->Found.IsFirst >> lane & 1u) != 0)
        {
          CellSurfaces met;
          this->Scene.SearchCell(this->Place[cell], ray, this->Layers, met);
          this->Append(ray, met);
        }
        else if ((this->Found.One >> lane & 1u) != 0)
        {
          const bool isExit = (this->Found.Begins >> lane & 1u) != 0;
          if (!(isExit && this->Task.IsSolid))
          {
            this->Append(ray, this->DistanceAt(lane, this->Found.Share[lane]),
              isExit ? HitKind::Exit : HitKind::Entry, this->Surface[cell]);
          }
        }
        else if ((this->Found.Any >> lane & 1u) != 0)
        {
          CellSurfaces met;
          this->FindSeveral(lane, this->Surface[cell], met);
          this->Append(ray, met);
        }
      });
  }

  double DistanceAt(std::size_t lane, Real share) const
  {
    const double enter = this->Found.Enter[lane];
    return enter + static_cast<double>(share) * (this->Found.Leave[lane] - enter);
  }

  /// Find all crossings of one isovalue, which a ray may cross several times.
  void FindSeveral(std::size_t lane, SurfaceIndex surface, CellSurfaces& all) const
  {
    const auto& b = this->Found.Cubic;
    bool isInside = (this->Found.Begins >> lane & 1u) != 0;
    VisitCrossings(Cubic<Real>{ b[0][lane], b[1][lane], b[2][lane], b[3][lane] },
      [&](Real share)
      {
        isInside = !isInside;
        if (isInside || !this->Task.IsSolid)
        {
          all.All[all.Count++] = { this->DistanceAt(lane, share),
            isInside ? HitKind::Entry : HitKind::Exit, surface };
        }
        return false;
      });
  }

  void Append(std::size_t ray, const CellSurfaces& met)
  {
    for (std::size_t i = 0; i < met.Count && (this->LiveRays() >> ray & 1u) != 0; ++i)
    {
      this->Append(ray, met.All[i].Distance, met.All[i].Kind, met.All[i].Surface);
    }
  }

  /// Append a surface to the layers of a live ray.
  HWY_INLINE void Append(std::size_t ray, double distance, HitKind kind, SurfaceIndex surface)
  {
    if (this->Layers.IsClearlyBehind(ray, distance) &&
      this->Layers.LastDistance[ray] < this->Task.Rays.WalkEnd[ray])
    {
      this->Layers.Append(ray, distance, kind, surface);
    }
    else
    {
      this->Unclear |= std::uint64_t(1) << ray;
    }
  }

  const LayerTask& Task;
  LayerBeamScene<Real>& Scene;
  LayerBatch& Layers;
  std::uint64_t Unclear = 0;

  std::size_t Total = 0, Cells = 0;
  // Pairs:
  List<std::int32_t> Ray, Cell;
  // Cells, no more than pairs:
  List<glm::ivec3> Place;
  List<SurfaceIndex> Surface; ///< Frame::NoSurface: any isovalue
  List<std::array<Real, 8>> Corners;

  CellCrossings<Real> Found;
};

/// Intervals of t that contain the rays' stays in a cell.
struct CellStays
{
  float Enter[RayBatch::Capacity], Leave[RayBatch::Capacity];
};

/// Find the rays of a beam that may pass a cell on their walk.
/// \tparam IsPlain TileBeam::IsPlain
/// \return one bit for each ray
template <bool IsPlain, class Box>
HWY_INLINE std::uint64_t FindStays(const Box& box, const TileBeam& beam, CellStays& stays)
{
  const CellFaces faces(box, beam.Margin, beam.Flip);
  std::uint64_t passing = 0;
  for (std::size_t i = 0; i < RayBatch::Capacity; i += hn::Lanes(Floats()))
  {
    auto [enter, leave] = IsPlain ? FindPlainInterval(faces, beam, i)
                                  : FindInterval(faces, beam.Origin, beam.Inverse, i);
    if (!IsPlain)
    {
      enter = hn::Max(enter, Load(&beam.Begin[i]));
    }
    const M isAhead = hn::Le(enter, hn::Min(leave, Load(&beam.Behind[i])));
    passing |= BitsOf(hn::And(isAhead, hn::Ge(leave, Load(&beam.WalkBegin[i])))) << i;
    hn::StoreU(enter, Floats(), stays.Enter + i);
    hn::StoreU(leave, Floats(), stays.Leave + i);
  }
  return passing;
}

/// Selects rays of a plain beam that surely enter no solid in a cell, as the field falls along
/// them. The exact search covers at least half of the tested interval: all except the slack at both
/// ends. So its coefficients fall at least half as much, which exceeds rounding errors, and their
/// signs change at most once.
/// \param b     coefficients of the rays from number `i` on, between `enter` and `leave`
/// \param error bound of the errors of these coefficients
HWY_INLINE M CanOnlyExit(
  const TileBeam& beam, const Coefficients& b, V error, V enter, V leave, std::size_t i)
{
  const V end = hn::Min(leave, hn::Sub(Load(&beam.End[i]), Set(2.0f * beam.Margin)));
  const V slack = Load(&beam.Slack[i]), quarter = hn::Mul(Set(0.25f), hn::Sub(leave, enter));
  const M isLong = hn::And(hn::Lt(slack, quarter), hn::Lt(hn::Sub(leave, end), quarter));
  return hn::And(isLong, hn::Lt(b.LargestRise, hn::Mul(Set(-8.0f), error)));
}

/// Finds the surfaces that the rays of a beam meet in cells. Single precision only skips rays that
/// do not pass a cell or surely miss in it.
/// \tparam IsPlain TileBeam::IsPlain
/// \tparam Lattice tells where cells lie (KernelsLattice-inl.h)
template <typename Real, bool IsPlain, class Lattice>
class LayerCells
{
public:
  using Box = typename Lattice::Cell;

  LayerCells(const LayerTask& task, const Lattice& places, LayerBeamScene<Real>& scene,
    TileBeam& beam, LayerBatch& layers)
    : Task(task)
    , Places(places)
    , Scene(scene)
    , Beam(beam)
    , Notes(task, scene, layers)
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
    this->Notes.Search();
    return this->Notes.UnclearRays();
  }

private:
  /// Note the rays that may meet surfaces in a cell.
  void TestCell(const glm::ivec3& cell)
  {
    const Box box = this->Places.CellAt(cell);
    CellStays stays;
    const std::uint64_t passing =
      FindStays<IsPlain>(box, this->Beam, stays) & this->Notes.LiveRays();
    if (passing == 0)
    {
      return;
    }
    this->Beam.CellsPassed += static_cast<std::int64_t>(hwy::PopCount(passing));
    if (this->Task.HasCaps)
    {
      this->Notes.Note(cell, passing);
    }
    else
    {
      this->Scene.Read(cell, this->Levels);
      this->NoteOpen(cell, box, stays, passing);
    }
    if (this->Notes.IsFull())
    {
      this->SearchNoted();
    }
  }

  /// Search the noted cells. Rays that become full or opaque end there.
  void SearchNoted()
  {
    const std::uint64_t live = this->Notes.LiveRays();
    this->Notes.Search();
    const std::uint64_t done = live & ~this->Notes.LiveRays();
    if (done != 0)
    {
      ForEachRay(
        done, [&](std::size_t ray) HWY_ATTR { this->Beam.Behind[ray] = -TileBeam::Never; });
      MoveAcrossIfNearer(this->Beam);
    }
  }

  /// Note the rays that may cross isovalues in a cell that was read. A ray that may cross several
  /// isovalues is noted for all of them, to sort its crossings.
  HWY_INLINE void NoteOpen(
    const glm::ivec3& cell, const Box& box, const CellStays& stays, std::uint64_t passing)
  {
    const float margin = this->Beam.Margin * box.LargestShare();
    constexpr float most = 0x1p-5f;
    if (!(margin < most && this->Levels.AreAll()))
    {
      // Single precision decides nothing.
      this->Notes.Note(cell, this->Levels.Count > 0 ? passing : 0);
      return;
    }
    std::uint64_t open[CellLevels<Real>::Most], any = 0, several = 0;
    for (std::size_t level = 0; level < this->Levels.Count; ++level)
    {
      open[level] = this->FindOpen(this->Levels.All[level].Corners, margin, box, stays, passing);
      several |= any & open[level];
      any |= open[level];
    }
    for (std::size_t level = 0; level < this->Levels.Count; ++level)
    {
      this->Notes.Note(cell, this->Levels.All[level], open[level] & ~several);
    }
    this->Notes.Note(cell, several);
  }

  /// One bit for each ray that may cross an isovalue in a cell. (CellSearch::ErrorIn explains the
  /// error bound.)
  HWY_INLINE std::uint64_t FindOpen(const std::array<Real, 8>& corners, float margin,
    const Box& box, const CellStays& stays, std::uint64_t passing) const
  {
    const CellValues values = ValuesOf(InFloat(corners));
    const V error = Set(values.Largest * (16.0f * margin + 0x1p-13f) + 1e-30f);
    std::uint64_t open = 0;
    while (passing != 0)
    {
      constexpr std::size_t lanes = hn::MaxLanes(Floats());
      const std::size_t i = hwy::Num0BitsBelowLS1Bit_Nonzero64(passing) & ~(lanes - 1);
      const M isPassed = MaskOf(passing >> i);
      passing &= ~(((std::uint64_t(1) << lanes) - 1) << i);
      const V enter = hn::IfThenElseZero(isPassed, Load(stays.Enter + i));
      const V leave = hn::IfThenElseZero(isPassed, Load(stays.Leave + i));
      V at[3], step[3];
      FindPathsIn(box, this->Beam, enter, leave, i, at, step);
      const Coefficients b = CubicsAlong(values, at, step);
      const M isOutside = hn::Or(hn::Lt(b.Largest, hn::Neg(error)), hn::Gt(b.Smallest, error));
      M isOpen = hn::AndNot(isOutside, isPassed);
      if (IsPlain && this->Task.IsSolid)
      {
        isOpen = hn::AndNot(CanOnlyExit(this->Beam, b, error, enter, leave, i), isOpen);
      }
      open |= BitsOf(isOpen) << i;
    }
    return open;
  }

  /// Corners in single precision; doubles in units of the largest one.
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

  const LayerTask& Task;
  const Lattice& Places;
  LayerBeamScene<Real>& Scene;
  TileBeam& Beam;
  LayerNotes<Real> Notes;
  CellLevels<Real> Levels; ///< of the present cell
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
