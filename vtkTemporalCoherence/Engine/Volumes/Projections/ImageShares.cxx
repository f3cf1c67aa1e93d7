// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Projections/ImageShares.h"

#include "Volumes/Medium/SegmentReader.h"
#include "Volumes/Medium/SegmentWalk.h"
#include "Volumes/Medium/VisibleBands.h"
#include "Volumes/Projections/KernelsShares.h"
#include "Volumes/Projections/ShareLook.h"
#include "Volumes/Projections/ShareTable.h"

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

/// Error of a segment, at most: of its mean in an average, which has many segments, and of its sum
/// in unit distances. Both errors are estimated from above.
constexpr float MeanTolerance = 1.0f / 32.0f, SumTolerance = 1.0f / 256.0f;

template <typename T>
class ImageShares final
  : public ShareLook
  , private LeafSource
{
public:
  explicit ImageShares(const BlendScene& scene)
    : ShareLook(scene.Key.Blended())
    , Samples(scene.Key.Samples)
    , Unit(scene.Key.Blended().Looks.front().UnitDistance)
    , Table(scene.Key.Blended().Looks.front().Transfer, scene.Key.Blended().ScalarRanges.front())
    , Reader(Samples, Table.Low, Table.PerValue)
    , Volume(this->VolumeOf(scene.Key.Blended()))
    , Active(scene.Visible)
  {
    if (!this->Active)
    {
      // An average selects cells by their samples. Rounding may move values between samples into
      // its range, even from far away if a sample is far away.
      const ValueBand all{ -Infinity, Infinity };
      this->All.BuildVisible(this->Samples, *scene.Ranges,
        this->IsAverage ? *VisibleBands(scene.Key.Blended()) : std::vector<ValueBand>{ all });
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
    // The rounding error of samples that kernels count in bins.
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
  ActiveCells All; ///< all cells that count, if the scene does not list visible cells
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
