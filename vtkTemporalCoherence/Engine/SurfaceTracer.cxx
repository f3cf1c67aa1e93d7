// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceTracer.h"

#include "CellRoot.h"
#include "Frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace TemporalCoherence
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// One ray on its way from cell to cell.
///
/// The distance at which the ray passes a plane between cells is always computed from the plane's
/// position, never summed up on the way, so that each cell's part of the ray is the same however
/// the ray got there.
class CellWalk
{
public:
  CellWalk(const RayBatch& rays, std::size_t ray, const glm::ivec3& cells)
    : Cells(cells)
    , End(rays.WalkEnd[ray])
    , T(rays.WalkBegin[ray])
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto a = static_cast<std::size_t>(axis);
      this->Origin[axis] = rays.Origin[a][ray];
      this->Direction[axis] = rays.Direction[a][ray];
      this->Inverse[axis] = rays.Inverse[a][ray];
      this->Ahead[axis] = this->Direction[axis] > 0.0 ? 1 : 0;
      const double at = this->Origin[axis] + this->T * this->Direction[axis];
      this->Cell[axis] = Clamp(static_cast<int>(std::floor(at)), 0, cells[axis] - 1);
    }
  }

  /// Distance at which the ray passes plane `plane` of an axis.
  double Pass(int axis, int plane) const
  {
    return (plane - this->Origin[axis]) * this->Inverse[axis];
  }

  /// Go on behind the aligned block of 2^bits cells that holds the present cell.
  /// \return false if the walk ends before
  bool LeaveBlock(int bits)
  {
    const int size = 1 << bits;
    const glm::ivec3 first = this->Cell & -size;
    const double leave[3] = { this->Pass(0, first.x + this->Ahead.x * size),
      this->Pass(1, first.y + this->Ahead.y * size),
      this->Pass(2, first.z + this->Ahead.z * size) };
    const int exit = FirstOf(leave);
    this->T = leave[exit];
    if (!(this->T < this->End))
    {
      return false;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const double at = this->Origin[axis] + this->T * this->Direction[axis];
      this->Cell[axis] = Clamp(static_cast<int>(at), first[axis], first[axis] + size - 1);
    }
    this->Cell[exit] = this->Ahead[exit] ? first[exit] + size : first[exit] - 1;
    return this->IsInGrid(exit);
  }

  /// Prepare for steps from cell to cell.
  void BeginSteps()
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Next[axis] = this->Pass(axis, this->Cell[axis] + this->Ahead[axis]);
    }
  }

  /// Go on to the next cell.
  /// \return the axis along which the ray leaves the present cell, or -1 if the walk ends before
  int Step()
  {
    const int exit = FirstOf(this->Next);
    this->T = this->Next[exit];
    if (!(this->T < this->End))
    {
      return -1;
    }
    const int ahead = this->Ahead[exit];
    const int cell = this->Cell[exit] + 2 * ahead - 1;
    this->Cell[exit] = cell;
    this->Next[exit] = this->Pass(exit, cell + ahead);
    return exit;
  }

  bool IsInGrid(int axis) const
  {
    return static_cast<unsigned>(this->Cell[axis]) < static_cast<unsigned>(this->Cells[axis]);
  }

  static int Clamp(int value, int low, int high)
  {
    value = value < low ? low : value;
    return value > high ? high : value;
  }

  static int FirstOf(const double distances[3])
  {
    const int first = distances[1] < distances[0] ? 1 : 0;
    return distances[2] < distances[first] ? 2 : first;
  }

  glm::ivec3 Cells; ///< number of cells along each axis
  glm::ivec3 Cell{ 0 };
  glm::ivec3 Ahead; ///< 1 where the ray runs towards higher cells, else 0
  glm::dvec3 Origin, Direction, Inverse;
  double End;
  double T;       ///< where the walk stands
  double Next[3]; ///< where the ray leaves the present cell along each axis, while stepping
};

/// The part of a ray within one cell.
template <typename Real>
struct CellPassage
{
  /// \return false if the ray only touches the cell
  bool SetUp(const CellWalk& walk, double begin, double end)
  {
    double enter[3], leave[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const int ahead = walk.Ahead[axis];
      enter[axis] = walk.Pass(axis, walk.Cell[axis] + 1 - ahead);
      leave[axis] = walk.Pass(axis, walk.Cell[axis] + ahead);
    }
    this->Enter = std::max(begin, std::max(enter[0], std::max(enter[1], enter[2])));
    this->Leave = std::min(end, std::min(leave[0], std::min(leave[1], leave[2])));
    if (!(this->Enter < this->Leave))
    {
      return false;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      // On a face the coordinate is exactly 0 or 1, as the neighbour across the face has it.
      const auto a = static_cast<std::size_t>(axis);
      const Real ahead = static_cast<Real>(walk.Ahead[axis]);
      this->Path.Begin[a] =
        this->Enter == enter[axis] ? Real(1) - ahead : At(walk, axis, this->Enter);
      this->Path.End[a] = this->Leave == leave[axis] ? ahead : At(walk, axis, this->Leave);
    }
    return true;
  }

  static Real At(const CellWalk& walk, int axis, double t)
  {
    const double at = walk.Origin[axis] + t * walk.Direction[axis] - walk.Cell[axis];
    return static_cast<Real>(std::min(std::max(at, 0.0), 1.0));
  }

  double Enter, Leave;
  CellPath<Real> Path;
};

template <typename T, Interpolation Between>
class TypedTracer final : public SurfaceTracer
{
public:
  using Real = RealOf<T>;

  explicit TypedTracer(const TraceScene& scene)
    : Scene(scene)
    , Samples(scene.Samples)
    , Cells(scene.Samples.Dimensions - 1)
  {
    const glm::i64vec3& s = this->Samples.Strides;
    for (const double isovalue : scene.Sought.Isovalues)
    {
      this->Differences.emplace_back(isovalue, scene.FiniteRange);
    }
    this->CornerOffsets = { 0, s.x, s.y, s.x + s.y, s.z, s.x + s.z, s.y + s.z, s.x + s.y + s.z };
  }

  void Trace(const RayBatch& rays, HitBatch& hits) const override
  {
    hits.CellsRead = 0;
    for (int i = 0; i < rays.Count; ++i)
    {
      const auto ray = static_cast<std::size_t>(i);
      Hit hit;
      if (rays.Begin[ray] < rays.End[ray])
      {
        // A solid that the ray begins in is capped there; otherwise what is ahead counts.
        const bool cut =
          this->Scene.Sought.Mode == SurfaceMode::Threshold && this->BeginsInside(rays, ray, hit);
        if (!cut && rays.WalkBegin[ray] < rays.WalkEnd[ray])
        {
          this->Walk(rays, ray, hit, hits.CellsRead);
        }
      }
      hits.Depth[ray] = hit.Depth;
      hits.Surface[ray] = hit.Surface;
      hits.Kind[ray] = hit.Kind;
    }
  }

private:
  struct Hit
  {
    double Depth = Infinity;
    std::int16_t Surface = Frame::NoSurface;
    HitKind Kind = HitKind::None;
  };

  void Walk(const RayBatch& rays, std::size_t ray, Hit& hit, std::int64_t& cellsRead) const
  {
    CellWalk walk(rays, ray, this->Cells);
    if (!this->Scene.Active)
    {
      this->WalkEveryCell(walk, rays, ray, hit, cellsRead);
      return;
    }
    const ActiveCells& active = *this->Scene.Active;
    bool isAhead = true;
    while (isAhead)
    {
      const std::int64_t node = active.NodeOf(walk.Cell);
      const std::uint64_t leaves = active.LeavesOf(node);
      if (leaves == 0)
      {
        isAhead = walk.LeaveBlock(ActiveCells::NodeBits);
      }
      else if (!(leaves >> ActiveCells::LeafOf(walk.Cell) & 1u))
      {
        isAhead = walk.LeaveBlock(ActiveCells::LeafBits);
      }
      else
      {
        const std::uint64_t cells = active.CellsOf(this->Samples, node, walk.Cell);
        isAhead = this->WalkLeaf(cells, walk, rays, ray, hit, cellsRead);
      }
    }
  }

  void WalkEveryCell(
    CellWalk& walk, const RayBatch& rays, std::size_t ray, Hit& hit, std::int64_t& cellsRead) const
  {
    walk.BeginSteps();
    int exit;
    do
    {
      if (this->VisitCell(walk, rays, ray, hit, cellsRead))
      {
        return;
      }
      exit = walk.Step();
    } while (exit >= 0 && walk.IsInGrid(exit));
  }

  /// Visit the active cells of the present leaf that lie on the way.
  /// \return true if the walk goes on behind the leaf
  bool WalkLeaf(std::uint64_t cells, CellWalk& walk, const RayBatch& rays, std::size_t ray,
    Hit& hit, std::int64_t& cellsRead) const
  {
    walk.BeginSteps();
    int leaf;
    int exit;
    do
    {
      if (cells >> ActiveCells::BitOf(walk.Cell) & 1u &&
        this->VisitCell(walk, rays, ray, hit, cellsRead))
      {
        return false;
      }
      leaf = ActiveCells::LeafOf(walk.Cell);
      exit = walk.Step();
      if (exit < 0)
      {
        return false;
      }
    } while (ActiveCells::LeafOf(walk.Cell) == leaf);
    return walk.IsInGrid(exit);
  }

  /// Look for the nearest surface in the walk's cell; false if there is none.
  bool VisitCell(const CellWalk& walk, const RayBatch& rays, std::size_t ray, Hit& hit,
    std::int64_t& cellsRead) const
  {
    const T* origin = this->Samples.At(walk.Cell);
    std::array<T, 8> samples;
    for (std::size_t i = 0; i < 8; ++i)
    {
      samples[i] = origin[this->CornerOffsets[i]];
    }
    ++cellsRead;

    CellPassage<Real> passage;
    bool isSetUp = false;
    for (std::size_t surface = 0; surface < this->Differences.size(); ++surface)
    {
      Corners<Real> corners;
      if (!this->Differ(samples, this->Differences[surface], corners))
      {
        continue;
      }
      if (!isSetUp && !passage.SetUp(walk, rays.Begin[ray], rays.End[ray]))
      {
        return false;
      }
      isSetUp = true;
      double t;
      const HitKind kind = this->FindCrossing(walk, passage, corners, t);
      if (kind != HitKind::None && t < hit.Depth)
      {
        hit = { t, static_cast<std::int16_t>(surface), kind };
      }
    }
    return hit.Surface != Frame::NoSurface;
  }

  /// Differences of a cell's samples; false if all are on the same side of the isovalue.
  static bool Differ(
    const std::array<T, 8>& samples, const Difference<T>& difference, Corners<Real>& corners)
  {
    int inside = 0;
    for (std::size_t i = 0; i < 8; ++i)
    {
      corners[i] = difference(samples[i]);
      inside += IsInside(corners[i]);
    }
    return inside != 0 && inside != 8;
  }

  /// The first crossing in a cell. In a solid (THRESHOLD) that the walk began in, it is where the
  /// ray enters the cell, and the ray "leaves".
  HitKind FindCrossing(const CellWalk& walk, const CellPassage<Real>& passage,
    const Corners<Real>& corners, double& t) const
  {
    const double length = passage.Leave - passage.Enter;
    bool isInside;
    if constexpr (Between == Interpolation::Linear)
    {
      const Cubic<Real> cubic = CubicAlong(corners, passage.Path);
      isInside = IsInside(cubic[0]);
      Real s = Real(0);
      const bool isInSolid = this->Scene.Sought.Mode == SurfaceMode::Threshold && isInside;
      if (!isInSolid && !FirstCrossing(cubic, s))
      {
        return HitKind::None;
      }
      t = passage.Enter + static_cast<double>(s) * length;
    }
    else
    {
      std::array<double, 3> midway;
      for (int axis = 0; axis < 3; ++axis)
      {
        const double middle = walk.Cell[axis] + 0.5 - walk.Origin[axis];
        midway[static_cast<std::size_t>(axis)] =
          (middle * walk.Inverse[axis] - passage.Enter) / length;
      }
      isInside = IsInside(corners[NearestCorner(passage.Path.Begin)]);
      double s;
      if (!FirstNearestCrossing(corners, passage.Path, midway, s))
      {
        return HitKind::None;
      }
      t = passage.Enter + s * length;
    }
    return isInside ? HitKind::Leaves : HitKind::Enters;
  }

  /// True if the field at the beginning of the ray is inside an isovalue. Of several that are, the
  /// highest is the one that is seen.
  bool BeginsInside(const RayBatch& rays, std::size_t ray, Hit& hit) const
  {
    glm::ivec3 cell;
    std::array<Real, 3> at;
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto a = static_cast<std::size_t>(axis);
      const int last = this->Cells[axis] - 1;
      const bool isForward = rays.Direction[a][ray] > 0.0;
      const double face = isForward ? 0.0 : last + 1.0;
      if ((face - rays.Origin[a][ray]) * rays.Inverse[a][ray] == rays.Begin[ray])
      {
        // The ray enters here: exactly on the face, whose samples may equal an isovalue.
        cell[axis] = isForward ? 0 : last;
        at[a] = isForward ? Real(0) : Real(1);
        continue;
      }
      const double x = rays.Origin[a][ray] + rays.Begin[ray] * rays.Direction[a][ray];
      cell[axis] = CellWalk::Clamp(static_cast<int>(std::floor(x)), 0, last);
      at[a] = static_cast<Real>(std::min(std::max(x - cell[axis], 0.0), 1.0));
    }
    const T* origin = this->Samples.At(cell);
    const std::vector<double>& isovalues = this->Scene.Sought.Isovalues;
    for (std::size_t surface = 0; surface < isovalues.size(); ++surface)
    {
      const bool isHighest = hit.Surface == Frame::NoSurface ||
        isovalues[surface] > isovalues[static_cast<std::size_t>(hit.Surface)];
      if (isHighest && this->IsInsideAt(origin, at, this->Differences[surface]))
      {
        hit = { rays.Begin[ray], static_cast<std::int16_t>(surface), HitKind::Cap };
      }
    }
    return hit.Surface != Frame::NoSurface;
  }

  bool IsInsideAt(
    const T* origin, const std::array<Real, 3>& at, const Difference<T>& difference) const
  {
    if constexpr (Between == Interpolation::Nearest)
    {
      return IsInside(difference(origin[this->CornerOffsets[NearestCorner(at)]]));
    }
    else
    {
      Corners<Real> corners;
      for (std::size_t i = 0; i < 8; ++i)
      {
        corners[i] = difference(origin[this->CornerOffsets[i]]);
      }
      return IsInside(CubicAlong(corners, { at, at })[0]);
    }
  }

  TraceScene Scene;
  TypedField<T> Samples;
  std::vector<Difference<T>> Differences; ///< from each isovalue
  glm::ivec3 Cells;                       ///< number of cells along each axis
  std::array<std::int64_t, 8> CornerOffsets;
};

}

std::unique_ptr<SurfaceTracer> SurfaceTracer::Make(const TraceScene& scene)
{
  return DispatchScalarType(scene.Samples.Type,
    [&](auto type) -> std::unique_ptr<SurfaceTracer>
    {
      using T = decltype(type);
      if (scene.Samples.Between == Interpolation::Nearest)
      {
        return std::make_unique<TypedTracer<T, Interpolation::Nearest>>(scene);
      }
      return std::make_unique<TypedTracer<T, Interpolation::Linear>>(scene);
    });
}

}
