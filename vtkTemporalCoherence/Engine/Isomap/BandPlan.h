// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BandPlan_h
#define TemporalCoherence_BandPlan_h

#include "Acceleration/LeafHistogram.h"
#include "Scene/Surfaces.h"

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
    double Before;   ///< the isovalue before it: isovalues are expected to go on in this direction,
                     ///< or, if it is the same, in both
    ValueBand Gap;   ///< isovalues around it for which there is no band yet
  };

  /// A band for a wish, within its gap, by what is known of the field.
  /// \param isAhead it is to hold the next isovalues, too, if they come as the last ones did
  ValueBand Choose(const Wish& wish, const LeafHistogram& leaves, bool isAhead) const;

  /// Learn from a band that was built: the next may be up to twice as wide, or narrower.
  /// \param cellsRead to build it
  /// \param coldCells that a frame without an isomap reads
  void Learn(const ValueBand& band, std::int64_t cellsRead, std::int64_t coldCells);

  /// A band took too much time or memory: the next is as narrow as can be, and some after it do not
  /// look ahead.
  void Shorten();

private:
  double WidthAhead(const Wish& wish, const LeafHistogram& leaves) const;

  double Width = 0.0; ///< to try next; 0: no band was built yet
  int Careful = 0;    ///< bands that will not look ahead
};

}

#endif
