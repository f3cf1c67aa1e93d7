// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_BlendTruthLook_h
#define Testing_BlendTruthLook_h

#include "Integral/BlendTruthField.h"
#include "Scene/FrameKey.h"

#include <glm/glm.hpp>

#include <vector>

/// How the values of a volume look at a point, in double precision, for BlendTruth: VTK's meaning
/// of transfer functions, gradient opacity, light and several components.
class BlendTruthLook
{
public:
  /// What a place adds to light that passes it.
  struct Medium
  {
    double Extinction = 0.0;    ///< per world distance
    glm::dvec3 Emission{ 0.0 }; ///< per world distance
    bool IsOpaque = false;      ///< it lets nothing through; Emission is then what is seen
  };

  /// A point on a ray: in index space, and in the world.
  struct Place
  {
    glm::dvec3 Index, World;
    glm::dvec3 Ray; ///< its direction in the world, of unit length
  };

  BlendTruthLook(const TemporalCoherence::FrameKey& key, const BlendTruthField& field);

  /// Values of a component between which its functions are smooth, ascending.
  std::vector<double> Bends(std::size_t component) const;

  /// The same for the opacity by the length of gradients, and this length. No bends if there is
  /// none.
  std::vector<double> GradientBends(std::size_t component) const;
  double SteepnessAt(
    std::size_t component, const BlendTruthField::Cell& cell, const glm::dvec3& index) const;

  Medium MediumAt(const BlendTruthField::Cell& cell, const Place& place) const;

  /// The same if a step of finite length is made: what it adds is Emission, and what it takes away
  /// Extinction.
  Medium StepAt(const BlendTruthField::Cell& cell, const Place& place, double length) const;

  /// Colour and opacity of values, without light; not multiplied by each other, but by weights.
  glm::dvec4 BlendedColorOf(const std::array<double, 4>& values) const;

  /// Opacity times the value as a share of the scalar range, of what ShareOf counts.
  double WeighedShareOf(std::size_t component, const std::array<double, 4>& values) const;

  double UnitDistance(std::size_t component) const { return this->LookOf(component).UnitDistance; }
  double Weight(std::size_t component) const { return this->LookOf(component).Weight; }
  /// How many components are blended by themselves.
  std::size_t Parts() const;

private:
  /// What a component is at a place.
  struct Part
  {
    glm::dvec3 Color;
    double Opacity, Share; ///< Share by its gradient
  };

  using ComponentLook = TemporalCoherence::ComponentLook;

  const ComponentLook& LookOf(std::size_t component) const;
  const ComponentLook& LookAt(
    std::size_t component, const BlendTruthField::Cell& cell, const Place& place) const;
  std::vector<const ComponentLook*> LooksOf(std::size_t component) const;
  glm::dvec4 ColorOf(
    const ComponentLook& look, std::size_t component, const std::array<double, 4>& values) const;
  std::size_t GradientComponent(std::size_t component) const;
  Part PartAt(std::size_t component, const BlendTruthField::Cell& cell, const Place& place) const;
  glm::dvec3 Lit(const TemporalCoherence::Material& material, const glm::dvec3& color,
    const glm::dvec3& gradient, const Place& place) const;

  const TemporalCoherence::FrameKey& Key;
  const BlendTruthField& Field;
};

#endif
