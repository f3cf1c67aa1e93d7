// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Beams/BeamChoice.h"
#include "Fields/UniformBlending.h"
#include "Fields/UniformCells.h"
#include "Fields/UniformTracer.h"
#include "Scene/FieldKind.h"
#include "Shade/LatticeFaces.h"
#include "Shade/SurfaceNormal.h"

#include <cmath>

namespace TemporalCoherence
{
namespace
{

/// The planes between cells, at integers.
struct UniformPlanes
{
  int Nearest(int axis, double at) const
  {
    return static_cast<int>(std::round(glm::clamp(at, -1.0, this->Samples[axis] + 0.0)));
  }
  double At(int, int plane) const { return plane; }
  int CellOf(int axis, double at) const
  {
    return static_cast<int>(std::floor(glm::clamp(at, 0.0, this->Samples[axis] - 2.0)));
  }

  glm::ivec3 Samples; ///< along each axis
};

/// Samples lie at integers. Boxes and lengths are the defaults of FieldKind.
class UniformFieldKind final : public FieldKind
{
public:
  FieldAbilities Abilities() const override { return { true, true, true }; }

  std::shared_ptr<const SurfaceTracer> MakeTracer(const TraceScene& scene) const override
  {
    return MakeUniformTracer(scene);
  }

  /// Measured: walks beside hidden cells gain nothing either (Documentation/Tried.md).
  bool GainsFromImages(const Field& field, const Surfaces& surfaces) const override
  {
    return !field.Hidden && !HasBeams(field, surfaces);
  }

  std::shared_ptr<const BandTracer> MakeBandTracer(const BandScene& scene) const override
  {
    return MakeUniformBandTracer(scene);
  }

  std::shared_ptr<const BlendTracer> MakeBlendTracer(const BlendScene& scene) const override
  {
    return MakeUniformBlendTracer(scene, nullptr);
  }

  void FindGradients(const GradientQuery& query, const GradientTile& tile) const override
  {
    UniformGradients(query, tile);
  }

  glm::dvec3 FaceNormal(const Field& field, const CapPoint& cap, double& nearest) const override
  {
    return LatticeFaceNormal(UniformPlanes{ field.Dimensions }, field, cap, nearest);
  }
};

}

std::shared_ptr<const FieldKind> UniformKind()
{
  // Without an owner, so that copying fields counts no references.
  static const UniformFieldKind kind{};
  return { std::shared_ptr<const FieldKind>(), &kind };
}

}
