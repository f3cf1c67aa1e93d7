// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Trace/GradedTracer.h"

#include "Scene/Difference.h"
#include "Scene/HitOrder.h"
#include "Trace/CellRoot.h"
#include "Trace/CellSamples.h"
#include "Trace/CellWalk.h"
#include "Trace/GradedPassage.h"

#include <limits>
#include <vector>

namespace TemporalCoherence
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

template <typename T>
class GradedTracer final : public SurfaceTracer
{
public:
  explicit GradedTracer(const TraceScene& scene)
    : Scene(scene)
    , Samples(scene.Samples)
    , Cells(scene.Samples.Dimensions - 1)
    , IsSolid(scene.Sought.Mode == SurfaceMode::Threshold)
    , IsNearest(scene.Samples.Between == Interpolation::Nearest)
    , Hidden(scene.Samples.Hidden.get())
  {
    for (const double isovalue : scene.Sought.Isovalues)
    {
      this->Differences.emplace_back(isovalue, scene.FiniteRange);
    }
  }

  void Trace(const RayBatch& rays, HitBatch& hits) const override
  {
    hits.Clear(rays.Count);
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      if (this->IsSolid && rays.Begin[ray] < rays.End[ray])
      {
        this->FindCap(this->RayOf(rays, ray), hits);
      }
      if (rays.HasWalk(ray) && hits.Kind[ray] == HitKind::None)
      {
        this->Walk(this->RayOf(rays, ray), hits);
      }
    }
  }

  std::uint64_t SearchCells(
    const RayBatch& rays, const CellList& cells, HitBatch& hits) const override
  {
    std::uint64_t missing = 0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(cells.Count); ++i)
    {
      const std::size_t ray = cells.Ray[i];
      const glm::ivec3 cell(cells.Cell[0][i], cells.Cell[1][i], cells.Cell[2][i]);
      const GradedPassage passage(this->RayOf(rays, ray), cell);
      const Found found =
        this->Search(passage, this->Differ(this->Samples.Read(cell), cells.Surface));
      if (cells.IsContact[i])
      {
        KeepContact(passage, found, ray, hits);
      }
      missing |= static_cast<std::uint64_t>(found.Distance == Infinity) << ray;
      this->KeepFirst(found, cells.Surface, ray, hits);
    }
    hits.CellsRead += cells.Count;
    return missing;
  }

private:
  /// What a passage through a cell shows of one surface.
  struct Found
  {
    double AtEntry;  ///< difference from the isovalue where the ray enters the cell
    double Distance; ///< t of the first crossing; infinity if there is none
  };

  GradedRay RayOf(const RayBatch& rays, std::size_t ray) const
  {
    return { rays, ray, *this->Scene.Samples.Grid };
  }

  /// Differences of a cell's samples from an isovalue.
  Corners<double> Differ(const std::array<T, 8>& samples, std::size_t surface) const
  {
    Corners<double> corners;
    for (std::size_t i = 0; i < 8; ++i)
    {
      corners[i] = this->Differences[surface](static_cast<double>(samples[i]));
    }
    return corners;
  }

  /// True if a surface can be in a cell, or a cap before it.
  bool CanHold(const Corners<double>& corners) const
  {
    int inside = 0;
    for (const double corner : corners)
    {
      inside += IsInside(corner);
    }
    return inside != 0 && (inside != 8 || this->IsCapped());
  }

  Found Search(const GradedPassage& passage, const Corners<double>& corners) const
  {
    double share = 0.0;
    if (this->IsNearest)
    {
      const double atEntry = corners[NearestCorner(passage.Path.Begin)];
      const bool isFound =
        passage.HasLength() && FirstNearestCrossing(corners, passage.Nearest(), share);
      return { atEntry, isFound ? passage.DistanceAt(share) : Infinity };
    }
    const Cubic<double> cubic = CubicAlong(corners, passage.Path);
    // A walk may begin within a solid whose surface it is to find.
    const bool begins = this->IsSolid && IsInside(cubic[0]);
    const bool isFound = begins || FirstCrossing(cubic, share);
    return { cubic[0], isFound ? passage.DistanceAt(share) : Infinity };
  }

  /// Go from cell to cell up to the first hit.
  void Walk(const GradedRay& ray, HitBatch& hits) const
  {
    CellWalk walk;
    walk.Begin(ray, this->Cells);
    const auto goOn = [&]
    {
      return this->Scene.Active ? walk.FindActive(ray, *this->Scene.Active, this->Samples.All())
                                : walk.FindAny(ray, this->Cells);
    };
    while (hits.Kind[ray.Ray] == HitKind::None && goOn())
    {
      ++hits.CellsRead;
      this->Visit(ray, walk.Here(), hits);
    }
  }

  /// Search a cell for the isovalues that pass through it, unless it is hidden.
  void Visit(const GradedRay& ray, const glm::ivec3& cell, HitBatch& hits) const
  {
    if (this->IsHidden(cell))
    {
      return;
    }
    const std::array<T, 8> samples = this->Samples.Read(cell);
    for (std::size_t surface = 0; surface < this->Differences.size(); ++surface)
    {
      const Corners<double> corners = this->Differ(samples, surface);
      if (this->CanHold(corners))
      {
        const GradedPassage passage(ray, cell);
        const Found found = this->Search(passage, corners);
        KeepContact(passage, found, ray.Ray, hits);
        this->KeepFirst(found, surface, ray.Ray, hits);
        if (this->IsCapped() && passage.HasLength() && IsInside(found.AtEntry))
        {
          this->CapBehindHidden(ray, cell, passage.Enter, surface, hits);
        }
      }
    }
  }

  bool IsHidden(const glm::ivec3& cell) const
  {
    return this->Hidden && this->Hidden->IsHidden(cell);
  }

  /// True if hidden cells may cut a solid open.
  bool IsCapped() const { return this->Hidden && this->IsSolid; }

  /// A solid that a ray is inside of where it leaves hidden cells is capped there. Of several
  /// isovalues the highest is the one that is seen.
  void CapBehindHidden(const GradedRay& ray, const glm::ivec3& cell, double enter,
    std::size_t surface, HitBatch& hits) const
  {
    const std::vector<double>& isovalues = this->Scene.Sought.Isovalues;
    if (IsInFrontOfHit({ enter, HitKind::Cap, isovalues[surface] }, hits, ray.Ray, isovalues) &&
      ComesFromHidden(ray, cell, enter, *this->Hidden))
    {
      hits.Depth[ray.Ray] = enter;
      hits.Surface[ray.Ray] = static_cast<std::int16_t>(surface);
      hits.Kind[ray.Ray] = HitKind::Cap;
    }
  }

  /// Make the beginning of a passage the contact of its ray if it is nearer.
  static void KeepContact(
    const GradedPassage& passage, const Found& found, std::size_t ray, HitBatch& hits)
  {
    if (passage.Enter < hits.Contact[ray])
    {
      hits.Contact[ray] = passage.Enter;
      hits.FromInside[ray] = IsInside(found.AtEntry);
    }
  }

  /// Make what was found in a passage the hit of its ray if it is met before that.
  void KeepFirst(const Found& found, std::size_t surface, std::size_t ray, HitBatch& hits) const
  {
    if (!(found.Distance <= hits.Depth[ray]) || found.Distance == Infinity)
    {
      return;
    }
    const std::vector<double>& isovalues = this->Scene.Sought.Isovalues;
    const MetSurface met{ found.Distance,
      IsInside(found.AtEntry) ? HitKind::Leaves : HitKind::Enters, isovalues[surface] };
    if (IsInFrontOfHit(met, hits, ray, isovalues))
    {
      hits.Depth[ray] = found.Distance;
      hits.Surface[ray] = static_cast<std::int16_t>(surface);
      hits.Kind[ray] = met.Kind;
    }
  }

  /// A solid that a ray begins in is capped there. Of several isovalues the highest is the one
  /// that is seen.
  void FindCap(const GradedRay& ray, HitBatch& hits) const
  {
    const std::vector<double>& isovalues = this->Scene.Sought.Isovalues;
    const double begin = ray.Rays.Begin[ray.Ray];
    const glm::ivec3 cell = ray.CellAt(begin, this->Cells);
    if (this->IsHidden(cell))
    {
      return;
    }
    const std::array<T, 8> samples = this->Samples.Read(cell);
    const GradedPassage passage(ray, cell);
    double highest = -Infinity;
    for (std::size_t surface = 0; surface < isovalues.size(); ++surface)
    {
      const Found found = this->Search(passage, this->Differ(samples, surface));
      if (isovalues[surface] > highest && IsInside(found.AtEntry))
      {
        highest = isovalues[surface];
        hits.Depth[ray.Ray] = begin;
        hits.Contact[ray.Ray] = begin;
        hits.Surface[ray.Ray] = static_cast<std::int16_t>(surface);
        hits.Kind[ray.Ray] = HitKind::Cap;
      }
    }
  }

  TraceScene Scene;
  CellSamples<T> Samples;
  std::vector<Difference<double>> Differences; ///< from each isovalue
  glm::ivec3 Cells;                            ///< number of cells along each axis
  bool IsSolid;
  bool IsNearest;
  const HiddenCells* Hidden; ///< null for none
};

}

std::unique_ptr<SurfaceTracer> MakeGradedTracer(const TraceScene& scene)
{
  return DispatchScalarType(scene.Samples.Type,
    [&](auto type) -> std::unique_ptr<SurfaceTracer>
    { return std::make_unique<GradedTracer<decltype(type)>>(scene); });
}

}
