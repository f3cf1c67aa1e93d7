// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Samples/ConvergedTracer.h"

#include "Volumes/Samples/ComponentLooks.h"
#include "Volumes/Samples/LookTables.h"
#include "Volumes/Samples/LooksByLabel.h"
#include "Volumes/Samples/MediumParts.h"
#include "Volumes/Samples/SegmentBreaks.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <memory>
#include <mutex>
#include <vector>

namespace TemporalCoherence
{
namespace
{

/// Rays end once their transmittance is this small.
constexpr float LeastPassed = 1.0f / 1024.0f;

/// Segments of a batch: at first, and at most. Segments behind an opaque one are prepared in vain.
constexpr std::size_t FirstSegments = 2, MostSegments = 12;

/// Parts of a segment that are at most this share of it show nothing: rounding puts bends beside
/// the end of a segment, where a peak of opacity 1 would be a wall.
constexpr double NoPart = 1e-7;

/// Blends one ray after the other. It collects segments, and integrates them in batches.
class RayBlender
{
public:
  RayBlender(const ComponentLooks& looks, const LookTables& tables, const SegmentSource& cells)
    : Looks(looks)
    , Tables(tables)
    , Cells(cells)
    , Parts(tables.Look())
  {
  }

  /// Begin with a ray.
  /// \param seen   light of the ray so far
  /// \param begin  t of the ray's Begin
  /// \param point  at this t, in the world
  void Begin(const Veil& seen, double begin, const glm::dvec3& point, const glm::dvec3& direction)
  {
    this->Seen = seen;
    this->First = std::numeric_limits<double>::infinity();
    this->BeginOfRay = begin;
    this->Parts.Begin(point, direction);
    this->Enough = FirstSegments;
  }

  /// \return false if nothing can be seen behind a segment
  bool Add(const ComponentSegment& segment)
  {
    segment.IsNearest ? this->AddNearest(segment) : this->AddSmooth(segment);
    if (this->Parts.NumberOfSegments() >= this->Enough || this->Parts.AreMany())
    {
      this->Blend();
      this->Enough = std::min(2 * this->Enough, MostSegments);
    }
    return this->Seen.Passed > LeastPassed;
  }

  /// Integrate the segments added so far.
  void Blend()
  {
    this->First = std::min(this->First, this->BeginOfRay + this->Parts.Blend(this->Seen));
  }

  Veil Seen;
  double First = std::numeric_limits<double>::infinity(); ///< t of the first visible part

private:
  using Row = MediumKernels::Row;

  /// The power coefficients of a Bernstein polynomial.
  static Row PowersOf(const std::array<double, 4>& b)
  {
    return { static_cast<float>(b[0]), static_cast<float>(3.0 * (b[1] - b[0])),
      static_cast<float>(3.0 * ((b[2] - b[1]) - (b[1] - b[0]))),
      static_cast<float>((b[3] - b[0]) - 3.0 * (b[2] - b[1])) };
  }

  void AddSmooth(const ComponentSegment& segment)
  {
    std::array<std::array<double, 4>, 4> values;
    std::array<double, 4> low, high;
    for (std::size_t c = 0; c < this->Looks.Components(); ++c)
    {
      for (std::size_t i = 0; i < 4; ++i)
      {
        values[c][i] = this->Tables.ScaleOf(c).Of(segment.Cubics[c][i]);
      }
      const auto [least, most] = std::minmax_element(values[c].begin(), values[c].end());
      low[c] = *least;
      high[c] = *most;
    }
    if (!this->Tables.IsSeen(low, high))
    {
      return;
    }
    Row* const rows = this->AddSegment(segment.Enter, segment.Length());
    for (std::size_t c = 0; c < this->Looks.Components(); ++c)
    {
      rows[c] = PowersOf(values[c]);
    }
    this->FindGradients(segment, low, high, rows);
    this->AddParts(segment, low, high);
  }

  /// Add the visible parts of a segment between bends.
  void AddParts(const ComponentSegment& segment, const std::array<double, 4>& low,
    const std::array<double, 4>& high)
  {
    SegmentBreaks breaks(segment);
    for (std::size_t c = 0; c < this->Looks.Components(); ++c)
    {
      if (this->CanBeSeen(c, low, high))
      {
        breaks.AddBends(c, this->Tables.BendsOf(c));
      }
    }
    breaks.ForEachPart(
      [&](double from, double to)
      {
        std::array<double, 4> at{};
        for (std::size_t c = 0; c < this->Looks.Components(); ++c)
        {
          at[c] = this->Tables.ScaleOf(c).Of(segment.ValueAt(c, 0.5 * (from + to)));
        }
        if (to - from > NoPart && (breaks.AreEven() || this->Tables.IsSeen(at, at)))
        {
          this->Parts.AddPart(static_cast<float>(from), static_cast<float>(to), breaks.AreEven());
        }
      });
  }

  /// Add the parts of a segment with one nearest sample each.
  void AddNearest(const ComponentSegment& segment)
  {
    for (std::size_t step = 0; step < segment.Nearest.Count; ++step)
    {
      const std::size_t corner = segment.Nearest.Corners[step];
      const double from = segment.Nearest.Shares[step];
      const double to = step + 1 < segment.Nearest.Count ? segment.Nearest.Shares[step + 1] : 1.0;
      ComponentValues values{};
      for (std::size_t c = 0; c < this->Looks.Components(); ++c)
      {
        values[c] = segment.Samples[c][corner];
      }
      std::array<Row, 4> looks;
      bool isSeen = false;
      for (std::size_t part = 0; part < this->Looks.Parts(); ++part)
      {
        looks[part] = this->Tables.RowOf(this->Looks, part, values);
        isSeen |= looks[part][0] > 0.0f;
      }
      if (!(from < to) || !isSeen)
      {
        continue;
      }
      Row* const rows = this->AddSegment(segment.DistanceAt(from), (to - from) * segment.Length());
      std::copy_n(looks.begin(), this->Looks.Parts(), rows);
      for (const LookTables::Gradients& of : this->Tables.AllGradients())
      {
        const glm::vec3 gradient(
          of.Scale * this->Cells.GradientAt(of.Component, segment.Cell, corner));
        for (std::size_t a = 0; a < 3; ++a)
        {
          rows[of.Row + a][0] = gradient[static_cast<int>(a)];
        }
      }
      if (this->Tables.AreLightsNear())
      {
        this->Parts.AddPart(0.0f, 1.0f, false);
      }
      else
      {
        this->Parts.AddEvenPart();
      }
    }
  }

  Row* AddSegment(double enter, double length)
  {
    return this->Parts.AddSegment(enter - this->BeginOfRay, length);
  }

  /// True if an independent component may be visible, or if components are dependent.
  bool CanBeSeen(std::size_t component, const std::array<double, 4>& low,
    const std::array<double, 4>& high) const
  {
    return !this->Looks.AreIndependent() ||
      this->Tables.IsSeenOf(component, low[component], high[component]);
  }

  /// Find the rows of gradients of visible components.
  void FindGradients(const ComponentSegment& segment, const std::array<double, 4>& low,
    const std::array<double, 4>& high, Row* rows)
  {
    using Vector = glm::vec4; // as long as the vectors of most machines
    for (const LookTables::Gradients& of : this->Tables.AllGradients())
    {
      if (!this->CanBeSeen(of.Component, low, high))
      {
        continue;
      }
      CornerGradients gradients;
      this->Cells.FindGradients(of.Component, segment.Cell, gradients);
      Corners<Vector> corners;
      for (std::size_t i = 0; i < corners.size(); ++i)
      {
        corners[i] = Vector(of.Scale * gradients[i], 0.0);
      }
      CellPath<Vector> path;
      for (std::size_t a = 0; a < 3; ++a)
      {
        path.Begin[a] = Vector(static_cast<float>(segment.Path.Begin[a]));
        path.End[a] = Vector(static_cast<float>(segment.Path.End[a]));
      }
      const Cubic<Vector> b = CubicAlong(corners, path);
      const Vector rise = 3.0f * (b[1] - b[0]), bend = 3.0f * ((b[2] - b[1]) - (b[1] - b[0]));
      const Vector twist = (b[3] - b[0]) - 3.0f * (b[2] - b[1]);
      for (int a = 0; a < 3; ++a)
      {
        rows[of.Row + static_cast<std::size_t>(a)] = { b[0][a], rise[a], bend[a], twist[a] };
      }
    }
  }

  const ComponentLooks& Looks;
  const LookTables& Tables;
  const SegmentSource& Cells;
  MediumParts Parts;
  double BeginOfRay = 0.0;
  std::size_t Enough = FirstSegments;
};

/// The looks of a volume, and their tables, each made when a ray first meets the look.
class TabledLooks
{
public:
  explicit TabledLooks(const BlendScene& scene)
    : Scene(scene)
    , Looks(scene.Key.Blended())
    , Tables(Looks.Count())
    , AreMade(Looks.Count())
  {
  }

  std::size_t Count() const { return this->Looks.Count(); }

  RayBlender BlenderOf(std::size_t look, const SegmentSource& cells) const
  {
    std::call_once(this->AreMade[look],
      [&] { this->Tables[look] = std::make_unique<LookTables>(this->Scene, this->Looks[look]); });
    return { this->Looks[look], *this->Tables[look], cells };
  }

private:
  BlendScene Scene;
  LooksByLabel Looks;
  mutable std::vector<std::unique_ptr<const LookTables>> Tables;
  mutable std::vector<std::once_flag> AreMade;
};

/// Blends rays through segments of all looks, with a RayBlender for each look that is met.
class LookBlender
{
public:
  LookBlender(const TabledLooks& looks, const SegmentSource& cells)
    : Looks(looks)
    , Cells(cells)
    , Blenders(looks.Count())
  {
  }

  /// Begin with a ray: see RayBlender.
  void Begin(const Veil& seen, double begin, const glm::dvec3& point, const glm::dvec3& direction)
  {
    this->Seen = seen;
    this->First = std::numeric_limits<double>::infinity();
    this->BeginOfRay = begin;
    this->Point = point;
    this->Direction = direction;
    this->Present = nullptr;
  }

  /// \return false if nothing can be seen behind a segment
  bool Add(const ComponentSegment& segment)
  {
    std::unique_ptr<RayBlender>& blender = this->Blenders[segment.Look];
    if (!blender)
    {
      blender = std::make_unique<RayBlender>(this->Looks.BlenderOf(segment.Look, this->Cells));
    }
    if (blender.get() != this->Present)
    {
      this->Blend();
      blender->Begin(this->Seen, this->BeginOfRay, this->Point, this->Direction);
      this->Present = blender.get();
    }
    return this->Seen.Passed > LeastPassed && this->Present->Add(segment);
  }

  /// Integrate the segments added so far.
  void Blend()
  {
    if (this->Present)
    {
      this->Present->Blend();
      this->Seen = this->Present->Seen;
      this->First = std::min(this->First, this->Present->First);
    }
  }

  Veil Seen;
  double First = std::numeric_limits<double>::infinity(); ///< t of the first visible part

private:
  const TabledLooks& Looks;
  const SegmentSource& Cells;
  std::vector<std::unique_ptr<RayBlender>> Blenders; ///< by look; null before it is met
  RayBlender* Present = nullptr;                     ///< of the last segment
  double BeginOfRay = 0.0;
  glm::dvec3 Point{ 0.0 }, Direction{ 0.0 };
};

class ConvergedTracer final : public BlendTracer
{
public:
  ConvergedTracer(const BlendScene& scene, const GridCoordinates* grid, SegmentSourceMaker make)
    : Looks(scene)
    , WorldFromIndex(scene.Key.Transform.WorldFromIndex)
    , Cells(make(scene, grid))
  {
  }

  void Trace(const RayBatch& rays, const WorldDirections& world, BlendedRays& seen) const override
  {
    LookBlender blender(this->Looks, *this->Cells);
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      if (rays.HasWalk(ray) && seen.Passed[ray] > LeastPassed)
      {
        this->Blend(rays, world, ray, blender, seen);
      }
    }
  }

private:
  void Blend(const RayBatch& rays, const WorldDirections& world, std::size_t ray,
    LookBlender& blender, BlendedRays& seen) const
  {
    const double begin = rays.Begin[ray];
    const glm::dvec3 origin(rays.Origin[0][ray], rays.Origin[1][ray], rays.Origin[2][ray]);
    const glm::dvec3 direction(world[0][ray], world[1][ray], world[2][ray]);
    const glm::dvec3 point =
      glm::dvec3(this->WorldFromIndex * glm::dvec4(origin, 1.0)) + begin * direction;
    blender.Begin(
      { { seen.Color[0][ray], seen.Color[1][ray], seen.Color[2][ray] }, seen.Passed[ray] }, begin,
      point, direction);
    seen.CellsRead += this->Cells->Visit(
      rays, ray, [&](const ComponentSegment& segment) { return blender.Add(segment); });
    blender.Blend();
    for (std::size_t channel = 0; channel < 3; ++channel)
    {
      seen.Color[channel][ray] = blender.Seen.Color[static_cast<int>(channel)];
    }
    seen.Passed[ray] = blender.Seen.Passed;
    seen.First[ray] = std::min(seen.First[ray], blender.First);
  }

  TabledLooks Looks;
  glm::dmat4 WorldFromIndex;
  std::unique_ptr<const SegmentSource> Cells;
};

}

std::shared_ptr<const BlendTracer> MakeConvergedTracer(
  const BlendScene& scene, const GridCoordinates* grid, SegmentSourceMaker make)
{
  return std::make_shared<ConvergedTracer>(scene, grid, make);
}

}
