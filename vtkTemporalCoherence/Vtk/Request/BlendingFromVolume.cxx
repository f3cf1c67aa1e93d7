// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Request/BlendingFromVolume.h"

#include "Input/MatrixFromVtk.h"
#include "Input/SettingCheck.h"
#include "Request/GradientOpacityFromVolume.h"
#include "Request/LightsFromRenderer.h"

#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeMapper.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <sstream>

namespace TemporalCoherence
{
namespace
{

bool MakeMaterial(vtkVolumeProperty* property, int component, Material& made, std::string& error)
{
  made.Shade = property->GetShade(component) != 0;
  if (!made.Shade)
  {
    return true; // other numbers have no effect
  }
  made.Ambient = property->GetAmbient(component);
  made.Diffuse = property->GetDiffuse(component);
  made.Specular = property->GetSpecular(component);
  made.SpecularPower = property->GetSpecularPower(component);
  SettingCheck check({ "the volume's property" }, error);
  check("Ambient", made.Ambient, Allowed::Coefficient, "SetAmbient");
  check("Diffuse", made.Diffuse, Allowed::Coefficient, "SetDiffuse");
  check("Specular", made.Specular, Allowed::Coefficient, "SetSpecular");
  check("Specular power", made.SpecularPower, Allowed::SpecularPower, "SetSpecularPower");
  return check.HasPassed();
}

/// World length of a unit of the data's coordinates, in which VTK's mappers measure distances along
/// rays.
double LengthOfUnit(vtkVolume* volume)
{
  volume->ComputeMatrix();
  const glm::dmat3 axes(MatrixFromVtk(volume->GetMatrix()));
  const double length = std::cbrt(std::abs(glm::determinant(axes)));
  return length > 0.0 && std::isfinite(length) ? length : 1.0; // PlaceVolume reports the mistake
}

/// The values whose shares are 0 and 1.
glm::dvec2 SharesOf(ScalarType type, const glm::dvec2& ofData)
{
  switch (type)
  {
    case ScalarType::Int8:
      return { 0.0, std::numeric_limits<std::int8_t>::max() };
    case ScalarType::UInt8:
      return { 0.0, std::numeric_limits<std::uint8_t>::max() };
    case ScalarType::Int16:
      return { 0.0, std::numeric_limits<std::int16_t>::max() };
    case ScalarType::UInt16:
      return { 0.0, std::numeric_limits<std::uint16_t>::max() };
    case ScalarType::Float32:
      return { 0.0, 1.0 };
    default:
      return ofData;
  }
}

/// Maps a value linearly from the range of the data to the range of shares.
double Stretched(double value, const glm::dvec2& ofData, const glm::dvec2& shares)
{
  return shares.x + (value - ofData.x) / (ofData.y - ofData.x) * (shares.y - shares.x);
}

/// Give four dependent components the meaning that they have in VTK's GPU mapper.
///
/// They are shares, as in its textures: shares of the largest number for types of 8 or 16 bits,
/// plain values for floats, and shares of the data's range otherwise. The first three are a colour.
/// The share of the last one selects a value in its range, whose opacity counts. AverageRange
/// treats the share of the first one likewise.
/// \param volume of the use RgbOpacity, with ScalarRanges and functions in units of the data.
/// \param type   of the samples
void ShowDirectColors(ScalarType type, Blending& volume)
{
  assert(volume.Use == ComponentUse::RgbOpacity);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<glm::dvec2> ofData = volume.ScalarRanges;
  for (glm::dvec2& range : volume.ScalarRanges)
  {
    range = SharesOf(type, range);
  }

  // A range without width has a single value and cannot be stretched.
  const glm::dvec2 &opacities = ofData.back(), &first = ofData.front();
  glm::dvec2& transfer = volume.Looks.front().Transfer.Range;
  if (opacities.x < opacities.y)
  {
    const glm::dvec2& shares = volume.ScalarRanges.back();
    transfer = { Stretched(transfer.x, opacities, shares),
      Stretched(transfer.y, opacities, shares) };
  }
  glm::dvec2& averaged = volume.AverageRange;
  if (first.x < first.y)
  {
    const glm::dvec2& shares = volume.ScalarRanges.front();
    averaged = { Stretched(averaged.x, first, shares), Stretched(averaged.y, first, shares) };
  }
  else if (averaged.x <= first.x && first.x <= averaged.y)
  {
    averaged = { -infinity, infinity };
  }
  else
  {
    averaged = { infinity, infinity };
  }
}

/// Find the way to use components together.
/// \return false if their number has no meaning
bool FindUse(
  vtkVolumeProperty* property, const DrawnComponent& drawn, ComponentUse& use, std::string& error)
{
  use = ComponentUse::Independent;
  const bool areIndependent = drawn.Count == 1 || property->GetIndependentComponents();
  std::ostringstream what;
  if (areIndependent && drawn.Count > MostBlended)
  {
    what << "The array has " << drawn.Count << " components, more than the " << MostBlended
         << " that are blended";
  }
  else if (!areIndependent && drawn.Count != 2 && drawn.Count != 4)
  {
    what
      << "The array has " << drawn.Count
      << " components that depend on one another (IndependentComponentsOff), but only 2 (colour, "
         "opacity) or 4 (red, green, blue, opacity) have a meaning";
  }
  else if (!areIndependent)
  {
    use = drawn.Count == 2 ? ComponentUse::ColorOpacity : ComponentUse::RgbOpacity;
  }
  error = what.str();
  if (!error.empty())
  {
    error += "; draw one with SetVectorModeToComponent(), or their length with "
             "SetVectorModeToMagnitude().";
  }
  return error.empty();
}

/// The range of the values that a look finds in its functions.
/// \param ranges by component
glm::dvec2 LookedUp(const std::vector<glm::dvec2>& ranges, ComponentUse use, std::size_t look)
{
  if (use == ComponentUse::Independent)
  {
    return ranges[look];
  }
  // The last component gives the opacity. Of two components, the first one gives colours.
  const glm::dvec2 &first = ranges.front(), &last = ranges.back();
  return use == ComponentUse::ColorOpacity
    ? glm::dvec2(std::min(first.x, last.x), std::max(first.y, last.y))
    : last;
}

bool MakeAverageRange(vtkVolumeMapper* mapper, glm::dvec2& made, std::string& error)
{
  const double* range = mapper->GetAverageIPScalarRange();
  made = { range[0], range[1] };
  if (made.x <= made.y)
  {
    return true; // an end may be infinite
  }
  std::ostringstream what;
  what << "AverageIPScalarRange of the mapper must begin with its lower end, got " << made.x
       << " to " << made.y << "; call SetAverageIPScalarRange(low, high).";
  error = what.str();
  return false;
}

}

std::optional<BlendMode> BlendModeOf(vtkVolumeMapper* mapper)
{
  switch (mapper->GetBlendMode())
  {
    case vtkVolumeMapper::COMPOSITE_BLEND:
      return BlendMode::Composite;
    case vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND:
      return BlendMode::Maximum;
    case vtkVolumeMapper::MINIMUM_INTENSITY_BLEND:
      return BlendMode::Minimum;
    case vtkVolumeMapper::AVERAGE_INTENSITY_BLEND:
      return BlendMode::Average;
    case vtkVolumeMapper::ADDITIVE_BLEND:
      return BlendMode::Additive;
    default:
      return std::nullopt;
  }
}

bool BlendingFromVolume::Make(vtkVolumeMapper* mapper, vtkVolume* volume,
  const DrawnComponent& drawn, double sampleDistance, Blending& made, std::string& error)
{
  vtkVolumeProperty* property = volume->GetProperty();
  made.Mode = BlendModeOf(mapper).value_or(BlendMode::Composite);
  if (property->GetTransferFunctionMode() != vtkVolumeProperty::TF_1D)
  {
    error = "Volumes are not blended by two-dimensional transfer functions; call "
            "SetTransferFunctionMode(vtkVolumeProperty::TF_1D), or use vtkGPUVolumeRayCastMapper.";
    return false;
  }
  if (!FindUse(property, drawn, made.Use, error) ||
    (made.Mode == BlendMode::Average && !MakeAverageRange(mapper, made.AverageRange, error)))
  {
    return false;
  }
  SettingCheck check({ "the mapper" }, error);
  check("SampleDistance", sampleDistance, { 0.0, Allowed::Distance.High },
    "FixedStepSamplingOff(), which converges");
  if (!check.HasPassed())
  {
    return false;
  }
  made.SampleDistance = sampleDistance * LengthOfUnit(volume);
  this->FirstTransfer = static_cast<std::size_t>(drawn.OfProperty);
  const int looks = made.Use == ComponentUse::Independent ? drawn.Count : 1;
  made.Looks.assign(static_cast<std::size_t>(looks), ComponentLook());
  for (int i = 0; i < looks; ++i)
  {
    // For dependent components, VTK's GPU mapper takes the functions of the first component and the
    // unit distance of the last one.
    const int component = drawn.OfProperty + i;
    const int last = drawn.OfProperty + drawn.Count - 1;
    const int ofOpacity = made.Use == ComponentUse::Independent ? component : last;
    if (!this->MakeLook(
          volume, component, ofOpacity, made.Looks[static_cast<std::size_t>(i)], error))
    {
      return false;
    }
  }
  if (looks == 1)
  {
    made.Looks.front().Weight = 1.0; // a single look needs no weight
  }
  return true;
}

bool BlendingFromVolume::MakeLook(
  vtkVolume* volume, int component, int ofOpacity, ComponentLook& look, std::string& error)
{
  vtkVolumeProperty* property = volume->GetProperty();
  const double unit = property->GetScalarOpacityUnitDistance(ofOpacity);
  const double weight = property->GetComponentWeight(component);
  SettingCheck check({ "the volume's property" }, error);
  check("Scalar opacity unit distance", unit, Allowed::Distance, "SetScalarOpacityUnitDistance");
  check("Component weight", weight, { 0.0, 1.0 }, "SetComponentWeight");
  SampledTransfer& transfer = this->Transfers[static_cast<std::size_t>(component)];
  if (!check.HasPassed() || !transfer.Find(TransferFunctions(property, component), error) ||
    !MakeGradientOpacity(property, component, look.ByGradient, error) ||
    !MakeMaterial(property, component, look.Material, error))
  {
    return false;
  }
  look.UnitDistance = unit * LengthOfUnit(volume);
  look.Weight = weight;
  return true;
}

void BlendingFromVolume::MakeTransfers(const Field& first, Blending& made)
{
  for (std::size_t i = 0; i < made.Looks.size(); ++i)
  {
    const glm::dvec2 range = LookedUp(made.ScalarRanges, made.Use, i);
    // Differences of neighbours are at most as large as the range.
    GradientOpacity& byGradient = made.Looks[i].ByGradient;
    LeaveOutBeyond((range.y - range.x) * glm::length(byGradient.PerStep), byGradient);
    SampledTransfer& transfer = this->Transfers[this->FirstTransfer + i];
    const Field& field = i == 0 ? first : made.Others[i - 1];
    // The functions of colours that samples hold end with the range.
    made.Looks[i].Transfer = made.Use == ComponentUse::RgbOpacity
      ? transfer.Sample({ range, range, true })
      : transfer.SampleFor(field, range, made.Use == ComponentUse::Independent);
  }
  if (made.Use == ComponentUse::RgbOpacity)
  {
    ShowDirectColors(first.Type, made);
  }
}

bool BlendingFromVolume::MakeLights(
  vtkRenderer* renderer, Blending& blending, Appearance& appearance, std::string& error)
{
  const auto isShaded = [](const ComponentLook& look) { return look.Material.Shade; };
  appearance.Shade = std::any_of(blending.Looks.begin(), blending.Looks.end(), isShaded);
  if (!appearance.Shade)
  {
    return true;
  }
  std::optional<glm::dvec3> ambient;
  if (!FindLights(renderer, appearance.Lights, error) ||
    !FindAmbientLight(renderer, ambient, error))
  {
    return false;
  }
  appearance.TwoSided = renderer->GetTwoSidedLighting() != 0;
  if (appearance.Lights.empty())
  {
    // Without a light, volumes are lit evenly like isosurfaces, not black.
    for (ComponentLook& look : blending.Looks)
    {
      look.Material.Ambient += look.Material.Diffuse;
    }
  }
  else if (ambient)
  {
    for (ComponentLook& look : blending.Looks)
    {
      look.Material.Glow = look.Material.Ambient * *ambient;
      look.Material.Ambient = 0.0;
    }
  }
  return true;
}

}
