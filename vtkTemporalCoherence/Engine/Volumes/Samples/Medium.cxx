// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Samples/Medium.h"

#include "Volumes/Samples/PhongLight.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{

SegmentMedium::SegmentMedium(const FrameKey& key, const LooksByLabel& looks,
  const SegmentSource& cells, const RayBatch& rays, const WorldDirections& world, std::size_t ray)
  : Key(key)
  , AllLooks(looks)
  , Cells(cells)
  , Direction(world[0][ray], world[1][ray], world[2][ray])
  , WorldFromGradient(glm::transpose(glm::dmat3(key.Transform.IndexFromWorld)))
{
  const glm::dvec3 origin(rays.Origin[0][ray], rays.Origin[1][ray], rays.Origin[2][ray]);
  this->Origin = glm::dvec3(key.Transform.WorldFromIndex * glm::dvec4(origin, 1.0));
}

void SegmentMedium::Enter(const ComponentSegment& segment)
{
  this->Present = &segment;
  this->Looks = &this->AllLooks[segment.Look];
  this->HasGradients.fill(false);
}

glm::dvec3 SegmentMedium::GradientAt(std::size_t component, double share)
{
  if (!this->HasGradients[component])
  {
    this->Cells.FindGradients(component, this->Present->Cell, this->Gradients[component]);
    this->HasGradients[component] = true;
  }
  const CornerGradients& corners = this->Gradients[component];
  if (this->Present->IsNearest)
  {
    return corners[this->Present->CornerAt(share)];
  }
  glm::dvec3 sum(0.0);
  for (std::size_t corner = 0; corner < corners.size(); ++corner)
  {
    double weight = 1.0;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const double at = Mix(this->Present->Path.Begin[a], this->Present->Path.End[a], share);
      weight *= corner >> a & 1u ? at : 1.0 - at;
    }
    sum += weight * corners[corner];
  }
  return sum;
}

SegmentMedium::Part SegmentMedium::PartAt(std::size_t part, double share)
{
  ComponentValues values{};
  for (std::size_t c = 0; c < this->Looks->Components(); ++c)
  {
    values[c] = this->Present->ValueAt(c, share);
  }
  const glm::dvec4 color = this->Looks->ColorOf(part, values);
  Part result{ glm::dvec3(color), color.w, 1.0 };
  const ComponentLook& look = this->Looks->Of(part);
  if (!(result.Opacity > 0.0) || (!look.Material.Shade && look.ByGradient.Nodes.empty()))
  {
    return result;
  }
  const glm::dvec3 gradient = this->GradientAt(this->Looks->GradientOf(part), share);
  if (!look.ByGradient.Nodes.empty())
  {
    result.Share = look.ByGradient.At(glm::length(look.ByGradient.PerStep * gradient));
  }
  if (look.Material.Shade)
  {
    const double t = this->Present->DistanceAt(share);
    const LitPlace place{ this->Origin + t * this->Direction, this->Direction,
      this->WorldFromGradient * -gradient };
    result.Color = LightUp(look.Material, this->Key.Appearance, place, result.Color);
  }
  return result;
}

Medium SegmentMedium::StepAt(double share, double length)
{
  Medium medium;
  double squares = 0.0, weighed = 0.0;
  for (std::size_t i = 0; i < this->Looks->Parts(); ++i)
  {
    const double weight = this->Looks->WeightOf(i);
    if (weight > 0.0)
    {
      const Part part = this->PartAt(i, share);
      const double alpha =
        (1.0 - std::pow(1.0 - part.Opacity, length / this->Looks->Of(i).UnitDistance)) * part.Share;
      medium.Emission += weight * alpha * part.Color;
      squares += alpha * alpha;
      weighed += weight * alpha;
    }
  }
  medium.Extinction = weighed > 0.0 ? std::min(squares / weighed, 1.0) : 0.0;
  return medium;
}

}
