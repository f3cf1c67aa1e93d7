// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageCache/PaperHint.h"

#include "Scene/FramePlanes.h"

#include <algorithm>

namespace TemporalCoherence
{

bool PaperHint::Narrow(RayBatch& rays, KnownRays& known) const
{
  const bool isAnyLeft = ImageHint::Narrow(rays, known);
  const double voxel = this->Query.VoxelSize();
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
  {
    if (known.Answers[i] == Answer::DefiniteHit)
    {
      rays.WalkBegin[i] = std::max(rays.WalkBegin[i], known.Hit[i] - voxel);
      rays.WalkEnd[i] =
        this->Interpolates ? rays.WalkBegin[i] : std::min(rays.WalkEnd[i], known.Hit[i] + voxel);
    }
  }
  return isAnyLeft;
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

}
