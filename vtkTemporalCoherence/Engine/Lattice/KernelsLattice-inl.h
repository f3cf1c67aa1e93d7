// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Positions of cells and blocks of cells, for a beam. Included by kernels once for each kind of
// vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsLattice_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsLattice_inl_h
#undef TemporalCoherence_KernelsLattice_inl_h
#else
#define TemporalCoherence_KernelsLattice_inl_h
#endif

#include "Lattice/TileBeam.h"
#include "Scene/GridCoordinates.h"

#include "Lattice/CellCubics-inl.h"

#include <algorithm>
#include <array>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace BeamKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// The faces of a cell, moved outwards. The beam passes Near before Far.
struct CellFaces
{
  template <class Box>
  HWY_INLINE CellFaces(const Box& box, float margin, int flip)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      const bool isBack = flip >> (2 * a) & 1;
      const float low = box.Low(a) - margin, high = box.High(a) + margin;
      this->Near[a] = isBack ? high : low;
      this->Far[a] = isBack ? low : high;
    }
  }

  float Near[3], Far[3];
};

/// Intervals of t of a vector of rays in a cell.
struct Interval
{
  V Enter, Leave;
};

/// Find where the infinite lines of rays are between a cell's faces.
/// \tparam AreAlike TileBeam::AreAlike
/// \param origin, inverse of the rays of a beam
/// \param i first ray of the vector
template <bool AreAlike = true>
HWY_INLINE Interval FindInterval(const CellFaces& faces,
  const std::array<TileBeam::Array<float>, 3>& origin,
  const std::array<TileBeam::Array<float>, 3>& inverse, std::size_t i)
{
  Interval in{ Set(-TileBeam::Never), Set(TileBeam::Never) };
  for (std::size_t a = 0; a < 3; ++a)
  {
    const V from = Load(&origin[a][i]), scale = Load(&inverse[a][i]);
    const V one = hn::Mul(hn::Sub(Set(faces.Near[a]), from), scale);
    const V other = hn::Mul(hn::Sub(Set(faces.Far[a]), from), scale);
    in.Enter = hn::Max(in.Enter, AreAlike ? one : hn::Min(one, other));
    in.Leave = hn::Min(in.Leave, AreAlike ? other : hn::Max(one, other));
  }
  return in;
}

/// The intervals of the rays of a plain beam, with fewer operations.
/// \pre beam.IsPlain
HWY_INLINE Interval FindPlainInterval(const CellFaces& faces, const TileBeam& beam, std::size_t i)
{
  Interval in{ Set(-TileBeam::Never), Set(TileBeam::Never) };
  for (std::size_t a = 0; a < 3; ++a)
  {
    const V inverse = Load(&beam.Inverse[a][i]), toOrigin = Load(&beam.ToOrigin[a][i]);
    in.Enter = hn::Max(in.Enter, hn::MulAdd(Set(faces.Near[a]), inverse, toOrigin));
    in.Leave = hn::Min(in.Leave, hn::MulAdd(Set(faces.Far[a]), inverse, toOrigin));
  }
  return in;
}

/// Paths of a vector of rays from `enter` to `leave`, in the cell's coordinates.
template <class Box>
HWY_INLINE void FindPathsIn(
  const Box& box, const TileBeam& beam, V enter, V leave, std::size_t i, V at[3], V step[3])
{
  const V length = hn::Sub(leave, enter);
  for (std::size_t a = 0; a < 3; ++a)
  {
    const V direction = Load(&beam.Direction[a][i]);
    const V origin = hn::Sub(Load(&beam.Origin[a][i]), Set(box.Low(a)));
    at[a] = box.ShareOf(hn::MulAdd(enter, direction, origin), a);
    step[a] = box.ShareOf(hn::Mul(length, direction), a);
  }
}

/// Call visit(place) from front to back for each child whose bit is set. `place` is the child's
/// position in the block.
/// \param word  bits in the order in which the beam meets the children
/// \param first, size first cell of the block, and cells along an edge of a child
template <class Lattice, typename Visitor>
HWY_INLINE void VisitInOrder(const Lattice& lattice, const TileBeam& beam, std::uint64_t word,
  const glm::ivec3& first, int size, const Visitor& visit)
{
  const auto reach = lattice.ReachIn(first, size);
  for (; word != 0; word &= word - 1)
  {
    const int child = static_cast<int>(hwy::Num0BitsBelowLS1Bit_Nonzero64(word)) ^ beam.Flip;
    // A hit found meanwhile may hide it.
    if (reach.Of(child) >= beam.Around.Offset[TileBeam::Across])
    {
      visit(glm::ivec3(child & 3, child >> 2 & 3, child >> 4));
    }
  }
}

/// The lattice of an image: planes between cells lie at integers.
class UniformLattice
{
public:
  explicit UniformLattice(const TileBeam& beam)
    : Beam(beam)
  {
  }

  /// A cell, in the coordinates of the beam.
  struct Cell
  {
    HWY_INLINE float Low(std::size_t a) const { return this->First[a]; }
    HWY_INLINE float High(std::size_t a) const { return this->First[a] + 1.0f; }
    /// A length along an axis, relative to the cell's edge.
    HWY_INLINE V ShareOf(V length, std::size_t) const { return length; }
    /// A unit length relative to the cell's shortest edge.
    HWY_INLINE float LargestShare() const { return 1.0f; }

    float First[3];
  };

  HWY_INLINE Cell CellAt(const glm::ivec3& cell) const
  {
    const glm::ivec3& anchor = this->Beam.Anchor;
    return { { static_cast<float>(cell.x - anchor.x), static_cast<float>(cell.y - anchor.y),
      static_cast<float>(cell.z - anchor.z) } };
  }

  /// The largest normal . point in each child of a block, for the plane across the beam.
  struct Reach
  {
    HWY_INLINE float Of(int child) const
    {
      return this->First + this->Edge * this->Children[static_cast<std::size_t>(child)];
    }

    float First, Edge;
    const std::array<float, 64>& Children;
  };

  HWY_INLINE Reach ReachIn(const glm::ivec3& first, int size) const
  {
    const TileBeam& beam = this->Beam;
    constexpr std::size_t across = TileBeam::Across;
    const float edge = static_cast<float>(size);
    const float at = glm::dot(-beam.Forward, glm::vec3(first - beam.Anchor));
    return { at + edge * beam.Around.Reach[across], edge, beam.Around.Children[across] };
  }

  /// Selects the children of a block, one bit each, that intersect the beam's hull.
  /// \param first, size first cell of the block, and cells along an edge of a child
  HWY_INLINE std::uint64_t Cull(const glm::ivec3& first, int size) const
  {
    const hn::CappedTag<float, 8> d;
    const TileBeam::Hull& hull = this->Beam.Around;
    const glm::vec3 corner(first - this->Beam.Anchor);
    const auto perSize = hn::Set(d, 1.0f / static_cast<float>(size));
    TileBeam::OfPlanes least;
    for (std::size_t i = 0; i < least.size(); i += hn::Lanes(d))
    {
      auto left = hn::LoadU(d, &hull.Offset[i]);
      for (std::size_t a = 0; a < 3; ++a)
      {
        const auto at = hn::Set(d, corner[static_cast<int>(a)]);
        left = hn::NegMulAdd(hn::LoadU(d, &hull.Normal[a][i]), at, left);
      }
      const auto reach = hn::LoadU(d, &hull.Reach[i]);
      hn::StoreU(hn::MulSub(left, perSize, reach), d, &least[i]);
    }
    std::uint64_t kept = 0;
    for (std::size_t i = 0; i < 64; i += hn::Lanes(Floats()))
    {
      M isKept = hn::Ge(Load(&hull.Children[0][i]), Set(least[0]));
      for (std::size_t plane = 1; plane < TileBeam::Planes; ++plane)
      {
        isKept = hn::And(isKept, hn::Ge(Load(&hull.Children[plane][i]), Set(least[plane])));
      }
      kept |= BitsOf(isKept) << i;
    }
    return kept;
  }

private:
  const TileBeam& Beam;
};

/// The lattice of a rectilinear field: planes between cells lie at given coordinates.
class RectilinearLattice
{
public:
  RectilinearLattice(const TileBeam& beam, const GridCoordinates& grid)
    : Beam(beam)
  {
    for (int a = 0; a < 3; ++a)
    {
      this->Along[a] = grid.Of(a).data();
      this->Last[a] = static_cast<int>(grid.Of(a).size()) - 1;
    }
  }

  struct Cell
  {
    HWY_INLINE float Low(std::size_t a) const { return this->Lows[a]; }
    HWY_INLINE float High(std::size_t a) const { return this->Highs[a]; }
    HWY_INLINE V ShareOf(V length, std::size_t a) const
    {
      return hn::Mul(length, Set(this->Shares[a]));
    }
    HWY_INLINE float LargestShare() const
    {
      return std::max(std::max(this->Shares[0], this->Shares[1]), this->Shares[2]);
    }

    float Lows[3], Highs[3];
    float Shares[3]; ///< 1 / edge; infinity where a cell is too thin for single precision
  };

  HWY_INLINE Cell CellAt(const glm::ivec3& cell) const
  {
    Cell box;
    for (int a = 0; a < 3; ++a)
    {
      const double* const at = this->Along[a] + cell[a];
      box.Lows[a] = static_cast<float>(at[0] - this->Beam.Anchor[a]);
      box.Highs[a] = static_cast<float>(at[1] - this->Beam.Anchor[a]);
      box.Shares[a] = 1.0f / static_cast<float>(at[1] - at[0]);
    }
    return box;
  }

  /// UniformLattice::Reach as a sum over axes, with a term for each position of children.
  struct Reach
  {
    HWY_INLINE float Of(int child) const
    {
      return this->Along[0][child & 3] + this->Along[1][child >> 2 & 3] +
        this->Along[2][child >> 4];
    }

    float Along[3][4];
  };

  HWY_INLINE Reach ReachIn(const glm::ivec3& first, int size) const
  {
    Reach reach;
    for (int a = 0; a < 3; ++a)
    {
      float planes[5];
      this->PlanesIn(a, first[a], size, planes);
      const float normal = -this->Beam.Forward[a];
      const float* const farther = planes + (normal > 0.0f ? 1 : 0);
      for (int i = 0; i < 4; ++i)
      {
        reach.Along[a][i] = normal * farther[i];
      }
    }
    return reach;
  }

  HWY_INLINE std::uint64_t Cull(const glm::ivec3& first, int size) const
  {
    // Low and high planes along x and y of 16 children, at [axis][side][x + 4 y].
    float ends[2][2][16], endsOfZ[5];
    float planes[5];
    this->PlanesIn(0, first.x, size, planes);
    for (std::size_t i = 0; i < 16; ++i)
    {
      ends[0][0][i] = planes[i & 3];
      ends[0][1][i] = planes[(i & 3) + 1];
    }
    this->PlanesIn(1, first.y, size, planes);
    for (std::size_t i = 0; i < 16; ++i)
    {
      ends[1][0][i] = planes[i >> 2];
      ends[1][1][i] = planes[(i >> 2) + 1];
    }
    this->PlanesIn(2, first.z, size, endsOfZ);
    const TileBeam::Hull& hull = this->Beam.Around;
    constexpr std::size_t lanes = hn::MaxLanes(Floats());
    std::uint64_t kept = 0;
    for (std::size_t i = 0; i < 16; i += lanes)
    {
      std::uint64_t left = 0;
      for (std::size_t z = 0; z < 4; ++z)
      {
        M isKept = hn::Eq(hn::Zero(Floats()), hn::Zero(Floats()));
        for (std::size_t plane = 0; plane < TileBeam::Planes; ++plane)
        {
          const float x = hull.Normal[0][plane], y = hull.Normal[1][plane];
          const float alongZ = hull.Normal[2][plane];
          const V atX = hn::Mul(Set(x), Load(&ends[0][x > 0.0f][i]));
          const V at = hn::MulAdd(Set(y), Load(&ends[1][y > 0.0f][i]), atX);
          const float least = hull.Offset[plane] - alongZ * endsOfZ[z + (alongZ > 0.0f)];
          isKept = hn::And(isKept, hn::Ge(at, Set(least)));
        }
        left |= BitsOf(isKept) << (16 * z);
      }
      kept |= left << i;
    }
    return kept;
  }

private:
  /// The five planes that bound four children along an axis, clamped to the field's end.
  HWY_INLINE void PlanesIn(int a, int first, int size, float planes[5]) const
  {
    for (int i = 0; i < 5; ++i)
    {
      const int plane = std::min(first + i * size, this->Last[a]);
      planes[i] = static_cast<float>(this->Along[a][plane] - this->Beam.Anchor[a]);
    }
  }

  const TileBeam& Beam;
  const double* Along[3];
  int Last[3];
};

}
}
}
HWY_AFTER_NAMESPACE();

#endif
