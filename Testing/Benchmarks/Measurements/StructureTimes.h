// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_StructureTimes_h
#define Benchmarks_StructureTimes_h

#include "Stage.h"

/// What the structures take that frames are made from, beside reading the samples once.
namespace StructureTimes
{

/// Medians in milliseconds, and bytes.
struct Times
{
  double VolumeBytes = 0.0;
  double Read = 0.0;    ///< a sum over all samples, as words, in parallel
  double Pyramid = 0.0; ///< of value ranges: once for the data
  double PyramidBytes = 0.0;
  double ActiveCells = 0.0; ///< once for the data and an isovalue
  double ActiveBytes = 0.0;
  double Isomap = 0.0; ///< BuildIsomap as by default: a band around the isovalue
  double IsomapBytes = 0.0;
};

/// \throws Measuring::Failure if the image is not one that the mapper can see
Times Measure(Stage& stage, int frames);

}

#endif
