// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BandPlan_h
#define TemporalCoherence_BandPlan_h

#include "Scene/Surfaces.h"

namespace TemporalCoherence
{

/// Chooses the bands of a drag: how many of its steps they reach ahead, and whether they are worth
/// their cost at all. It learns from what building and looking up cost, compared with tracing.
///
/// Building a band costs a + b times its width. A band of many steps is cheaper for each step, but
/// a drag may turn before it is used.
class BandPlan
{
public:
  /// An isovalue that needs a band.
  struct Wish
  {
    double Isovalue;
    double Before; ///< the previous one; the same if it did not move
    double Range;  ///< of all values
  };

  /// True if the isovalue moves by more than a step of a drag. Nobody knows where it goes next.
  static bool IsJump(const Wish& wish);

  /// The band from the isovalue on. If it does not move, a narrow one around it.
  ValueBand Choose(const Wish& wish) const;

  /// The same by rule, not by what was learnt.
  static ValueBand ChooseFixed(const Wish& wish);

  /// True if the band chosen for a wish is expected to save time.
  bool IsWorthIt(const Wish& wish) const;

  /// Expected cost of building the band of a wish and looking up its first isovalue; and of any
  /// other look-up. Tracing costs 1.
  double BuildCost(const Wish& wish) const;
  double LookUpCost() const { return this->LookUp; }

  /// Costs that were measured in a frame.
  struct Measured
  {
    double Width = 0.0;        ///< of the bands built, as a share of the range
    double Built = 0.0;        ///< groups built and looked up
    double TracingBuilt = 0.0; ///< what tracing these groups costs
    double LookedUp = 0.0;     ///< groups looked up
    double TracingFound = 0.0; ///< what tracing these groups costs
    double TracingAll = 0.0;   ///< what tracing all groups costs
    double Memory =
      0.0; ///< share of the memory that bands like those built would take in all groups
    bool IsMemoryFull = false; ///< the bands did not fit
  };
  void Learn(const Measured& measured);

private:
  double CostOf(double width) const;
  double StepsFor(const Wish& wish) const;

  /// Sums of a linear regression of the cost by the width, the latest frames first: weight, width,
  /// width squared, cost, cost times width.
  struct Sums
  {
    double Weight, Width, WidthSquared, Cost, CostWidth;

    void Add(double weight, double width, double cost);
    void Fade(double by);
  };

  Sums Known{};
  double LookUp = 0.5;
  double MemoryByWidth = 0.0; ///< share of the memory that bands take, by their width; 0: not known
  double MemoryShare = 1.0;   ///< of the width that is expected to fit: less if it did not
};

}

#endif
