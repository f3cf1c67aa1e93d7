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
/// follows the sum of all. Tracing may get cheaper than look-ups tell: by how much, groups tell
/// that are traced frame after frame, and those that are traced after look-ups.
class GroupCosts
{
public:
  /// Keep the costs of as many groups as before; else forget all.
  /// \throws std::bad_alloc
  void Resize(std::size_t groups);

  /// Different groups may be told at the same time.
  void SetTraced(std::size_t group, std::int64_t cost);
  void SetLookedUp(std::size_t group, std::int64_t cost);

  /// A frame is made: take note of what the groups told. Not beside them.
  void Learn();

  /// Forget all.
  void Forget() { *this = GroupCosts(); }

  /// True if the cost of any group is known.
  bool AreKnown() const;

  /// True if the cost of a group is only told by its look-ups.
  bool IsGuess(std::size_t group) const { return this->Groups[group].LookedUpFirst > 0.0f; }

  /// True if look-ups do not cost what they did when their groups were traced, so that some groups
  /// should be traced again.
  bool AreOld() const;

  /// The cost of each group: that of the known ones on average for one that is not known.
  std::vector<double> All() const;

private:
  struct Cost
  {
    float Traced = 0.0f;        ///< 0: not known
    float Before = 0.0f;        ///< the same of the tracing before; 0: it was looked up
    float Guessed = 0.0f;       ///< what it was taken to be before; 0: not looked up
    bool IsNew = false;         ///< traced since the last call of Learn()
    float TracedFirst = 0.0f;   ///< before it was looked up
    float LookedUpFirst = 0.0f; ///< 0: it was not looked up since
    float LookedUpLast = 0.0f;
    float LookedUpBefore = 0.0f; ///< one frame before the last; 0: not told since
    float TrendFirst = 1.0f;     ///< when it was first looked up
  };

  /// Sums over the groups that are looked up.
  struct Sums
  {
    double Now = 0.0, ByTrend = 0.0, TracedFirst = 0.0, LookedUpFirst = 0.0, LookedUpLast = 0.0;
  };
  double GuessOf(const Cost& cost) const;
  void FollowTrend(double all);
  Sums OfGuesses() const;
  double Correction() const;

  std::vector<Cost> Groups;
  double Trend = 1.0; ///< what tracing costs by look-ups, compared with the first frame
  double Guessed = 0.0, Measured = 0.0; ///< of groups traced after look-ups, the latest ones first
};

}

#endif
