// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageCache/PaperHint.h"

#include "Scene/FramePlanes.h"

#include <algorithm>

namespace TemporalCoherence
{

bool PaperHint::Narrow(RayBatch& rays, KnownRays& known) const
{
  known.WalkBegin = rays.WalkBegin;
  known.WalkEnd = rays.WalkEnd;
  this->Query.Ask(rays, known);
  const double voxel = this->Query.VoxelSize();
  bool isAllMissed = true;
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
  {
    isAllMissed &= known.Answers[i] == Answer::DefiniteMiss;
    switch (known.Answers[i])
    {
      case Answer::DefiniteMiss:
        rays.WalkEnd[i] = rays.WalkBegin[i];
        break;
      case Answer::DefiniteHit:
        rays.WalkBegin[i] = std::max(rays.WalkBegin[i], known.Hit[i] - voxel);
        rays.WalkEnd[i] =
          this->Interpolates ? rays.WalkBegin[i] : std::min(rays.WalkEnd[i], known.Hit[i] + voxel);
        break;
      case Answer::PossibleHit:
        rays.WalkBegin[i] = known.Free[i];
        break;
    }
  }
  return !isAllMissed;
}

bool PaperHint::TakeOver(
  const KnownRays& known, const RayBatch& rays, std::size_t ray, Frame& frame) const
{
  if (!this->Interpolates || known.Answers[ray] != Answer::DefiniteHit)
  {
    return false;
  }
  const auto pixel = static_cast<std::size_t>(rays.Pixel[ray]);
  this->Query.Interpolate(known, ray, pixel, frame);
  frame.Disparities[pixel] = DisparityAt(rays, ray, known.Hit[ray], this->IsParallel);
  return true;
}

bool PaperHint::Correct(
  const KnownRays& known, const HitBatch& hits, std::size_t ray, RayBatch& rays) const
{
  const bool isShortened =
    rays.WalkBegin[ray] > known.WalkBegin[ray] || rays.WalkEnd[ray] < known.WalkEnd[ray];
  if (!isShortened || !this->IsWrong(known, hits, ray))
  {
    return false;
  }
  rays.WalkBegin[ray] = hits.Kind[ray] == HitKind::None ? known.Free[ray] : known.WalkBegin[ray];
  rays.WalkEnd[ray] = known.WalkEnd[ray];
  return true;
}

/// True if there is no surface where the image shows one. Also true if a surface is met from inside
/// that the image does not show from inside: the walk then began behind another surface.
bool PaperHint::IsWrong(const KnownRays& known, const HitBatch& hits, std::size_t ray) const
{
  switch (hits.Kind[ray])
  {
    case HitKind::None:
      return known.Answers[ray] == Answer::DefiniteHit;
    case HitKind::Exit:
      return this->IsSolid || !this->Query.IsSeenFromInside(known.Pixel[ray]);
    default:
      return false;
  }
}

RayHint::Told PaperHint::TellOf(
  const KnownRays& known, const RayBatch& /*rays*/, const HitBatch& hits, std::size_t ray) const
{
  // A cap is found without a walk.
  const Answer answer = hits.Kind[ray] == HitKind::Cap ? Answer::PossibleHit : known.Answers[ray];
  return { answer, answer == Answer::PossibleHit };
}

}
