// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/LayerTracer.h"

#include "Scene/Difference.h"
#include "Scene/HitOrder.h"
#include "Trace/CellSamples.h"
#include "Trace/CellWalk.h"
#include "Trace/GradedPassage.h"
#include "Trace/HiddenPassage.h"
#include "Trace/Passage.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace TemporalCoherence
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// A surface, and its position in the list.
struct FoundSurface
{
  MetSurface Met{ Infinity, HitKind::None, 0.0 };
  std::int16_t Surface = Frame::NoSurface;
};

/// How rays go through the cells of an image.
template <typename T>
struct UniformCells
{
  using Value = T; ///< what differences from isovalues are taken of
  using Real = RealOf<T>;

  explicit UniformCells(const Field&) {}

  BatchRay RayOf(const RayBatch& rays, std::size_t ray) const { return { rays, ray }; }

  /// The part of a ray in one cell.
  struct Part
  {
    Part(const BatchRay& ray, const glm::ivec3& cell)
      : Passages(BatchOf(ray, cell))
      , Passed(this->Passages, 0)
    {
    }

    bool HasLength() const { return this->Passed.Enter < this->Passed.Leave; }
    double Enter() const { return this->Passed.Enter; }
    double DistanceAt(double share) const { return this->Passed.DistanceAt(share); }
    const CellPath<Real>& Path() const { return this->Passed.Path; }
    NearestPath Nearest() const { return this->Passed.Nearest(this->Passages, 0); }
    bool ComesFrom(const HiddenCells& hidden) const
    {
      return ComesFromHidden(this->Passages, 0, this->Passed.Enter, hidden);
    }

  private:
    static PassageBatch<Real> BatchOf(const BatchRay& ray, const glm::ivec3& cell)
    {
      PassageBatch<Real> passages;
      AppendPassage(ray.Rays, ray.Ray, cell, Corners<Real>(), passages);
      return passages;
    }

    PassageBatch<Real> Passages;
    Passage<Real> Passed;
  };
};

/// The same for a graded field.
template <typename T>
struct GradedCells
{
  using Value = double;
  using Real = double;

  explicit GradedCells(const Field& field)
    : Grid(*field.Grid)
  {
  }

  GradedRay RayOf(const RayBatch& rays, std::size_t ray) const { return { rays, ray, this->Grid }; }

  struct Part
  {
    Part(const GradedRay& ray, const glm::ivec3& cell)
      : Line(ray)
      , Cell(cell)
      , Passed(ray, cell)
    {
    }

    bool HasLength() const { return this->Passed.HasLength(); }
    double Enter() const { return this->Passed.Enter; }
    double DistanceAt(double share) const { return this->Passed.DistanceAt(share); }
    const CellPath<double>& Path() const { return this->Passed.Path; }
    NearestPath Nearest() const { return this->Passed.Nearest(); }
    bool ComesFrom(const HiddenCells& hidden) const
    {
      return this->HasLength() && ComesFromHidden(this->Line, this->Cell, this->Enter(), hidden);
    }

  private:
    GradedRay Line;
    glm::ivec3 Cell;
    GradedPassage Passed;
  };

  const GridCoordinates& Grid;
};

template <typename T, typename Geometry, Interpolation Between>
class TypedLayerTracer final : public LayerTracer
{
public:
  using Real = typename Geometry::Real;
  using Value = typename Geometry::Value;
  using Part = typename Geometry::Part;

  explicit TypedLayerTracer(const TraceScene& scene)
    : Scene(scene)
    , Shape(scene.Samples)
    , Samples(scene.Samples)
    , Cells(scene.Samples.Dimensions - 1)
    , IsSolid(scene.Sought.Mode == SurfaceMode::Threshold)
  {
    const std::vector<double>& isovalues = scene.Sought.Isovalues;
    for (const double isovalue : isovalues)
    {
      this->Differences.emplace_back(isovalue, scene.FiniteRange);
    }
    this->Ascending.resize(isovalues.size());
    std::iota(this->Ascending.begin(), this->Ascending.end(), std::size_t(0));
    std::sort(this->Ascending.begin(), this->Ascending.end(),
      [&](std::size_t a, std::size_t b) { return isovalues[a] < isovalues[b]; });
  }

  void FindNext(const RayBatch& rays, HitBatch& hits) const override
  {
    RayBatch rest = rays;
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      FoundSurface next;
      const FoundSurface last = this->LastOf(rays, ray, hits);
      if (rays.Begin[ray] < rays.End[ray])
      {
        if (this->IsSolid && last.Met.Distance <= rays.Begin[ray])
        {
          this->FindCap(rays, ray, last, next);
        }
        if (next.Surface == Frame::NoSurface)
        {
          rest.WalkBegin[ray] = std::max(rays.WalkBegin[ray], last.Met.Distance);
          this->Walk(rest, ray, last, next, hits);
        }
      }
      hits.Depth[ray] = next.Met.Distance;
      hits.Kind[ray] = next.Met.Kind;
      hits.Surface[ray] = next.Surface;
    }
  }

private:
  FoundSurface LastOf(const RayBatch& rays, std::size_t ray, const HitBatch& hits) const
  {
    FoundSurface last;
    last.Surface = hits.Surface[ray];
    last.Met = { last.Surface == Frame::NoSurface ? -Infinity : hits.Depth[ray], hits.Kind[ray],
      this->IsovalueOf(last.Surface) };
    // What is known of an earlier piece of the ray does not matter to this one.
    if (last.Met.Distance < rays.Begin[ray])
    {
      last = FoundSurface();
      last.Met.Distance = -Infinity;
    }
    return last;
  }

  double IsovalueOf(int surface) const
  {
    return surface == Frame::NoSurface
      ? 0.0
      : this->Scene.Sought.Isovalues[static_cast<std::size_t>(surface)];
  }

  /// Take a surface if it is behind the last one and before the best so far.
  void Consider(double distance, HitKind kind, std::size_t surface, const FoundSurface& last,
    FoundSurface& next) const
  {
    const MetSurface met{ distance, kind, this->Scene.Sought.Isovalues[surface] };
    if (distance < Infinity && IsInFront(last.Met, met) && IsInFront(met, next.Met))
    {
      next = { met, static_cast<std::int16_t>(surface) };
    }
  }

  bool IsHidden(const glm::ivec3& cell) const
  {
    return this->Scene.Samples.Hidden && this->Scene.Samples.Hidden->IsHidden(cell);
  }

  /// Places in Ascending of the isovalues that a cell may pass: from its smallest sample on, or
  /// from all that are less, too, up to its largest. Samples that are not numbers are below all.
  std::pair<std::size_t, std::size_t> FindPassed(
    const std::array<T, 8>& samples, bool withLess) const
  {
    double low = Infinity, high = -Infinity;
    for (const T sample : samples)
    {
      const double value = static_cast<double>(sample);
      const double ranked = value == value ? value : -Infinity;
      low = std::min(low, ranked);
      high = std::max(high, ranked);
    }
    const auto placeOf = [&](double value, auto isBefore)
    {
      const auto found = std::partition_point(this->Ascending.begin(), this->Ascending.end(),
        [&](std::size_t i) { return isBefore(this->Scene.Sought.Isovalues[i], value); });
      return static_cast<std::size_t>(found - this->Ascending.begin());
    };
    return { withLess ? 0 : placeOf(low, std::less<>()), placeOf(high, std::less_equal<>()) };
  }

  /// Solids that are cut open where the ray begins.
  void FindCap(
    const RayBatch& rays, std::size_t ray, const FoundSurface& last, FoundSurface& next) const
  {
    const auto line = this->Shape.RayOf(rays, ray);
    const glm::ivec3 cell = line.CellAt(rays.Begin[ray], this->Cells);
    if (this->IsHidden(cell))
    {
      return;
    }
    const Part part(line, cell);
    const std::array<T, 8> samples = this->Samples.Read(cell);
    const auto [first, behind] = this->FindPassed(samples, true);
    for (std::size_t place = first; place < behind; ++place)
    {
      const std::size_t surface = this->Ascending[place];
      if (IsInside(AtEntry(this->Differ(samples, surface), part)))
      {
        this->Consider(rays.Begin[ray], HitKind::Cap, surface, last, next);
      }
    }
  }

  /// From cell to cell until there is a surface behind the last one.
  void Walk(const RayBatch& rays, std::size_t ray, const FoundSurface& last, FoundSurface& next,
    HitBatch& hits) const
  {
    if (!rays.HasWalk(ray))
    {
      return;
    }
    const auto line = this->Shape.RayOf(rays, ray);
    CellWalk walk;
    walk.Begin(line, this->Cells);
    while (next.Surface == Frame::NoSurface &&
      (this->Scene.Active ? walk.FindActive(line, *this->Scene.Active, this->Samples.All())
                          : walk.FindAny(line, this->Cells)))
    {
      if (!this->IsHidden(walk.Here()))
      {
        ++hits.CellsRead;
        this->Search(Part(line, walk.Here()), this->Samples.Read(walk.Here()), last, next);
      }
    }
  }

  /// All surfaces in a cell.
  void Search(const Part& part, const std::array<T, 8>& samples, const FoundSurface& last,
    FoundSurface& next) const
  {
    const bool isBehindHidden =
      this->IsSolid && this->Scene.Samples.Hidden && part.ComesFrom(*this->Scene.Samples.Hidden);
    const auto [first, behind] = this->FindPassed(samples, isBehindHidden);
    for (std::size_t place = first; place < behind; ++place)
    {
      const std::size_t surface = this->Ascending[place];
      const Corners<Real> corners = this->Differ(samples, surface);
      const auto inside = std::count_if(corners.begin(), corners.end(), IsInside<Real>);
      if (inside == 0 || (inside == 8 && !isBehindHidden))
      {
        continue; // all on one side
      }
      Cubic<Real> cubic;
      bool isInside;
      if constexpr (Between == Interpolation::Linear)
      {
        cubic = CubicAlong(corners, part.Path());
        isInside = IsInside(cubic[0]);
      }
      else
      {
        isInside = IsInside(AtEntry(corners, part));
      }
      if (isInside && isBehindHidden)
      {
        this->Consider(part.Enter(), HitKind::Cap, surface, last, next);
      }
      const auto consider = [&](double share)
      {
        isInside = !isInside;
        if (isInside || !this->IsSolid)
        {
          this->Consider(part.DistanceAt(share), isInside ? HitKind::Enters : HitKind::Leaves,
            surface, last, next);
        }
        return false;
      };
      if constexpr (Between == Interpolation::Linear)
      {
        VisitCrossings(cubic, [&](Real share) { return consider(static_cast<double>(share)); });
      }
      else if (part.HasLength())
      {
        VisitNearestCrossings(corners, part.Nearest(), consider);
      }
    }
  }

  Corners<Real> Differ(const std::array<T, 8>& samples, std::size_t surface) const
  {
    Corners<Real> corners;
    for (std::size_t i = 0; i < 8; ++i)
    {
      corners[i] = this->Differences[surface](static_cast<Value>(samples[i]));
    }
    return corners;
  }

  /// Difference from the isovalue where the ray enters the cell.
  static Real AtEntry(const Corners<Real>& corners, const Part& part)
  {
    return Between == Interpolation::Linear ? CubicAlong(corners, part.Path())[0]
                                            : corners[NearestCorner(part.Path().Begin)];
  }

  TraceScene Scene;
  Geometry Shape; ///< of the cells
  CellSamples<T> Samples;
  std::vector<Difference<Value>> Differences; ///< from each isovalue
  std::vector<std::size_t> Ascending;         ///< places of the isovalues, by their values
  glm::ivec3 Cells;                           ///< number of cells along each axis
  bool IsSolid;
};

template <typename T, typename Geometry>
std::unique_ptr<LayerTracer> MakeTyped(const TraceScene& scene)
{
  if (scene.Samples.Between == Interpolation::Nearest)
  {
    return std::make_unique<TypedLayerTracer<T, Geometry, Interpolation::Nearest>>(scene);
  }
  return std::make_unique<TypedLayerTracer<T, Geometry, Interpolation::Linear>>(scene);
}

}

std::unique_ptr<LayerTracer> LayerTracer::Make(const TraceScene& scene)
{
  return DispatchScalarType(scene.Samples.Type,
    [&](auto type)
    {
      using T = decltype(type);
      return scene.Samples.Grid ? MakeTyped<T, GradedCells<T>>(scene)
                                : MakeTyped<T, UniformCells<T>>(scene);
    });
}

}
