// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Integral/BlendTruthLook.h"

#include <algorithm>
#include <cmath>

using namespace TemporalCoherence;

namespace
{

glm::dvec4 NodeAt(const TransferFunction& transfer, double value)
{
  const auto last = static_cast<double>(transfer.Nodes.size() - 1);
  const double at = std::clamp(
    (value - transfer.Range.x) / (transfer.Range.y - transfer.Range.x) * last, 0.0, last);
  const double node = std::min(std::floor(at), last - 1.0);
  const auto i = static_cast<std::size_t>(node);
  return glm::mix(transfer.Nodes[i], transfer.Nodes[i + 1], at - node);
}

/// The values of nodes where a function is not straight.
void AddBends(const TransferFunction& transfer, std::vector<double>& bends)
{
  constexpr double straight = 1e-9;
  const std::vector<glm::dvec4>& nodes = transfer.Nodes;
  const std::size_t last = nodes.size() - 1;
  for (std::size_t i = 0; i <= last; ++i)
  {
    const glm::dvec4 bend =
      nodes[i == 0 ? 0 : i - 1] - 2.0 * nodes[i] + nodes[std::min(i + 1, last)];
    if (glm::any(glm::greaterThan(glm::abs(bend), glm::dvec4(straight))))
    {
      bends.push_back(glm::mix(
        transfer.Range.x, transfer.Range.y, static_cast<double>(i) / static_cast<double>(last)));
    }
  }
}

/// The share of a light that arrives, and the direction it comes from.
double ArrivingShare(const Light& light, const glm::dvec3& point, glm::dvec3& toward)
{
  toward = -light.Direction;
  if (!light.Positional)
  {
    return 1.0;
  }
  const glm::dvec3 away = point - light.Position;
  const double distance = glm::length(away);
  toward = away / -distance;
  const double fading = glm::dot(light.Attenuation, glm::dvec3(1.0, distance, distance * distance));
  const double share = fading > 0.0 ? 1.0 / fading : 1.0;
  if (light.ConeAngle >= 90.0)
  {
    return share;
  }
  const double cosine = glm::dot(away, light.Direction) / distance;
  const bool isInCone = cosine > 0.0 && cosine >= std::cos(glm::radians(light.ConeAngle));
  return isInCone ? share * std::pow(cosine, light.Exponent) : 0.0;
}

}

BlendTruthLook::BlendTruthLook(const FrameKey& key, const BlendTruthField& field)
  : Key(key)
  , Field(field)
{
}

std::size_t BlendTruthLook::Parts() const
{
  return this->Key.Blended().Use == ComponentUse::Independent ? this->Field.Components() : 1;
}

const ComponentLook& BlendTruthLook::LookOf(std::size_t component) const
{
  const std::vector<ComponentLook>& looks = this->Key.Blended().Looks;
  return looks[std::min(component, looks.size() - 1)];
}

/// The look of a component at a place, which may have a label with a look of its own.
const ComponentLook& BlendTruthLook::LookAt(
  std::size_t component, const BlendTruthField::Cell& cell, const Place& place) const
{
  const auto& labels = this->Key.Blended().Labels;
  const double here = labels ? BlendTruthField::LabelAt(cell, place.Index) : 0.0;
  for (std::size_t i = 0; labels && i < labels->Looks.size(); ++i)
  {
    if (static_cast<double>(labels->Looks[i].Label) == here)
    {
      return labels->Looks[i].Look;
    }
  }
  return this->LookOf(component);
}

/// All looks that a component has somewhere.
std::vector<const ComponentLook*> BlendTruthLook::LooksOf(std::size_t component) const
{
  std::vector<const ComponentLook*> looks{ &this->LookOf(component) };
  const auto& labels = this->Key.Blended().Labels;
  for (std::size_t i = 0; labels && i < labels->Looks.size(); ++i)
  {
    looks.push_back(&labels->Looks[i].Look);
  }
  return looks;
}

std::vector<double> BlendTruthLook::Bends(std::size_t component) const
{
  const Blending& volume = this->Key.Blended();
  std::vector<double> bends{ volume.AverageRange.x, volume.AverageRange.y };
  for (const ComponentLook* look : this->LooksOf(component))
  {
    AddBends(look->Transfer, bends);
  }
  if (component < volume.ScalarRanges.size())
  {
    bends.push_back(volume.ScalarRanges[component].x);
    bends.push_back(volume.ScalarRanges[component].y);
  }
  std::sort(bends.begin(), bends.end());
  bends.erase(std::unique(bends.begin(), bends.end()), bends.end());
  return bends;
}

/// Colour and opacity of a component, or of all if they depend on each other.
glm::dvec4 BlendTruthLook::ColorOf(
  const ComponentLook& look, std::size_t component, const std::array<double, 4>& values) const
{
  const TransferFunction& transfer = look.Transfer;
  switch (this->Key.Blended().Use)
  {
    case ComponentUse::Independent:
      return NodeAt(transfer, values[component]);
    case ComponentUse::ColorOpacity:
      return glm::dvec4(glm::dvec3(NodeAt(transfer, values[0])), NodeAt(transfer, values[1]).w);
    case ComponentUse::RgbOpacity:
      break;
  }
  glm::dvec4 color(0.0, 0.0, 0.0, NodeAt(transfer, values[3]).w);
  for (std::size_t c = 0; c < 3; ++c)
  {
    const glm::dvec2& range = this->Key.Blended().ScalarRanges[c];
    color[static_cast<int>(c)] = std::clamp((values[c] - range.x) / (range.y - range.x), 0.0, 1.0);
  }
  return color;
}

glm::dvec4 BlendTruthLook::BlendedColorOf(const std::array<double, 4>& values) const
{
  glm::dvec4 sum(0.0);
  for (std::size_t c = 0; c < this->Parts(); ++c)
  {
    const glm::dvec4 color = this->ColorOf(this->LookOf(c), c, values);
    const double weight = this->Parts() > 1 ? this->Weight(c) : 1.0;
    sum += weight * color.w * glm::dvec4(glm::dvec3(color), 1.0);
  }
  return sum;
}

double BlendTruthLook::WeighedShareOf(
  std::size_t component, const std::array<double, 4>& values) const
{
  const glm::dvec2& range = this->Key.Blended().ScalarRanges[component];
  const double share = (values[component] - range.x) / (range.y - range.x);
  return this->ColorOf(this->LookOf(component), component, values).w * share;
}

/// Dependent components have one gradient: that of the first, or of the opacity beside a colour.
std::size_t BlendTruthLook::GradientComponent(std::size_t component) const
{
  return this->Key.Blended().Use == ComponentUse::RgbOpacity ? 3 : component;
}

std::vector<double> BlendTruthLook::GradientBends(std::size_t component) const
{
  std::vector<double> bends;
  for (const ComponentLook* look : this->LooksOf(component))
  {
    for (const glm::dvec2& node : look->ByGradient.Nodes)
    {
      bends.push_back(node.x);
    }
  }
  std::sort(bends.begin(), bends.end());
  return bends;
}

double BlendTruthLook::SteepnessAt(
  std::size_t component, const BlendTruthField::Cell& cell, const glm::dvec3& index) const
{
  const glm::dvec3 gradient =
    this->Field.GradientAt(cell, this->GradientComponent(component), index);
  return glm::length(this->LookOf(component).ByGradient.PerStep * gradient);
}

BlendTruthLook::Part BlendTruthLook::PartAt(
  std::size_t component, const BlendTruthField::Cell& cell, const Place& place) const
{
  std::array<double, 4> values{};
  for (std::size_t c = 0; c < this->Field.Components(); ++c)
  {
    values[c] = this->Field.ValueAt(cell, c, place.Index);
  }
  const ComponentLook& look = this->LookAt(component, cell, place);
  const glm::dvec4 color = this->ColorOf(look, component, values);
  Part part{ glm::dvec3(color), color.w, 1.0 };
  if (part.Opacity <= 0.0 || (!look.Material.Shade && look.ByGradient.Nodes.empty()))
  {
    return part;
  }
  if (!look.ByGradient.Nodes.empty())
  {
    part.Share = look.ByGradient.At(this->SteepnessAt(component, cell, place.Index));
  }
  if (look.Material.Shade)
  {
    const glm::dvec3 gradient =
      this->Field.GradientAt(cell, this->GradientComponent(component), place.Index);
    part.Color = this->Lit(look.Material, part.Color, gradient, place);
  }
  return part;
}

glm::dvec3 BlendTruthLook::Lit(const Material& material, const glm::dvec3& color,
  const glm::dvec3& gradient, const Place& place) const
{
  glm::dvec3 sum = material.Ambient * color + material.Glow;
  const glm::dmat3 toWorld = glm::transpose(glm::dmat3(this->Key.Transform.IndexFromWorld));
  const glm::dvec3 outward = toWorld * -gradient;
  const double length = glm::length(outward);
  if (length > 0.0 && std::isfinite(length))
  {
    const glm::dvec3 normal = outward / length;
    for (const Light& light : this->Key.Appearance.Lights)
    {
      glm::dvec3 toward;
      const double arriving = ArrivingShare(light, place.World, toward);
      const double cosine = glm::dot(normal, toward);
      const double matt = this->Key.Appearance.TwoSided ? std::abs(cosine) : cosine;
      if (matt > 0.0)
      {
        const glm::dvec3 mirrored = 2.0 * cosine * normal - toward;
        const double shine = std::max(0.0, glm::dot(mirrored, -place.Ray));
        sum += arriving *
          (material.Diffuse * matt * light.Diffuse * color +
            std::max(material.Specular, 0.0) *
              (shine > 0.0 ? std::pow(shine, material.SpecularPower) : 0.0) * light.Specular);
      }
    }
  }
  return glm::clamp(sum, 0.0, 1.0);
}

BlendTruthLook::Medium BlendTruthLook::MediumAt(
  const BlendTruthField::Cell& cell, const Place& place) const
{
  Medium medium;
  const bool areSeveral = this->Parts() > 1;
  double squares = 0.0, weighed = 0.0;
  glm::dvec3 opaque(0.0);
  for (std::size_t c = 0; c < this->Parts(); ++c)
  {
    const double weight = areSeveral ? this->Weight(c) : 1.0;
    const Part part = this->PartAt(c, cell, place);
    if (weight <= 0.0 || part.Opacity <= 0.0 || part.Share <= 0.0)
    {
      continue;
    }
    if (part.Opacity >= 1.0)
    {
      medium.IsOpaque = true;
      opaque += weight * part.Color;
      continue;
    }
    const double unit = this->LookAt(c, cell, place).UnitDistance;
    const double extinction = -std::log1p(-part.Opacity) / unit * part.Share;
    medium.Emission += weight * extinction * part.Color;
    squares += extinction * extinction;
    weighed += weight * extinction;
  }
  medium.Extinction = weighed > 0.0 ? squares / weighed : 0.0;
  medium.Emission = medium.IsOpaque ? opaque : medium.Emission;
  return medium;
}

BlendTruthLook::Medium BlendTruthLook::StepAt(
  const BlendTruthField::Cell& cell, const Place& place, double length) const
{
  Medium medium;
  const bool areSeveral = this->Parts() > 1;
  double squares = 0.0, weighed = 0.0;
  for (std::size_t c = 0; c < this->Parts(); ++c)
  {
    const double weight = areSeveral ? this->Weight(c) : 1.0;
    const Part part = this->PartAt(c, cell, place);
    const double unit = this->LookAt(c, cell, place).UnitDistance;
    const double alpha = (1.0 - std::pow(1.0 - part.Opacity, length / unit)) * part.Share;
    if (weight > 0.0)
    {
      medium.Emission += weight * alpha * part.Color;
      squares += alpha * alpha;
      weighed += weight * alpha;
    }
  }
  medium.Extinction = weighed > 0.0 ? std::min(squares / weighed, 1.0) : 0.0;
  return medium;
}
