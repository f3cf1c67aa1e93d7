// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Behind the factory, a rule that can be set says who draws a blended volume:
// vtkTemporalCoherenceVolumeMapper on the CPU, or VTK's own mapper, to the last bit. Both pictures
// look alike.

#include "BlendedScene.h"
#include "Checks/Expect.h"
#include "vtkTemporalCoherenceGPUVolumeRayCastMapper.h"
#include "vtkTemporalCoherenceObjectFactory.h"

#include <vtkFloatingPointExceptions.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPlane.h>
#include <vtkSmartVolumeMapper.h>

#include <cstdlib>
#include <cstring>
#include <string>

namespace
{

using Door = vtkTemporalCoherenceGPUVolumeRayCastMapper;
constexpr int Size = 120;

/// The volume of a scene, drawn into a window by another mapper.
class Stage
{
public:
  Stage(int mode, vtkSmartPointer<vtkVolumeMapper> mapper)
    : Look(mode)
    , Mapper(mapper)
  {
    this->Mapper->SetInputDataObject(this->Look.Mapper->GetInput());
    this->Mapper->SetBlendMode(mode);
    this->Look.Volume->SetMapper(this->Mapper);
    OpenWindow(this->Window, this->Look.Renderer, Size, Size);
  }

  vtkNew<vtkUnsignedCharArray> Draw()
  {
    this->Window->Render();
    return PixelsOf(this->Window);
  }

  Door* AsDoor() { return Door::SafeDownCast(this->Mapper); }

  BlendedScene Look;
  vtkSmartPointer<vtkVolumeMapper> Mapper;
  vtkNew<vtkRenderWindow> Window;
};

template <typename T>
vtkSmartPointer<T> Made()
{
  return vtkSmartPointer<T>::Take(T::New());
}

/// VTK's mapper, with dense samples.
vtkSmartPointer<vtkVolumeMapper> Vtk()
{
  const auto mapper = Made<vtkOpenGLGPUVolumeRayCastMapper>();
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(0.05f);
  return mapper;
}

vtkSmartPointer<vtkVolumeMapper> FromFactory(int rule)
{
  const auto mapper = Made<vtkGPUVolumeRayCastMapper>();
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(0.05f);
  Door::SafeDownCast(mapper)->SetBlendVolumes(rule);
  return mapper;
}

bool AreSame(vtkUnsignedCharArray* a, vtkUnsignedCharArray* b)
{
  return a->GetNumberOfValues() == b->GetNumberOfValues() &&
    std::memcmp(
      a->GetPointer(0), b->GetPointer(0), static_cast<std::size_t>(a->GetNumberOfValues())) == 0;
}

double MeanDifference(vtkUnsignedCharArray* a, vtkUnsignedCharArray* b)
{
  double sum = 0.0;
  for (vtkIdType i = 0; i < a->GetNumberOfValues(); ++i)
  {
    sum += std::abs(a->GetValue(i) - b->GetValue(i));
  }
  return sum / static_cast<double>(a->GetNumberOfValues());
}

bool IsSoftware(vtkRenderWindow* window)
{
  return std::string(window->ReportCapabilities()).find("llvmpipe") != std::string::npos;
}

void TestRules(int mode)
{
  const std::string name = NameOfMode(mode);
  Stage ours(mode, Made<vtkTemporalCoherenceVolumeMapper>()), vtk(mode, Vtk());
  const auto own = ours.Draw(), theirs = vtk.Draw();
  Stage always(mode, FromFactory(Door::BLEND_ALWAYS));
  Expect(AreSame(always.Draw(), own) && always.AsDoor()->GetDrewIsosurfaces() &&
      std::string(always.AsDoor()->GetReason()) == "BlendVolumes is BLEND_ALWAYS",
    name + ": always ours, since " + always.AsDoor()->GetReason());
  Stage never(mode, FromFactory(Door::BLEND_NEVER));
  Expect(AreSame(never.Draw(), theirs) && !never.AsDoor()->GetDrewIsosurfaces() &&
      std::string(never.AsDoor()->GetReason()) == "the blend mode is not ISOSURFACE_BLEND",
    name + ": never ours, since " + never.AsDoor()->GetReason());
  never.AsDoor()->SetBlendVolumesToAlways();
  Expect(AreSame(never.Draw(), own), name + ": switched");

  const double difference = MeanDifference(own, theirs);
  Expect(difference < 1.0, name + ": looks as VTK's, but for " + std::to_string(difference));

  // VTK's mapper needs more time for samples as dense as these, except for averages and sums.
  const bool isOurs = IsSoftware(ours.Window) && !IsGrey(mode);
  Stage byDefault(mode, FromFactory(Door::GetDefaultBlendVolumes()));
  Expect(AreSame(byDefault.Draw(), isOurs ? own : theirs) &&
      byDefault.AsDoor()->GetDrewIsosurfaces() == isOurs,
    name + ": by default ours without a GPU, since " + byDefault.AsDoor()->GetReason());
}

/// With nearest interpolation VTK's mapper may be far faster.
void TestNearest(int mode)
{
  const std::string name = NameOfMode(mode) + " of the nearest samples";
  for (const int rule : { Door::BLEND_ON_SOFTWARE_OPENGL, Door::BLEND_ALWAYS })
  {
    Stage stage(mode, FromFactory(rule));
    stage.Look.Volume->GetProperty()->SetInterpolationTypeToNearest();
    stage.Draw();
    Expect(stage.AsDoor()->GetDrewIsosurfaces() == (rule == Door::BLEND_ALWAYS),
      name + ": rule " + std::to_string(rule) + ", since " + stage.AsDoor()->GetReason());
  }
}

/// Composite volumes are left to VTK where so much is half transparent that it needs less time: the
/// function, the data, the distance of samples and light decide, in every frame.
void TestTime()
{
  Stage stage(vtkVolumeMapper::COMPOSITE_BLEND, Made<vtkGPUVolumeRayCastMapper>());
  stage.Mapper->SetInputDataObject(Volumes::FourSpheres(96));
  vtkVolumeProperty* const property = stage.Look.Volume->GetProperty();
  property->SetScalarOpacityUnitDistance(1.0);
  vtkPiecewiseFunction* const opacity = property->GetScalarOpacity();
  stage.Draw();
  if (!IsSoftware(stage.Window))
  {
    return;
  }
  const auto isOurs = [&](double from, double to, double highest)
  {
    opacity->RemoveAllPoints();
    opacity->AddPoint(from, 0.0);
    opacity->AddPoint(to, highest);
    stage.Draw();
    return stage.AsDoor()->GetDrewIsosurfaces();
  };
  const std::string reason = "so much of the volume is half transparent";
  Expect(!isOurs(0.0, 255.0, 0.05), "a soft ramp over all values is VTK's");
  Expect(std::string(stage.AsDoor()->GetReason()).find(reason) == 0, stage.AsDoor()->GetReason());
  Expect(isOurs(240.0, 255.0, 1.0), "little that is seen is ours");
  Expect(isOurs(300.0, 400.0, 1.0), "nothing that is seen is ours");
  Expect(!isOurs(0.0, 255.0, 0.05), "the ramp is VTK's again");
  auto* const door = stage.AsDoor();
  door->AutoAdjustSampleDistancesOff();
  door->SetSampleDistance(0.01f);
  Expect(isOurs(0.0, 255.0, 0.05), "the ramp is ours where VTK takes very many samples");
  door->SetSampleDistance(0.0f);
  Expect(isOurs(0.0, 255.0, 0.05), "it is ours where VTK's steps would never end");
  door->SetSampleDistance(1.0f);
  Expect(!isOurs(0.0, 255.0, 0.05), "and VTK's with as many as usual");
}

/// The rule reaches mappers that others hold, and the environment gives its default.
void TestDefault()
{
  class Smart : public vtkSmartVolumeMapper
  {
  public:
    static Smart* New() { return new Smart; }
    using vtkSmartVolumeMapper::GetGPUMapper;
  };
  for (const int rule : { Door::BLEND_NEVER, Door::BLEND_ALWAYS })
  {
    Door::SetDefaultBlendVolumes(rule);
    const auto smart = Made<Smart>();
    Stage stage(vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND, smart);
    smart->SetRequestedRenderModeToGPU();
    stage.Draw();
    auto* inner = Door::SafeDownCast(smart->GetGPUMapper());
    Expect(inner->GetBlendVolumes() == rule &&
        inner->GetDrewIsosurfaces() == (rule == Door::BLEND_ALWAYS),
      "vtkSmartVolumeMapper, rule " + std::to_string(rule));
  }
  // No object has this setting: its error would be a line of the output.
  vtkObject::GlobalWarningDisplayOff();
  Door::SetDefaultBlendVolumes(7);
  vtkObject::GlobalWarningDisplayOn();
  Expect(Door::GetDefaultBlendVolumes() == Door::BLEND_ALWAYS, "what is no rule changes nothing");
  Door::SetDefaultBlendVolumes(Door::BLEND_ON_SOFTWARE_OPENGL);
}

/// What only VTK's mapper can do is left to it.
void TestLeftToVtk()
{
  Stage stage(vtkVolumeMapper::COMPOSITE_BLEND, FromFactory(Door::BLEND_ALWAYS));
  stage.AsDoor()->UseDepthPassOn();
  stage.Draw();
  Expect(!stage.AsDoor()->GetDrewIsosurfaces(), "contours of a depth pass");
  stage.AsDoor()->UseDepthPassOff();
  vtkNew<vtkPlane> slice;
  slice->SetOrigin(15.5, 15.5, 15.5);
  slice->SetNormal(0.0, 0.3, 1.0);
  stage.Look.Volume->GetProperty()->SetSliceFunction(slice);
  stage.Mapper->SetBlendModeToSlice();
  stage.Draw();
  Expect(!stage.AsDoor()->GetDrewIsosurfaces(), "slices");
  stage.Mapper->SetBlendModeToMaximumIntensity();
  stage.Draw();
  Expect(stage.AsDoor()->GetDrewIsosurfaces(), "but not maxima");
}

}

int TestBlendedEverywhere(int, char*[])
{
  vtkFloatingPointExceptions::Disable();
  vtkTemporalCoherenceObjectFactory::UseEverywhere();
  Expect(Door::GetDefaultBlendVolumes() == Door::BLEND_ON_SOFTWARE_OPENGL, "the default rule");
  for (const int mode : BlendModes)
  {
    TestRules(mode);
    TestNearest(mode);
  }
  TestTime();
  TestDefault();
  TestLeftToVtk();
  vtkTemporalCoherenceObjectFactory::UseNowhere();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
