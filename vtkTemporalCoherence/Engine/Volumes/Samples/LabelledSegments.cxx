// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Samples/LabelledSegments.h"

#include "Lattice/CellSamples.h"
#include "Scene/LabelIndex.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace TemporalCoherence
{
namespace
{

std::vector<double> LabelsOf(const LabelMap& map)
{
  std::vector<double> labels;
  for (const LabelledLook& each : map.Looks)
  {
    labels.push_back(static_cast<double>(each.Label));
  }
  return labels;
}

/// The corners of a cell whose samples are the nearest ones on a path.
NearestPath NearestOn(const CellPath<double>& path)
{
  std::array<double, 3> midway{};
  for (std::size_t a = 0; a < 3; ++a)
  {
    midway[a] = (0.5 - path.Begin[a]) / (path.End[a] - path.Begin[a]);
  }
  return FindNearestPath(path, midway);
}

/// \tparam T the type of labels
template <typename T>
class LabelledSegments final : public SegmentSource
{
public:
  LabelledSegments(const LabelMap& map, std::unique_ptr<const SegmentSource> cells)
    : Labels(map.Samples)
    , Looks(LabelsOf(map))
    , Cells(std::move(cells))
  {
  }

  std::int64_t Visit(
    const RayBatch& rays, std::size_t ray, const SegmentVisitor& visit) const override
  {
    return this->Cells->Visit(
      rays, ray, [&](const ComponentSegment& segment) { return this->VisitParts(segment, visit); });
  }

  void FindGradients(
    std::size_t component, const glm::ivec3& cell, CornerGradients& gradients) const override
  {
    this->Cells->FindGradients(component, cell, gradients);
  }

  glm::dvec3 GradientAt(
    std::size_t component, const glm::ivec3& cell, std::size_t corner) const override
  {
    return this->Cells->GradientAt(component, cell, corner);
  }

private:
  /// 0 for labels without a look of their own.
  std::size_t LookOf(T label) const
  {
    return static_cast<std::size_t>(this->Looks.Of(static_cast<std::int64_t>(label)) + 1);
  }

  bool VisitParts(const ComponentSegment& whole, const SegmentVisitor& visit) const
  {
    const std::array<T, 8> labels = this->Labels.Read(whole.Cell);
    std::array<std::size_t, 8> looks;
    std::transform(
      labels.begin(), labels.end(), looks.begin(), [this](T label) { return this->LookOf(label); });
    if (std::equal(looks.begin() + 1, looks.end(), looks.begin()))
    {
      ComponentSegment same = whole;
      same.Look = looks[0];
      return visit(same);
    }
    const NearestPath nearest = whole.IsNearest ? whole.Nearest : NearestOn(whole.Path);
    for (std::size_t first = 0, end = 0; first < nearest.Count; first = end)
    {
      const std::size_t look = looks[nearest.Corners[first]];
      for (end = first + 1; end < nearest.Count && looks[nearest.Corners[end]] == look;)
      {
        ++end;
      }
      ComponentSegment part = whole.Part(nearest, first, end);
      part.Look = look;
      if (part.Enter < part.Leave && !visit(part))
      {
        return false;
      }
    }
    return true;
  }

  CellSamples<T> Labels;
  LabelIndex Looks;
  std::unique_ptr<const SegmentSource> Cells;
};

}

std::unique_ptr<const SegmentSource> MakeLabelledSegments(
  const LabelMap& labels, std::unique_ptr<const SegmentSource> cells)
{
  return DispatchScalarType(labels.Samples.Type,
    [&](auto type) -> std::unique_ptr<const SegmentSource>
    { return std::make_unique<LabelledSegments<decltype(type)>>(labels, std::move(cells)); });
}

}
