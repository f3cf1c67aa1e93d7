// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/FieldShape.h"

#include "Scene/CellBox.h"
#include "Scene/Field.h"

#include <limits>

namespace TemporalCoherence
{

glm::dvec2 FieldShape::RangeIn(const CellBox&) const
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return { -infinity, infinity };
}

std::uint64_t FieldShape::CellsIn(const CellBox&, const std::vector<ValueBand>&) const
{
  return ~std::uint64_t(0);
}

IndexBox FieldShape::BoxOf(const CellBox& cells) const
{
  return { glm::dvec3(cells.First), glm::dvec3(cells.First + cells.Size) };
}

VoxelSize FieldShape::VoxelSizeIn(const IndexTransform& transform) const
{
  const glm::dmat3 edges(transform.WorldFromIndex);
  const double x = glm::length(edges[0]), y = glm::length(edges[1]), z = glm::length(edges[2]);
  return { glm::min(x, glm::min(y, z)), glm::max(x, glm::max(y, z)) };
}

namespace
{

/// Boxes and lengths are the defaults of FieldShape.
class ShapeOfImages final : public FieldShape
{
public:
  FieldAbilities Abilities() const override { return { true, true, true }; }
};

}

std::shared_ptr<const FieldShape> UniformShape()
{
  // Without an owner, so that copying fields counts no references.
  static const ShapeOfImages shape{};
  return { std::shared_ptr<const FieldShape>(), &shape };
}

}
