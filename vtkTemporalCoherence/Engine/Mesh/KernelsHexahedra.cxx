// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/KernelsCells.h"

#include "Mesh/FoldedSpans.h"
#include "Mesh/RootItems.h"

// This file is compiled once for each kind of vectors. The best one for the machine is chosen at
// run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Mesh/KernelsHexahedra.cxx"
#include <hwy/foreach_target.h>

#include "Mesh/KernelsRootSearch-inl.h"

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
    const SameFunctions<D> functions(cell, axis);
    now.Count = next.Count = 0;
    RootWork work{ rays, &now, &next, several };
    LookIntoCell<D>(functions, along, work, found);
    LookRoundByRound<D>(functions, work);
    alone |= work.Alone;
  }
  return alone;
}

std::uint64_t HexahedronPairCrossingsOf(const HexahedronFunctions* cells, const MeshRays& rays,
  std::uint64_t which, FoundRoots& several, Crossings& found)
{
  using D = Doubles;
  RootItems now, next;
  const OwnFunctions<D> functions(cells, rays);
  RootWork work{ rays, &now, &next, several };
  LookIntoCell<D>(functions, which, work, found);
  LookRoundByRound<D>(functions, work);
  return work.Alone;
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

/// Search rays one by one, and append what was found in several boxes.
template <typename CellOf, typename DifferencesOf>
void AppendOthers(const CellOf& cellOf, const DifferencesOf& differencesOf, const MeshRays& rays,
  std::uint64_t alone, FoundRoots& several, Crossings& found)
{
  for (std::uint64_t left = alone | several.Rays; left != 0; left &= left - 1)
  {
    const auto ray = static_cast<std::size_t>(hwy::Num0BitsBelowLS1Bit_Nonzero64(left));
    HexahedronRoots& roots = several.Begin(ray);
    if ((alone >> ray & 1u) != 0)
    {
      SeenHexahedron seen = SeeFrom(cellOf(ray), rays, ray, 0.0);
      seen.Difference = differencesOf(ray);
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

}

HWY_EXPORT(HexahedronCrossingsOf);
HWY_EXPORT(HexahedronPairCrossingsOf);

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
    const std::uint64_t alone =
      HWY_DYNAMIC_DISPATCH(HexahedronCrossingsOf)(functions, rays, which, several, found);
    AppendOthers([&](std::size_t) -> const MeshCell& { return cell; },
      [&](std::size_t) { return differences; }, rays, alone, several, found);
  }
}

void HexahedronCrossingsOfPairs(
  const MeshCell* cells, const CellDifferences* differences, const MeshRays& rays, Crossings& found)
{
  std::array<HexahedronFunctions, MeshRays::Capacity> functions;
  std::uint64_t which = 0;
  for (std::size_t i = 0; i < rays.Count; ++i)
  {
    functions[i] = HexahedronFunctions(cells[i], differences[i]);
    which |= std::uint64_t(functions[i].IsPassed) << i;
  }
  for (std::size_t i = rays.Count; i > 0 && i < WholeVectors(rays.Count); ++i)
  {
    functions[i] = functions[i - 1];
  }
  FoundRoots several;
  const std::uint64_t alone =
    HWY_DYNAMIC_DISPATCH(HexahedronPairCrossingsOf)(functions.data(), rays, which, several, found);
  AppendOthers([&](std::size_t ray) -> const MeshCell& { return cells[ray]; },
    [&](std::size_t ray) { return differences[ray]; }, rays, alone, several, found);
}

}
}
#endif
