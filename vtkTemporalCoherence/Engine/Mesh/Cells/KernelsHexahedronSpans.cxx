// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Cells/KernelsCells.h"

#include "Mesh/Cells/CornerPoints.h"
#include "Mesh/Cells/HexahedronRoots.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#ifndef TemporalCoherence_HexahedronFaces // this file is included once for each kind of vectors
#define TemporalCoherence_HexahedronFaces
namespace TemporalCoherence
{
namespace MeshKernels
{

/// Hits of rays with the faces of a hexahedron, for rays with hits between entry and exit.
struct HexahedronHits
{
  static constexpr std::size_t Most = 12; ///< of a ray: two on each face

  /// Rounding error of coordinates, relative to the largest; how far outside of a face hits still
  /// count, in the face's coordinates, beyond rounding errors; and the largest rounding error of a
  /// hit.
  static constexpr double ValueError = 8e-15, Margin = 1e-12, MostError = 1e-3;

  /// Hits closer together than this share of the cell's length along the ray are one hit.
  static constexpr double SameHit = 1e-10;

  struct Hit
  {
    double T, Value;
  };

  void Add(std::size_t ray, double t, double value, double same)
  {
    std::uint8_t& count = this->Count[ray];
    this->Hits[ray][count++] = { t, value };
    this->Same[ray] = same;
  }

  std::uint64_t Which = 0;
  TileArray<std::uint8_t> Count{};
  TileArray<double> Same;
  TileArray<std::array<Hit, Most>> Hits;
};

/// The corners of the six faces of a hexahedron, by their places in the cell. Each face lists them
/// in an order that depends on points and values alone, so that two cells that share a face compute
/// the same bits there.
struct HexahedronFaces
{
  std::array<std::array<std::uint8_t, 4>, 6> Corners; ///< (0, 0), (1, 0), (0, 1), (1, 1)

  explicit HexahedronFaces(const CornerPoints<8>& cell)
  {
    std::array<std::uint8_t, 8> rank{};
    for (std::size_t i = 0; i < 8; ++i)
    {
      for (std::size_t j = 0; j < 8; ++j)
      {
        rank[i] = static_cast<std::uint8_t>(rank[i] + IsLess(cell, j, i));
      }
    }
    for (std::size_t face = 0; face < 6; ++face)
    {
      const std::size_t axis = face / 2;
      const std::size_t a = std::size_t(1) << (axis + 1) % 3, b = std::size_t(1) << (axis + 2) % 3;
      const std::size_t first = (face & 1) << axis;
      this->Corners[face] = Least({ first, first + a, first + b, first + a + b }, rank);
    }
  }

private:
  using Order = std::array<std::uint8_t, 4>;

  static bool IsLess(const CornerPoints<8>& cell, std::size_t i, std::size_t j)
  {
    const glm::dvec3 &a = cell.Points[i], &b = cell.Points[j];
    return a.x != b.x ? a.x < b.x
      : a.y != b.y    ? a.y < b.y
      : a.z != b.z    ? a.z < b.z
                      : cell.Values[i] < cell.Values[j];
  }

  /// The listing of a face's corners with the lexicographically least ranks, of eight possible
  /// ones.
  static Order Least(
    const std::array<std::size_t, 4>& corners, const std::array<std::uint8_t, 8>& rank)
  {
    Order least{};
    unsigned int code = ~0u;
    for (std::size_t first = 0; first < 4; ++first)
    {
      for (std::size_t step = 1; step <= 2; ++step)
      {
        const std::array<std::size_t, 4> at = { corners[first], corners[first ^ step],
          corners[first ^ (3 - step)], corners[first ^ 3] };
        const unsigned int mine = static_cast<unsigned int>(
          rank[at[0]] << 9 | rank[at[1]] << 6 | rank[at[2]] << 3 | rank[at[3]]);
        if (mine < code)
        {
          code = mine;
          for (std::size_t i = 0; i < 4; ++i)
          {
            least[i] = static_cast<std::uint8_t>(at[i]);
          }
        }
      }
    }
    return least;
  }
};

}
}
#endif

// This file is compiled once for each kind of vectors. The best one for the machine is chosen at
// run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Mesh/Cells/KernelsHexahedronSpans.cxx"
#include <hwy/foreach_target.h>

#include "Mesh/Cells/KernelsSheared-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace MeshKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// A face as rays see it, by corners (0, 0), (1, 0), (0, 1), (1, 1).
template <class V>
struct SeenFace
{
  V X[4], Y[4], T[4], Value[4];
};

/// Hits of a vector of rays with the six faces of a cell, at most two on each face.
template <class D>
struct FaceHits
{
  using V = hn::Vec<D>;
  static constexpr std::size_t Most = HexahedronHits::Most;
  hn::Mask<D> IsHit[Most];
  V T[Most], Value[Most];
};

template <class V>
HWY_INLINE V Cross(const V a[2], const V b[2])
{
  return hn::Sub(hn::Mul(a[0], b[1]), hn::Mul(a[1], b[0]));
}

/// Bilinear interpolation that keeps a common sign of the corners.
template <class V>
HWY_INLINE V Mean(const V corners[4], V a, V b)
{
  const hn::DFromV<V> d;
  const V one = hn::Set(d, 1.0), beforeA = hn::Sub(one, a), beforeB = hn::Sub(one, b);
  const V low = hn::Add(hn::Mul(beforeA, corners[0]), hn::Mul(a, corners[1]));
  const V high = hn::Add(hn::Mul(beforeA, corners[2]), hn::Mul(a, corners[3]));
  return hn::Add(hn::Mul(beforeB, low), hn::Mul(b, high));
}

/// The bilinear function that is 0 where a ray meets a face: Low + a AlongA + b AlongB + a b Bend.
template <class D>
struct FaceFunction
{
  using V = hn::Vec<D>;

  HWY_INLINE explicit FaceFunction(const SeenFace<V>& face)
  {
    const V* const values[2] = { face.X, face.Y };
    for (std::size_t i = 0; i < 2; ++i)
    {
      const V* const v = values[i];
      this->Low[i] = v[0];
      this->AlongA[i] = hn::Sub(v[1], v[0]);
      this->AlongB[i] = hn::Sub(v[2], v[0]);
      this->Bend[i] = hn::Sub(hn::Sub(v[3], v[1]), this->AlongB[i]);
      for (std::size_t corner = 0; corner < 4; ++corner)
      {
        const V length = hn::Abs(v[corner]);
        this->Largest = i + corner == 0 ? length : hn::Max(this->Largest, length);
      }
    }
  }

  /// Solve for a, given b.
  HWY_INLINE V FindA(V b) const
  {
    const D d;
    V value[2], slope[2];
    for (std::size_t i = 0; i < 2; ++i)
    {
      value[i] = hn::Add(this->Low[i], hn::Mul(b, this->AlongB[i]));
      slope[i] = hn::Add(this->AlongA[i], hn::Mul(b, this->Bend[i]));
    }
    const auto isFirst = hn::Ge(hn::Abs(slope[0]), hn::Abs(slope[1]));
    const V steep = hn::IfThenElse(isFirst, slope[0], slope[1]);
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0);
    const auto isPoint = hn::Eq(steep, zero);
    const V far = hn::Add(hn::Abs(value[0]), hn::Abs(value[1]));
    const V from =
      hn::IfThenElse(isPoint, far, hn::Neg(hn::IfThenElse(isFirst, value[0], value[1])));
    // If an edge is a point, its b solves the quadratic equation for every ray. Only a ray through
    // this point meets the face there; for others, a is infinite.
    const auto isAnywhere = hn::And(isPoint, hn::Eq(far, zero));
    return hn::Div(from, hn::IfThenElse(isAnywhere, one, steep));
  }

  V Low[2], AlongA[2], AlongB[2], Bend[2], Largest;
};

/// Lanes whose rays have all corners of a face on one side.
template <class V>
HWY_INLINE hn::Mask<hn::DFromV<V>> IsPassedBy(const SeenFace<V>& face)
{
  const V zero = hn::Zero(hn::DFromV<V>());
  const auto isBeside = [&](const V v[4]) HWY_ATTR
  {
    const V low = hn::Min(hn::Min(v[0], v[1]), hn::Min(v[2], v[3]));
    const V high = hn::Max(hn::Max(v[0], v[1]), hn::Max(v[2], v[3]));
    return hn::Or(hn::Gt(low, zero), hn::Lt(high, zero));
  };
  return hn::Or(isBeside(face.X), isBeside(face.Y));
}

/// Add the hits with one face.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void AddHits(D d, const SeenFace<V>& face, std::size_t place, FaceHits<D>& hits)
{
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0), two = hn::Set(d, 2.0);
  const auto isPassedBy = IsPassedBy(face);
  if (hn::AllTrue(d, isPassedBy))
  {
    for (std::size_t i = 0; i < 2; ++i)
    {
      hits.IsHit[place + i] = hn::Lt(one, zero);
      hits.T[place + i] = hits.Value[place + i] = zero;
    }
    return;
  }
  const FaceFunction<D> f(face);
  // Eliminate a: c0 + c1 b + c2 b^2 = 0.
  const V c0 = Cross(f.Low, f.AlongA), c2 = Cross(f.AlongB, f.Bend);
  const V c1 = hn::Add(Cross(f.Low, f.Bend), Cross(f.AlongB, f.AlongA));
  const V discriminant = hn::Sub(hn::Mul(c1, c1), hn::Mul(hn::Mul(two, two), hn::Mul(c0, c2)));
  const auto isReal = hn::Gt(discriminant, zero);
  const V root = hn::Sqrt(hn::IfThenElse(isReal, discriminant, one));
  const V sum = hn::Add(hn::Abs(c1), root);
  const V q = hn::Mul(hn::Set(d, -0.5), hn::IfThenElse(hn::Lt(c1, zero), hn::Neg(sum), sum));
  const V b[2] = { hn::Div(c0, q), hn::Div(q, hn::IfThenElse(hn::Ne(c2, zero), c2, one)) };
  const V error =
    hn::Div(hn::Mul(hn::Set(d, HexahedronHits::ValueError), hn::Mul(f.Largest, f.Largest)), root);
  // Where a face is seen edge on, a and b mean nothing. A ray in it meets the faces beside it.
  const auto isClear = hn::And(isReal, hn::Le(error, hn::Set(d, HexahedronHits::MostError)));
  const auto isBent = hn::Ne(c2, zero), isMet = hn::AndNot(isPassedBy, isClear);
  const V margin = hn::Add(hn::Set(d, HexahedronHits::Margin), error);
  const V low = hn::Neg(margin), high = hn::Add(one, margin);
  for (std::size_t i = 0; i < 2; ++i)
  {
    const V a = f.FindA(b[i]);
    const auto isIn = hn::And(
      hn::And(hn::Ge(a, low), hn::Le(a, high)), hn::And(hn::Ge(b[i], low), hn::Le(b[i], high)));
    hits.IsHit[place + i] = hn::And(isMet, i == 0 ? isIn : hn::And(isIn, isBent));
    if (hn::AllFalse(d, hits.IsHit[place + i]))
    {
      hits.T[place + i] = hits.Value[place + i] = zero;
      continue;
    }
    const V inA = hn::Max(zero, hn::Min(a, one)), inB = hn::Max(zero, hn::Min(b[i], one));
    hits.T[place + i] = Mean(face.T, inA, inB);
    hits.Value[place + i] = Mean(face.Value, inA, inB);
  }
}

/// Store the span from the first to the last hit. Lanes with hits in between go to `others`.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void StoreSpans(D d, const FaceHits<D>& hits, const SeenFace<V> faces[6], std::size_t i,
  std::uint64_t wanted, CellSpans& spans, HexahedronHits& others)
{
  const V most = hn::Set(d, std::numeric_limits<double>::max()), zero = hn::Zero(d);
  V in = most, out = hn::Neg(most), atIn = zero, atOut = zero;
  hn::Mask<D> isHit = hn::Lt(most, zero), isBetween = isHit;
  for (std::size_t hit = 0; hit < hits.Most; ++hit)
  {
    const auto isFirst = hn::And(hits.IsHit[hit], hn::Lt(hits.T[hit], in));
    const auto isLast = hn::And(hits.IsHit[hit], hn::Gt(hits.T[hit], out));
    in = hn::IfThenElse(isFirst, hits.T[hit], in);
    atIn = hn::IfThenElse(isFirst, hits.Value[hit], atIn);
    out = hn::IfThenElse(isLast, hits.T[hit], out);
    atOut = hn::IfThenElse(isLast, hits.Value[hit], atOut);
    isHit = hn::Or(isHit, hits.IsHit[hit]);
  }
  V nearest = faces[0].T[0], farthest = nearest;
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const V t = faces[corner / 4].T[corner % 4];
    nearest = hn::Min(nearest, t);
    farthest = hn::Max(farthest, t);
  }
  const V size = hn::Mul(hn::Set(d, HexahedronHits::SameHit), hn::Sub(farthest, nearest));
  in = hn::IfThenElseZero(isHit, in);
  out = hn::IfThenElseZero(isHit, out);
  for (std::size_t hit = 0; hit < hits.Most; ++hit)
  {
    const auto isInner =
      hn::And(hn::Gt(hn::Sub(hits.T[hit], in), size), hn::Gt(hn::Sub(out, hits.T[hit]), size));
    isBetween = hn::Or(isBetween, hn::And(hits.IsHit[hit], isInner));
  }
  HWY_ALIGN double all[4][hn::MaxLanes(d)];
  hn::Store(in, d, all[0]);
  hn::Store(out, d, all[1]);
  hn::Store(atIn, d, all[2]);
  hn::Store(atOut, d, all[3]);
  const std::uint64_t met = wanted & BitsOf(d, isHit), several = met & BitsOf(d, isBetween);
  for (std::uint64_t left = met & ~several; left != 0; left &= left - 1)
  {
    const auto lane = static_cast<std::size_t>(hwy::Num0BitsBelowLS1Bit_Nonzero64(left));
    spans.Count[i + lane] = 1;
    spans.Spans[i + lane][0] = { all[0][lane], all[1][lane], all[2][lane], all[3][lane] };
  }
  if (several != 0)
  {
    others.Which |= several << i;
    HWY_ALIGN double t[hn::MaxLanes(d)], value[hn::MaxLanes(d)], same[hn::MaxLanes(d)];
    hn::Store(size, d, same);
    for (std::size_t hit = 0; hit < hits.Most; ++hit)
    {
      hn::Store(hits.T[hit], d, t);
      hn::Store(hits.Value[hit], d, value);
      const std::uint64_t these = several & BitsOf(d, hits.IsHit[hit]);
      for (std::uint64_t left = these; left != 0; left &= left - 1)
      {
        const auto lane = static_cast<std::size_t>(hwy::Num0BitsBelowLS1Bit_Nonzero64(left));
        others.Add(i + lane, t[lane], value[lane], same[lane]);
      }
    }
  }
}

/// The eight corners of one cell as rays see them.
template <class D>
struct SeenCorners
{
  using V = hn::Vec<D>;
  template <class Points>
  HWY_INLINE SeenCorners(const ShearedRays<D>& rays, const Points& points)
  {
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      rays.See(points, corner, this->X[corner], this->Y[corner], this->T[corner]);
      this->Value[corner] = points.Value(corner);
    }
  }

  V X[8], Y[8], T[8], Value[8];
};

/// Find the spans of a vector of rays in a cell.
/// \param i the first ray
template <class D>
HWY_INLINE void FindSpans(D d, const SeenCorners<D>& corners, const HexahedronFaces& faces,
  std::size_t i, std::uint64_t wanted, CellSpans& spans, HexahedronHits& others)
{
  SeenFace<hn::Vec<D>> seen[6];
  FaceHits<D> hits;
  for (std::size_t face = 0; face < 6; ++face)
  {
    for (std::size_t corner = 0; corner < 4; ++corner)
    {
      const std::size_t from = faces.Corners[face][corner];
      seen[face].X[corner] = corners.X[from];
      seen[face].Y[corner] = corners.Y[from];
      seen[face].T[corner] = corners.T[from];
      seen[face].Value[corner] = corners.Value[from];
    }
    AddHits(d, seen[face], 2 * face, hits);
  }
  StoreSpans(d, hits, seen, i, wanted, spans, others);
}

void HexahedronSpansOf(const CornerPoints<8>& points, const HexahedronFaces& faces,
  const MeshRays& rays, std::uint64_t which, CellSpans& spans, HexahedronHits& others)
{
  ForEachVector(rays, which, points,
    [&](auto d, const auto& cell, const auto& vector, std::size_t i, std::uint64_t wanted) HWY_ATTR
    { FindSpans(d, SeenCorners<decltype(d)>(vector, cell), faces, i, wanted, spans, others); });
}

}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{
namespace MeshKernels
{

namespace
{

/// Find the spans between successive hits. A span counts if its midpoint lies in the cell.
void FindFoldedSpans(
  const MeshCell& cell, HexahedronHits& hits, const MeshRays& rays, CellSpans& spans)
{
  for (std::size_t ray = 0; ray < MeshRays::Capacity; ++ray)
  {
    if ((hits.Which >> ray & 1u) == 0)
    {
      continue;
    }
    auto& of = hits.Hits[ray];
    const std::size_t count = hits.Count[ray];
    std::stable_sort(of.begin(), of.begin() + static_cast<std::ptrdiff_t>(count),
      [](const auto& a, const auto& b) { return a.T < b.T; });
    std::uint8_t& found = spans.Count[ray];
    bool goesOn = false;
    std::size_t last = 0;
    for (std::size_t next = 1; next < count; ++next)
    {
      if (of[next].T - of[last].T <= hits.Same[ray] && next + 1 < count)
      {
        continue;
      }
      HexahedronRoots roots;
      FindRoots(SeeFrom(cell, rays, ray, 0.5 * (of[last].T + of[next].T)), roots);
      const bool isIn = roots.Count > 0;
      if (isIn && !goesOn && found < CellSpans::Most)
      {
        spans.Spans[ray][found++] = { of[last].T, of[next].T, of[last].Value, of[next].Value };
      }
      else if (isIn)
      {
        spans.Spans[ray][found - 1u].Out = of[next].T;
        spans.Spans[ray][found - 1u].AtOut = of[next].Value;
      }
      goesOn = isIn;
      last = next;
    }
  }
}

}

HWY_EXPORT(HexahedronSpansOf);

void HexahedronSpans(const MeshCell& cell, const CellDifferences& differences, const MeshRays& rays,
  std::uint64_t which, CellSpans& spans)
{
  spans.Count.fill(0);
  HexahedronHits others;
  const CornerPoints<8> points = { cell.Points, differences };
  HWY_DYNAMIC_DISPATCH(HexahedronSpansOf)
  (points, HexahedronFaces(points), rays, which, spans, others);
  FindFoldedSpans(cell, others, rays, spans);
}

}
}
#endif
