// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FrameBands_h
#define TemporalCoherence_FrameBands_h

#include "Isomap/BandBuilder.h"
#include "Isomap/BandPlan.h"
#include "Isomap/GroupCosts.h"
#include "Isomap/Isomap.h"
#include "Scene/FramePlanes.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// What is done with a group of tiles.
enum class GroupWork : std::uint8_t
{
  LookUp, ///< its bands hold all isovalues of the frame
  Build,  ///< they are built, and then hold them
  Trace
};

/// The state of a drag in one view, from frame to frame.
struct DragState
{
  BandPlan Plan;
  GroupCosts Costs;
  std::uint64_t Frame = 0;          ///< number of the last frame
  std::vector<std::size_t> Order{}; ///< in which groups are chosen to be built
  std::size_t NextGroup = 0;        ///< place in the order where the choice goes on
  double BytesOfBand = 4096.0;      ///< of a group, on average
  double CostOfBounds = 0.0;        ///< the last time; 0: not known
  double CostOfBuilders = 0.0;      ///< the same, without bounds
  bool HasDropped = false;          ///< bands, because of the user's limit of memory
};

/// Decides for each group of a frame whether it is looked up, built or traced, and builds bands
/// within what the frame may cost.
///
/// An exact isomap shows the same picture whatever is built. So bands are built as long as the
/// frame takes hardly longer than if all was traced: what look-ups save may be spent, and a little
/// more. Where a picture depends on what is built (with a tolerance or normals), a fixed share of
/// the groups is built in each frame.
class FrameBands
{
public:
  struct Source
  {
    const FrameKey& Key;
    const Isomap::Options& Options;
    const std::vector<double>& IsovaluesBefore;
    const ValueRangePyramid& Pyramid; ///< of the key's field
    double SetUpCost = 0.0; ///< of the frame's own structures, in units of the costs of groups
  };

  /// The time, in units of the costs of groups: that of all threads.
  using Clock = std::function<double()>;

  /// Decide. The arguments must outlive this.
  /// \param map of the view of the key. Bands that nobody needs are dropped if memory is short
  /// \throws std::bad_alloc
  FrameBands(const Source& source, Isomap& map, DragState& state);

  /// Drops what was built, unless the frame was finished.
  ~FrameBands();

  FrameBands(const FrameBands&) = delete;
  FrameBands& operator=(const FrameBands&) = delete;

  /// True if every group is looked up.
  bool AreAllFound() const { return this->NumberOf(GroupWork::LookUp) == this->Work.size(); }

  /// What is planned for a group or, in the end, was done.
  GroupWork WorkOf(std::size_t group) const { return this->Work[group]; }

  /// Number of groups for which that is so.
  std::size_t NumberOf(GroupWork work) const;

  /// Prepare the building of bands, if any is planned. The time counts as spent.
  void MakeBuilders(const Clock& clock);

  /// Build the bands of a group, if that is planned and the frame may still cost more.
  /// Thread-safe.
  /// \param counts cells and time of building are added
  /// \return what is to be done: LookUp, Build if bands were built for it just now, or Trace
  GroupWork Prepare(std::size_t group, TraceCounts& counts);

  /// Tell what a group has cost, Prepare included. Thread-safe.
  void Done(std::size_t group, std::int64_t cost);

  /// The frame is made: keep what was built, and learn from it.
  void Finish();

  /// True if memory ran out.
  bool HasFailed() const { return this->IsOutOfMemory; }

private:
  BandPlan::Wish WishFor(double isovalue) const;
  void Choose(double extra);
  void MakeRoom(std::size_t planned);
  bool Build(std::size_t group, std::int64_t& cellsRead);
  ValueBand Widened(std::size_t isovalue) const;
  const TileBounds* BoundsFor(std::size_t isovalue, const Clock& clock);
  std::size_t BytesOfNewBounds() const;
  std::size_t RoomOfUser() const;
  std::size_t RoomForAll() const;
  bool IsLimitedByUser() const;

  Source From;
  Isomap& Map;
  DragState& State;
  bool IsExact;
  std::vector<double> Costs; ///< of tracing each group
  double CostOfAll = 0.0;
  std::vector<GroupWork> Work;
  std::vector<std::uint8_t> IsTried; ///< for each group: building was begun, if not finished
  std::vector<std::int64_t> CostNow; ///< of each group in this frame
  std::vector<ValueBand> Bands;      ///< of each isovalue
  std::vector<bool> IsMissing;       ///< for each isovalue: some group has no band for it
  std::vector<std::unique_ptr<BandBuilder>> Builders;
  std::int64_t MostExtra = 0;
  double MostForSetUp = 0.0;
  bool IsProbe = false;
  std::size_t Room = 0, RoomForGroup = 0; ///< bytes
  bool HasRoomForBounds = false;          ///< those that are missing
  std::atomic<std::int64_t> Extra{ 0 };
  std::atomic<std::size_t> Taken{ 0 };
  std::atomic<bool> IsFull{ false }, IsOutOfMemory{ false };
  bool IsFinished = false;
};

}

#endif
