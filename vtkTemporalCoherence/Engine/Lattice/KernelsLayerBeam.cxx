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
#include "Lattice/KernelsLayerNotes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace BeamKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

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
