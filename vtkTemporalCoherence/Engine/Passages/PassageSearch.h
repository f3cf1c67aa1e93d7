// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PassageSearch_h
#define TemporalCoherence_PassageSearch_h

#include "Isomap/Knots.h"
#include "Scene/LayerBatch.h"
#include "Scene/RayBatch.h"
#include "Trace/SurfaceTracer.h"

#include <array>
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
  void Add(std::size_t surface, const TileKnots& knots, BandScale::Key key);

  /// Append the layers of all open rays, up to where they are full or opaque.
  /// \return one bit for each ray that must be traced behind its last layer
  std::uint64_t Search();

private:
  /// The passages of one isovalue.
  struct Stream
  {
    /// Go on to the next passage of a ray that holds the isovalue. \return false if there is none
    bool Find(std::size_t ray)
    {
      std::uint32_t next = this->Next[ray];
      const std::uint32_t end = this->End[ray];
      while (next < end && !(this->Low[next] <= this->Wanted && this->Wanted <= this->High[next]))
      {
        ++next;
      }
      this->Next[ray] = next;
      return next < end;
    }

    const CellIndex& CellOf(std::size_t ray) const { return this->Cells[this->Next[ray]]; }

    const BandScale::Key *Low, *High;
    const CellIndex* Cells;
    BandScale::Key Wanted;
    std::uint64_t Truncated; ///< one bit for each ray with more passages than are stored
    RayBatch::Array<std::uint32_t> Next, End;
    PassedCells Found;
  };

  /// A passage to be searched.
  struct Candidate
  {
    std::uint16_t Stream;
    std::uint8_t Place;
    bool IsSameCell; ///< as that before, for another isovalue
  };

  bool TakeNext(std::size_t ray);
  bool TakeNextOfMany(std::size_t ray);
  void Take(std::size_t stream, std::size_t ray, bool isSameCell);
  int PlaceAlong(std::size_t ray, const CellIndex& cell) const;
  bool IsFull() const;
  void Flush();
  std::size_t Decide(std::size_t first);

  const SurfaceTracer& Tracer;
  const RayBatch& Rays;
  LayerBatch& Layers;
  std::vector<Stream> Streams;
  std::vector<Candidate> Order;
  bool MayBeCapped = false;
  // One bit for each ray:
  std::uint64_t Ended = 0;   ///< has come to the end of what is stored, but not of its passages
  std::uint64_t Unclear = 0; ///< its surfaces are too close together
};

}

#endif
