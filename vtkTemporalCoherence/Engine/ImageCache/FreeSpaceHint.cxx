// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageCache/FreeSpaceHint.h"

namespace TemporalCoherence
{
namespace
{

/// A surface within this many voxels behind the free space counts as a definite hit. This affects
/// statistics and ColorByAnswer only, not the picture.
constexpr double NearStart = 2.0;

}

RayHint::Told FreeSpaceHint::TellOf(
  const KnownRays& known, const RayBatch& rays, const HitBatch& hits, std::size_t ray) const
{
  Told told = ImageHint::TellOf(known, rays, hits, ray);
  const bool isServed = known.Free[ray] > known.WalkBegin[ray];
  const double near = NearStart * this->Query.VoxelSize();
  if (told.Known == Answer::PossibleHit && hits.Kind[ray] != HitKind::Cap && isServed &&
    hits.Depth[ray] - known.Free[ray] <= near)
  {
    told.Known = Answer::DefiniteHit;
  }
  return told;
}

}
