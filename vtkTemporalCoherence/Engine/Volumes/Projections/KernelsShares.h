// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsShares_h
#define TemporalCoherence_KernelsShares_h

#include "Volumes/Medium/BlendTracer.h"
#include "Volumes/Medium/VolumeSegments.h"
#include "Volumes/Projections/ShareTable.h"

namespace TemporalCoherence
{

/// Kernels that add up shares along cell segments, in the widest vectors of the machine. Every kind
/// of vectors gives the same bits.
namespace SharesKernels
{

/// Input of the kernels.
struct SharedVolume
{
  const ShareTable& Table;
  bool IsAverage;
  float PerError;  ///< 1 / tolerance of a segment's mean, or of a sum per world distance
  float Low, High; ///< values that an average takes into account, in bins
  float Blur;      ///< rounding error of constant values beyond them
};

/// Add the integrals of segments to BlendedRays::Value. An average also adds its lengths, and
/// records where values first count, as t from the rays' Begin.
void AddSegments(const SharedVolume& volume, const VolumeSegments& segments, BlendedRays& seen);

}

}

#endif
