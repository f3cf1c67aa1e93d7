// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LeafHistogram_h
#define TemporalCoherence_LeafHistogram_h

#include "Acceleration/ValueRangePyramid.h"
#include "Scene/Field.h"
#include "Scene/Surfaces.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <vector>

namespace TemporalCoherence
{

/// Estimates how many leaves the isovalues of a band pass through, and so the cost of tracing it.
class LeafHistogram
{
public:
  /// Count leaves by their smallest and largest sample. Of many leaves only some are counted.
  /// \throws std::bad_alloc; the histogram is then empty
  void Build(const Field& field, const ValueRangePyramid& pyramid);

  void Release();

  bool IsEmpty() const { return this->MinAtLeast.empty(); }

  /// Largest minus smallest finite sample, or the largest double if the difference overflows.
  double Range() const
  {
    return std::min(this->High - this->Low, std::numeric_limits<double>::max());
  }

  /// Share of all leaves that some isovalue of the band passes through, 0 to 1.
  double ShareOf(const ValueBand& band) const;

private:
  static constexpr int Bins = 4096;

  double BinOf(double value) const;

  double Low = 0.0, High = 0.0;               ///< smallest and largest finite sample
  std::vector<double> MinAtLeast, MaxAtLeast; ///< share of leaves, by bin
};

}

#endif
