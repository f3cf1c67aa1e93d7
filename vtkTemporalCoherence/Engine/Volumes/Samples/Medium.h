// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Medium_h
#define TemporalCoherence_Medium_h

#include "Scene/FrameKey.h"
#include "Scene/TileHits.h"
#include "Volumes/Samples/ComponentSegment.h"
#include "Volumes/Samples/LooksByLabel.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>

namespace TemporalCoherence
{

/// Opacity and emission of a step through a volume.
struct Medium
{
  double Extinction = 0.0; ///< opacity of the step
  glm::dvec3 Emission{ 0.0 };
};

/// Evaluates steps of finite length in segments of a ray, with VTK's blending of components.
class SegmentMedium
{
public:
  /// \param cells give gradients; key, looks and cells outlive this
  SegmentMedium(const FrameKey& key, const LooksByLabel& looks, const SegmentSource& cells,
    const RayBatch& rays, const WorldDirections& world, std::size_t ray);

  /// Go to a segment of the ray, which outlives the look-ups.
  void Enter(const ComponentSegment& segment);

  /// \param share of the segment
  Medium StepAt(double share, double length);

private:
  /// The look of a part at a place.
  struct Part
  {
    glm::dvec3 Color;
    double Opacity;
    double Share; ///< gradient opacity
  };

  Part PartAt(std::size_t part, double share);
  glm::dvec3 GradientAt(std::size_t component, double share);

  const FrameKey& Key;
  const LooksByLabel& AllLooks;
  const SegmentSource& Cells;
  glm::dvec3 Origin, Direction; ///< of the ray, in the world
  glm::dmat3 WorldFromGradient; ///< for normals
  const ComponentSegment* Present = nullptr;
  const ComponentLooks* Looks = nullptr;    ///< of the present segment
  std::array<CornerGradients, 4> Gradients; ///< of the present cell, by component
  std::array<bool, 4> HasGradients{};
};

}

#endif
