// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Where rays are in tetrahedra, in vectors of rays. Kernels include this file once for each kind of
// vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsTetrahedronSpan_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsTetrahedronSpan_inl_h
#undef TemporalCoherence_KernelsTetrahedronSpan_inl_h
#else
#define TemporalCoherence_KernelsTetrahedronSpan_inl_h
#endif

#include "Mesh/Cells/KernelsSheared-inl.h"

#include <cmath>
#include <limits>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace MeshKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Intervals of a vector of rays in a tetrahedron.
template <class D, class V = hn::Vec<D>>
struct TetrahedronSpan
{
  hn::Mask<D> IsHit;
  V In, Out, AtIn, AtOut;
};

/// A tetrahedron as rays see it: vertices ascending, as TetrahedronPoints has them.
template <class D, class V = hn::Vec<D>>
struct SeenTetrahedron
{
  V X[4], Y[4], T[4], Value[4];
  V Edge[6]; ///< cross products of its ends: 01, 02, 03, 12, 13, 23
};

/// The face opposite to a vertex. The cross product of each edge weights the face's other vertex;
/// the middle one is negated.
struct FaceParts
{
  std::size_t First, Second, Third;       ///< vertices
  std::size_t OfFirst, OfSecond, OfThird; ///< edges
};
constexpr FaceParts Faces[4] = { { 1, 2, 3, 5, 4, 3 }, { 0, 2, 3, 5, 2, 1 }, { 0, 1, 3, 4, 2, 0 },
  { 0, 1, 2, 3, 1, 0 } };
constexpr std::size_t EdgeEnds[6][2] = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 3 },
  { 2, 3 } };

/// Hits of rays with a face.
template <class V>
struct FacePoint
{
  V T, Value;
};

template <class D, class V = hn::Vec<D>>
HWY_INLINE FacePoint<V> PointOnFace(D d, const SeenTetrahedron<D>& seen, const FaceParts& face)
{
  const V first = seen.Edge[face.OfFirst], second = hn::Neg(seen.Edge[face.OfSecond]);
  const V third = seen.Edge[face.OfThird];
  const V sum = hn::Add(hn::Add(first, second), third), one = hn::Set(d, 1.0);
  const V scale = hn::Div(one, hn::IfThenElse(hn::Eq(sum, hn::Zero(d)), one, sum));
  const V a = hn::Mul(first, scale), b = hn::Mul(second, scale), c = hn::Mul(third, scale);
  const auto mean = [&](const V of[4]) HWY_ATTR
  {
    return hn::Add(
      hn::Add(hn::Mul(a, of[face.First]), hn::Mul(b, of[face.Second])), hn::Mul(c, of[face.Third]));
  };
  return { mean(seen.T), mean(seen.Value) };
}

/// If a ray goes exactly through an edge of the face, find the point from the edge alone. So all
/// faces at an edge find one point, and all faces at a vertex find the vertex.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void TakeEdges(
  D d, const SeenTetrahedron<D>& seen, const FaceParts& face, FacePoint<V>& point)
{
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0);
  for (const std::size_t edge : { face.OfFirst, face.OfSecond, face.OfThird })
  {
    const std::size_t i = EdgeEnds[edge][0], j = EdgeEnds[edge][1];
    const V x = hn::Sub(seen.X[i], seen.X[j]), y = hn::Sub(seen.Y[i], seen.Y[j]);
    const auto isAlongX = hn::Ge(hn::Abs(x), hn::Abs(y));
    const V from = hn::IfThenElse(isAlongX, seen.X[i], seen.Y[i]);
    const V length = hn::IfThenElse(isAlongX, x, y);
    const auto isOn = hn::And(hn::Eq(seen.Edge[edge], zero), hn::Ne(length, zero));
    const V share = hn::Div(from, hn::IfThenElse(isOn, length, one));
    const V ofJ = hn::Min(hn::Max(share, zero), one), ofI = hn::Sub(one, ofJ);
    const auto mean = [&](const V of[4]) HWY_ATTR
    { return hn::Add(hn::Mul(ofI, of[i]), hn::Mul(ofJ, of[j])); };
    point.T = hn::IfThenElse(isOn, mean(seen.T), point.T);
    point.Value = hn::IfThenElse(isOn, mean(seen.Value), point.Value);
  }
}

/// \tparam Points as Sheared-inl has them
template <class D, class Points>
HWY_INLINE SeenTetrahedron<D> See(const ShearedRays<D>& rays, const Points& points)
{
  SeenTetrahedron<D> seen;
  for (std::size_t vertex = 0; vertex < 4; ++vertex)
  {
    rays.See(points, vertex, seen.X[vertex], seen.Y[vertex], seen.T[vertex]);
    seen.Value[vertex] = points.Value(vertex);
  }
  for (std::size_t edge = 0; edge < 6; ++edge)
  {
    const std::size_t i = EdgeEnds[edge][0], j = EdgeEnds[edge][1];
    seen.Edge[edge] = hn::Sub(hn::Mul(seen.X[i], seen.Y[j]), hn::Mul(seen.Y[i], seen.X[j]));
  }
  return seen;
}

/// Complete a span: a ray that touches a cell has only an entry or only an exit. Make its distances
/// ascend.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void Finish(D d, TetrahedronSpan<D>& span)
{
  const V most = hn::Set(d, std::numeric_limits<double>::max());
  const auto isIn = hn::Lt(span.In, most), isOut = hn::Gt(span.Out, hn::Neg(most));
  span.IsHit = hn::Or(isIn, isOut);
  span.AtIn = hn::IfThenElse(isIn, span.AtIn, span.AtOut);
  span.AtOut = hn::IfThenElse(isOut, span.AtOut, span.AtIn);
  const V in = hn::IfThenElseZero(span.IsHit, hn::IfThenElse(isIn, span.In, span.Out));
  const V out = hn::IfThenElseZero(span.IsHit, hn::IfThenElse(isOut, span.Out, span.In));
  const auto isReversed = hn::Gt(in, out);
  span.In = hn::IfThenElse(isReversed, out, in);
  span.Out = hn::IfThenElse(isReversed, in, out);
}

template <class D, class Points, class V = hn::Vec<D>>
HWY_INLINE TetrahedronSpan<D> FindSpan(D d, const ShearedRays<D>& rays, const Points& points)
{
  const SeenTetrahedron<D> seen = See(rays, points);
  const V zero = hn::Zero(d);
  hn::Mask<D> isLow[6], isHigh[6];
  for (std::size_t edge = 0; edge < 6; ++edge)
  {
    isLow[edge] = hn::Le(seen.Edge[edge], zero);
    isHigh[edge] = hn::Ge(seen.Edge[edge], zero);
  }
  const V most = hn::Set(d, std::numeric_limits<double>::max());
  TetrahedronSpan<D> span;
  span.In = most;
  span.Out = hn::Neg(most);
  span.AtIn = span.AtOut = zero;
  // The tetrahedron's orientation decides which faces are entries, not distances, whose order
  // rounding errors may change. So rays pass a chain of cells in order, however thin the cells are.
  auto isEntered = hn::Lt(hn::Mul(rays.PerDepth, points.Handedness()), zero);
  for (const FaceParts& face : Faces)
  {
    // A ray hits a face if all edges turn around it in one direction.
    const auto first = face.OfFirst, second = face.OfSecond, third = face.OfThird;
    const auto isLeft = hn::And(hn::And(isHigh[first], isLow[second]), isHigh[third]);
    const auto isRight = hn::And(hn::And(isLow[first], isHigh[second]), isLow[third]);
    const auto isSeenFlat = hn::And(isLeft, isRight);
    const auto isHit = hn::AndNot(isSeenFlat, hn::Or(isLeft, isRight));
    isEntered = hn::Not(isEntered);
    if (hn::AllFalse(d, isHit))
    {
      continue;
    }
    FacePoint<V> point = PointOnFace(d, seen, face);
    const auto isOnEdge =
      hn::Or(hn::Or(hn::And(isLow[first], isHigh[first]), hn::And(isLow[second], isHigh[second])),
        hn::And(isLow[third], isHigh[third]));
    if (!hn::AllFalse(d, hn::And(isHit, isOnEdge)))
    {
      TakeEdges(d, seen, face, point);
    }
    const auto isIn = hn::And(isHit, hn::Xor(isEntered, isLeft));
    const auto isFirst = hn::And(isIn, hn::Lt(point.T, span.In));
    const auto isLast = hn::And(hn::AndNot(isIn, isHit), hn::Gt(point.T, span.Out));
    span.In = hn::IfThenElse(isFirst, point.T, span.In);
    span.AtIn = hn::IfThenElse(isFirst, point.Value, span.AtIn);
    span.Out = hn::IfThenElse(isLast, point.T, span.Out);
    span.AtOut = hn::IfThenElse(isLast, point.Value, span.AtOut);
  }
  Finish(d, span);
  return span;
}

/// Where a vector of rays crosses the surface.
template <class D>
struct CrossingsOfSpan
{
  using V = hn::Vec<D>;

  HWY_INLINE CrossingsOfSpan(D d, const TetrahedronSpan<D>& span, std::uint64_t wanted)
  {
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0);
    const auto rises = hn::Lt(span.AtIn, zero);
    const auto isCrossed = hn::And(span.IsHit, hn::Xor(rises, hn::Lt(span.AtOut, zero)));
    this->T = zero;
    this->Met = this->Rising = 0;
    wanted &= BitsOf(d, isCrossed);
    if (wanted == 0)
    {
      return;
    }
    const V change = hn::IfThenElse(isCrossed, hn::Sub(span.AtIn, span.AtOut), one);
    const V t = hn::Add(span.In, hn::Mul(hn::Div(span.AtIn, change), hn::Sub(span.Out, span.In)));
    const V at = hn::Max(span.In, hn::Min(t, span.Out));
    this->T = hn::Add(at, zero);
    // An entry at the cell's exit must come before surfaces that begin at this exit.
    const auto isLate = hn::And(hn::Ge(at, span.Out), hn::Lt(span.In, span.Out));
    this->Rising = wanted & BitsOf(d, rises);
    this->ComeBefore(d, this->Rising & BitsOf(d, isLate));
    this->Met = wanted;
  }

  V T;
  std::uint64_t Met, Rising; ///< one bit for each ray

private:
  HWY_INLINE void ComeBefore(D d, std::uint64_t late)
  {
    if (late == 0)
    {
      return;
    }
    HWY_ALIGN double all[hn::MaxLanes(d)];
    hn::Store(this->T, d, all);
    for (; late != 0; late &= late - 1)
    {
      double& t = all[hwy::Num0BitsBelowLS1Bit_Nonzero64(late)];
      t = std::nextafter(t, -std::numeric_limits<double>::max());
    }
    this->T = hn::Load(d, all);
  }
};

/// Append the crossings of a vector of rays between Begin and End.
/// \param places of the rays
template <class D, class V = hn::Vec<D>>
HWY_INLINE void AppendCrossings(D d, const TetrahedronSpan<D>& span, const MeshRays& rays,
  const std::int64_t* places, std::uint64_t wanted, Crossings& found)
{
  const CrossingsOfSpan<D> crossings(d, span, wanted);
  HWY_ALIGN double all[hn::MaxLanes(d)];
  hn::Store(crossings.T, d, all);
  for (std::uint64_t left = crossings.Met; left != 0; left &= left - 1)
  {
    const auto lane = static_cast<std::size_t>(hwy::Num0BitsBelowLS1Bit_Nonzero64(left));
    const auto ray = static_cast<std::size_t>(places[lane]);
    if (all[lane] >= rays.Begin[ray] && all[lane] <= rays.End[ray])
    {
      found.Append(ray, all[lane], (crossings.Rising >> lane & 1u) != 0);
    }
  }
}

template <class D>
HWY_INLINE void StoreSpans(
  D d, const TetrahedronSpan<D>& span, std::size_t i, std::uint64_t wanted, CellSpans& spans)
{
  HWY_ALIGN double all[4][hn::MaxLanes(d)];
  hn::Store(span.In, d, all[0]);
  hn::Store(span.Out, d, all[1]);
  hn::Store(span.AtIn, d, all[2]);
  hn::Store(span.AtOut, d, all[3]);
  for (wanted &= BitsOf(d, span.IsHit); wanted != 0; wanted &= wanted - 1)
  {
    const auto lane = static_cast<std::size_t>(hwy::Num0BitsBelowLS1Bit_Nonzero64(wanted));
    spans.Count[i + lane] = 1;
    spans.Spans[i + lane][0] = { all[0][lane], all[1][lane], all[2][lane], all[3][lane] };
  }
}

/// Append the spans with values between `low` and `high`, for a vector of rays from ray i on.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void AppendSpans(D d, const TetrahedronSpan<D>& span, V low, V high, std::size_t i,
  std::uint64_t wanted, SpanList& found)
{
  const auto isAbove = hn::Gt(hn::Min(span.AtIn, span.AtOut), high);
  const auto isBelow = hn::Lt(hn::Max(span.AtIn, span.AtOut), low);
  wanted &= BitsOf(d, hn::AndNot(hn::Or(isAbove, isBelow), span.IsHit));
  if (wanted == 0)
  {
    return;
  }
  const std::uint8_t bits[8] = { static_cast<std::uint8_t>(wanted) };
  const auto isTaken = hn::LoadMaskBits(d, bits);
  hn::CompressBlendedStore(span.In, isTaken, d, &found.In[found.Count]);
  hn::CompressBlendedStore(span.Out, isTaken, d, &found.Out[found.Count]);
  hn::CompressBlendedStore(span.AtIn, isTaken, d, &found.AtIn[found.Count]);
  hn::CompressBlendedStore(span.AtOut, isTaken, d, &found.AtOut[found.Count]);
  for (; wanted != 0; wanted &= wanted - 1)
  {
    found.Ray[found.Count++] =
      static_cast<std::uint8_t>(i + hwy::Num0BitsBelowLS1Bit_Nonzero64(wanted));
  }
}

}
}
}
HWY_AFTER_NAMESPACE();

#endif
