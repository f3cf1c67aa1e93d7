// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ComponentLooks_h
#define TemporalCoherence_ComponentLooks_h

#include "Scene/Blending.h"
#include "Volumes/Samples/ComponentSegment.h"
#include "Volumes/Samples/TransferLookup.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace TemporalCoherence
{

/// Looks of the components of a volume, by VTK's rules for several components.
class ComponentLooks
{
public:
  explicit ComponentLooks(const Blending& volume)
    : Volume(volume)
    , NumberOfComponents(volume.Others.size() + 1)
  {
  }

  /// The look of a label (LabelMap) of a volume with one component. Both outlive this.
  ComponentLooks(const Blending& volume, const ComponentLook& ofLabel)
    : Volume(volume)
    , OfLabel(&ofLabel)
    , NumberOfComponents(1)
  {
  }

  std::size_t Components() const { return this->NumberOfComponents; }

  bool AreIndependent() const
  {
    return this->Volume.Use == ComponentUse::Independent || this->NumberOfComponents == 1;
  }

  /// The number of parts: independent components, or all dependent components as one part.
  std::size_t Parts() const { return this->AreIndependent() ? this->NumberOfComponents : 1; }

  const ComponentLook& Of(std::size_t part) const
  {
    return this->OfLabel ? *this->OfLabel
                         : this->Volume.Looks[std::min(part, this->Volume.Looks.size() - 1)];
  }

  /// The weight of a part in the blend.
  double WeightOf(std::size_t part) const
  {
    return this->Parts() > 1 ? this->Of(part).Weight : 1.0;
  }

  /// The component that gives a part its opacity.
  std::size_t OpacityOf(std::size_t part) const
  {
    return this->AreIndependent() ? part : this->NumberOfComponents - 1;
  }

  /// The component whose gradient a part has.
  std::size_t GradientOf(std::size_t part) const
  {
    return this->Volume.Use == ComponentUse::RgbOpacity ? this->OpacityOf(part) : part;
  }

  /// Colour and opacity.
  glm::dvec4 ColorOf(std::size_t part, const ComponentValues& values) const
  {
    const TransferFunction& transfer = this->Of(part).Transfer;
    const glm::dvec4 own = LookUp(transfer, values[this->OpacityOf(part)]);
    if (this->AreIndependent())
    {
      return own;
    }
    if (this->Volume.Use == ComponentUse::ColorOpacity)
    {
      return glm::dvec4(glm::dvec3(LookUp(transfer, values[0])), own.w);
    }
    glm::dvec4 color = own;
    for (std::size_t c = 0; c < 3; ++c)
    {
      color[static_cast<int>(c)] = std::clamp(this->ShareOf(c, values[c]), 0.0, 1.0);
    }
    return color;
  }

  /// A value as a share of the scalar range.
  double ShareOf(std::size_t component, double value) const
  {
    const glm::dvec2& range = this->Volume.ScalarRanges[component];
    const double width = range.y - range.x;
    return width > 0.0 ? (value - range.x) / width : 0.0;
  }

  /// The values, ascending, between which the functions of a component are linear.
  std::vector<double> BendsOf(std::size_t component) const;

  /// The values, ascending, between which the functions of a component are smooth and monotone. A
  /// curve has fewer kinks than nodes.
  std::vector<double> KinksOf(std::size_t component) const;

private:
  const Blending& Volume;
  const ComponentLook* OfLabel = nullptr;
  std::size_t NumberOfComponents;
};

}

#endif
