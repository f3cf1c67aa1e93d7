// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/FieldKind.h"

#include "Scene/CapPoint.h"
#include "Scene/CellBox.h"
#include "Scene/Field.h"

#include <cmath>
#include <limits>

namespace TemporalCoherence
{

glm::dvec2 FieldKind::RangeIn(const CellBox&) const
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return { -infinity, infinity };
}

std::uint64_t FieldKind::CellsIn(const CellBox&, const std::vector<ValueBand>&) const
{
  return ~std::uint64_t(0);
}

IndexBox FieldKind::BoxOf(const CellBox& cells) const
{
  return { glm::dvec3(cells.First), glm::dvec3(cells.First + cells.Size) };
}

VoxelSize FieldKind::VoxelSizeIn(const IndexTransform& transform) const
{
  const glm::dmat3 edges(transform.WorldFromIndex);
  const double x = glm::length(edges[0]), y = glm::length(edges[1]), z = glm::length(edges[2]);
  const double longest = glm::max(x, glm::max(y, z));
  return { glm::min(x, glm::min(y, z)), longest, longest };
}

std::shared_ptr<const BandTracer> FieldKind::MakeBandTracer(const BandScene&) const
{
  return nullptr;
}

std::shared_ptr<const BlendTracer> FieldKind::MakeBlendTracer(const BlendScene&) const
{
  return nullptr;
}

bool FieldKind::GainsFromImages(const Field&, const Surfaces&) const
{
  return true;
}

glm::dvec3 FieldKind::FaceNormal(const Field& field, const CapPoint& cap, double& nearest) const
{
  glm::dvec3 normal(0.0);
  for (int axis = 0; axis < 3; ++axis)
  {
    const double face = cap.Direction[axis] > 0.0 ? 0.0 : field.Dimensions[axis] - 1;
    const double distance = std::abs(cap.At[axis] - face);
    if (cap.Direction[axis] != 0.0 && distance < nearest)
    {
      nearest = distance;
      normal = glm::dvec3(0.0);
      normal[axis] = cap.Direction[axis] > 0.0 ? -1.0 : 1.0;
    }
  }
  return normal;
}

}
