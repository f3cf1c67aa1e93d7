// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Request/RequestFromMapper.h"

#include "Input/FieldFromImage.h"
#include "Input/SettingCheck.h"
#include "Request/AppearanceFromVolume.h"
#include "Request/RegionFromMapper.h"
#include "Request/ViewFromRenderer.h"

#include <vtkVolume.h>
#include <vtkVolumeMapper.h>
#include <vtkVolumeProperty.h>

#include <cmath>
#include <sstream>

namespace TemporalCoherence
{
namespace
{

/// A vtkMultiVolume has a property and a transform for each input of its mapper, and perhaps none
/// of its own.
bool IsOfSeveral(vtkVolume* volume)
{
  return volume->IsA("vtkMultiVolume") != 0;
}

/// Set colour scale and shift by the colour window and level.
/// \return false if these are invalid
bool SpreadColors(const PictureSettings& settings, Appearance& appearance, std::string& error)
{
  SettingCheck check({ "the mapper" }, error);
  check("FinalColorWindow", settings.ColorWindow, Allowed::ColorWindow, "SetFinalColorWindow");
  check("FinalColorLevel", settings.ColorLevel, Allowed::ColorWindow, "SetFinalColorLevel");
  if (!check.HasPassed())
  {
    return false;
  }
  if (std::abs(settings.ColorWindow) < 1.0 / Allowed::ColorWindow.High)
  {
    std::ostringstream what;
    what << "FinalColorWindow of the mapper must not be nearer to 0 than "
         << 1.0 / Allowed::ColorWindow.High << ", got " << settings.ColorWindow
         << "; call SetFinalColorWindow with 1, for all colours.";
    error = what.str();
    return false;
  }
  appearance.ColorScale = 1.0 / settings.ColorWindow;
  appearance.ColorShift = 0.5 - settings.ColorLevel / settings.ColorWindow;
  return true;
}

}

bool RequestFromMapper::Make(vtkVolumeMapper* mapper, const PictureSettings& settings,
  vtkVolume* volume, const FrameSight& sight, FrameRequest& request, std::string& error)
{
  if (IsOfSeveral(volume))
  {
    error = "A vtkMultiVolume cannot be drawn by this mapper; give each volume a vtkVolume and a "
            "mapper of its own in the same renderer, where they hide one another by their depths.";
    return false;
  }
  vtkVolumeProperty* property = volume->GetProperty();
  FrameKey& key = request.Key;
  request.IsovalueList = ChooseIsovalues(property, settings.DepthPass);
  MapperInput input;
  if (!this->Input.Find(mapper, property, settings.Vectors, input, error) ||
    !FindSurfaces(request.IsovalueList, property, input.PropertyComponent, key.Isosurfaces,
      request.IsovaluePlaces, error))
  {
    return false;
  }
  key.Isosurfaces.Mode = settings.Mode;
  request.Read = input.Array;

  if (sight.Renderer)
  {
    key.Appearance = {};
    if (!MakeView(sight.Renderer, sight.Size, sight.Aspect, key.View, error) ||
      !MakeAppearance(property, input.PropertyComponent, sight.Renderer, key.Isosurfaces.Isovalues,
        key.Appearance, error) ||
      !SpreadColors(settings, key.Appearance, error))
    {
      return false;
    }
    key.Appearance.ColorByAnswer = settings.ColorByAnswer;
  }

  // An image without points has no array: an empty picture, as for images without cells.
  return !input.Array || this->MakeScene(mapper, settings.Mask, volume, input, key, error);
}

namespace
{

/// \return false if there are too many translucent isovalues
bool AreFewEnough(const Surfaces& surfaces, std::string& error)
{
  constexpr std::size_t most = 1024;
  const std::size_t count = surfaces.Isovalues.size();
  if (!surfaces.IsTranslucent() || count <= most)
  {
    return true;
  }
  error = "There are " + std::to_string(count) + " translucent isovalues, more than the " +
    std::to_string(most) +
    " that can be drawn; shorten the list with SetNumberOfContours, or make them opaque with "
    "GetScalarOpacity and DisableGradientOpacityOn.";
  return false;
}

}

/// Make the samples, transform, region and hidden cells of a key.
bool RequestFromMapper::MakeScene(vtkVolumeMapper* mapper, const MaskSettings& mask,
  vtkVolume* volume, const MapperInput& input, FrameKey& key, std::string& error)
{
  vtkVolumeProperty* property = volume->GetProperty();
  SampleMask ofSamples;
  const ImageAxes axes = AxesOf(input.Image, input.OnCells);
  if (!MakeGradientOpacity(property, input.PropertyComponent, glm::abs(axes.Step),
        key.Isosurfaces.ByGradient, error) ||
    !AreFewEnough(key.Isosurfaces, error) ||
    !MakeField(input.Image, input.Array, input.OnCells, input.Component, key.Samples, error) ||
    !FindMask(mask, mapper, key.Samples.Dimensions, property, key.Isosurfaces.Isovalues, ofSamples,
      error) ||
    !this->Hidden.Find(input.Image, input.OnCells, ofSamples, key.Samples.Hidden, error) ||
    !MakeIndexTransform(input.Image, input.OnCells, volume, key.Transform, error) ||
    !MakeRegion(mapper, axes, key.Region, error))
  {
    return false;
  }
  key.Samples.Kind = input.Kind;
  key.Samples.Between = property->GetInterpolationType() == VTK_NEAREST_INTERPOLATION
    ? Interpolation::Nearest
    : Interpolation::Linear;
  return true;
}

bool RequestFromMapper::IsOpaque(
  vtkVolumeMapper* mapper, const PictureSettings& settings, vtkVolume* volume)
{
  if (IsOfSeveral(volume))
  {
    return true; // nothing to draw
  }
  vtkVolumeProperty* property = volume->GetProperty();
  MapperInput input;
  std::string error; // the next frame reports it
  this->Input.Find(mapper, property, settings.Vectors, input, error);
  return TemporalCoherence::IsOpaque(
    ChooseIsovalues(property, settings.DepthPass), property, input.PropertyComponent);
}

void RequestFromMapper::Release()
{
  this->Input.Release();
  this->Hidden.Release();
}

}
