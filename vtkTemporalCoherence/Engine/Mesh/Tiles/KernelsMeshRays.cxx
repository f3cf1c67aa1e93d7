// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The rays of a batch in the coordinates of a mesh, in vectors of rays.

#include "Mesh/Tiles/KernelsMeshRays.h"

#include <algorithm>
#include <cstdint>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Mesh/Tiles/KernelsMeshRays.cxx"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, WidestVector / 2>;
using V = hn::Vec<Doubles>;

HWY_INLINE std::uint64_t BitsOf(hn::Mask<Doubles> mask)
{
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(Doubles(), mask, bits);
  return bits[0];
}

/// MeshRays::Prepare in vectors, bit-identical.
HWY_INLINE void PrepareVector(
  const V origin[3], const V direction[3], std::size_t i, MeshKernels::MeshRays& rays)
{
  const Doubles d;
  const V x = hn::Abs(direction[0]), y = hn::Abs(direction[1]), z = hn::Abs(direction[2]);
  const auto isAlongZ = hn::Gt(z, hn::Max(x, y));
  const auto isAlongY = hn::AndNot(isAlongZ, hn::Gt(y, x));
  const auto choose = [&](const V of[3], std::size_t a) HWY_ATTR
  {
    const V other = hn::IfThenElse(isAlongY, of[(a + 1) % 3], of[a]);
    return hn::IfThenElse(isAlongZ, of[(a + 2) % 3], other);
  };
  hn::Store(choose(origin, 1), d, &rays.Turned[0][i]);
  hn::Store(choose(origin, 2), d, &rays.Turned[1][i]);
  hn::Store(choose(origin, 0), d, &rays.Turned[2][i]);
  const V depth = choose(direction, 0);
  hn::Store(hn::Div(choose(direction, 1), depth), d, &rays.ShearX[i]);
  hn::Store(hn::Div(choose(direction, 2), depth), d, &rays.ShearY[i]);
  hn::Store(hn::Div(hn::Set(d, 1.0), depth), d, &rays.PerDepth[i]);
  rays.Along[1] |= BitsOf(isAlongY) << i;
  rays.Along[2] |= BitsOf(isAlongZ) << i;
}

void Put(const RayBatch& rays, const glm::dvec3& low, double scale, MeshKernels::MeshRays& inMesh)
{
  const Doubles d;
  const V scales = hn::Set(d, scale);
  inMesh.Count = static_cast<std::size_t>(rays.Count);
  inMesh.Along = {};
  for (std::size_t i = 0; i < inMesh.Count; i += hn::Lanes(d))
  {
    V origin[3], direction[3];
    for (std::size_t a = 0; a < 3; ++a)
    {
      const V first = hn::Set(d, low[static_cast<int>(a)]);
      origin[a] = hn::Add(first, hn::Mul(scales, hn::Load(d, &rays.Origin[a][i])));
      direction[a] = hn::Mul(scales, hn::Load(d, &rays.Direction[a][i]));
      hn::Store(origin[a], d, &inMesh.Origin[a][i]);
      hn::Store(direction[a], d, &inMesh.Direction[a][i]);
    }
    PrepareVector(origin, direction, i, inMesh);
  }
  std::copy_n(rays.Begin.begin(), inMesh.Count, inMesh.Begin.begin());
  std::copy_n(rays.End.begin(), inMesh.Count, inMesh.End.begin());
}

}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{

HWY_EXPORT(Put);

void PutIntoMesh(
  const RayBatch& rays, const glm::dvec3& low, double scale, MeshKernels::MeshRays& inMesh)
{
  HWY_DYNAMIC_DISPATCH(Put)(rays, low, scale, inMesh);
  const std::uint64_t all = inMesh.Count > 0 ? ~std::uint64_t(0) >> (64 - inMesh.Count) : 0;
  inMesh.Along[1] &= all;
  inMesh.Along[2] &= all;
  inMesh.Along[0] = all & ~(inMesh.Along[1] | inMesh.Along[2]);
  inMesh.FillUp();
}

}
#endif
