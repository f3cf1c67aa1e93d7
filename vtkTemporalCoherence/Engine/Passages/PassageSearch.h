// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PassageSearch_h
#define TemporalCoherence_PassageSearch_h

#include "Isomap/Knots.h"
#include "Scene/LayerBatch.h"
#include "Scene/RayBatch.h"
#include "Trace/SurfaceTracer.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Searches passages of the open rays of a tile for isovalues, and appends what they meet.
///
/// All rays take a step to their next passage in turn, so that passages of rays beside each other
/// are searched together, and few of those behind what makes a ray opaque.
class PassageSearch
{
public:
  /// The arguments must outlive this.
  /// \param most isovalues that are added
  /// \throws std::bad_alloc
  PassageSearch(
    const SurfaceTracer& tracer, const RayBatch& rays, std::size_t most, LayerBatch& layers);

  /// Look for an isovalue, too.
  /// \param surface its position in the list of isovalues
  /// \param knots   of the rays
  /// \param key     of the isovalue
  /// \throws std::bad_alloc
  void Add(std::size_t surface, const TileKnots& knots, PassageKey key);

  /// Append the layers of all open rays, up to where they are full or opaque.
  /// \return one bit for each ray that must be traced behind its last layer
  std::uint64_t Search();

private:
  /// A passage that holds an isovalue.
  struct Candidate
  {
    std::uint16_t Cell;   ///< its number
    std::uint16_t Stream; ///< of which isovalue
  };

  /// The passages of one isovalue.
  struct Stream
  {
    const PassageTable* Table;
    PassageKey Wanted;
    std::uint64_t Truncated; ///< one bit for each ray with more passages than are stored
  };

  /// A candidate that is searched next.
  struct Taken
  {
    std::uint16_t Stream;
    std::uint8_t Place;
    bool IsSameCell; ///< as that before, for another isovalue
  };

  void Collect();
  void CollectOf(std::size_t ray, std::uint16_t stream, const std::uint64_t* words);
  void MergeOf(std::size_t ray, std::size_t first);
  void CutOff(std::size_t ray, std::size_t first);
  int PlaceAlong(std::size_t ray, const CellIndex& cell) const;
  const CellIndex& CellOf(const Candidate& candidate) const
  {
    return this->Streams[candidate.Stream].Table->Cells[candidate.Cell];
  }
  /// True if a ray is neither full nor opaque, nor has to be traced.
  bool GoesOn(std::size_t ray) const
  {
    return this->Layers.IsOpen(ray) && !(this->Unclear >> ray & 1u);
  }

  void TakeNext(std::size_t ray);
  void Flush();
  void DecideAll(const PassedCells& found);
  std::size_t DecideCell(std::size_t first);
  void Append(std::size_t ray, const PassedCells& found, std::size_t place);
  void AppendIn(std::size_t ray, const glm::ivec3& cell);

  const SurfaceTracer& Tracer;
  const RayBatch& Rays;
  LayerBatch& Layers;
  std::vector<Stream> Streams;
  std::vector<PassedCells> Batches; ///< of each stream: what is searched next
  std::vector<Taken> Order;         ///< the same of several streams, in the order of searching

  /// Those of each ray, in their order along it.
  std::vector<Candidate> Candidates;
  RayBatch::Array<std::uint32_t> Next, End;

  bool MayBeCapped = false;
  // One bit for each ray:
  std::uint64_t Truncated = 0; ///< has more passages than are stored
  std::uint64_t Unclear = 0;   ///< its surfaces are too close together
};

}

#endif
