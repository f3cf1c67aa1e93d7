// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTemporalCoherenceGPUVolumeRayCastMapper.h"

#include "BlendingTime.h"
#include "Choice.h"
#include "GpuMapperSettings.h"
#include "Window/OpenGLWindow.h"
#include "vtkTemporalCoherenceVolumeMapper.h"
#include "vtkTemporalCoherenceVolumeMapperInternals.h"

#include "vtkCommand.h"
#include "vtkEventForwarderCommand.h"
#include "vtkLogger.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <atomic>
#include <cctype>
#include <cstdlib>
#include <mutex>
#include <set>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkTemporalCoherenceGPUVolumeRayCastMapper);

namespace
{

/// A variable of the user's environment, in upper case; empty if it is not set.
std::string WordInEnvironment(const char* name)
{
  const char* const value = std::getenv(name);
  std::string word = value ? value : "";
  std::transform(word.begin(), word.end(), word.begin(),
    [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return word;
}

/// False if a variable of the user's environment switches something off.
bool IsOnInEnvironment(const char* name)
{
  const std::string word = WordInEnvironment(name);
  return word != "OFF" && word != "NO" && word != "FALSE" && word != "0";
}

/// Set a rule when to blend volumes, of a mapper or (null) of those that are constructed next.
void SetRule(vtkObject* mapper, const char* name, int value, int& rule)
{
  using Mapper = vtkTemporalCoherenceGPUVolumeRayCastMapper;
  TemporalCoherence::SetChoice(mapper, name, value,
    { { Mapper::BLEND_NEVER, "BLEND_NEVER" },
      { Mapper::BLEND_ON_SOFTWARE_OPENGL, "BLEND_ON_SOFTWARE_OPENGL" },
      { Mapper::BLEND_ALWAYS, "BLEND_ALWAYS" } },
    rule);
}

/// The rule for mappers that are constructed next.
std::atomic<int>& DefaultRule()
{
  using Mapper = vtkTemporalCoherenceGPUVolumeRayCastMapper;
  const auto ofEnvironment = []()
  {
    const std::string word = WordInEnvironment("VTK_TEMPORAL_COHERENCE_BLEND_VOLUMES");
    if (!word.empty() && word != "NEVER" && word != "SOFTWARE" && word != "ALWAYS")
    {
      vtkGenericWarningMacro("VTK_TEMPORAL_COHERENCE_BLEND_VOLUMES must be NEVER, SOFTWARE or "
                             "ALWAYS, not "
        << word << "; it counts as SOFTWARE.");
    }
    return word == "NEVER" ? Mapper::BLEND_NEVER
      : word == "ALWAYS"   ? Mapper::BLEND_ALWAYS
                           : Mapper::BLEND_ON_SOFTWARE_OPENGL;
  };
  static std::atomic<int> rule(ofEnvironment());
  return rule;
}

/// Write a line to VTK's log, unless one of the same topic was written in this process.
void LogOnce(const std::string& topic, const std::string& line)
{
  static const bool isOn = IsOnInEnvironment("VTK_TEMPORAL_COHERENCE_LOG");
  static std::mutex guard;
  static std::set<std::string> told;
  const std::lock_guard<std::mutex> lock(guard);
  if (isOn && told.insert(topic).second)
  {
    vtkLog(INFO, << line);
  }
}

}

//------------------------------------------------------------------------------
vtkTemporalCoherenceGPUVolumeRayCastMapper::vtkTemporalCoherenceGPUVolumeRayCastMapper()
  : TemporalCoherence(IsOnInEnvironment("VTK_TEMPORAL_COHERENCE"))
  , BlendVolumes(GetDefaultBlendVolumes())
{
  this->Forwarder->SetTarget(this);
  this->Isosurfaces->AddObserver(vtkCommand::VolumeMapperRenderStartEvent, this->Forwarder);
  this->Isosurfaces->AddObserver(vtkCommand::VolumeMapperRenderEndEvent, this->Forwarder);
}

//------------------------------------------------------------------------------
vtkTemporalCoherenceGPUVolumeRayCastMapper::~vtkTemporalCoherenceGPUVolumeRayCastMapper()
{
  // Others may still hold the inner mapper.
  this->Isosurfaces->RemoveObserver(this->Forwarder);
  this->Forwarder->SetTarget(nullptr);
}

//------------------------------------------------------------------------------
vtkTemporalCoherenceVolumeMapper* vtkTemporalCoherenceGPUVolumeRayCastMapper::GetIsosurfaceMapper()
{
  return this->Isosurfaces;
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceGPUVolumeRayCastMapper::GetReductionRatio(double ratio[3])
{
  if (this->TemporalCoherence &&
    (this->BlendMode == ISOSURFACE_BLEND || this->DrawnBy == Drawer::Isosurfaces))
  {
    std::fill_n(ratio, 3, 1.0);
    return;
  }
  this->Superclass::GetReductionRatio(ratio);
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceGPUVolumeRayCastMapper::Render(vtkRenderer* renderer, vtkVolume* volume)
{
  const std::string why = this->WhySuperclassDraws(renderer, volume);
  if (why.empty())
  {
    const char* const reason = this->BlendMode == ISOSURFACE_BLEND
      ? "the blend mode is ISOSURFACE_BLEND"
      : this->BlendVolumes == BLEND_ALWAYS ? "BlendVolumes is BLEND_ALWAYS"
                                           : "OpenGL runs on the CPU";
    this->TellWhoDraws(Drawer::Isosurfaces, reason);
    this->Isosurfaces->Render(renderer, volume);
    this->TimeToDraw = this->Isosurfaces->GetTimeToDraw();
    return;
  }
  this->TellWhoDraws(Drawer::Superclass, why);
  // The superclass adjusts its sample distance by the time of its own last frame.
  this->TimeToDraw = this->SuperclassTimeToDraw;
  this->Superclass::Render(renderer, volume);
  this->SuperclassTimeToDraw = this->TimeToDraw;
}

//------------------------------------------------------------------------------
/// The reason why the superclass must draw; empty if the isosurface mapper is ready to draw.
std::string vtkTemporalCoherenceGPUVolumeRayCastMapper::WhySuperclassDraws(
  vtkRenderer* renderer, vtkVolume* volume)
{
  if (!this->TemporalCoherence)
  {
    return "TemporalCoherence is off";
  }
  if (!renderer || !volume || this->GeneratingCanonicalView)
  {
    return "the call is not for a frame in a window";
  }
  std::string why = this->WhySuperclassBlends(renderer);
  if (why.empty())
  {
    why = TemporalCoherence::WhyNotDrawn(this, renderer, volume);
  }
  if (!why.empty())
  {
    return why;
  }
  this->PrepareIsosurfaces();
  if (this->BlendMode != ISOSURFACE_BLEND && this->BlendVolumes != BLEND_ALWAYS)
  {
    why = this->WhySuperclassIsFaster(volume);
  }
  return why.empty() ? this->Isosurfaces->Internal->WhyRefused(renderer, volume) : why;
}

//------------------------------------------------------------------------------
/// The reason why the superclass blends a volume in less time though OpenGL runs on the CPU; empty
/// if it does not. The input is up to date.
std::string vtkTemporalCoherenceGPUVolumeRayCastMapper::WhySuperclassIsFaster(vtkVolume* volume)
{
  const bool takesOwnSteps =
    this->AutoAdjustSampleDistances || this->LockSampleDistanceToInputSpacing;
  if (!takesOwnSteps && !(this->SampleDistance > 0.0f))
  {
    return std::string(); // it would never end
  }
  if (volume->GetProperty()->GetInterpolationType() == VTK_NEAREST_INTERPOLATION)
  {
    return "the interpolation is nearest, which VTK blends faster";
  }
  if (this->BlendMode == AVERAGE_INTENSITY_BLEND || this->BlendMode == ADDITIVE_BLEND)
  {
    return "VTK draws averages and sums faster";
  }
  if (this->BlendMode != COMPOSITE_BLEND)
  {
    return std::string();
  }
  static const std::string reason =
    "so much of the volume is half transparent that VTK should blend it faster";
  vtkDataObject* const data = this->GetInputDataObject(0, 0);
  vtkVolumeProperty* const property = volume->GetProperty();
  const BlendingTimeKey key = { property, data, volume,
    std::max({ this->GetMTime(), property->GetMTime(), data ? data->GetMTime() : 0,
      volume->GetMTime() }) };
  if (key != this->BlendingTimeOf)
  {
    this->BlendingTimeOf = key;
    this->BlendingTime = TemporalCoherence::BlendingTimeBesideVtk(this, volume);
  }
  // A function that is dragged does not change the mapper to and fro.
  const double most = this->DrawnBy == Drawer::Isosurfaces ? 1.1
    : this->Reason == reason                               ? 0.9
                                                           : 1.0;
  return this->BlendingTime <= most ? std::string() : reason;
}

//------------------------------------------------------------------------------
/// The reason why the superclass must draw this blend mode of any volume; empty for isosurfaces.
std::string vtkTemporalCoherenceGPUVolumeRayCastMapper::WhySuperclassBlends(vtkRenderer* renderer)
{
  if (this->BlendMode == ISOSURFACE_BLEND)
  {
    return std::string();
  }
  if (this->BlendVolumes == BLEND_ON_SOFTWARE_OPENGL)
  {
    vtkRenderWindow* const window = renderer->GetRenderWindow();
    if (window && this->LastWindow != window)
    {
      this->LastWindow = window;
      this->IsSoftware = TemporalCoherence::HasSoftwareOpenGL(window);
    }
    return window && this->IsSoftware
      ? std::string()
      : "the blend mode is not ISOSURFACE_BLEND, and OpenGL has a GPU";
  }
  return this->BlendVolumes == BLEND_ALWAYS ? std::string()
                                            : "the blend mode is not ISOSURFACE_BLEND";
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceGPUVolumeRayCastMapper::SetBlendVolumes(int rule)
{
  SetRule(this, "BlendVolumes", rule, this->BlendVolumes);
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceGPUVolumeRayCastMapper::SetDefaultBlendVolumes(int rule)
{
  int present = DefaultRule();
  SetRule(nullptr, "DefaultBlendVolumes", rule, present);
  DefaultRule() = present;
}

//------------------------------------------------------------------------------
int vtkTemporalCoherenceGPUVolumeRayCastMapper::GetDefaultBlendVolumes()
{
  return DefaultRule();
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceGPUVolumeRayCastMapper::PrepareIsosurfaces()
{
  if (this->GetNumberOfInputConnections(0) > 0)
  {
    this->GetInputAlgorithm(0, 0)->Update();
  }
  TemporalCoherence::HandOver(this, this->Isosurfaces);
  this->ForwardEvents();
}

//------------------------------------------------------------------------------
/// Forward these events only while this mapper has observers for them: observed events change the
/// work of the inner mapper.
void vtkTemporalCoherenceGPUVolumeRayCastMapper::ForwardEvents()
{
  for (const unsigned long event : { vtkCommand::VolumeMapperRenderProgressEvent,
         vtkCommand::ErrorEvent, vtkCommand::WarningEvent })
  {
    const bool isWanted = this->HasObserver(event) != 0;
    const bool isForwarded = this->Isosurfaces->HasObserver(event, this->Forwarder) != 0;
    if (isWanted && !isForwarded)
    {
      this->Isosurfaces->AddObserver(event, this->Forwarder);
    }
    else if (!isWanted && isForwarded)
    {
      this->Isosurfaces->RemoveObservers(event, this->Forwarder);
    }
  }
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceGPUVolumeRayCastMapper::TellWhoDraws(
  Drawer drawer, const std::string& reason)
{
  const bool isSwitch = drawer != this->DrawnBy;
  this->Reason = reason;
  this->DrawnBy = drawer;
  if (isSwitch && this->TemporalCoherence)
  {
    const bool isOurs = drawer == Drawer::Isosurfaces;
    const std::string name =
      isOurs ? "vtkTemporalCoherenceVolumeMapper" : "vtkOpenGLGPUVolumeRayCastMapper";
    LogOnce(isOurs ? name : reason, "A volume is drawn by " + name + ", since " + reason);
  }
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceGPUVolumeRayCastMapper::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Isosurfaces->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceGPUVolumeRayCastMapper::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const char* const names[] = { "(none)", "vtkTemporalCoherenceVolumeMapper",
    "vtkOpenGLGPUVolumeRayCastMapper" };
  os << indent << "TemporalCoherence: " << this->TemporalCoherence << endl;
  os << indent << "BlendVolumes: " << this->BlendVolumes << endl;
  os << indent << "Drawn by: " << names[static_cast<int>(this->DrawnBy)] << endl;
  os << indent << "Since: " << this->Reason << endl;
  os << indent << "Isosurface mapper:" << endl;
  this->Isosurfaces->PrintSelf(os, indent.GetNextIndent());
}
VTK_ABI_NAMESPACE_END
