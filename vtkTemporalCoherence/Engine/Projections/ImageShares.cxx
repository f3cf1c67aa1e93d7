// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Projections/ImageShares.h"

#include "Blending/SegmentReader.h"
#include "Blending/SegmentWalk.h"
#include "Blending/VisibleBands.h"
#include "Projections/KernelsShares.h"
#include "Projections/ShareLook.h"
#include "Projections/ShareTable.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace TemporalCoherence
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// How far the mean of an average's segment may be off, of which there are many; and a segment of a
/// sum. Both are estimates from above.
constexpr float MeanTolerance = 1.0f / 32.0f, SumTolerance = 1.0f / 256.0f;

template <typename T>
class ImageShares final
  : public ShareLook
  , private LeafSource
{
public:
  explicit ImageShares(const BlendScene& scene)
    : ShareLook(scene.Key.Volume)
    , Samples(scene.Key.Samples)
    , Unit(scene.Key.Volume.Looks.front().UnitDistance)
    , Table(scene.Key.Volume.Looks.front().Transfer, scene.Key.Volume.ScalarRanges.front())
    , Reader(Samples, Table.Low, Table.PerValue)
    , Volume(this->VolumeOf(scene.Key.Volume))
    , Active(scene.Visible)
  {
    if (!this->Active)
    {
      // Samples tell which cells an average takes into account. Values between them may be rounded
      // into its range, from far away if one sample is.
      const ValueBand all{ -Infinity, Infinity };
      this->All.BuildVisible(this->Samples, *scene.Ranges,
        this->IsAverage ? *VisibleBands(scene.Key.Volume) : std::vector<ValueBand>{ all });
      this->Active = &this->All;
    }
    if (this->IsAverage)
    {
      this->Seen.Count = 1;
      this->Seen.Bands[0] = { this->Volume.Low - this->Volume.Blur,
        this->Volume.High + this->Volume.Blur };
    }
  }

  void Trace(const RayBatch& rays, const WorldDirections&, BlendedRays& seen) const override
  {
    std::uint64_t which = 0;
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      this->BeginSum(rays, ray, seen);
      which |= static_cast<std::uint64_t>(rays.HasWalk(ray)) << ray;
    }
    if (which == 0)
    {
      return;
    }
    BlendedRays::Array<double> first;
    first.fill(Infinity);
    std::swap(first, seen.First);
    const WalkScene scene{ *this->Active, *this, this->Samples.Dimensions - 1 };
    seen.CellsRead += SegmentWalk<T>(scene, this->Reader, this->Seen)
                        .Trace(
                          rays, which,
                          [&](const VolumeSegments& segments)
                          { SharesKernels::AddSegments(this->Volume, segments, seen); },
                          [](std::size_t) { return true; });
    // Kernels count distances from where rays begin.
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      seen.First[ray] = std::min(first[ray], rays.Begin[ray] + seen.First[ray]);
    }
  }

private:
  SharesKernels::SharedVolume VolumeOf(const Blending& volume) const
  {
    const auto binOf = [&](double value)
    { return (value - this->Table.Low) * this->Table.PerValue; };
    // As far as kernels round when they count samples in bins.
    const double largest = this->Table.Bins + std::abs(this->Table.Low * this->Table.PerValue);
    const double blur = largest * 2.0 * std::numeric_limits<float>::epsilon();
    return { this->Table, this->IsAverage,
      this->IsAverage ? 1.0f / MeanTolerance
                      : 1.0f / (SumTolerance * static_cast<float>(this->Unit)),
      static_cast<float>(binOf(volume.AverageRange.x)),
      static_cast<float>(binOf(volume.AverageRange.y)), static_cast<float>(blur) };
  }

  std::uint64_t CellsOf(std::int64_t node, const glm::ivec3& cell) const override
  {
    return this->Active->CellsOf(TypedField<T>(this->Samples), node, cell);
  }

  const Field& Samples;
  double Unit;
  ShareTable Table;
  SegmentReader<T> Reader;
  SharesKernels::SharedVolume Volume;
  const ActiveCells* Active;
  ActiveCells All; ///< all cells that count, if no others are left out
  SegmentsKernels::SeenBins Seen;
};

}

std::shared_ptr<const BlendTracer> MakeImageShares(const BlendScene& scene)
{
  return DispatchScalarType(scene.Key.Samples.Type,
    [&](auto type) -> std::shared_ptr<const BlendTracer>
    { return std::make_shared<ImageShares<decltype(type)>>(scene); });
}

}
