// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Cells/KernelsCells.h"

#include "Mesh/Cells/CellPoints.h"
#include "Mesh/Cells/RootItems.h"

#include <algorithm>

// This file is compiled once for each kind of vectors. The best one for the machine is chosen at
// run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Mesh/Cells/KernelsHexahedra.cxx"
#include <hwy/foreach_target.h>

#include "Mesh/Cells/KernelsRoots-inl.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace MeshKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Boxes to search, and their results.
struct RootWork
{
  const MeshRays& Rays;
  RootItems *Now, *Next;
  FoundRoots& Several;
  std::uint64_t Alone = 0;           ///< rays that have to be searched alone
  TileArray<std::uint8_t> CountOf{}; ///< boxes of each ray in Next

  HWY_INLINE void Push(
    std::size_t ray, const std::array<double, 3>& middle, const std::array<double, 3>& half)
  {
    if (this->CountOf[ray] == RootItems::MostOfRay)
    {
      this->Alone |= std::uint64_t(1) << ray;
      return;
    }
    ++this->CountOf[ray];
    RootItems& to = *this->Next;
    const std::size_t at = to.Count++;
    to.Ray[at] = static_cast<std::int64_t>(ray);
    for (std::size_t a = 0; a < 3; ++a)
    {
      to.Middle[a][at] = middle[a];
      to.Half[a][at] = half[a];
    }
  }
};

/// A vector of boxes.
template <class D>
struct RootBoxes
{
  using V = hn::Vec<D>;

  /// \pre items are filled up
  HWY_INLINE RootBoxes(const RootItems& items, std::size_t first)
    : Count(std::min(hn::Lanes(D()), items.Count - first))
    , Ray(hn::LoadU(DI(), &items.Ray[first]))
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Middle[a] = hn::LoadU(D(), &items.Middle[a][first]);
      this->Half[a] = hn::LoadU(D(), &items.Half[a][first]);
    }
  }

  /// Whole cells, one for each ray.
  HWY_INLINE explicit RootBoxes(Places<D> rays)
    : Count(hn::Lanes(D()))
    , Ray(rays)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Middle[a] = hn::Zero(D());
      this->Half[a] = hn::Set(D(), 1.0);
    }
  }

  std::size_t Count;
  Places<D> Ray;
  V Middle[3], Half[3];

private:
  using DI = hn::RebindToSigned<D>;
};

/// Distances and directions of the crossings of a vector of rays.
template <class D>
struct CrossingVector
{
  HWY_INLINE CrossingVector(const TurnedFunctions<D>& functions, const ShearedRays<D>& rays,
    const StraightSystem<D>& system, const OnlyRoots<D>& roots)
  {
    const D d;
    const auto zero = hn::Zero(d);
    hn::Vec<D> depths[8];
    for (std::size_t k = 0; k < 8; ++k)
    {
      depths[k] = functions.OfAxis(functions.Cell.Coordinates, 2, k);
    }
    depths[0] = hn::Sub(depths[0], rays.Turned[2]);
    hn::Store(hn::Add(hn::Mul(ValueAt(depths, roots.At), rays.PerDepth), zero), d, this->T);
    // The difference rises along the ray as its linear part does, unless bends reverse it.
    const auto rises = hn::Gt(hn::Mul(system.PerDepth, rays.PerDepth), zero);
    const auto isTurned = hn::Xor(roots.IsPositive, IsUnfolded<D>(functions.Cell, roots.At));
    this->Rising = BitsOf(d, hn::Xor(rises, isTurned));
  }

  HWY_ALIGN double T[hn::MaxLanes(D())];
  std::uint64_t Rising;
};

/// Queue the remaining parts of boxes, or their halves if little was cut off.
template <class D, class V = hn::Vec<D>>
HWY_INLINE void PushParts(
  const RootBoxes<D>& boxes, const KnownPart<D>& part, std::uint64_t left, RootWork& work)
{
  constexpr std::size_t most = hn::MaxLanes(D());
  const D d;
  const V half = hn::Set(d, 0.5);
  HWY_ALIGN double parts[3][most], shares[3][most], middles[3][most], halves[3][most];
  for (std::size_t a = 0; a < 3; ++a)
  {
    const V middle = hn::Mul(half, hn::Add(part.Low[a], part.High[a]));
    const V share = hn::Mul(half, hn::Sub(part.High[a], part.Low[a]));
    hn::Store(hn::Div(hn::Sub(middle, boxes.Middle[a]), boxes.Half[a]), d, parts[a]);
    hn::Store(hn::Div(share, boxes.Half[a]), d, shares[a]);
    hn::Store(boxes.Middle[a], d, middles[a]);
    hn::Store(boxes.Half[a], d, halves[a]);
  }
  HWY_ALIGN std::int64_t rays[most];
  hn::Store(boxes.Ray, hn::RebindToSigned<D>(), rays);
  for (; left != 0; left &= left - 1)
  {
    const auto lane = static_cast<std::size_t>(hwy::Num0BitsBelowLS1Bit_Nonzero64(left));
    const auto ray = static_cast<std::size_t>(rays[lane]);
    std::array<double, 3> at, share, box, edge;
    for (std::size_t a = 0; a < 3; ++a)
    {
      at[a] = parts[a][lane];
      share[a] = shares[a][lane];
      box[a] = middles[a][lane];
      edge[a] = halves[a][lane];
    }
    if (CutBox(at, share, box, edge))
    {
      work.Push(ray, box, edge);
      continue;
    }
    const auto longest =
      static_cast<std::size_t>(std::max_element(edge.begin(), edge.end()) - edge.begin());
    edge[longest] *= 0.5;
    box[longest] -= edge[longest];
    work.Push(ray, box, edge);
    box[longest] += 2.0 * edge[longest];
    work.Push(ray, box, edge);
  }
}

/// Search a part of each box.
/// \param take called as take(crossings, roots, bits of lanes with a crossing)
/// \return bits of lanes to search again
template <class D, class Take>
HWY_INLINE std::uint64_t LookInto(const TurnedFunctions<D>& functions, const ShearedRays<D>& rays,
  const StraightSystem<D>& system, KnownPart<D>& part, std::uint64_t wanted, const Take& take)
{
  const D d;
  part.Narrow(system);
  wanted &= ~BitsOf(d, part.IsOut);
  const std::uint64_t only = wanted & BitsOf(d, part.IsOnly);
  if (only == 0)
  {
    return wanted;
  }
  const OnlyRoots<D> roots(system, part, hn::AndNot(part.IsOut, part.IsOnly));
  const std::uint64_t met = only & BitsOf(d, roots.IsInCell);
  if (met != 0)
  {
    take(CrossingVector<D>(functions, rays, system, roots), roots, met);
  }
  return wanted & ~(only & BitsOf(d, roots.IsFound));
}

/// Find the crossings of a vector of rays with a cell. Unfinished rays are queued as boxes.
/// \param places of the rays
/// \param wanted bits of lanes
template <class D>
HWY_INLINE void LookIntoCell(const TurnedFunctions<D>& functions, const std::int64_t* places,
  std::uint64_t wanted, RootWork& work, Crossings& found)
{
  const D d;
  const auto ray = hn::LoadU(hn::RebindToSigned<D>(), places);
  const ShearedRays<D> rays(work.Rays, ray);
  const StraightSystem<D> system(functions, rays);
  KnownPart<D> part(system);
  wanted &= ~BitsOf(d, part.IsOut);
  std::uint64_t alone = wanted & ~BitsOf(d, hn::Lt(system.Error, hn::Set(d, MostErrorOfSystem)));
  wanted &= ~alone;
  for (; alone != 0; alone &= alone - 1)
  {
    work.Alone |= std::uint64_t(1) << places[hwy::Num0BitsBelowLS1Bit_Nonzero64(alone)];
  }
  if (wanted == 0)
  {
    return;
  }
  const std::uint64_t left = LookInto(functions, rays, system, part, wanted,
    [&](const auto& crossings, const auto&, std::uint64_t met) HWY_ATTR
    {
      for (; met != 0; met &= met - 1)
      {
        const auto lane = static_cast<std::size_t>(hwy::Num0BitsBelowLS1Bit_Nonzero64(met));
        const auto place = static_cast<std::size_t>(places[lane]);
        const double t = crossings.T[lane];
        if (t >= work.Rays.Begin[place] && t <= work.Rays.End[place])
        {
          found.Append(place, t, (crossings.Rising >> lane & 1u) != 0);
        }
      }
    });
  if (left != 0)
  {
    PushParts(RootBoxes<D>(ray), part, left, work);
  }
}

/// Search the cell along all wanted rays.
template <class D>
HWY_INLINE void LookIntoCell(
  const TurnedFunctions<D>& functions, std::uint64_t which, RootWork& work, Crossings& found)
{
  ForEachFullVector(which,
    [&](const std::int64_t* places, std::uint64_t wanted) HWY_ATTR
    { LookIntoCell<D>(functions, places, wanted, work, found); });
}

/// Search a vector of boxes.
template <class D>
HWY_INLINE void Look(const TurnedFunctions<D>& functions, const RootBoxes<D>& boxes, RootWork& work)
{
  const ShearedRays<D> rays(work.Rays, boxes.Ray);
  const StraightSystem<D> system(functions, rays);
  KnownPart<D> part(boxes.Middle, boxes.Half);
  part.CutToRay(functions.Cell, system);
  const std::uint64_t wanted = ((std::uint64_t(1) << boxes.Count) - 1) & ~BitsOf(D(), part.IsOut);
  if (wanted == 0)
  {
    return;
  }
  const std::uint64_t left = LookInto(functions, rays, system, part, wanted,
    [&](const auto& crossings, const auto& roots, std::uint64_t met) HWY_ATTR
    {
      HWY_ALIGN double at[3][hn::MaxLanes(D())];
      HWY_ALIGN std::int64_t places[hn::MaxLanes(D())];
      hn::Store(boxes.Ray, hn::RebindToSigned<D>(), places);
      for (std::size_t a = 0; a < 3; ++a)
      {
        hn::Store(roots.At[a], D(), at[a]);
      }
      for (; met != 0; met &= met - 1)
      {
        const auto lane = static_cast<std::size_t>(hwy::Num0BitsBelowLS1Bit_Nonzero64(met));
        const bool rises = (crossings.Rising >> lane & 1u) != 0;
        AddRoot({ { at[0][lane], at[1][lane], at[2][lane] }, crossings.T[lane], rises },
          work.Several.Begin(static_cast<std::size_t>(places[lane])));
      }
    });
  if (left != 0)
  {
    PushParts(boxes, part, left, work);
  }
}

/// Search ever smaller boxes, for all rays together.
template <class D>
HWY_INLINE void LookRoundByRound(const TurnedFunctions<D>& functions, RootWork& work)
{
  std::swap(work.Now, work.Next);
  for (int round = 0; round < MostRounds && work.Now->Count > 0; ++round)
  {
    work.Next->Count = 0;
    work.CountOf.fill(0);
    work.Now->FillUp();
    for (std::size_t i = 0; i < work.Now->Count; i += hn::Lanes(D()))
    {
      Look(functions, RootBoxes<D>(*work.Now, i), work);
    }
    // Drop the boxes of rays that will be searched alone.
    RootItems& next = *work.Next;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < next.Count && work.Alone != 0; ++i)
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        next.Middle[a][kept] = next.Middle[a][i];
        next.Half[a][kept] = next.Half[a][i];
      }
      next.Ray[kept] = next.Ray[i];
      kept += (work.Alone >> next.Ray[i] & 1u) == 0;
    }
    next.Count = work.Alone != 0 ? kept : next.Count;
    std::swap(work.Now, work.Next);
  }
  for (std::size_t i = 0; i < work.Now->Count; ++i)
  {
    work.Alone |= std::uint64_t(1) << work.Now->Ray[i];
  }
}

/// \return rays that have to be searched alone
std::uint64_t HexahedronCrossingsOf(const HexahedronFunctions& cell, const MeshRays& rays,
  std::uint64_t which, FoundRoots& several, Crossings& found)
{
  using D = Doubles;
  RootItems now, next;
  std::uint64_t alone = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::uint64_t along = which & rays.Along[axis];
    if (along == 0)
    {
      continue;
    }
    const TurnedFunctions<D> functions(cell, axis);
    now.Count = next.Count = 0;
    RootWork work{ rays, &now, &next, several };
    LookIntoCell<D>(functions, along, work, found);
    LookRoundByRound<D>(functions, work);
    alone |= work.Alone;
  }
  return alone;
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

/// Search the rays in `alone` one by one. Append their roots, and the roots found in several boxes.
void AppendOthers(const MeshCell& cell, const CellDifferences& differences, const MeshRays& rays,
  std::uint64_t alone, FoundRoots& several, Crossings& found)
{
  for (std::uint64_t left = alone | several.Rays; left != 0; left &= left - 1)
  {
    const auto ray = static_cast<std::size_t>(hwy::Num0BitsBelowLS1Bit_Nonzero64(left));
    HexahedronRoots& roots = several.Begin(ray);
    if ((alone >> ray & 1u) != 0)
    {
      SeenHexahedron seen = SeeFrom(cell, rays, ray, 0.0);
      seen.Difference = differences;
      FindRoots(seen, roots);
    }
    for (std::size_t root = 0; root < roots.Count; ++root)
    {
      const double t = roots.Roots[root].T;
      if (t >= rays.Begin[ray] && t <= rays.End[ray])
      {
        found.Append(ray, t, roots.Roots[root].Rises);
      }
    }
  }
}

/// Faces of a hexahedron whose corners all have the isovalue, one bit each: 2 axis + side.
unsigned int FacesAtIsovalue(const CellDifferences& differences)
{
  unsigned int equal = 0;
  for (unsigned int corner = 0; corner < 8; ++corner)
  {
    equal |= static_cast<unsigned int>(differences[corner] == 0.0) << corner;
  }
  constexpr std::array<unsigned int, 6> corners = { 0x55, 0xaa, 0x33, 0xcc, 0x0f, 0xf0 };
  unsigned int faces = 0;
  for (unsigned int face = 0; equal != 0 && face < 6; ++face)
  {
    faces |= static_cast<unsigned int>((equal & corners[face]) == corners[face]) << face;
  }
  return faces;
}

/// The point of a ray at distance t, in the coordinates of the mesh.
glm::dvec3 PointOf(const MeshRays& rays, std::size_t ray, double t)
{
  const std::size_t axis = rays.AxisOf(ray), x = axis < 2 ? axis + 1 : 0, y = x < 2 ? x + 1 : 0;
  const double depth = t / rays.PerDepth[ray];
  glm::dvec3 point;
  point[static_cast<int>(x)] = rays.Turned[0][ray] + rays.ShearX[ray] * depth;
  point[static_cast<int>(y)] = rays.Turned[1][ray] + rays.ShearY[ray] * depth;
  point[static_cast<int>(axis)] = rays.Turned[2][ray] + depth;
  return point;
}

/// True if a point lies on one of `faces`, whose corners have the isovalue, and the values next to
/// it in the cell are above the isovalue.
bool TouchesFromAbove(const CellDifferences& differences, unsigned int faces, const glm::dvec3& at)
{
  constexpr double onFace = 1e-7;
  for (unsigned int face = 0; face < 6; ++face)
  {
    const auto axis = static_cast<int>(face / 2);
    const bool isFar = (face & 1u) != 0;
    if ((faces >> face & 1u) == 0 || std::abs(at[axis] - (isFar ? 1.0 : 0.0)) > onFace)
    {
      continue;
    }
    double opposite = 0.0; // the difference at the opposite face
    for (unsigned int corner = 0; corner < 8; ++corner)
    {
      double weight = (corner >> axis & 1u) != (isFar ? 1u : 0u) ? 1.0 : 0.0;
      for (int a = 0; a < 3; ++a)
      {
        weight *= a == axis ? 1.0 : (corner >> a & 1u) != 0 ? at[a] : 1.0 - at[a];
      }
      opposite += weight * differences[corner];
    }
    if (opposite > 0.0)
    {
      return true;
    }
  }
  return false;
}

/// Remove crossings where a ray only touches the isovalue from above: the isovalue is inside, so
/// the ray does not change sides. Rays do not miss such touches if a whole face has the isovalue.
/// \param begin the first crossing with the cell
void DropTouches(const MeshCell& cell, const CellDifferences& differences, const MeshRays& rays,
  std::size_t begin, Crossings& found)
{
  const unsigned int faces = found.Count > begin ? FacesAtIsovalue(differences) : 0;
  std::size_t count = begin;
  for (std::size_t i = begin; faces != 0 && i < found.Count; ++i)
  {
    const PointInCell place = FindPoint(cell, PointOf(rays, found.Ray[i], found.T[i]));
    if (!TouchesFromAbove(differences, faces, place.At))
    {
      found.Ray[count] = found.Ray[i];
      found.T[count] = found.T[i];
      found.Rises[count++] = found.Rises[i];
    }
  }
  found.Count = faces != 0 ? count : found.Count;
}

}

HWY_EXPORT(HexahedronCrossingsOf);

void HexahedronCrossings(const MeshCell& cell, const CellDifferences& differences,
  const MeshRays& rays, std::uint64_t which, Crossings& found)
{
  HexahedronCrossings(
    HexahedronFunctions(cell, differences), cell, differences, rays, which, found);
}

void HexahedronCrossings(const HexahedronFunctions& functions, const MeshCell& cell,
  const CellDifferences& differences, const MeshRays& rays, std::uint64_t which, Crossings& found)
{
  if (functions.IsPassed)
  {
    FoundRoots several;
    const std::size_t begin = found.Count;
    const std::uint64_t alone =
      HWY_DYNAMIC_DISPATCH(HexahedronCrossingsOf)(functions, rays, which, several, found);
    AppendOthers(cell, differences, rays, alone, several, found);
    DropTouches(cell, differences, rays, begin, found);
  }
}

}
}
#endif
