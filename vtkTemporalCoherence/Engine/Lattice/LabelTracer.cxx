// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/LabelTracer.h"

#include "Lattice/KernelsRays.h"
#include "Lattice/KernelsWalk.h"
#include "Lattice/TracedCells.h"
#include "Lattice/UniformCells.h"
#include "Scene/LabelIndex.h"

#include <algorithm>
#include <array>
#include <utility>

namespace TemporalCoherence
{
namespace
{

/// The smooth labels of a cell.
template <typename T, typename Real>
struct SmoothCell
{
  void Set(const glm::ivec3& cell, const std::array<T, 8>& labels, const SmoothLabels& smooth)
  {
    this->Place = cell;
    this->Count = 0;
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      std::size_t label = 0;
      while (label < this->Count && this->Labels[label] < labels[corner])
      {
        ++label;
      }
      if (label == this->Count || this->Labels[label] != labels[corner])
      {
        std::copy_backward(this->Labels.begin() + static_cast<std::ptrdiff_t>(label),
          this->Labels.begin() + static_cast<std::ptrdiff_t>(this->Count),
          this->Labels.begin() + static_cast<std::ptrdiff_t>(this->Count) + 1);
        this->Labels[label] = labels[corner];
        ++this->Count;
      }
    }
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      std::uint8_t label = 0;
      while (this->Labels[label] != labels[corner])
      {
        ++label;
      }
      this->Own[corner] = label;
    }
    if (this->Count > 1)
    {
      this->SetShares(smooth);
    }
  }

  glm::ivec3 Place{ -1 };
  std::array<T, 8> Labels; ///< ascending
  std::size_t Count = 0;
  std::array<std::uint8_t, 8> Own; ///< label of each corner, by its position in Labels
  std::array<Corners<Real>, 8> Shares;

private:
  void SetShares(const SmoothLabels& smooth)
  {
    const glm::ivec3 inLeaf = this->Place & (CellBlocks::LeafSize - 1);
    for (std::size_t label = 0; label < this->Count; ++label)
    {
      const SmoothLabels::Block& block =
        smooth.Of(this->Place, static_cast<std::int64_t>(this->Labels[label]));
      for (std::size_t corner = 0; corner < 8; ++corner)
      {
        const glm::ivec3 step(corner & 1, corner >> 1 & 1, corner >> 2);
        this->Shares[label][corner] =
          static_cast<Real>(block.Share[SmoothLabels::PlaceOf(inLeaf + step)]);
      }
    }
  }
};

/// The smooth labels of the cells that the rays of a tile used last.
template <typename T, typename Real>
class SmoothCells
{
public:
  explicit SmoothCells(const SmoothLabels* all)
    : All(all)
  {
  }

  const SmoothCell<T, Real>& Of(const glm::ivec3& cell, const CellSamples<T>& samples)
  {
    SmoothCell<T, Real>& found =
      this->Cells[static_cast<std::size_t>((cell.x & 3) | (cell.y & 3) << 2 | (cell.z & 3) << 4)];
    if (found.Place != cell)
    {
      found.Set(cell, samples.Read(cell), *this->All);
    }
    return found;
  }

private:
  const SmoothLabels* All;
  std::array<SmoothCell<T, Real>, 64> Cells;
};

/// The smooth labels in a cell along the path of a ray.
template <typename T, typename Real>
class LabelPath
{
public:
  LabelPath(const SmoothCell<T, Real>& cell, const CellPath<Real>& path)
    : Cell(cell)
    , Path(path)
  {
    if (cell.Count == 2)
    {
      this->OfTwo = this->Lead(0, 1);
    }
  }

  T LabelAt(std::size_t label) const { return this->Cell.Labels[label]; }

  /// The label where the path begins, or ends. Only labels of samples with a weight there count, so
  /// cells agree at their faces.
  std::size_t AtBegin() const
  {
    return this->Cell.Count != 2 ? this->Largest(this->Path.Begin, 0)
      : IsInside(this->OfTwo[0]) ? 0
                                 : 1;
  }
  std::size_t AtEnd() const { return this->Largest(this->Path.End, 3); }

  /// Call visit(share of the path, label) for each change to another label, in order, until it
  /// returns true.
  template <typename Visit>
  void VisitChanges(std::size_t label, const Visit& visit) const
  {
    if (this->Cell.Count <= 2)
    {
      VisitCrossings(this->OfTwo,
        [&](Real at)
        {
          label = 1 - label;
          return visit(at, label);
        });
      return;
    }
    // Each change is to a label whose share passes that of the present one.
    constexpr int most = 24;
    Real here = Real(0);
    for (int change = 0; change < most; ++change)
    {
      Real next = Real(2);
      std::size_t to = label;
      for (std::size_t other = 0; other < this->Cell.Count; ++other)
      {
        const Real at = other == label ? Real(2) : this->FirstShare(label, other, here);
        to = at < next ? other : to;
        next = std::min(next, at);
      }
      if (to == label)
      {
        break;
      }
      if (visit(next, to))
      {
        return;
      }
      label = to;
      here = next;
    }
    const std::size_t last = this->AtEnd();
    if (last != label)
    {
      visit(Real(1), last);
    }
  }

private:
  /// The difference between the shares of two labels along the path: first minus second.
  /// \pre first < second
  Cubic<Real> Lead(std::size_t first, std::size_t second) const
  {
    Corners<Real> lead;
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      lead[corner] = this->Cell.Shares[first][corner] - this->Cell.Shares[second][corner];
    }
    return CubicAlong(lead, this->Path);
  }

  /// The label with the largest share at an end of the path.
  /// \param coefficient of a cubic that is its value there
  std::size_t Largest(const std::array<Real, 3>& at, std::size_t coefficient) const
  {
    std::uint32_t counts = 0; // one bit for each label
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      bool hasWeight = true;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        hasWeight &= at[axis] != (corner >> axis & 1u ? Real(0) : Real(1));
      }
      counts |= static_cast<std::uint32_t>(hasWeight) << this->Cell.Own[corner];
    }
    std::size_t largest = this->Cell.Count;
    for (std::size_t label = 0; label < this->Cell.Count; ++label)
    {
      const bool isLarger = (counts >> label & 1u) != 0 &&
        (largest == this->Cell.Count || !IsInside(this->Lead(largest, label)[coefficient]));
      largest = isLarger ? label : largest;
    }
    return largest;
  }

  /// The first place from `here` on where another label takes over; 2 if none does.
  Real FirstShare(std::size_t label, std::size_t other, Real here) const
  {
    const bool isFirst = label < other;
    const Cubic<Real> lead = isFirst ? this->Lead(label, other) : this->Lead(other, label);
    bool leads = IsInside(lead[0]) == isFirst;
    Real found = Real(2);
    VisitCrossings(lead,
      [&](Real at)
      {
        if (at > here)
        {
          found = leads ? at : found;
          return true;
        }
        leads = !leads;
        return false;
      });
    return leads ? found : here;
  }

  const SmoothCell<T, Real>& Cell;
  const CellPath<Real>& Path;
  Cubic<Real> OfTwo{}; ///< Lead(0, 1), if there are two labels
};

template <typename T>
class LabelTracer final
  : public SurfaceTracer
  , private LeafSource
{
public:
  LabelTracer(const TraceScene& scene, std::shared_ptr<const SmoothLabels> smooth)
    : Cells(scene, {})
    , Labels(scene.Isosurfaces.Isovalues)
    , Smooth(std::move(smooth))
  {
  }

  void Trace(const RayBatch& rays, HitBatch& hits) const override
  {
    hits.Clear(rays.Count);
    Recent recent(this->Smooth.get());
    for (std::size_t ray = 0; rays.MayBeCapped && ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      if (rays.Begin[ray] < rays.End[ray])
      {
        const SurfaceIndex surface = this->SurfaceAtBegin({ rays, ray }, recent);
        if (surface != Frame::NoSurface)
        {
          Keep(rays.Begin[ray], HitKind::Cap, surface, ray, hits);
        }
      }
    }
    if (this->Cells.Scene.Active)
    {
      this->TraceActive(rays, recent, hits);
    }
    else
    {
      this->TraceAll(rays, recent, hits);
    }
  }

  /// Rays that begin at a surface are not blocked by the label that they begin in: normals are
  /// smoother than surfaces.
  std::uint64_t FindBlocked(const RayBatch& rays, std::int64_t& cellsRead) const override
  {
    RayBatch fromSurface = rays;
    fromSurface.MayBeCapped = false;
    return SurfaceTracer::FindBlocked(fromSurface, cellsRead);
  }

  void FindNext(const RayBatch& rays, HitBatch& hits) const override
  {
    Recent recent(this->Smooth.get());
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      const BatchRay line{ rays, ray };
      NextHit next(this->Cells.Rules, LastOn(this->Cells.Rules, rays.Begin[ray], ray, hits));
      if (rays.Begin[ray] < rays.End[ray] && rays.MayBeCapped)
      {
        const SurfaceIndex surface = this->SurfaceAtBegin(line, recent);
        if (surface != Frame::NoSurface)
        {
          next.Consider(rays.Begin[ray], HitKind::Cap, surface);
        }
      }
      if (!next.IsFound() && rays.HasWalk(ray))
      {
        this->WalkOn(line, recent, next, hits);
      }
      next.Store(ray, hits);
    }
  }

private:
  using Lattice = TracedCells<T, UniformCells<T>, Interpolation::Nearest>;
  using Segment = typename Lattice::Segment;
  using Path = LabelPath<T, typename Lattice::Real>;
  using Recent = SmoothCells<T, typename Lattice::Real>;

  std::uint64_t CellsOf(std::int64_t node, const glm::ivec3& cell) const override
  {
    return this->Cells.Scene.Active->CellsOf(this->Cells.Samples.All(), node, cell);
  }

  static void Keep(
    double distance, HitKind kind, SurfaceIndex surface, std::size_t ray, HitBatch& hits)
  {
    hits.Depth[ray] = distance;
    hits.Kind[ray] = kind;
    hits.Surface[ray] = surface;
  }

  /// The surface of a label; NoSurface if it is not drawn.
  SurfaceIndex SurfaceOf(T label) const
  {
    return this->Labels.Of(static_cast<std::int64_t>(label));
  }

  /// The surface of the label that a ray begins in.
  SurfaceIndex SurfaceAtBegin(const BatchRay& line, Recent& recent) const
  {
    const glm::ivec3 cell = line.CellAt(line.Rays.Begin[line.Ray], this->Cells.Count);
    if (this->Cells.IsHidden(cell))
    {
      return Frame::NoSurface;
    }
    const Segment segment(line, cell);
    if (this->Smooth)
    {
      const Path path(recent.Of(cell, this->Cells.Samples), segment.Path());
      return this->SurfaceOf(path.LabelAt(path.AtBegin()));
    }
    return this->SurfaceOf(this->Cells.Samples.Read(cell)[NearestCorner(segment.Path().Begin)]);
  }

  /// Call meet(distance, kind, surface) for each label that a ray enters in a cell, in order, until
  /// it returns true.
  template <typename Meet>
  void Visit(const BatchRay& line, const glm::ivec3& cell, Recent& recent, const Meet& meet) const
  {
    if (this->Cells.IsHidden(cell))
    {
      return;
    }
    const Segment segment(line, cell);
    if (!segment.HasLength())
    {
      return;
    }
    const bool isBehindHidden = this->Cells.Hidden && segment.ComesFrom(*this->Cells.Hidden);
    const auto meetAt = [&](double distance, HitKind kind, T label)
    {
      const SurfaceIndex surface = this->SurfaceOf(label);
      return surface != Frame::NoSurface && meet(distance, kind, surface);
    };
    if (this->Smooth)
    {
      const Path path(recent.Of(cell, this->Cells.Samples), segment.Path());
      const std::size_t first = path.AtBegin();
      if (!(isBehindHidden && meetAt(segment.Enter(), HitKind::Cap, path.LabelAt(first))))
      {
        path.VisitChanges(first,
          [&](auto share, std::size_t label)
          {
            return meetAt(
              segment.DistanceAt(static_cast<double>(share)), HitKind::Entry, path.LabelAt(label));
          });
      }
      return;
    }
    const std::array<T, 8> labels = this->Cells.Samples.Read(cell);
    const NearestPath path = segment.Nearest();
    T before = labels[path.Corners[0]];
    bool isDone = isBehindHidden && meetAt(segment.Enter(), HitKind::Cap, before);
    for (std::size_t i = 1; i < path.Count && !isDone; ++i)
    {
      // Of voxels that the ray only touches, nothing is seen.
      const bool isLast = i + 1 == path.Count;
      const bool isTouched = isLast
        ? path.Shares[i] == 1.0 && segment.Leave() == line.Rays.End[line.Ray]
        : path.Shares[i + 1] == path.Shares[i];
      const T label = labels[path.Corners[i]];
      if (!isTouched && label != before)
      {
        before = label;
        isDone = meetAt(segment.DistanceAt(path.Shares[i]), HitKind::Entry, label);
      }
    }
  }

  /// Search the present cell of a ray for its first hit.
  void VisitFirst(const BatchRay& line, const glm::ivec3& cell, std::size_t ray, Recent& recent,
    HitBatch& hits) const
  {
    ++hits.CellsRead;
    this->Visit(line, cell, recent,
      [&](double distance, HitKind kind, SurfaceIndex surface)
      {
        Keep(distance, kind, surface, ray, hits);
        return true;
      });
  }

  /// Walk from active cell to active cell, all rays together.
  void TraceActive(const RayBatch& rays, Recent& recent, HitBatch& hits) const
  {
    RayWalks walks(rays, WalksWithoutHit(rays, hits));
    while (walks.Rays.Count > 0)
    {
      FindActiveCells({ *this->Cells.Scene.Active, *this, this->Cells.Count }, walks);
      for (std::size_t i = 0; i < static_cast<std::size_t>(walks.Rays.Count); ++i)
      {
        const auto ray = static_cast<std::size_t>(walks.From[i]);
        const glm::ivec3 cell(walks.Cell[0][i], walks.Cell[1][i], walks.Cell[2][i]);
        this->VisitFirst({ walks.Rays, i }, cell, ray, recent, hits);
        walks.Distance[i] = hits.Depth[ray];
      }
    }
  }

  /// Walk from cell to cell, ray by ray.
  void TraceAll(const RayBatch& rays, Recent& recent, HitBatch& hits) const
  {
    for (std::uint64_t left = WalksWithoutHit(rays, hits); left != 0; left &= left - 1)
    {
      const std::size_t ray = hwy::Num0BitsBelowLS1Bit_Nonzero64(left);
      const BatchRay line{ rays, ray };
      CellWalk walk;
      walk.Begin(line, this->Cells.Count);
      while (hits.Kind[ray] == HitKind::None && this->Cells.GoOn(line, walk))
      {
        this->VisitFirst(line, walk.Here(), ray, recent, hits);
      }
    }
  }

  /// Walk from active cell to active cell until the ray meets its next label.
  void WalkOn(const BatchRay& line, Recent& recent, NextHit& next, HitBatch& hits) const
  {
    RayBatch rest;
    AppendRay(line.Rays, line.Ray, rest);
    rest.WalkBegin[0] = std::max(rest.WalkBegin[0], next.Before().Distance);
    const BatchRay ahead{ rest, 0 };
    if (!rest.HasWalk(0))
    {
      return;
    }
    CellWalk walk;
    walk.Begin(ahead, this->Cells.Count);
    while (!next.IsFound() && this->Cells.GoOn(ahead, walk))
    {
      ++hits.CellsRead;
      this->Visit(ahead, walk.Here(), recent,
        [&next](double distance, HitKind kind, SurfaceIndex surface)
        {
          next.Consider(distance, kind, surface);
          return next.IsFound();
        });
    }
  }

  Lattice Cells;
  LabelIndex Labels;
  std::shared_ptr<const SmoothLabels> Smooth; ///< null: labels are made of voxels
};

}

std::shared_ptr<const SurfaceTracer> MakeLabelTracer(
  const TraceScene& scene, std::shared_ptr<const SmoothLabels> smooth)
{
  return DispatchScalarType(scene.Samples.Type,
    [&](auto type) -> std::shared_ptr<const SurfaceTracer>
    { return std::make_shared<LabelTracer<decltype(type)>>(scene, smooth); });
}

}
