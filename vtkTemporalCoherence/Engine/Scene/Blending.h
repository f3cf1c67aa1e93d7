// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Blending_h
#define TemporalCoherence_Blending_h

#include "Scene/Field.h"
#include "Scene/Surfaces.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// How a ray combines the values along it.
enum class BlendMode : std::uint8_t
{
  Composite, ///< the volume emits and absorbs light (Max 1995)
  Maximum,   ///< the largest value on the ray is seen
  Minimum,   ///< the smallest
  Average,   ///< the mean of the values in Blending::AverageRange
  Additive   ///< the integral of value times opacity
};

/// Colour and opacity as functions of a value: linear between nodes, constant beyond the range.
struct TransferFunction
{
  glm::dvec2 Range{ 0.0, 1.0 };  ///< values of the first and the last node, ascending
  std::vector<glm::dvec4> Nodes; ///< RGB and opacity, all in [0, 1]; equidistant; at least two
};

inline bool operator==(const TransferFunction& a, const TransferFunction& b)
{
  return a.Range == b.Range && a.Nodes == b.Nodes;
}

/// How light falls on a component: VTK's Phong model, with the lights of the Appearance.
struct Material
{
  bool Shade = false;
  double Ambient = 0.1; ///< share of its own colour that shows without any light
  double Diffuse = 0.7;
  double Specular = 0.2;
  double SpecularPower = 10.0;
  glm::dvec3 Glow{ 0.0 }; ///< light that is added to any colour: ambient light of the lights
};

inline bool operator==(const Material& a, const Material& b)
{
  return a.Shade == b.Shade &&
    (!a.Shade ||
      (a.Ambient == b.Ambient && a.Glow == b.Glow && a.Diffuse == b.Diffuse &&
        a.Specular == b.Specular && a.SpecularPower == b.SpecularPower));
}

/// How the values of one component look.
struct ComponentLook
{
  TransferFunction Transfer;
  double UnitDistance = 1.0; ///< world distance over which an opacity counts; positive
  GradientOpacity ByGradient;
  TemporalCoherence::Material Material;
  double Weight = 1.0; ///< among several components, in [0, 1]
};

inline bool operator==(const ComponentLook& a, const ComponentLook& b)
{
  return a.Transfer == b.Transfer && a.UnitDistance == b.UnitDistance &&
    a.ByGradient == b.ByGradient && a.Material == b.Material && a.Weight == b.Weight;
}

/// How the components of a field are seen together.
enum class ComponentUse : std::uint8_t
{
  Independent,  ///< each has a look of its own
  ColorOpacity, ///< two: the first gives the colour, the second the opacity
  RgbOpacity    ///< four: the first three are a colour, the fourth gives the opacity
};

/// A label's look.
struct LabelledLook
{
  std::int64_t Label;
  ComponentLook Look;
};

inline bool operator==(const LabelledLook& a, const LabelledLook& b)
{
  return a.Label == b.Label && a.Look == b.Look;
}

/// Labels of a volume's samples. A place has the label of its nearest sample.
struct LabelMap
{
  Field Samples; ///< whole numbers in the places of the volume's samples, with Field::Labels
  std::vector<LabelledLook> Looks; ///< ascending labels; others have the look of the volume
};

inline bool operator==(const LabelMap& a, const LabelMap& b)
{
  return a.Samples == b.Samples && a.Looks == b.Looks;
}

/// Settings of a blended volume.
struct Blending
{
  BlendMode Mode = BlendMode::Composite;
  ComponentUse Use = ComponentUse::Independent;
  std::vector<ComponentLook>
    Looks; ///< one for each component; a single one if components are dependent
  /// Components 1, 2 and 3, if they exist. Only their values differ from FrameKey::Samples.
  std::vector<Field> Others;
  /// Labels whose parts have looks of their own; null: there are none. For Composite with a single
  /// component.
  std::shared_ptr<const LabelMap> Labels;
  glm::dvec2 AverageRange{ 0.0 }; ///< values that count for Average, both ends included
  /// By component: the values that count as 0 and as 1 with Additive and with RgbOpacity.
  std::vector<glm::dvec2> ScalarRanges;
  /// World distance between samples; 0: the picture is converged.
  double SampleDistance = 0.0;
  /// For each pixel, the t at which an opaque prop hides the volume; null without such props.
  std::shared_ptr<const std::vector<double>> Ends;
};

/// True if both sample equal components at equal places.
inline bool HaveSameRays(const Blending& a, const Blending& b)
{
  const bool haveSameEnds = a.Ends == b.Ends || (a.Ends && b.Ends && *a.Ends == *b.Ends);
  return a.Mode == b.Mode && a.Use == b.Use && a.Others == b.Others &&
    a.SampleDistance == b.SampleDistance && haveSameEnds;
}

/// True if both give the same picture of the same samples.
inline bool operator==(const Blending& a, const Blending& b)
{
  const bool haveSameLabels =
    a.Labels == b.Labels || (a.Labels && b.Labels && *a.Labels == *b.Labels);
  return HaveSameRays(a, b) && a.Looks == b.Looks && a.AverageRange == b.AverageRange &&
    a.ScalarRanges == b.ScalarRanges && haveSameLabels;
}

}

#endif
