// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BandPlan_h
#define TemporalCoherence_BandPlan_h

#include "LeafHistogram.h"
#include "Surfaces.h"

#include <cstdint>

namespace TemporalCoherence
{

/// Chooses bands of isovalues by what they cost: wide enough that the next isovalues are in them,
/// narrow enough that nobody waits.
class BandPlan
{
public:
  /// What a band is wanted for.
  struct Wish
  {
    double Isovalue; ///< it must hold
    double Before;   ///< the isovalue before it: isovalues are expected to go on in this direction
    ValueBand Gap;   ///< isovalues around it for which there is no band yet
  };

  /// A band for a wish, within its gap, by what is known of the field.
  ValueBand Choose(const Wish& wish, const LeafHistogram& leaves) const;

  /// Learn from a band that was built: the next may be up to twice as wide, or narrower.
  /// \param cellsRead to build it
  /// \param coldCells that a frame without an isomap reads
  void Learn(std::int64_t cellsRead, std::int64_t coldCells);

  /// The next band will be half as wide: the last one took too much memory.
  void Shorten() { this->Stretch *= 0.5; }

private:
  double Stretch = 1.0; ///< of bands, over the first
};

}

#endif
