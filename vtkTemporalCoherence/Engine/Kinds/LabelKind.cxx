// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Kinds/LabelKind.h"

#include "Kinds/UniformKind.h"
#include "Lattice/LabelTracer.h"
#include "Shade/LabelGradients.h"

#include <utility>

namespace TemporalCoherence
{
namespace
{

/// Labels lie as the samples of an image do.
class LabelFieldKind final : public FieldKind
{
public:
  explicit LabelFieldKind(std::shared_ptr<const SmoothLabels> smooth)
    : Smooth(std::move(smooth))
  {
  }

  bool IsSame(const FieldShape& other) const override
  {
    const auto* const same = dynamic_cast<const LabelFieldKind*>(&other);
    return same && this->Radius() == same->Radius();
  }

  FieldAbilities Abilities() const override
  {
    FieldAbilities abilities;
    abilities.Samples = true;
    abilities.TimeSteps = true;
    abilities.Reach = this->Smooth ? this->Smooth->Reach() : 0;
    return abilities;
  }

  std::shared_ptr<const SurfaceTracer> MakeTracer(const TraceScene& scene) const override
  {
    return MakeLabelTracer(scene, this->Smooth);
  }

  void FindGradients(const GradientQuery& query, const GradientTile& tile) const override
  {
    LabelGradients(query, tile, this->Smooth.get());
  }

  glm::dvec3 FaceNormal(const Field& field, const CapPoint& cap, double& nearest) const override
  {
    return UniformKind().FaceNormal(field, cap, nearest);
  }

private:
  double Radius() const { return this->Smooth ? this->Smooth->Radius() : 0.0; }

  std::shared_ptr<const SmoothLabels> Smooth;
};

}

std::shared_ptr<const FieldKind> LabelKind(std::shared_ptr<const SmoothLabels> smooth)
{
  return std::make_shared<LabelFieldKind>(std::move(smooth));
}

}
