// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Cells/KernelsCells.h"

#include "Mesh/Cells/CellPoints.h"
#include "Mesh/Cells/FoldedSpans.h"
#include "Mesh/Cells/RootItems.h"

// This file is compiled once for each kind of vectors. The best one for the machine is chosen at
// run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Mesh/Cells/KernelsHexahedra.cxx"
#include <hwy/foreach_target.h>

#include "Mesh/Cells/KernelsRootSearch-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace MeshKernels
{
namespace HWY_NAMESPACE
{

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
