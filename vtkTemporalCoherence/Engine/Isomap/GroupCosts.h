// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_GroupCosts_h
#define TemporalCoherence_GroupCosts_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// What it costs to trace and shade each group of tiles of a picture, in units of a clock. A group
/// costs what it did last. While it is looked up, its cost follows that of its look-ups, which
/// grows and shrinks with the surface as well. Single look-ups are noisy: the sum of the costs
/// follows the sum of all.
class GroupCosts
{
public:
  /// Keep the costs of as many groups as before; else forget all.
  /// \throws std::bad_alloc
  void Resize(std::size_t groups);

  /// Different groups may be told at the same time.
  void SetTraced(std::size_t group, std::int64_t cost);
  void SetLookedUp(std::size_t group, std::int64_t cost);

  /// Forget all.
  void Forget() { this->Groups.clear(); }

  /// True if the cost of any group is known.
  bool AreKnown() const;

  /// The cost of each group: that of the known ones on average for one that is not known.
  std::vector<double> All() const;

private:
  double Excess() const;

  struct Cost
  {
    float Traced = 0.0f;        ///< 0: not known
    float TracedFirst = 0.0f;   ///< before it was looked up
    float LookedUpFirst = 0.0f; ///< 0: it was not looked up since
    float LookedUpLast = 0.0f;
  };
  std::vector<Cost> Groups;
};

}

#endif
