// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SegmentWalk_h
#define TemporalCoherence_SegmentWalk_h

#include "Lattice/KernelsWalk.h"
#include "Volumes/Medium/BlendTracer.h"
#include "Volumes/Medium/SegmentReader.h"
#include "Volumes/Medium/VolumeSegments.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace TemporalCoherence
{

/// Walks rays through the active cells of an image, and passes on their visible segments.
template <typename T>
class SegmentWalk
{
public:
  SegmentWalk(
    const WalkScene& scene, const SegmentReader<T>& reader, const SegmentsKernels::SeenBins& seen)
    : Scene(scene)
    , Reader(reader)
    , Seen(seen)
  {
  }

  /// \param which    one bit for each ray of the batch that walks
  /// \param add      takes VolumeSegments
  /// \param seesMore true if a ray of the batch sees anything behind the segments so far
  /// \return the number of cells that were read
  template <typename Add, typename SeesMore>
  std::int64_t Trace(
    const RayBatch& rays, std::uint64_t which, const Add& add, const SeesMore& seesMore) const
  {
    RayWalks walks(rays, which);
    NextCells next;
    VolumeSegments segments;
    std::int64_t cellsRead = 0;
    while (walks.Rays.Count > 0)
    {
      ListActiveCells(this->Scene, walks, next);
      this->AddCells(walks, next, segments, add);
      cellsRead =
        std::accumulate(next.Count.begin(), next.Count.begin() + walks.Rays.Count, cellsRead);
      std::uint64_t goOn = 0;
      for (std::size_t i = 0; i < static_cast<std::size_t>(walks.Rays.Count); ++i)
      {
        const bool goesOn =
          next.Count[i] == NextCells::Most && seesMore(static_cast<std::size_t>(walks.From[i]));
        goOn |= static_cast<std::uint64_t>(goesOn) << i;
      }
      KeepRays(goOn, walks);
    }
    return cellsRead;
  }

private:
  template <typename Add>
  void AddCells(
    const RayWalks& walks, const NextCells& next, VolumeSegments& segments, const Add& add) const
  {
    const auto most = static_cast<std::size_t>(
      *std::max_element(next.Count.begin(), next.Count.begin() + walks.Rays.Count));
    segments.Count = 0;
    for (std::size_t place = 0; place < most; ++place)
    {
      this->Reader.Find({ walks, next, place }, this->Seen, segments);
      if (segments.Count > 0 && (segments.IsFull() || place + 1 == most))
      {
        add(segments);
        segments.Count = 0;
      }
    }
  }

  const WalkScene& Scene;
  const SegmentReader<T>& Reader;
  const SegmentsKernels::SeenBins& Seen;
};

}

#endif
