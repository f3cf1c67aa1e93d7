// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Isomap_h
#define TemporalCoherence_Isomap_h

#include "Acceleration/TileBounds.h"
#include "Isomap/KnotCollector.h"
#include "Isomap/Knots.h"
#include "Scene/FrameKey.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace TemporalCoherence
{

/// The knots of a group of tiles for a band of isovalues.
struct GroupBand
{
  ValueBand Values{ 1.0, 0.0 };
  /// Indexed by tile in the group, then by ray piece. Empty if no ray meets an isovalue of the
  /// band.
  std::vector<TileKnots> Tiles{};
  std::size_t Memory = 0; ///< bytes
  std::size_t NumberOfKnots = 0;
  std::uint64_t LastUse = 0; ///< number of the frame
  std::uint64_t Made = 0;    ///< number of the frame
  bool IsAsked = false;      ///< the user asks for its range

  /// The knots of a tile, one entry per ray piece; null if all rays miss the band.
  const TileKnots* At(std::size_t tileInGroup, std::size_t pieces) const
  {
    return this->Tiles.empty() ? nullptr : this->Tiles.data() + tileInGroup * pieces;
  }
};

/// The tile bounds of a band of isovalues, kept for bands that it contains.
struct BandBounds
{
  ValueBand Values{ 1.0, 0.0 };
  TileBounds Tiles{};
};

/// For one view: where the ray of each pixel first passes each isovalue.
///
/// Every group of tiles has its own bands of isovalues, built when a frame had time for the group.
class Isomap
{
public:
  struct Options
  {
    ValueBand Range{ 1.0, 0.0 }; ///< asks for one band of these isovalues; none if Low > High
    std::size_t MemoryLimit = std::size_t(256) << 20; ///< limit of all bands together, in bytes
    double Tolerance = 0.0; ///< largest error in the distance of looked-up surfaces, in voxels; too
                            ///< small a tolerance counts as 0
    bool HasNormals = false; ///< store normals, to interpolate between them
  };

  /// How the building of a range ended.
  enum class Outcome : std::uint8_t
  {
    Built,
    Stopped,   ///< by the progress report
    TooLarge,  ///< it would exceed the limit of memory
    Impossible ///< there are no isovalues, no cells, too many cells, or no BandTracer
  };

  /// Tolerances below this, in voxels, count as 0. Finer ones would gain nothing: the steps of
  /// progress could not locate even steep surfaces, and every ray would be traced.
  static constexpr double FinestTolerance = 1e-3;

  /// The finest tolerance for a field of any size; smaller ones count as 0.
  static double SmallestTolerance(const Field& field, const IndexTransform& transform);

  /// The form of the knots for a frame. For translucent surfaces, tolerance and normals count as
  /// off.
  static KnotForm FormFor(const FrameKey& key, const Options& options);

  /// True if the kind of a field has isomaps, and its cell indices fit into knots.
  static bool CanHold(const Field& field);

  /// Bytes that the isomap of a view takes without any band.
  static std::size_t FixedMemory(const FrameKey& key);

  /// True if this isomap belongs to the view, data and mode of a frame, and has the form that the
  /// options ask for.
  bool IsOf(const FrameKey& key, const Options& options) const;

  /// Begin an empty isomap for a frame's view, data and mode.
  /// \throws std::bad_alloc; the isomap is then released
  void Begin(const FrameKey& key, const Options& options);

  /// Reassign the isomap from the field `before` to `now`, whose samples are equal but lie
  /// elsewhere.
  void MoveTo(const Field& now, const Field& before);

  void Release() { *this = Isomap(); }

  /// The key of the frame that began the isomap.
  const FrameKey& FirstKey() const { return this->Key; }
  const KnotForm& Form() const { return this->KnotsAre; }

  /// Largest error in the distance of looked-up surfaces; 0: they are exact.
  double Tolerance() const { return this->KnotsAre.Tolerance; }

  /// Number of pieces into which the region may split a ray.
  std::size_t Pieces() const;

  std::size_t Size() const { return this->Groups.size(); }

  /// The band of a group that holds an isovalue, or null.
  const GroupBand* Find(std::size_t group, double isovalue) const;

  /// True if a group has a band for each isovalue.
  bool Covers(std::size_t group, const std::vector<double>& isovalues) const;

  /// True if every group has a band for each isovalue.
  bool Covers(const std::vector<double>& isovalues) const;

  /// True if every group has a band that holds all of these isovalues.
  bool Holds(const ValueBand& values) const;

  /// Add a band to a group. Thread-safe for different groups; call Count() afterwards.
  /// \throws std::bad_alloc; nothing is changed
  void Add(std::size_t group, GroupBand&& band);

  /// Add a band to each group, and count them.
  /// \throws std::bad_alloc; nothing is changed
  void AddToAll(std::vector<GroupBand>&& bands);

  /// Mark the bands in which the isovalues of a frame are looked up.
  void MarkUsed(const std::vector<double>& isovalues, std::uint64_t frame);

  /// Mark all bands as no longer asked for.
  void ForgetAsked();

  /// Mark the bands that hold all of these isovalues as asked for.
  void MarkAsked(const ValueBand& values);

  /// Selects bands.
  using Which = std::function<bool(const GroupBand&)>;

  /// Bytes of the selected bands.
  std::size_t MemoryOf(const Which& which) const;

  /// Drop selected bands, the least recently used first, until the selected bands together take at
  /// most `limit` bytes.
  /// \return true if any was dropped
  bool Trim(std::size_t limit, const Which& which);

  /// Drop the selected bands.
  void Drop(const Which& which);

  /// Make room for the bounds of a frame's number of isovalues; drop surplus bounds.
  /// \throws std::bad_alloc; nothing is changed
  void ResizeBounds(std::size_t isovalues);

  /// The bounds kept for isovalue number `isovalue` of a frame, if they contain `band`; else null.
  const TileBounds* FindBounds(std::size_t isovalue, const ValueBand& band) const;

  /// Replace the bounds of an isovalue.
  void KeepBounds(std::size_t isovalue, BandBounds&& bounds);

  /// Drop all bounds.
  void DropBounds();

  /// Bytes of all bounds.
  std::size_t MemoryOfBounds() const;

  /// Bytes of all bands and bounds, and of their containers.
  std::size_t MemoryInBytes() const { return this->Memory; }
  std::size_t NumberOfKnots() const { return this->Knots; }
  std::size_t NumberOfBands() const { return this->Bands; }

  /// Count memory and knots again.
  void Count();

private:
  FrameKey Key;
  KnotForm KnotsAre;
  bool IsBegun = false;
  std::vector<std::vector<GroupBand>> Groups;
  std::vector<BandBounds> Bounds; ///< for each isovalue of the last frames
  std::size_t Memory = 0, Knots = 0, Bands = 0;
};

}

#endif
