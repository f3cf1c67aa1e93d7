// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BandPlan_h
#define TemporalCoherence_BandPlan_h

#include "Acceleration/LeafHistogram.h"
#include "Scene/Surfaces.h"

#include <cstdint>

namespace TemporalCoherence
{

/// Chooses bands of isovalues by their cost: wide enough to hold the next isovalues, narrow enough
/// that nobody has to wait.
class BandPlan
{
public:
  /// The isovalue that needs a band.
  struct Wish
  {
    double Isovalue; ///< that the band must hold
    double Before;   ///< the previous isovalue: the next ones are expected to continue in this
                     ///< direction; if it is the same, in both
    ValueBand Gap;   ///< isovalues around it for which there is no band yet
  };

  /// Choose a band for a wish, within its gap.
  /// \param isAhead the band should also hold the next isovalues, if the drag goes on
  ValueBand Choose(const Wish& wish, const LeafHistogram& leaves, bool isAhead) const;

  /// Learn from a band that was built: the next one may be up to twice as wide, or narrower.
  /// \param cellsRead to build it
  /// \param coldCells that a frame without an isomap reads
  void Learn(const ValueBand& band, std::int64_t cellsRead, std::int64_t coldCells);

  /// A band took too much time or memory: the next one is as narrow as possible, and some after it
  /// do not look ahead.
  void Shorten();

private:
  double WidthAhead(const Wish& wish, const LeafHistogram& leaves) const;

  double Width = 0.0; ///< of the next band; 0: no band was built yet
  int Careful = 0;    ///< number of bands that will not look ahead
};

}

#endif
