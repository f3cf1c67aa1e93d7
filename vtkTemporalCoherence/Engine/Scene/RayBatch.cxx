// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/RayBatch.h"

namespace TemporalCoherence
{

std::uint64_t WalksWithoutHit(const RayBatch& rays, const HitBatch& hits)
{
  std::uint64_t which = 0;
  for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
  {
    const bool isOne = rays.HasWalk(ray) && hits.Kind[ray] == HitKind::None;
    which |= static_cast<std::uint64_t>(isOne) << ray;
  }
  return which;
}

void AppendRay(const RayBatch& from, std::size_t ray, RayBatch& to)
{
  const auto at = static_cast<std::size_t>(to.Count++);
  for (std::size_t a = 0; a < 3; ++a)
  {
    to.Origin[a][at] = from.Origin[a][ray];
    to.Direction[a][at] = from.Direction[a][ray];
    to.Inverse[a][at] = from.Inverse[a][ray];
  }
  to.PerDepth[at] = from.PerDepth[ray];
  to.Begin[at] = from.Begin[ray];
  to.End[at] = from.End[ray];
  to.WalkBegin[at] = from.WalkBegin[ray];
  to.WalkEnd[at] = from.WalkEnd[ray];
  to.Pixel[at] = from.Pixel[ray];
}

}
