// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/BandBeam.h"

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Isomap/KernelsBandBeam.cxx"
#include <hwy/foreach_target.h>

#include "Lattice/KernelsBeamTree-inl.h"
#include "Lattice/KernelsHull-inl.h"
#include "Lattice/KernelsRange-inl.h"
#include "Lattice/KernelsSegment-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace BeamKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;
namespace segments = SegmentKernels::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, WidestVector / 2>;

/// Tests the cells of leaves against the rays of a beam, and reports cells that can raise the
/// progress of rays to the scene. Single precision, with the beam's margin, selects rays that may
/// pass a cell; paths and ranges are computed as by a walk.
template <typename Real>
class BandSearch
{
public:
  BandSearch(
    const RayBatch& rays, const UniformLattice& lattice, BandBeamScene<Real>& scene, TileBeam& beam)
    : Rays(rays)
    , Lattice(lattice)
    , Scene(scene)
    , Beam(beam)
    , Rises(scene.ReachedIn(Rising))
    , Falls(scene.ReachedIn(Falling))
  {
  }

  /// \param cells one bit for each, from front to back
  void TestCells(const glm::ivec3& leaf, std::uint64_t cells)
  {
    this->FindPassed(leaf, cells);
    if (this->NumberOfPairs == 0)
    {
      return;
    }
    this->Scene.Read(this->Places, this->NumberOfPassed, this->Cells);
    bool isNearer = false;
    for (std::size_t pair = 0; pair < this->NumberOfPairs; ++pair)
    {
      isNearer |= this->SearchCell(this->Pairs[pair]);
    }
    if (isNearer)
    {
      MoveAcrossIfNearer(this->Beam);
    }
  }

private:
  static constexpr std::size_t CellsOfLeaf = 64;

  /// A cell, a vector of rays, and the mask of rays that may pass the cell.
  struct Pair
  {
    std::uint8_t Cell, Rays;
    std::uint16_t Which; ///< one bit for each of the rays
  };

  /// List the cells that rays pass. All cells take this step before any takes the next, so that few
  /// branches depend on a cell's content.
  HWY_INLINE void FindPassed(const glm::ivec3& leaf, std::uint64_t cells)
  {
    this->NumberOfPassed = this->NumberOfPairs = 0;
    std::int64_t passing = 0;
    for (; cells != 0; cells &= cells - 1)
    {
      const int number =
        static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero64(cells)) ^ this->Beam.Flip;
      const glm::ivec3 place(number & 3, number >> 2 & 3, number >> 4);
      this->Places[this->NumberOfPassed] = leaf + place;
      const UniformLattice::Cell box = this->Lattice.CellAt(this->Places[this->NumberOfPassed]);
      const CellFaces faces(box, this->Beam.Margin, this->Beam.Flip);
      const std::size_t before = this->NumberOfPairs;
      for (std::size_t i = 0; i < RayBatch::Capacity; i += hn::Lanes(Floats()))
      {
        const std::uint64_t which = BitsOf(this->Passes(faces, i));
        this->Pairs[this->NumberOfPairs] = { static_cast<std::uint8_t>(this->NumberOfPassed),
          static_cast<std::uint8_t>(i), static_cast<std::uint16_t>(which) };
        this->NumberOfPairs += which != 0;
        passing += static_cast<std::int64_t>(hwy::PopCount(which));
      }
      this->NumberOfPassed += this->NumberOfPairs != before;
    }
    this->Beam.CellsPassed += passing;
  }

  /// Selects rays of a vector that may pass a cell within their walks, in front of Behind.
  HWY_INLINE M Passes(const CellFaces& faces, std::size_t i) const
  {
    const TileBeam& beam = this->Beam;
    const auto [enter, leave] = FindInterval(faces, beam.Origin, beam.Inverse, i);
    const V behind = Load(&beam.Behind[i]), begin = Load(&beam.WalkBegin[i]);
    return hn::And(hn::Le(enter, hn::Min(leave, behind)), hn::Ge(leave, begin));
  }

  /// Selects rays of a vector whose progress a cell can raise, one bit each.
  HWY_INLINE std::uint64_t FindBroughtOn(const CellReach<Real>& cell, std::size_t first) const
  {
    const hn::CappedTag<Real, WidestVector> d;
    std::uint64_t which = 0;
    for (std::size_t i = 0; i < hn::Lanes(Floats()); i += hn::Lanes(d))
    {
      const auto rises =
        hn::Lt(hn::LoadU(d, this->Rises + first + i), hn::Set(d, cell.Corner[Rising]));
      const auto falls =
        hn::Lt(hn::LoadU(d, this->Falls + first + i), hn::Set(d, cell.Corner[Falling]));
      which |= BitsIn(d, hn::Or(rises, falls)) << i;
    }
    return which;
  }

  /// Report a cell to the scene, if it can raise the progress of rays.
  /// \return true if a ray is done
  HWY_INLINE bool SearchCell(const Pair& pair)
  {
    const BandCell<Real>& cell = this->Cells[pair.Cell];
    CellStays<Real>& rays = this->Stays;
    rays.First = pair.Rays;
    rays.Which = pair.Which & this->FindBroughtOn(cell.Reach, rays.First);
    if (rays.Which == 0)
    {
      return false;
    }
    Paths paths;
    this->FindPaths(cell, rays, paths);
    this->FindRanges(cell, paths, rays);
    return this->Scene.TakeNote(cell, rays, this->Beam);
  }

  /// Paths of a vector of rays through a cell, in its coordinates.
  struct alignas(64) Paths
  {
    Real Begin[3][WidestVector], End[3][WidestVector];
  };

  HWY_INLINE void FindPaths(const BandCell<Real>& cell, CellStays<Real>& rays, Paths& paths) const
  {
    const Doubles d;
    using Vector = hn::Vec<Doubles>;
    Vector place[3];
    for (std::size_t a = 0; a < 3; ++a)
    {
      place[a] = hn::Set(d, cell.Place[static_cast<int>(a)]);
    }
    rays.IsOnWalk = 0;
    for (std::size_t i = 0; i < hn::Lanes(Floats()); i += hn::Lanes(d))
    {
      const std::size_t from = rays.First + i;
      const auto path = segments::FindPath(d, segments::LoadRays(d, this->Rays, from), place);
      for (std::size_t a = 0; a < 3; ++a)
      {
        segments::StoreAs(path.Begin[a], &paths.Begin[a][i]);
        segments::StoreAs(path.End[a], &paths.End[a][i]);
      }
      hn::StoreU(path.Enter, d, &rays.Enter[i]);
      hn::StoreU(path.Leave, d, &rays.Leave[i]);
      const auto begins = hn::Gt(path.Leave, hn::LoadU(d, &this->Rays.WalkBegin[from]));
      const auto ends = hn::Lt(path.Enter, hn::LoadU(d, &this->Rays.WalkEnd[from]));
      const auto isOnWalk = hn::And(hn::Lt(path.Enter, path.Leave), hn::And(begins, ends));
      rays.IsOnWalk |= BitsIn(d, isOnWalk) << i;
    }
  }

  HWY_INLINE void FindRanges(
    const BandCell<Real>& cell, const Paths& paths, CellStays<Real>& rays) const
  {
    const hn::CappedTag<Real, WidestVector> d;
    using Vector = hn::Vec<decltype(d)>;
    Vector samples[8];
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      samples[corner] = hn::Set(d, cell.Samples[corner]);
    }
    for (std::size_t i = 0; i < hn::Lanes(Floats()); i += hn::Lanes(d))
    {
      Vector begin[3], end[3], b[4], lowest, highest;
      for (std::size_t a = 0; a < 3; ++a)
      {
        begin[a] = hn::LoadU(d, &paths.Begin[a][i]);
        end[a] = hn::LoadU(d, &paths.End[a][i]);
      }
      segments::CubicsBetween(d, samples, begin, end, b);
      segments::RangesOf(d, b, lowest, highest);
      for (std::size_t c = 0; c < 4; ++c)
      {
        hn::StoreU(b[c], d, &rays.Cubic[c][i]);
      }
      hn::StoreU(lowest, d, &rays.Lowest[i]);
      hn::StoreU(highest, d, &rays.Highest[i]);
    }
  }

  const RayBatch& Rays;
  const UniformLattice& Lattice;
  BandBeamScene<Real>& Scene;
  TileBeam& Beam;
  const Real *Rises, *Falls;

  // The cells of the present leaf that rays pass.
  std::size_t NumberOfPassed = 0, NumberOfPairs = 0;
  glm::ivec3 Places[CellsOfLeaf];
  BandCell<Real> Cells[CellsOfLeaf];
  Pair Pairs[CellsOfLeaf * RayBatch::Capacity / hn::MaxLanes(Floats()) + 1];
  CellStays<Real> Stays;
};

template <typename Real>
void SearchAll(
  const ActiveCells& active, const RayBatch& rays, BandBeamScene<Real>& scene, TileBeam& beam)
{
  const UniformLattice lattice(beam);
  BandSearch<Real> search(rays, lattice, scene, beam);
  BeamTree<BandSearch<Real>, UniformLattice>(active, scene, lattice, beam, search).Visit();
}

void SearchFloat(
  const ActiveCells& active, const RayBatch& rays, BandBeamScene<float>& scene, TileBeam& beam)
{
  SearchAll(active, rays, scene, beam);
}

void SearchDouble(
  const ActiveCells& active, const RayBatch& rays, BandBeamScene<double>& scene, TileBeam& beam)
{
  SearchAll(active, rays, scene, beam);
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
HWY_EXPORT(SearchFloat);
HWY_EXPORT(SearchDouble);
}

void SearchBand(
  const ActiveCells& active, const RayBatch& rays, BandBeamScene<float>& scene, TileBeam& beam)
{
  using namespace BeamKernels;
  HWY_DYNAMIC_DISPATCH(SearchFloat)(active, rays, scene, beam);
}

void SearchBand(
  const ActiveCells& active, const RayBatch& rays, BandBeamScene<double>& scene, TileBeam& beam)
{
  using namespace BeamKernels;
  HWY_DYNAMIC_DISPATCH(SearchDouble)(active, rays, scene, beam);
}

}
#endif
