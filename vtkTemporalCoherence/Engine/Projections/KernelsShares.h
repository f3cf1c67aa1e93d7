// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsShares_h
#define TemporalCoherence_KernelsShares_h

#include "Blending/BlendTracer.h"
#include "Blending/VolumeSegments.h"
#include "Projections/ShareTable.h"

namespace TemporalCoherence
{

/// Kernels that add up shares along cell segments, in the widest vectors of the machine. Every kind
/// of vectors gives the same bits.
namespace SharesKernels
{

/// What is added up.
struct SharedVolume
{
  const ShareTable& Table;
  bool IsAverage;
  float PerError;  ///< for the mean of an average's segment, or each world distance of a sum: 1 /
                   ///< how far it may be off
  float Low, High; ///< values that an average takes into account, in bins
  float Blur;      ///< how far constant values may lie beyond them, by rounding
};

/// Add the integrals of segments to BlendedRays::Value; those of an average add their lengths, too,
/// and note where values first count, as t from where the rays begin.
void AddSegments(const SharedVolume& volume, const VolumeSegments& segments, BlendedRays& seen);

}

}

#endif
