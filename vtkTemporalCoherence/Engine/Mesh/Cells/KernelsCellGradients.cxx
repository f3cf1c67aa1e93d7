// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Cells/KernelsCellGradients.h"

#include "Mesh/Cells/CellPoints.h"
#include "Mesh/Cells/Trilinear.h"

#include <algorithm>
#include <array>
#include <cmath>

#ifndef TemporalCoherence_PlacedCell // this file is included once for each kind of vectors
#define TemporalCoherence_PlacedCell
namespace TemporalCoherence
{
namespace MeshKernels
{

/// A cell, ready for the search of points: coordinates and values as trilinear functions, with
/// lengths divided by a power of two near the cell's size.
struct alignas(64) PlacedCell
{
  /// Longest last step of Newton's method. The remaining error is about its square.
  static constexpr double ShortStep = 1e-6;
  /// A longer step starts at a place without volume.
  static constexpr double LongStep = 1e6;
  /// Places are kept in [-FarAway, FarAway].
  static constexpr double FarAway = 2.0;
  /// Places up to this coordinate count as points of the face.
  static constexpr double Border = 1.0 + 1e-5;
  /// Edges are flat if their volume is below this share of the product of their lengths.
  static constexpr double LeastVolume = 1e-9;
  /// The steepest gradient for cells of length 1, and the largest coefficient.
  static constexpr double Steepest = 1e100;

  static constexpr std::size_t Size = 32;

  std::array<double, Size> Numbers; ///< coefficients of x, y, z and the value
  glm::dvec3 Origin;
  double PerLength;  ///< a power of two
  double FirstValue; ///< subtracted from all values

  void Place(const MeshCell& cell)
  {
    this->Origin = cell.Points[0];
    this->FirstValue = cell.Values[0];
    const auto count = static_cast<std::size_t>(cell.NumberOfPoints());
    double largest = 0.0;
    for (std::size_t i = 1; i < count; ++i)
    {
      const glm::dvec3 edge = glm::abs(cell.Points[i] - this->Origin);
      largest = std::max({ largest, edge.x, edge.y, edge.z });
    }
    this->PerLength =
      largest > 0.0 && largest < Steepest ? std::ldexp(1.0, -std::ilogb(largest)) : 1.0;
    for (int a = 0; a < 3; ++a)
    {
      this->Take(cell, static_cast<std::size_t>(a),
        [&](std::size_t i) { return this->PerLength * (cell.Points[i][a] - this->Origin[a]); });
    }
    this->Take(cell, 3, [&](std::size_t i) { return cell.Values[i] - cell.Values[0]; });
  }

private:
  /// A tetrahedron is the corner of a parallelepiped.
  template <typename Corner>
  void Take(const MeshCell& cell, std::size_t function, const Corner& corner)
  {
    Trilinear c{};
    if (cell.Shape == MeshCellShape::Tetrahedron)
    {
      const double x = 0.5 * corner(1), y = 0.5 * corner(2), z = 0.5 * corner(3);
      c = { x + y + z, x, y, 0.0, z, 0.0, 0.0, 0.0 };
    }
    else
    {
      for (std::size_t i = 0; i < 8; ++i)
      {
        c[i] = corner(i);
      }
      c = TrilinearOf(c);
    }
    std::copy(
      c.begin(), c.end(), this->Numbers.begin() + static_cast<std::ptrdiff_t>(8 * function));
  }
};

}
}
#endif

// This file is compiled once for each kind of vectors. The best one for the machine is chosen at
// run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Mesh/Cells/KernelsCellGradients.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace MeshKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// A vector for each axis.
template <class V>
struct Axes
{
  V X, Y, Z;
};

template <class V>
HWY_INLINE Axes<V> Cross(const Axes<V>& a, const Axes<V>& b)
{
  return { hn::Sub(hn::Mul(a.Y, b.Z), hn::Mul(a.Z, b.Y)),
    hn::Sub(hn::Mul(a.Z, b.X), hn::Mul(a.X, b.Z)), hn::Sub(hn::Mul(a.X, b.Y), hn::Mul(a.Y, b.X)) };
}

template <class V>
HWY_INLINE V Dot(const Axes<V>& a, const Axes<V>& b)
{
  return hn::Add(hn::Add(hn::Mul(a.X, b.X), hn::Mul(a.Y, b.Y)), hn::Mul(a.Z, b.Z));
}

/// The largest coordinate without its sign.
template <class V>
HWY_INLINE V LargestOf(const Axes<V>& a)
{
  return hn::Max(hn::Abs(a.X), hn::Max(hn::Abs(a.Y), hn::Abs(a.Z)));
}

/// True where all coordinates are between -limit and limit, and so none is NaN.
template <class V>
HWY_INLINE auto AreWithin(const Axes<V>& a, V limit)
{
  return hn::And(
    hn::And(hn::Le(hn::Abs(a.X), limit), hn::Le(hn::Abs(a.Y), limit)), hn::Le(hn::Abs(a.Z), limit));
}

/// A trilinear function, in vectors of points.
template <class V>
struct TrilinearVectors
{
  V C[8];

  HWY_INLINE V ValueAt(const Axes<V>& u) const
  {
    const V low =
      hn::Add(hn::Add(C[0], hn::Mul(u.X, C[1])), hn::Mul(u.Y, hn::Add(C[2], hn::Mul(u.X, C[3]))));
    const V high =
      hn::Add(hn::Add(C[4], hn::Mul(u.X, C[5])), hn::Mul(u.Y, hn::Add(C[6], hn::Mul(u.X, C[7]))));
    return hn::Add(low, hn::Mul(u.Z, high));
  }

  HWY_INLINE Axes<V> SlopesAt(const Axes<V>& u) const
  {
    const V z = hn::Add(C[6], hn::Mul(u.X, C[7]));
    return { hn::Add(
               hn::Add(C[1], hn::Mul(u.Y, C[3])), hn::Mul(u.Z, hn::Add(C[5], hn::Mul(u.Y, C[7])))),
      hn::Add(hn::Add(C[2], hn::Mul(u.X, C[3])), hn::Mul(u.Z, z)),
      hn::Add(hn::Add(C[4], hn::Mul(u.X, C[5])), hn::Mul(u.Y, z)) };
  }
};

/// The trilinear functions of a cell, in all lanes.
template <class D>
struct CellVectors
{
  using V = hn::Vec<D>;
  TrilinearVectors<V> Place[3], Value;

  HWY_INLINE CellVectors(D d, const PlacedCell& cell)
  {
    for (std::size_t k = 0; k < 8; ++k)
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        this->Place[a].C[k] = hn::Set(d, cell.Numbers[8 * a + k]);
      }
      this->Value.C[k] = hn::Set(d, cell.Numbers[24 + k]);
    }
  }
};

/// Derivatives of a place by the coordinates of the cell, one row for each coordinate of the place.
template <class V>
struct Jacobian
{
  Axes<V> X, Y, Z;

  HWY_INLINE Jacobian(const TrilinearVectors<V> place[3], const Axes<V>& u)
    : X(place[0].SlopesAt(u))
    , Y(place[1].SlopesAt(u))
    , Z(place[2].SlopesAt(u))
  {
  }
};

/// Find the coordinates of points in their cell, in [-1, 1], by Newton's method.
/// \return lanes whose point was found in the cell
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> FindPlaces(
  D d, const CellVectors<D>& cells, const Axes<V>& point, Axes<V>& at)
{
  // Each lane stops by itself, so that no result depends on the other points of a vector.
  constexpr int mostSteps = 8;
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0);
  const V isShort = hn::Set(d, PlacedCell::ShortStep), isLong = hn::Set(d, PlacedCell::LongStep);
  const V most = hn::Set(d, PlacedCell::FarAway), least = hn::Neg(most);
  at = { zero, zero, zero };
  hn::Mask<D> isOpen = hn::Eq(zero, zero), isFound = hn::Ne(zero, zero);
  for (int step = 0; step < mostSteps && !hn::AllFalse(d, isOpen); ++step)
  {
    const Axes<V> wrong = { hn::Sub(cells.Place[0].ValueAt(at), point.X),
      hn::Sub(cells.Place[1].ValueAt(at), point.Y), hn::Sub(cells.Place[2].ValueAt(at), point.Z) };
    const Jacobian<V> slopes(cells.Place, at);
    // Cramer's rule with the rows of the Jacobian.
    const Axes<V> yz = Cross(slopes.Y, slopes.Z), zx = Cross(slopes.Z, slopes.X);
    const Axes<V> xy = Cross(slopes.X, slopes.Y);
    const V volume = Dot(slopes.X, yz);
    const V scale = hn::Div(one, hn::IfThenElse(hn::Eq(volume, zero), one, volume));
    const V x = hn::Mul(wrong.X, scale), y = hn::Mul(wrong.Y, scale), z = hn::Mul(wrong.Z, scale);
    const auto moveOf = [&](const V& ofX, const V& ofY, const V& ofZ) HWY_ATTR
    { return hn::Add(hn::Add(hn::Mul(x, ofX), hn::Mul(y, ofY)), hn::Mul(z, ofZ)); };
    const Axes<V> move = { moveOf(yz.X, zx.X, xy.X), moveOf(yz.Y, zx.Y, xy.Y),
      moveOf(yz.Z, zx.Z, xy.Z) };
    // Lanes without a number, or without volume, are given up.
    isOpen = hn::And(isOpen, hn::And(AreWithin(move, isLong), hn::Ne(volume, zero)));
    const auto moved = [&](const V& from, const V& by) HWY_ATTR
    { return hn::IfThenElse(isOpen, hn::Min(hn::Max(hn::Sub(from, by), least), most), from); };
    at = { moved(at.X, move.X), moved(at.Y, move.Y), moved(at.Z, move.Z) };
    const auto isDone = hn::And(isOpen, AreWithin(move, isShort));
    isFound = hn::Or(isFound, isDone);
    isOpen = hn::AndNot(isDone, isOpen);
  }
  isFound = hn::And(isFound, AreWithin(at, hn::Set(d, PlacedCell::Border)));
  const auto inside = [&](const V& u) HWY_ATTR { return hn::Min(hn::Max(u, hn::Neg(one)), one); };
  at = { inside(at.X), inside(at.Y), inside(at.Z) };
  return isFound;
}

/// Find the gradients of the values at places in the cell.
/// \return lanes with a usable gradient
template <class D, class V = hn::Vec<D>>
HWY_INLINE hn::Mask<D> FindSlopes(
  D d, const CellVectors<D>& cells, const Axes<V>& at, Axes<V>& gradient)
{
  const Jacobian<V> slopes(cells.Place, at);
  // Cramer's rule with the columns of the Jacobian.
  const Axes<V> alongX = { slopes.X.X, slopes.Y.X, slopes.Z.X };
  const Axes<V> alongY = { slopes.X.Y, slopes.Y.Y, slopes.Z.Y };
  const Axes<V> alongZ = { slopes.X.Z, slopes.Y.Z, slopes.Z.Z };
  const Axes<V> yz = Cross(alongY, alongZ), zx = Cross(alongZ, alongX);
  const Axes<V> xy = Cross(alongX, alongY), value = cells.Value.SlopesAt(at);
  const V volume = Dot(alongX, yz);
  const V box = hn::Mul(LargestOf(alongX), hn::Mul(LargestOf(alongY), LargestOf(alongZ)));
  const auto isThick = hn::Gt(hn::Abs(volume), hn::Mul(hn::Set(d, PlacedCell::LeastVolume), box));
  const V scale = hn::Div(hn::Set(d, 1.0), hn::IfThenElse(isThick, volume, hn::Set(d, 1.0)));
  const auto meanOf = [&](const V& ofX, const V& ofY, const V& ofZ) HWY_ATTR
  {
    return hn::Mul(
      scale, hn::Add(hn::Add(hn::Mul(value.X, ofX), hn::Mul(value.Y, ofY)), hn::Mul(value.Z, ofZ)));
  };
  gradient = { meanOf(yz.X, zx.X, xy.X), meanOf(yz.Y, zx.Y, xy.Y), meanOf(yz.Z, zx.Z, xy.Z) };
  return hn::And(isThick, AreWithin(gradient, hn::Set(d, PlacedCell::Steepest)));
}

/// Tetrahedra, one in each lane.
template <class D>
struct TetrahedronVectors
{
  using V = hn::Vec<D>;
  Axes<V> Edge[3]; ///< from point 0 to the others
  V Rise[3];       ///< of values along the edges

  HWY_INLINE TetrahedronVectors(D d, const TetrahedronLanes& cells, std::size_t i)
  {
    const auto along = [&](std::size_t edge, std::size_t k) HWY_ATTR
    {
      const V to = hn::Load(d, &cells.Numbers[edge + 1][k][i]);
      return hn::Sub(to, hn::Load(d, &cells.Numbers[0][k][i]));
    };
    for (std::size_t edge = 0; edge < 3; ++edge)
    {
      this->Edge[edge] = { along(edge, 0), along(edge, 1), along(edge, 2) };
      this->Rise[edge] = along(edge, 3);
    }
  }
};

/// The gradients of tetrahedra, step by step as GradientAt finds them.
/// \return a bit for each tetrahedron with volume; results of others have no meaning
std::uint64_t GradientsOfTetrahedra(
  const TetrahedronLanes& cells, PointsInCells::Vectors& gradients)
{
  using D = hn::CappedTag<double, 8>;
  using V = hn::Vec<D>;
  const D d;
  std::uint64_t found = 0;
  for (std::size_t i = 0; i < cells.Count; i += hn::Lanes(d))
  {
    const TetrahedronVectors<D> cell(d, cells, i);
    Axes<V> unit[3];
    V rise[3];
    auto isThick = hn::Eq(hn::Zero(d), hn::Zero(d));
    for (std::size_t edge = 0; edge < 3; ++edge)
    {
      const Axes<V>& along = cell.Edge[edge];
      const V largest = LargestOf(along);
      isThick = hn::And(isThick, hn::Gt(largest, hn::Zero(d)));
      unit[edge] = { hn::Div(along.X, largest), hn::Div(along.Y, largest),
        hn::Div(along.Z, largest) };
      rise[edge] = hn::Div(cell.Rise[edge], largest);
    }
    const Axes<V> yz = Cross(unit[1], unit[2]), zx = Cross(unit[2], unit[0]);
    const Axes<V> xy = Cross(unit[0], unit[1]);
    const V volume = Dot(unit[0], yz);
    isThick = hn::And(isThick, hn::Gt(hn::Abs(volume), hn::Set(d, LeastCornerVolume)));
    const auto store = [&](const V& ofX, const V& ofY, const V& ofZ, std::size_t a) HWY_ATTR
    {
      const V sum =
        hn::Add(hn::Add(hn::Mul(rise[0], ofX), hn::Mul(rise[1], ofY)), hn::Mul(rise[2], ofZ));
      hn::Store(hn::Div(sum, volume), d, gradients[a].data() + i);
    };
    store(yz.X, zx.X, xy.X, 0);
    store(yz.Y, zx.Y, xy.Y, 1);
    store(yz.Z, zx.Z, xy.Z, 2);
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, isThick, bits);
    found |= std::uint64_t(bits[0]) << i;
  }
  return found;
}

/// A vector of points of a cell.
template <class D>
struct PointVector
{
  using V = hn::Vec<D>;
  using DI = hn::RebindToSigned<D>;

  /// Take points from `left`, one bit each, until the vector is full.
  HWY_INLINE PointVector(std::uint64_t& left, const PointsInCells::Vectors& points)
  {
    const D d;
    std::int64_t point = 0;
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
    {
      // Surplus lanes repeat the last point.
      if (left != 0)
      {
        point = static_cast<std::int64_t>(hwy::Num0BitsBelowLS1Bit_Nonzero64(left));
        left &= left - 1;
        ++this->Count;
      }
      this->Which[lane] = point;
    }
    this->At = { this->Gather(points[0]), this->Gather(points[1]), this->Gather(points[2]) };
  }

  HWY_INLINE V Gather(const TileArray<double>& numbers) const
  {
    return hn::GatherIndex(D(), numbers.data(), hn::Load(DI(), this->Which));
  }

  HWY_INLINE void Put(const Axes<V>& values, PointsInCells::Vectors& points) const
  {
    const D d;
    HWY_ALIGN double all[3][hn::MaxLanes(d)];
    hn::Store(values.X, d, all[0]);
    hn::Store(values.Y, d, all[1]);
    hn::Store(values.Z, d, all[2]);
    for (std::size_t lane = 0; lane < this->Count; ++lane)
    {
      const auto to = static_cast<std::size_t>(this->Which[lane]);
      points[0][to] = all[0][lane];
      points[1][to] = all[1][lane];
      points[2][to] = all[2][lane];
    }
  }

  /// \param bits of lanes
  HWY_INLINE std::uint64_t PointsOf(std::uint64_t bits) const
  {
    std::uint64_t points = 0;
    for (std::size_t lane = 0; lane < this->Count; ++lane)
    {
      points |= (bits >> lane & 1u) << this->Which[lane];
    }
    return points;
  }

  Axes<V> At;

private:
  HWY_ALIGN std::int64_t Which[hn::MaxLanes(D())];
  std::size_t Count = 0;
};

/// Upper bound of the range of a cell's values, from the coefficients of their function.
inline double RangeOf(const PlacedCell& cell)
{
  double sum = 0.0;
  for (std::size_t k = 25; k < PlacedCell::Size; ++k)
  {
    sum += 2.0 * std::abs(cell.Numbers[k]);
  }
  return sum;
}

/// \param which points of the cell, one bit each
/// \return bits of the found points; results of others have no meaning
std::uint64_t GradientsInCell(const PlacedCell& cell, std::uint64_t which, PointsInCells& points)
{
  using D = hn::CappedTag<double, 8>;
  using V = hn::Vec<D>;
  const D d;
  const V half = hn::Set(d, 0.5), perLength = hn::Set(d, cell.PerLength);
  const CellVectors<D> placed(d, cell);
  std::uint64_t found = 0;
  while (which != 0)
  {
    const PointVector<D> vector(which, points.Point);
    const auto relative = [&](const V& coordinate, int a) HWY_ATTR
    { return hn::Mul(perLength, hn::Sub(coordinate, hn::Set(d, cell.Origin[a]))); };
    const Axes<V> point = { relative(vector.At.X, 0), relative(vector.At.Y, 1),
      relative(vector.At.Z, 2) };
    Axes<V> at, gradient;
    const auto isIn = FindPlaces(d, placed, point, at);
    const auto isSloped = FindSlopes(d, placed, at, gradient);
    auto isFound = hn::And(isIn, isSloped);
    if (points.HasValues)
    {
      // Unknown values are NaN.
      const V value = hn::Sub(vector.Gather(points.Value), hn::Set(d, cell.FirstValue));
      const V wrong = hn::Abs(hn::Sub(placed.Value.ValueAt(at), value));
      isFound = hn::AndNot(hn::Gt(wrong, hn::Set(d, SameValue * RangeOf(cell))), isFound);
    }
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, isFound, bits);
    found |= vector.PointsOf(bits[0]);
    if (points.HasPlaces)
    {
      const auto inUnit = [&](const V& u) HWY_ATTR { return hn::Add(half, hn::Mul(half, u)); };
      vector.Put({ inUnit(at.X), inUnit(at.Y), inUnit(at.Z) }, points.At);
    }
    vector.Put({ hn::Mul(perLength, gradient.X), hn::Mul(perLength, gradient.Y),
                 hn::Mul(perLength, gradient.Z) },
      points.Gradient);
  }
  return found;
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

void Set(PointsInCells::Vectors& vectors, std::size_t i, const glm::dvec3& vector)
{
  for (std::size_t a = 0; a < 3; ++a)
  {
    vectors[a][i] = vector[static_cast<int>(a)];
  }
}

glm::dvec3 Get(const PointsInCells::Vectors& vectors, std::size_t i)
{
  return { vectors[0][i], vectors[1][i], vectors[2][i] };
}

}

HWY_EXPORT(GradientsInCell);
HWY_EXPORT(GradientsOfTetrahedra);

void FindCellGradients(const MeshCell* cells, std::size_t numberOfCells, PointsInCells& points)
{
  std::array<std::uint64_t, PointsInCells::Capacity + 1> ofCells{};
  for (std::size_t i = 0; i < points.Count; ++i)
  {
    ofCells[points.Cell[i]] |= std::uint64_t(1) << i;
  }
  for (std::size_t cell = 0; cell < numberOfCells; ++cell)
  {
    // Tetrahedra are searched only for places. Their gradients follow below.
    if (ofCells[cell] == 0 ||
      (!points.HasPlaces && cells[cell].Shape == MeshCellShape::Tetrahedron))
    {
      continue;
    }
    PlacedCell placed;
    placed.Place(cells[cell]);
    const std::uint64_t found =
      HWY_DYNAMIC_DISPATCH(GradientsInCell)(placed, ofCells[cell], points);
    ForEachRay(ofCells[cell] & ~found,
      [&](std::size_t point)
      {
        const glm::dvec3 at =
          FindPointWith(cells[cell], Get(points.Point, point), points.ValueAt(point)).At;
        Set(points.At, point, at);
        Set(points.Gradient, point, GradientAt(cells[cell], at));
      });
  }
  std::array<std::uint8_t, PointsInCells::Capacity> lanes;
  TetrahedronLanes tetrahedra;
  for (std::size_t cell = 0; cell < numberOfCells; ++cell)
  {
    if (cells[cell].Shape == MeshCellShape::Tetrahedron)
    {
      lanes[cell] = static_cast<std::uint8_t>(tetrahedra.Count);
      tetrahedra.Append(cells[cell]);
    }
  }
  if (tetrahedra.Count > 0)
  {
    tetrahedra.FillUp();
    PointsInCells::Vectors gradients;
    FindTetrahedronGradients(tetrahedra, gradients);
    for (std::size_t i = 0; i < points.Count; ++i)
    {
      const std::size_t cell = points.Cell[i];
      if (cell < numberOfCells && cells[cell].Shape == MeshCellShape::Tetrahedron)
      {
        Set(points.Gradient, i, Get(gradients, lanes[cell]));
      }
    }
  }
}

void FindTetrahedronGradients(const TetrahedronLanes& cells, PointsInCells::Vectors& gradients)
{
  const std::uint64_t found = HWY_DYNAMIC_DISPATCH(GradientsOfTetrahedra)(cells, gradients);
  for (std::size_t i = 0; i < cells.Count; ++i)
  {
    if ((found >> i & 1u) == 0)
    {
      Set(gradients, i, GradientAt(cells.CellAt(i), glm::dvec3(0.25)));
    }
  }
}

}
}
#endif
