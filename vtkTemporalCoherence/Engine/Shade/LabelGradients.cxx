// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/LabelGradients.h"

#include "Shade/Shader.h"

#include <cmath>
#include <limits>

namespace TemporalCoherence
{
namespace
{

/// Finds the faces between voxels at which rays enter labels.
template <typename T>
class VoxelFaces
{
public:
  explicit VoxelFaces(const Field& field)
    : Samples(field)
  {
  }

  /// The nearest face that leads into a label; if rounding leaves none, the nearest face.
  /// \param point     in index space
  /// \param direction of the ray
  glm::dvec3 DirectionInto(
    std::int64_t label, const glm::dvec3& point, const glm::dvec3& direction) const
  {
    glm::dvec3 found(0.0);
    double nearest = std::numeric_limits<double>::infinity();
    bool leads = false;
    for (int axis = 0; axis < 3; ++axis)
    {
      const double low = std::floor(point[axis]); // the sample below the face, half a step away
      const double distance = std::abs(point[axis] - (low + 0.5));
      const bool isUp = direction[axis] > 0.0;
      const bool leadsHere =
        direction[axis] != 0.0 && this->Leads(label, point, axis, static_cast<int>(low), isUp);
      if ((leadsHere && !leads) || (leadsHere == leads && distance < nearest))
      {
        leads = leadsHere;
        nearest = distance;
        found = glm::dvec3(0.0);
        found[axis] = isUp ? 1.0 : -1.0;
      }
    }
    return found;
  }

private:
  bool Leads(std::int64_t label, const glm::dvec3& point, int axis, int low, bool isUp) const
  {
    glm::ivec3 from(glm::floor(point + 0.5));
    glm::ivec3 to = from;
    from[axis] = isUp ? low : low + 1;
    to[axis] = isUp ? low + 1 : low;
    return this->At(to) == label && this->At(from) != label;
  }

  std::int64_t At(const glm::ivec3& sample) const
  {
    return static_cast<std::int64_t>(
      *this->Samples.At(glm::clamp(sample, glm::ivec3(0), this->Samples.Dimensions - 1)));
  }

  TypedField<T> Samples;
};

/// The gradient of a label's share at a point.
glm::dvec3 SmoothGradient(
  const SmoothLabels& smooth, std::int64_t label, const glm::dvec3& point, const glm::ivec3& cells)
{
  const glm::ivec3 cell = glm::clamp(glm::ivec3(glm::floor(point)), glm::ivec3(0), cells - 1);
  const glm::dvec3 in = point - glm::dvec3(cell);
  const SmoothLabels::Block& block = smooth.Of(cell, label);
  glm::dvec3 gradient(0.0);
  for (int corner = 0; corner < 8; ++corner)
  {
    const glm::ivec3 step(corner & 1, corner >> 1 & 1, corner >> 2);
    const glm::dvec3 weights = glm::mix(1.0 - in, in, glm::dvec3(step));
    const std::size_t at = SmoothLabels::PlaceOf((cell & (CellBlocks::LeafSize - 1)) + step);
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto& along = block.Gradient[static_cast<std::size_t>(axis)];
      gradient[axis] += weights.x * weights.y * weights.z * static_cast<double>(along[at]);
    }
  }
  return gradient;
}

}

void LabelGradients(
  const GradientQuery& query, const GradientTile& tile, const SmoothLabels* smooth)
{
  // Where a label is as large before as behind, as in a thin sheet, the nearest face tells more.
  constexpr double least = 1e-4;
  const glm::dmat3 turn(query.IndexFromWorld);
  const glm::dvec3 last(query.Samples.Dimensions - 1);
  const std::size_t count = tile.Rays.Count;
  DispatchScalarType(query.Samples.Type,
    [&](auto type)
    {
      const VoxelFaces<decltype(type)> faces(query.Samples);
      for (std::size_t i = 0; i < count; ++i)
      {
        const glm::dvec3 point =
          glm::clamp(glm::dvec3(query.IndexFromWorld * glm::dvec4(tile.Rays.PointAt(i), 1.0)),
            glm::dvec3(0.0), last);
        const auto label =
          static_cast<std::int64_t>((*query.Isovalues)[static_cast<std::size_t>(tile.Surfaces[i])]);
        glm::dvec3 into(0.0);
        if (smooth)
        {
          into = SmoothGradient(*smooth, label, point, query.Samples.Dimensions - 1);
        }
        if (!(glm::length(into) > least))
        {
          into = faces.DirectionInto(label, point, turn * tile.Rays.DirectionAt(i));
        }
        for (std::size_t a = 0; a < 3; ++a)
        {
          tile.Gradients[a][i] = into[static_cast<int>(a)];
        }
      }
    });
  for (RayBatch::Array<double>& along : tile.Gradients)
  {
    FillLastVector(count, along);
  }
}

}
