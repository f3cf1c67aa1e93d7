// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Projections/ShareTracer.h"

#include "Volumes/Projections/ShareLook.h"
#include "Volumes/Samples/RaySamples.h"
#include "Volumes/Samples/SegmentBreaks.h"

#include <algorithm>
#include <array>
#include <vector>

namespace TemporalCoherence
{
namespace
{

/// Gauss's points and weights on [0, 1], exact for polynomials of degree 7: in a part of a cell
/// without bends, opacity and value are cubics.
constexpr std::array<double, 4> GaussAt{ 0.06943184420297371, 0.33000947820757187,
  0.6699905217924281, 0.9305681557970263 };
constexpr std::array<double, 4> GaussWeight{ 0.17392742256872692, 0.3260725774312731,
  0.3260725774312731, 0.17392742256872692 };

class ShareTracer final : public ShareLook
{
public:
  ShareTracer(const BlendScene& scene, const GridCoordinates* grid, SegmentSourceMaker make)
    : ShareLook(scene.Key.Blended())
    , Samples(scene.Key)
    , Cells(make(scene, grid))
    , RangeEnds{ scene.Key.Blended().AverageRange.x, scene.Key.Blended().AverageRange.y }
  {
    for (std::size_t part = 0; part < this->Looks.Parts(); ++part)
    {
      this->Bends.push_back(this->Looks.BendsOf(this->Looks.OpacityOf(part)));
    }
  }

  void Trace(const RayBatch& rays, const WorldDirections& world, BlendedRays& seen) const override
  {
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      this->BeginSum(rays, ray, seen);
      if (rays.HasWalk(ray))
      {
        const double entry =
          this->Samples.AreAsked() ? this->Samples.EntryOf(rays, world, ray) : 0.0;
        seen.CellsRead += this->Cells->Visit(rays, ray,
          [&](const ComponentSegment& segment)
          {
            for (std::size_t part = 0; part < this->Looks.Parts(); ++part)
            {
              if (this->IsAverage && !this->MayCount(segment.Samples[part]))
              {
                continue;
              }
              if (this->Samples.AreAsked())
              {
                this->AddSamples(segment, entry, part, ray, seen);
              }
              else
              {
                this->AddSegment(segment, part, ray, seen);
              }
            }
            return true;
          });
      }
    }
  }

private:
  void AddSegment(
    const ComponentSegment& segment, std::size_t part, std::size_t ray, BlendedRays& seen) const
  {
    const std::size_t from = this->Looks.OpacityOf(part);
    if (from == part && !segment.IsNearest &&
      this->AddSmooth(segment.Cubics[part], segment, part, ray, seen))
    {
      return;
    }
    SegmentBreaks breaks(segment);
    if (this->IsAverage)
    {
      breaks.AddBends(part, this->RangeEnds);
    }
    breaks.AddBends(from, this->Bends[part]);
    double sum = 0.0, length = 0.0, first = 1.0;
    breaks.ForEachPart(
      [&](double from, double to)
      {
        const double middle = segment.ValueAt(part, 0.5 * (from + to));
        if (this->IsAverage && !this->Counts(middle))
        {
          return;
        }
        first = std::min(first, from);
        length += to - from;
        for (std::size_t i = 0; i < GaussAt.size(); ++i)
        {
          const double share = from + GaussAt[i] * (to - from);
          sum += GaussWeight[i] * (to - from) * this->WeighedShareAt(segment, part, share);
        }
      });
    SumOf(seen, part)[ray] += sum * segment.Length();
    if (this->IsAverage && length > 0.0)
    {
      LengthOf(seen, part)[ray] += length * segment.Length();
      seen.First[ray] = std::min(seen.First[ray], segment.DistanceAt(first));
    }
  }

  /// Add a segment without bends, so that opacity is linear in its values.
  /// \return false, with nothing added, if the segment may have a bend
  bool AddSmooth(const Cubic<double>& b, const ComponentSegment& segment, std::size_t part,
    std::size_t ray, BlendedRays& seen) const
  {
    const double low = std::min(std::min(b[0], b[1]), std::min(b[2], b[3]));
    const double high = std::max(std::max(b[0], b[1]), std::max(b[2], b[3]));
    const auto isBetween = [&](const std::vector<double>& values)
    {
      const auto next = std::upper_bound(values.begin(), values.end(), low);
      return next != values.end() && *next < high;
    };
    if (isBetween(this->Bends[part]) || (this->IsAverage && isBetween(this->RangeEnds)))
    {
      return false;
    }
    if (this->IsAverage && !this->Counts(0.5 * (low + high)))
    {
      return true;
    }
    const TransferFunction& transfer = this->Looks.Of(part).Transfer;
    const double atLow = LookUp(transfer, low).w;
    const double slope = high > low ? (LookUp(transfer, high).w - atLow) / (high - low) : 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i < GaussAt.size(); ++i)
    {
      const double value = Evaluate(b, GaussAt[i]);
      const double opacity = atLow + slope * (value - low);
      sum += GaussWeight[i] * opacity * this->Looks.ShareOf(part, value);
    }
    SumOf(seen, part)[ray] += sum * segment.Length();
    if (this->IsAverage)
    {
      LengthOf(seen, part)[ray] += segment.Length();
      seen.First[ray] = std::min(seen.First[ray], segment.Enter);
    }
    return true;
  }

  /// Add a segment by samples at a fixed distance.
  void AddSamples(const ComponentSegment& segment, double entry, std::size_t part, std::size_t ray,
    BlendedRays& seen) const
  {
    this->Samples.ForEach(segment, entry,
      [&](double share)
      {
        if (this->IsAverage && !this->Counts(segment.ValueAt(part, share)))
        {
          return;
        }
        const double step = this->Samples.Distance();
        SumOf(seen, part)[ray] += step * this->WeighedShareAt(segment, part, share);
        if (this->IsAverage)
        {
          LengthOf(seen, part)[ray] += step;
          seen.First[ray] = std::min(seen.First[ray], segment.DistanceAt(share));
        }
      });
  }

  /// True if an average takes a value of a cell into account. Rounding may move values between
  /// samples into the range, even from far away if a sample is far away.
  bool MayCount(const Corners<double>& samples) const
  {
    const auto [least, most] = std::minmax_element(samples.begin(), samples.end());
    return *most >= this->RangeEnds[0] && *least <= this->RangeEnds[1];
  }

  /// True if an average takes a value into account.
  bool Counts(double value) const
  {
    return this->RangeEnds[0] <= value && value <= this->RangeEnds[1];
  }

  /// Opacity times the value as a share of the scalar range.
  double WeighedShareAt(const ComponentSegment& segment, std::size_t part, double share) const
  {
    const std::size_t from = this->Looks.OpacityOf(part);
    const double value = segment.ValueAt(part, share);
    const double opacity =
      LookUp(this->Looks.Of(part).Transfer, from == part ? value : segment.ValueAt(from, share)).w;
    return opacity * this->Looks.ShareOf(part, value);
  }

  RaySamples Samples;
  std::unique_ptr<const SegmentSource> Cells;
  std::vector<double> RangeEnds;          ///< of an average
  std::vector<std::vector<double>> Bends; ///< of the opacity of each part
};

}

std::shared_ptr<const BlendTracer> MakeShareTracer(
  const BlendScene& scene, const GridCoordinates* grid, SegmentSourceMaker make)
{
  return std::make_shared<ShareTracer>(scene, grid, make);
}

}
