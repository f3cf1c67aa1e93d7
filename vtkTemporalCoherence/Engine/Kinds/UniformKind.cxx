// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Kinds/UniformKind.h"

#include "Isomap/UniformBandTracer.h"
#include "Lattice/UniformCells.h"
#include "Lattice/UniformTracer.h"
#include "Shade/LatticeFaces.h"
#include "Shade/SurfaceNormal.h"
#include "Volumes/LatticeBlending.h"

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

/// Samples lie at integers. Boxes and lengths are the defaults of FieldShape.
class UniformFieldKind final : public FieldKind
{
public:
  FieldAbilities Abilities() const override { return { true, true, true }; }

  std::shared_ptr<const SurfaceTracer> MakeTracer(const TraceScene& scene) const override
  {
    return MakeUniformTracer(scene);
  }

  std::shared_ptr<const BandTracer> MakeBandTracer(const BandScene& scene) const override
  {
    return MakeUniformBandTracer(scene);
  }

  std::shared_ptr<const BlendTracer> MakeBlendTracer(
    const BlendScene& scene, KeptTables* kept) const override
  {
    return MakeLatticeBlendTracer(scene, nullptr, kept);
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

const FieldKind& UniformKind()
{
  static const UniformFieldKind kind{};
  return kind;
}

}
