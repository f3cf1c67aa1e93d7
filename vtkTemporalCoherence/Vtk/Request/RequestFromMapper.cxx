// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Request/RequestFromMapper.h"

#include "Input/SettingCheck.h"
#include "OutOfCore/VolumeOfArray.h"
#include "Request/AppearanceFromVolume.h"
#include "Request/GradientOpacityFromVolume.h"
#include "Request/RegionFromMapper.h"
#include "Request/ViewFromRenderer.h"

#include <vtkDataArray.h>
#include <vtkVolume.h>
#include <vtkVolumeMapper.h>
#include <vtkVolumeProperty.h>

#include <cmath>
#include <exception>
#include <optional>
#include <sstream>

#include <algorithm>

namespace TemporalCoherence
{
namespace
{

/// True for a vtkMultiVolume. Each input of its mapper has a property and a transform; the volume
/// itself may have none.
bool IsOfSeveral(vtkVolume* volume)
{
  return volume->IsA("vtkMultiVolume") != 0;
}

/// Set colour scale and shift from the colour window and level.
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
    what << "The absolute value of FinalColorWindow of the mapper must be at least "
         << 1.0 / Allowed::ColorWindow.High << ", got " << settings.ColorWindow
         << "; call SetFinalColorWindow(1) to show all colours.";
    error = what.str();
    return false;
  }
  appearance.ColorScale = 1.0 / settings.ColorWindow;
  appearance.ColorShift = 0.5 - settings.ColorLevel / settings.ColorWindow;
  return true;
}

}

namespace
{

/// The length of the longest edge of a field, in the world.
double LongestEdge(const FrameKey& key)
{
  double longest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double edge = glm::length(glm::dvec3(key.Transform.WorldFromIndex[axis]));
    longest = std::max(longest, (key.Samples.Dimensions[axis] - 1) * edge);
  }
  return longest;
}

/// Set how surfaces keep light away from one another, in a key whose field is made.
void SetMutualLight(const PictureSettings& settings, FrameKey& key)
{
  constexpr double defaultShare = 1.0 / 8.0;
  for (Light& light : key.Appearance.Lights)
  {
    light.CastsShadows &= settings.HasShadows && !key.IsBlended();
    light.Size *= light.CastsShadows ? settings.LightRadius : 0.0;
  }
  if (settings.IsOccluded && key.Appearance.Shade && !key.IsBlended())
  {
    AmbientOcclusion& occlusion = key.Appearance.Occlusion;
    occlusion = settings.Occlusion;
    occlusion.Radius = occlusion.Radius > 0.0 ? occlusion.Radius : defaultShare * LongestEdge(key);
  }
}

}

namespace
{

/// Find the volumes that the arrays of a request are read from.
void FindVolumes(FrameRequest& request)
{
  for (const vtkSmartPointer<vtkObjectBase>& read : request.Read)
  {
    const auto volume = VolumeOf(vtkDataArray::SafeDownCast(read));
    if (volume &&
      std::find(request.Volumes.begin(), request.Volumes.end(), volume) == request.Volumes.end())
    {
      request.Volumes.push_back(volume);
    }
  }
}

}

bool RequestFromMapper::Make(vtkVolumeMapper* mapper, const PictureSettings& settings,
  vtkVolume* volume, const FrameSight& sight, FrameRequest& request, std::string& error,
  const ReportProgress& report)
{
  if (IsOfSeveral(volume))
  {
    error = "A vtkMultiVolume cannot be drawn by this mapper; give each volume a vtkVolume and a "
            "mapper of its own in the same renderer, where they hide one another by their depths.";
    return false;
  }
  const bool isBlended = mapper->GetBlendMode() != vtkVolumeMapper::ISOSURFACE_BLEND;
  const bool areLabels = settings.Labels.AreDrawn && !isBlended;
  if (areLabels && settings.Mask.Image && settings.Mask.IsLabelMap)
  {
    error =
      "Labels are drawn, so the labels of a mask have no meaning; call SetMaskTypeToBinary(), "
      "or SetMaskInput(nullptr) and hide labels by the LabelTable.";
    return false;
  }
  DrawnComponent drawn;
  if (!this->FindDrawn(mapper, settings, volume, drawn, error))
  {
    return false;
  }
  FrameKey& key = request.Key;
  key.Appearance = {};
  if ((sight.Renderer && !MakeView(sight.Renderer, sight.Size, sight.Aspect, key.View, error)) ||
    !(isBlended
        ? this->MakeBlending(mapper, settings, volume, sight.Renderer, drawn, request, error)
        : MakeSurfaces(settings, volume, sight.Renderer, drawn, request, error)) ||
    (sight.Renderer && !SpreadColors(settings, key.Appearance, error)))
  {
    return false;
  }
  key.Appearance.ColorByAnswer = settings.ColorByAnswer && !isBlended;

  FieldQuery query;
  query.Mapper = mapper;
  query.Volume = volume;
  query.Isovalues = isBlended || areLabels ? nullptr : &key.Isosurfaces().Isovalues;
  query.Mask = settings.Mask;
  query.NeedsScalarRanges = isBlended;
  query.AveragedGradients = settings.AveragedGradients;
  query.MeshMemoryLimit = settings.MeshMemoryLimit;
  query.Report = report;
  this->Drawn = drawn;
  this->IsMakingField = true;
  // Input without cells is no mistake: the picture is empty.
  const bool isMade = this->Fields.IsEmpty() ||
    (this->MakeScene(query, drawn.OfProperty, request, error) &&
      (!areLabels ||
        this->MakeLabels(settings, volume, sight.Renderer, drawn.OfProperty, request, error)) &&
      (isBlended ||
        this->MakeArrayLooks(
          settings, volume, sight.Renderer != nullptr, drawn.OfProperty, request, error)));
  this->IsMakingField = false;
  FindVolumes(request);
  SetMutualLight(settings, key);
  return isMade && (!isBlended || this->FinishBlending(settings, volume, drawn, key, error));
}

/// Make what depends on the samples of a blended volume: its functions, and looks of labels.
bool RequestFromMapper::FinishBlending(const PictureSettings& settings, vtkVolume* volume,
  const DrawnComponent& drawn, FrameKey& key, std::string& error)
{
  Blending& blending = key.Blended();
  blending.ScalarRanges.resize(static_cast<std::size_t>(drawn.Count)); // empty without samples
  this->Blendings.MakeTransfers(key.Samples, blending);
  return !blending.Labels ||
    this->LabelLooks.Make(volume->GetProperty(), drawn.OfProperty,
      static_cast<double>(settings.Mask.BlendFactor), key.Samples, blending, error);
}

/// Find the components that the mapper draws.
bool RequestFromMapper::FindDrawn(vtkVolumeMapper* mapper, const PictureSettings& settings,
  vtkVolume* volume, DrawnComponent& drawn, std::string& error)
{
  const bool isBlended = mapper->GetBlendMode() != vtkVolumeMapper::ISOSURFACE_BLEND;
  if (isBlended && !BlendModeOf(mapper))
  {
    error = "Blend mode " + std::to_string(mapper->GetBlendMode()) +
      " is not supported; call SetBlendModeToIsoSurface(), ToComposite(), ToMaximumIntensity(), "
      "ToMinimumIntensity(), ToAverageIntensity() or ToAdditive(), or use "
      "vtkGPUVolumeRayCastMapper.";
    return false;
  }
  VectorChoice vectors = settings.Vectors;
  vectors.AreBlended = isBlended;
  return this->Fields.Find(mapper, volume->GetProperty(), vectors, drawn, error);
}

/// Make the isosurfaces of a key and, for a viewer, their appearance.
bool RequestFromMapper::MakeSurfaces(const PictureSettings& settings, vtkVolume* volume,
  vtkRenderer* renderer, const DrawnComponent& drawn, FrameRequest& request, std::string& error)
{
  FrameKey& key = request.Key;
  vtkVolumeProperty* property = volume->GetProperty();
  if (settings.Labels.AreDrawn)
  {
    key.Shown.emplace<Surfaces>().Mode = SurfaceMode::Threshold; // MakeLabels does the rest
    return true;
  }
  request.IsovalueList = ChooseIsovalues(property, settings.DepthPass);
  Surfaces& surfaces = key.Shown.emplace<Surfaces>();
  surfaces.Mode = settings.Mode;
  return FindSurfaces(request.IsovalueList, property, drawn.OfProperty, surfaces,
           request.IsovaluePlaces, error) &&
    (!renderer ||
      MakeAppearance(
        { property, drawn.OfProperty }, renderer, surfaces.Isovalues, key.Appearance, error));
}

/// Make the blending of a key's volume and, for a viewer, its lights.
bool RequestFromMapper::MakeBlending(vtkVolumeMapper* mapper, const PictureSettings& settings,
  vtkVolume* volume, vtkRenderer* renderer, const DrawnComponent& drawn, FrameRequest& request,
  std::string& error)
{
  Blending& blending = request.Key.Shown.emplace<Blending>();
  return this->Blendings.Make(mapper, volume, drawn, settings.SampleDistance, blending, error) &&
    (!renderer ||
      BlendingFromVolume::MakeLights(renderer, blending, request.Key.Appearance, error));
}

/// Find the labels to draw, in a key whose field is made, and their appearance.
bool RequestFromMapper::MakeLabels(const PictureSettings& settings, vtkVolume* volume,
  vtkRenderer* renderer, int component, FrameRequest& request, std::string& error)
{
  FrameKey& key = request.Key;
  vtkVolumeProperty* property = volume->GetProperty();
  Surfaces& surfaces = key.EditIsosurfaces();
  surfaces.ByGradient = {}; // labels have no gradient
  try
  {
    return this->Labels.Make(key.Samples, settings.Labels.Radius, request.Told, error) &&
      this->Labels.Find(
        settings.Labels, property, component, surfaces, request.IsovaluePlaces, error) &&
      (!renderer ||
        MakeAppearance({ property, component, settings.Labels.Table }, renderer, surfaces.Isovalues,
          key.Appearance, error));
  }
  catch (const std::exception&)
  {
    error = "There is not enough memory for the labels of the input; free memory.";
    return false;
  }
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
    "GetScalarOpacity, DisableGradientOpacityOn and ColorArrayOpacityOff.";
  return false;
}

}

/// Make the samples, transform and region of a key, and the gradient opacity of its surfaces.
bool RequestFromMapper::MakeScene(
  const FieldQuery& query, int component, FrameRequest& request, std::string& error)
{
  FrameKey& key = request.Key;
  const bool isBlended = key.IsBlended();
  PlacedField field;
  if ((!isBlended &&
        (!MakeGradientOpacity(
           query.Volume->GetProperty(), component, key.EditIsosurfaces().ByGradient, error) ||
          !AreFewEnough(key.Isosurfaces(), error))) ||
    !this->Fields.Make(query, field, error) ||
    !MakeRegion(query.Mapper, field.Axes, key.Region, error))
  {
    return false;
  }
  if (isBlended)
  {
    Blending& volume = key.Blended();
    for (ComponentLook& look : volume.Looks)
    {
      look.ByGradient.PerStep = field.PerStep;
    }
    volume.Others = field.Others;
    volume.ScalarRanges = field.ScalarRanges;
    if (field.Labels)
    {
      volume.Labels = std::make_shared<const LabelMap>(LabelMap{ *field.Labels, {} });
    }
  }
  else
  {
    key.EditIsosurfaces().ByGradient.PerStep = field.PerStep;
  }
  key.Samples = field.Samples;
  key.Transform = field.Transform;
  request.SetUp = field.SetUp;
  request.Cells = field.Cells;
  request.Told = field.Told;
  request.Read = field.Read;
  return true;
}

/// Make the looks by an array of the surfaces of a key, if one is asked for.
bool RequestFromMapper::MakeArrayLooks(const PictureSettings& settings, vtkVolume* volume,
  bool hasViewer, int component, FrameRequest& request, std::string& error)
{
  const ArrayLookSettings& byArray = settings.ByArray;
  if (byArray.HasOpacity && !byArray.Array.IsAsked())
  {
    error = "ColorArrayOpacity is on, but there is no array; choose one with SetColorArrayName, or "
            "call ColorArrayOpacityOff().";
    return false;
  }
  if (!byArray.Array.IsAsked() || (!hasViewer && !byArray.HasOpacity))
  {
    return true;
  }
  FrameKey& key = request.Key;
  return this->ArrayLooks.Make(
           this->Fields, byArray, component, volume, hasViewer, key, request.Read, error) &&
    (settings.Labels.AreDrawn || AreFewEnough(key.Isosurfaces(), error));
}

bool RequestFromMapper::IsOpaque(
  vtkVolumeMapper* mapper, const PictureSettings& settings, vtkVolume* volume)
{
  if (IsOfSeveral(volume))
  {
    return true; // nothing to draw
  }
  if (mapper->GetBlendMode() != vtkVolumeMapper::ISOSURFACE_BLEND)
  {
    return false;
  }
  DrawnComponent drawn = this->Drawn;
  std::string error; // the next frame reports it
  if (!this->IsMakingField)
  {
    this->FindDrawn(mapper, settings, volume, drawn, error);
  }
  vtkVolumeProperty* property = volume->GetProperty();
  if (settings.ByArray.Array.IsAsked() &&
    !this->ArrayLooks.AreOpaque(settings.ByArray, property, drawn.OfProperty))
  {
    return false;
  }
  if (settings.Labels.AreDrawn)
  {
    // Before the first frame nothing is known of the labels.
    Surfaces surfaces;
    std::vector<int> labels;
    return this->Labels.AreKnown() &&
      this->Labels.Find(settings.Labels, property, drawn.OfProperty, surfaces, labels, error) &&
      surfaces.Opacities.empty();
  }
  return TemporalCoherence::IsOpaque(
    ChooseIsovalues(property, settings.DepthPass), property, drawn.OfProperty);
}

void RequestFromMapper::Release()
{
  this->Fields.Release();
  this->Labels.Release();
  this->LabelLooks.Release();
  this->ArrayLooks = {};
}

}
