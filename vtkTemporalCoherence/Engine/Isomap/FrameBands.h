// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FrameBands_h
#define TemporalCoherence_FrameBands_h

#include "Isomap/BandBuilder.h"
#include "Isomap/DragRule.h"
#include "Isomap/Isomap.h"
#include "Scene/FramePlanes.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// The treatment of a group of tiles.
enum class GroupWork : std::uint8_t
{
  LookUp, ///< its bands hold all isovalues of the frame
  Build,  ///< they are built, and then hold them
  Trace
};

/// The state of a drag in one view, from frame to frame.
struct DragState
{
  DragRule Rule;
  std::uint64_t Frame = 0;          ///< number of the last frame
  std::vector<std::size_t> Order{}; ///< in which groups are chosen to be built
  std::size_t NextGroup = 0;        ///< place in the order where the choice goes on
  double BytesOfBand = 4096.0;      ///< of a group, on average
  bool HasDropped = false;          ///< bands, because of the user's limit of memory
};

/// Decides for each group of a frame whether it is looked up, built or traced, and builds bands.
/// Each frame builds a share of the groups, other ones each time, as DragRule says.
class FrameBands
{
public:
  struct Source
  {
    BandSource Bands;
    const Isomap::Options& Options;
    const std::vector<double>& IsovaluesBefore;
  };

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

  /// The planned treatment of a group; after Prepare(), the real one.
  GroupWork WorkOf(std::size_t group) const { return this->Work[group]; }

  /// Number of groups with this treatment.
  std::size_t NumberOf(GroupWork work) const;

  /// Prepare the building of bands, if any is planned.
  void MakeBuilders();

  /// Build the bands of a group, if that is planned. Thread-safe.
  /// \param counts cells and time of building are added
  /// \return LookUp, Build if its bands were built just now, or Trace
  GroupWork Prepare(std::size_t group, TraceCounts& counts);

  /// Tell how many cells were read for a group, Prepare included. Thread-safe.
  void Done(std::size_t group, std::int64_t cells) { this->CellsRead[group] = cells; }

  /// The frame is made: keep what was built, and learn from it.
  void Finish();

  /// True if memory ran out.
  bool HasFailed() const { return this->IsOutOfMemory; }

private:
  DragRule::Step StepTo(double isovalue) const;
  void Choose(std::size_t most);
  void MakeRoom(std::size_t planned);
  bool Build(std::size_t group, std::int64_t& cellsRead);
  ValueBand Widened(std::size_t isovalue) const;
  const TileBounds* BoundsFor(std::size_t isovalue);
  std::size_t BytesOfNewBounds() const;
  std::size_t RoomOfUser() const;
  std::size_t RoomForAll() const;
  bool IsLimitedByUser() const;

  Source From;
  Isomap& Map;
  DragState& State;
  std::vector<GroupWork> Work;
  std::vector<std::int64_t> CellsRead; ///< of each group
  std::vector<ValueBand> Bands;        ///< of each isovalue
  std::vector<bool> IsMissing;         ///< for each isovalue: some group has no band for it
  double Steps = std::numeric_limits<double>::infinity(); ///< fewest isovalues in a band
  std::vector<std::unique_ptr<BandBuilder>> Builders;
  std::size_t RoomForGroup = 0;  ///< bytes for each new band
  bool HasRoomForBounds = false; ///< those that are missing
  std::atomic<std::size_t> BytesBuilt{ 0 };
  std::atomic<bool> IsFull{ false }, IsOutOfMemory{ false };
  bool IsFinished = false;
};

}

#endif
