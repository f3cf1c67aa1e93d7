// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_BlendErrors_h
#define Benchmarks_BlendErrors_h

#include "BlendLooks.h"
#include "BlendWays.h"

/// How near pictures are to the volume rendering integral (Integral/BlendTruth.h).
namespace BlendErrors
{

/// In steps of 1/255, of the channel that is farthest off.
struct Errors
{
  double Mean, MostPixels; ///< 99.9 % of the pixels are nearer
  double Largest, PercentBeyondOne;
};

/// Makes the truth of some pixels of the stage's picture.
class Truth
{
public:
  /// \param mode   of vtkVolumeMapper: composite or maximum intensity
  /// \param stride one of so many pixels is compared
  Truth(const Stage& stage, const BlendLooks::Look& look, int mode, std::size_t stride = 97);

  Errors Of(const BlendWays::Picture& picture) const;

private:
  std::vector<std::size_t> Pixels;
  std::vector<std::array<double, 3>> Colors;
};

}

#endif
