// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ComponentSegment_h
#define TemporalCoherence_ComponentSegment_h

#include "Lattice/CellRoot.h"
#include "Scene/GridCoordinates.h"
#include "Scene/RayBatch.h"
#include "Volumes/Medium/BlendTracer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

namespace TemporalCoherence
{

/// The values of up to four components.
using ComponentValues = std::array<double, 4>;

/// A part of a ray in one cell, with the samples of all components.
struct ComponentSegment
{
  double Length() const { return this->Leave - this->Enter; }
  double DistanceAt(double share) const { return this->Enter + share * this->Length(); }

  double ValueAt(std::size_t component, double share) const
  {
    return this->IsNearest ? this->Samples[component][this->CornerAt(share)]
                           : Evaluate(this->Cubics[component], share);
  }

  /// The corner whose sample is the nearest.
  std::size_t CornerAt(double share) const
  {
    std::size_t step = 0;
    while (step + 1 < this->Nearest.Count && share >= this->Nearest.Shares[step + 1])
    {
      ++step;
    }
    return this->Nearest.Corners[step];
  }

  /// A part of a segment of one component.
  /// \param nearest    samples on the segment
  /// \param first, end of the nearest samples on the part
  ComponentSegment Part(const NearestPath& nearest, std::size_t first, std::size_t end) const
  {
    const bool isLast = end == nearest.Count;
    const double from = nearest.Shares[first], to = isLast ? 1.0 : nearest.Shares[end];
    ComponentSegment part = *this;
    part.Enter = this->DistanceAt(from);
    part.Leave = isLast ? this->Leave : this->DistanceAt(to);
    for (std::size_t a = 0; a < 3; ++a)
    {
      part.Path.Begin[a] = Mix(this->Path.Begin[a], this->Path.End[a], from);
      part.Path.End[a] = Mix(this->Path.Begin[a], this->Path.End[a], to);
    }
    if (!this->IsNearest)
    {
      part.Cubics[0] = CubicAlong(part.Samples[0], part.Path);
      return part;
    }
    part.Nearest.Count = end - first;
    for (std::size_t step = first; step < end; ++step)
    {
      part.Nearest.Corners[step - first] = nearest.Corners[step];
      part.Nearest.Shares[step - first] = (nearest.Shares[step] - from) / (to - from);
    }
    return part;
  }

  glm::ivec3 Cell;
  std::size_t Look = 0;  ///< in LooksByLabel
  double Enter, Leave;   ///< t
  CellPath<double> Path; ///< in the coordinates of the cell
  bool IsNearest;
  NearestPath Nearest;                    ///< if IsNearest
  std::array<Corners<double>, 4> Samples; ///< by component
  std::array<Cubic<double>, 4> Cubics;    ///< if not IsNearest
};

/// Gradients in index space at the corners of a cell, as Corners.
using CornerGradients = std::array<glm::dvec3, 8>;

/// Visits a segment; returns false to end the ray.
using SegmentVisitor = std::function<bool(const ComponentSegment& segment)>;

/// Walks rays through cells.
class SegmentSource
{
public:
  virtual ~SegmentSource() = default;
  SegmentSource(const SegmentSource&) = delete;
  SegmentSource& operator=(const SegmentSource&) = delete;

  /// Visit the visible cells of a ray from front to back, without hidden cells and cells with a
  /// sample that is not finite.
  /// \return how many cells were read
  virtual std::int64_t Visit(
    const RayBatch& rays, std::size_t ray, const SegmentVisitor& visit) const = 0;

  /// The gradients of a component at the corners of a cell: central differences, or one-sided ones
  /// at the boundary and beside a sample that is not finite.
  virtual void FindGradients(
    std::size_t component, const glm::ivec3& cell, CornerGradients& gradients) const = 0;

  /// The gradient of a component at one corner.
  virtual glm::dvec3 GradientAt(
    std::size_t component, const glm::ivec3& cell, std::size_t corner) const = 0;

protected:
  SegmentSource() = default;
};

/// Makes the source for a scene; throws std::bad_alloc.
/// \param grid where samples lie; null: at integers
using SegmentSourceMaker = std::unique_ptr<const SegmentSource> (*)(
  const BlendScene& scene, const GridCoordinates* grid);

}

#endif
