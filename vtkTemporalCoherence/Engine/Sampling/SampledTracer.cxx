// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Sampling/SampledTracer.h"

#include "Sampling/ComponentLooks.h"
#include "Sampling/Medium.h"
#include "Sampling/RaySamples.h"
#include "Sampling/SegmentBreaks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace TemporalCoherence
{
namespace
{

/// Less light than this from behind is not seen.
constexpr double LeastPassed = 1.0 / 4096.0;

/// How far a part of a segment may be off.
constexpr double Tolerance = 1.0 / 65536.0;
constexpr int MostHalves = 16;

/// Gauss's points and weights on [0, 1], exact for polynomials of degree 5.
constexpr std::array<double, 3> GaussAt{ 0.11270166537925831, 0.5, 0.8872983346207417 };
constexpr std::array<double, 3> GaussWeight{ 5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0 };

/// A part of a ray: its colour, and the share of light that passes it.
struct Veil
{
  /// Both, one behind the other.
  Veil Before(const Veil& behind) const
  {
    return { this->Color + this->Passed * behind.Color, this->Passed * behind.Passed };
  }

  glm::dvec3 Color{ 0.0 };
  double Passed = 1.0;
};

/// Blends one ray.
class RayBlender
{
public:
  RayBlender(SegmentMedium& medium, const RaySamples& samples, double entry)
    : AlongRay(medium)
    , Samples(samples)
    , Entry(entry)
  {
  }

  /// What a segment adds, by samples at a fixed distance.
  void AddSamples(const ComponentSegment& segment)
  {
    this->Samples.ForEach(segment, this->Entry,
      [&](double share)
      {
        const Medium step = this->AlongRay.StepAt(share, this->Samples.Distance());
        this->Note(step.Extinction > 0.0, segment.DistanceAt(share));
        this->Seen = this->Seen.Before({ step.Emission, 1.0 - step.Extinction });
      });
  }

  /// What a part of a segment without bends adds.
  void AddPart(const ComponentSegment& segment, double from, double to)
  {
    const Veil whole = this->VeilOf(segment, from, to);
    const Veil veil = this->Refine(segment, from, to, whole, this->Seen.Passed, MostHalves);
    this->Note(veil.Passed < 1.0, segment.DistanceAt(from));
    this->Seen = this->Seen.Before(veil);
  }

  Veil Seen;
  double First = std::numeric_limits<double>::infinity(); ///< t of the first thing seen

private:
  void Note(bool isSeen, double t)
  {
    this->First = isSeen ? std::min(this->First, t) : this->First;
  }

  /// A part from what it is at three places.
  Veil VeilOf(const ComponentSegment& segment, double from, double to)
  {
    Veil veil;
    for (std::size_t i = 0; i < GaussAt.size(); ++i)
    {
      const Medium medium = this->AlongRay.At(from + GaussAt[i] * (to - from));
      if (medium.IsOpaque)
      {
        return veil.Before({ medium.Emission, 0.0 });
      }
      const double step = GaussWeight[i] * (to - from) * segment.Length();
      const double taken = -std::expm1(-medium.Extinction * step);
      const double shown = medium.Extinction > 0.0 ? taken / medium.Extinction : step;
      veil = veil.Before({ shown * medium.Emission, 1.0 - taken });
    }
    return veil;
  }

  /// The same by halves, until they agree with the whole.
  Veil Refine(const ComponentSegment& segment, double from, double to, const Veil& whole,
    double passed, int halves)
  {
    const double middle = 0.5 * (from + to);
    Veil front = this->VeilOf(segment, from, middle), back = this->VeilOf(segment, middle, to);
    const Veil both = front.Before(back);
    const glm::dvec3 change = glm::abs(both.Color - whole.Color);
    const double largest =
      std::max({ change.x, change.y, change.z, std::abs(both.Passed - whole.Passed) });
    if (!(passed * largest > Tolerance) || halves == 0)
    {
      return both;
    }
    front = this->Refine(segment, from, middle, front, passed, halves - 1);
    back = this->Refine(segment, middle, to, back, passed * front.Passed, halves - 1);
    return front.Before(back);
  }

  SegmentMedium& AlongRay;
  const RaySamples& Samples;
  double Entry;
};

class SampledTracer final : public BlendTracer
{
public:
  SampledTracer(const BlendScene& scene, const GridCoordinates* grid, SegmentSourceMaker make)
    : Key(scene.Key)
    , Looks(Key.Volume)
    , Samples(Key)
    , Cells(make(scene, grid))
  {
    for (std::size_t component = 0; component < this->Looks.Components(); ++component)
    {
      this->Bends.push_back(this->Looks.BendsOf(component));
    }
  }

  void Trace(const RayBatch& rays, const WorldDirections& world, BlendedRays& seen) const override
  {
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      if (rays.HasWalk(ray) && static_cast<double>(seen.Passed[ray]) > LeastPassed)
      {
        this->Blend(rays, world, ray, seen);
      }
    }
  }

private:
  void Blend(
    const RayBatch& rays, const WorldDirections& world, std::size_t ray, BlendedRays& seen) const
  {
    SegmentMedium medium(this->Key, this->Looks, *this->Cells, rays, world, ray);
    const bool areFixed = this->Samples.AreAsked();
    RayBlender blender(
      medium, this->Samples, areFixed ? this->Samples.EntryOf(rays, world, ray) : 0.0);
    for (std::size_t channel = 0; channel < 3; ++channel)
    {
      blender.Seen.Color[static_cast<int>(channel)] = static_cast<double>(seen.Color[channel][ray]);
    }
    blender.Seen.Passed = static_cast<double>(seen.Passed[ray]);
    seen.CellsRead += this->Cells->Visit(rays, ray,
      [&](const ComponentSegment& segment)
      {
        medium.Enter(segment);
        if (areFixed)
        {
          blender.AddSamples(segment);
        }
        else
        {
          this->AddParts(segment, blender);
        }
        return blender.Seen.Passed > LeastPassed;
      });
    for (std::size_t channel = 0; channel < 3; ++channel)
    {
      seen.Color[channel][ray] = static_cast<float>(blender.Seen.Color[static_cast<int>(channel)]);
    }
    seen.Passed[ray] = static_cast<float>(blender.Seen.Passed);
    seen.First[ray] = std::min(seen.First[ray], blender.First);
  }

  void AddParts(const ComponentSegment& segment, RayBlender& blender) const
  {
    SegmentBreaks breaks(segment);
    for (std::size_t component = 0; component < this->Looks.Components(); ++component)
    {
      breaks.AddBends(component, this->Bends[component]);
    }
    breaks.ForEachPart([&](double from, double to) { blender.AddPart(segment, from, to); });
  }

  const FrameKey& Key;
  ComponentLooks Looks;
  RaySamples Samples;
  std::unique_ptr<const SegmentSource> Cells;
  std::vector<std::vector<double>> Bends; ///< of the functions of each component
};

}

std::shared_ptr<const BlendTracer> MakeSampledTracer(
  const BlendScene& scene, const GridCoordinates* grid, SegmentSourceMaker make)
{
  return std::make_shared<SampledTracer>(scene, grid, make);
}

}
