// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A program that makes vtkGPUVolumeRayCastMapper or vtkSmartVolumeMapper sees, behind the factory,
// what vtkTemporalCoherenceVolumeMapper shows of isosurfaces, re-use included, and what VTK's own
// mapper shows of everything else, to the last bit.

#include "Checks/EventCounter.h"
#include "Checks/Expect.h"
#include "Scenes/OffScreen.h"
#include "Scenes/Scene.h"
#include "Volumes/Volumes.h"
#include "vtkTemporalCoherenceGPUVolumeRayCastMapper.h"
#include "vtkTemporalCoherenceObjectFactory.h"
#include "vtkTemporalCoherencePicker.h"

#include <vtkContourValues.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkLogger.h>
#include <vtkMath.h>
#include <vtkMultiVolume.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkPropPicker.h>
#include <vtkRenderWindow.h>
#include <vtkShaderProperty.h>
#include <vtkSmartVolumeMapper.h>
#include <vtkTestErrorObserver.h>
#include <vtkTrivialProducer.h>

#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <random>
#include <sstream>
#include <string>

namespace
{

constexpr int Size = 100;

/// A volume in a window of its own, drawn by any mapper.
struct Stage
{
  explicit Stage(vtkSmartPointer<vtkVolumeMapper> mapper, vtkVolumeProperty* property = nullptr)
    : Mapper(mapper)
  {
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(Data());
    this->Mapper->SetInputConnection(producer->GetOutputPort());
    this->Volume->SetMapper(this->Mapper);
    this->Volume->SetProperty(property ? property : vtkNew<vtkVolumeProperty>().Get());
    this->Renderer->AddVolume(this->Volume);
    OpenWindow(this->Window, this->Renderer, Size, Size);
    if (!property)
    {
      vtkVolumeProperty* own = this->Volume->GetProperty();
      own->SetInterpolationTypeToLinear();
      own->ShadeOn();
      own->GetIsoSurfaceValues()->SetValue(0, 100.0);
      own->GetRGBTransferFunction()->AddRGBPoint(0.0, 0.2, 0.4, 0.9);
      own->GetRGBTransferFunction()->AddRGBPoint(255.0, 0.9, 0.5, 0.2);
      vtkNew<vtkPlane> slice;
      slice->SetNormal(0.0, 0.3, 1.0);
      own->SetSliceFunction(slice);
    }
  }

  static vtkImageData* Data()
  {
    static const auto data = Volumes::FourSpheres(40);
    return data;
  }

  vtkTemporalCoherenceGPUVolumeRayCastMapper* Door()
  {
    return vtkTemporalCoherenceGPUVolumeRayCastMapper::SafeDownCast(this->Mapper);
  }

  std::string Route()
  {
    return this->Door()->GetIsosurfaceMapper()->GetStatistics()->GetRouteAsString();
  }

  vtkNew<vtkUnsignedCharArray> Draw()
  {
    this->Window->Render();
    return PixelsOf(this->Window);
  }

  vtkSmartPointer<vtkVolumeMapper> Mapper;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
};

bool AreSame(vtkUnsignedCharArray* a, vtkUnsignedCharArray* b)
{
  return a->GetNumberOfValues() == b->GetNumberOfValues() &&
    std::memcmp(
      a->GetPointer(0), b->GetPointer(0), static_cast<std::size_t>(a->GetNumberOfValues())) == 0;
}

/// Pixels that are not black.
int CountSeen(vtkUnsignedCharArray* pixels)
{
  int seen = 0;
  for (vtkIdType i = 0; i < pixels->GetNumberOfValues(); i += 4)
  {
    seen += pixels->GetValue(i) + pixels->GetValue(i + 1) + pixels->GetValue(i + 2) > 0;
  }
  return seen;
}

template <typename T>
vtkSmartPointer<T> Made()
{
  return vtkSmartPointer<T>::Take(T::New());
}

/// What VTK's log is told while it lives.
class Log
{
public:
  Log()
  {
    vtkLogger::AddCallback(
      "TestEverywhere",
      [](void* lines, const vtkLogger::Message& message)
      { *static_cast<std::ostringstream*>(lines) << message.message << '\n'; },
      &this->Lines, vtkLogger::VERBOSITY_INFO);
  }
  ~Log() { vtkLogger::RemoveCallback("TestEverywhere"); }
  Log(const Log&) = delete;
  void operator=(const Log&) = delete;

  /// Lines that tell who draws.
  int Count(const std::string& who) const
  {
    int count = 0;
    const std::string text = this->Lines.str(), line = "A volume is drawn by " + who;
    for (std::size_t at = text.find(line); at != std::string::npos; at = text.find(line, at + 1))
    {
      ++count;
    }
    return count;
  }

private:
  std::ostringstream Lines;
};

void TestFactory()
{
  const std::string before = Made<vtkGPUVolumeRayCastMapper>()->GetClassName();
  Expect(
    before == "vtkOpenGLGPUVolumeRayCastMapper" && !vtkTemporalCoherenceObjectFactory::IsUsed(),
    "VTK's mapper is made unless asked otherwise, but is " + before);
  vtkTemporalCoherenceObjectFactory::UseEverywhere();
  vtkTemporalCoherenceObjectFactory::UseEverywhere();
  Expect(vtkTemporalCoherenceObjectFactory::IsUsed(), "the factory is used");
  Expect(std::string(Made<vtkGPUVolumeRayCastMapper>()->GetClassName()) ==
      "vtkTemporalCoherenceGPUVolumeRayCastMapper",
    "it makes ours");
  Expect(std::string(Made<vtkOpenGLGPUVolumeRayCastMapper>()->GetClassName()) ==
      "vtkOpenGLGPUVolumeRayCastMapper",
    "who asks for OpenGL gets it");
  vtkTemporalCoherenceObjectFactory::UseNowhere();
  vtkTemporalCoherenceObjectFactory::UseNowhere();
  Expect(Made<vtkGPUVolumeRayCastMapper>()->GetClassName() == before, "and VTK's again");
  vtkTemporalCoherenceObjectFactory::UseEverywhere();
}

/// Blend modes, views and isovalues in random order.
void TestSwitching()
{
  Stage door(Made<vtkGPUVolumeRayCastMapper>());
  vtkVolumeProperty* property = door.Volume->GetProperty();
  Stage vtk(Made<vtkOpenGLGPUVolumeRayCastMapper>(), property);
  Stage ours(Made<vtkTemporalCoherenceVolumeMapper>(), property);
  door.Renderer->ResetCamera();
  vtkCamera* camera = door.Renderer->GetActiveCamera();
  vtk.Renderer->SetActiveCamera(camera);
  ours.Renderer->SetActiveCamera(camera);
  std::mt19937 random(16);
  int isosurfaces = 0, shown = 0;
  for (int i = 0; i < 100; ++i)
  {
    const int mode = std::uniform_int_distribution<int>(0, 8)(random);
    const bool isIsosurface = mode >= vtkVolumeMapper::ISOSURFACE_BLEND && mode != 6;
    const int blend = isIsosurface ? static_cast<int>(vtkVolumeMapper::ISOSURFACE_BLEND) : mode;
    camera->Azimuth(std::uniform_int_distribution<int>(0, 1)(random) * 3.0);
    const double isovalue = std::uniform_int_distribution<int>(8, 12)(random) * 10.0;
    property->GetIsoSurfaceValues()->SetValue(0, isovalue);
    door.Mapper->SetBlendMode(blend);
    const auto picture = door.Draw();
    Stage& expected = isIsosurface ? ours : vtk;
    expected.Mapper->SetBlendMode(blend);
    Expect(AreSame(picture, expected.Draw()),
      "frame " + std::to_string(i) + " in blend mode " + std::to_string(blend));
    shown += CountSeen(picture) > 300;
    Expect(door.Door()->GetDrewIsosurfaces() == isIsosurface, "who drew is told");
    if (isIsosurface)
    {
      ++isosurfaces;
      auto* mapper = vtkTemporalCoherenceVolumeMapper::SafeDownCast(ours.Mapper);
      Expect(door.Route() == mapper->GetStatistics()->GetRouteAsString(),
        "the route is that of our mapper alone");
    }
  }
  Expect(isosurfaces > 20 && isosurfaces < 80 && shown > 60, "both drew, and something was seen");
}

/// What the last frame knew serves the next, whoever hands the settings over.
void TestReuse()
{
  class Smart : public vtkSmartVolumeMapper
  {
  public:
    static Smart* New() { return new Smart; }
    using vtkSmartVolumeMapper::GetGPUMapper;
  };
  const auto expectRoutes = [](const std::string& what, Stage& stage, vtkVolumeMapper* made)
  {
    auto* door = vtkTemporalCoherenceGPUVolumeRayCastMapper::SafeDownCast(made);
    stage.Mapper->SetBlendModeToIsoSurface();
    const auto expect = [&](const std::string& route)
    {
      stage.Window->Render();
      const std::string made = door->GetIsosurfaceMapper()->GetStatistics()->GetRouteAsString();
      Expect(made == route, what + ": the route is " + made + " instead of " + route);
    };
    vtkContourValues* isovalues = stage.Volume->GetProperty()->GetIsoSurfaceValues();
    expect("Cold");
    expect("Antialias");
    expect("Redisplay");
    isovalues->SetValue(0, 101.0);
    expect("IsomapBuild");
    door->GetIsosurfaceMapper()->SetIsomapRange(95.0, 105.0);
    isovalues->SetValue(0, 101.5);
    expect("IsomapBuild");
    isovalues->SetValue(0, 102.0);
    expect("IsomapLookup");
    stage.Renderer->GetActiveCamera()->Azimuth(2.0);
    expect("Cold");
    expect("Antialias");
    expect("Redisplay");
    stage.Volume->GetProperty()->SetAmbient(0.3);
    expect("Reshade");
    stage.Mapper->CroppingOn();
    expect("Cold");
  };
  Stage stage(Made<vtkGPUVolumeRayCastMapper>());
  expectRoutes("vtkGPUVolumeRayCastMapper", stage, stage.Mapper);
  const auto mapper = Made<Smart>();
  Stage smart(mapper);
  expectRoutes("vtkSmartVolumeMapper", smart, mapper->GetGPUMapper());
}

/// Draw isosurfaces after a change; VTK's mapper has to draw, show what it shows alone, and say
/// why.
void ExpectLeftToVtk(const std::string& why, const std::function<void(Stage&)>& change)
{
  Stage door(Made<vtkGPUVolumeRayCastMapper>()), vtk(Made<vtkOpenGLGPUVolumeRayCastMapper>());
  for (Stage* stage : { &door, &vtk })
  {
    stage->Mapper->SetBlendModeToIsoSurface();
    stage->Window->Render();
    change(*stage);
  }
  Expect(AreSame(door.Draw(), vtk.Draw()), why + ": the picture is VTK's");
  Expect(!door.Door()->GetDrewIsosurfaces() &&
      std::string(door.Door()->GetReason()).find(why) != std::string::npos,
    why + ": it is told, but as " + door.Door()->GetReason());
}

void TestWhatIsLeftToVtk()
{
  const auto gpu = [](Stage& stage)
  { return vtkGPUVolumeRayCastMapper::SafeDownCast(stage.Mapper); };
  ExpectLeftToVtk("the blend mode is not ISOSURFACE_BLEND",
    [](Stage& stage) { stage.Mapper->SetBlendModeToMaximumIntensity(); });
  ExpectLeftToVtk("peeled by depth",
    [](Stage& stage)
    {
      stage.Renderer->UseDepthPeelingOn();
      stage.Renderer->UseDepthPeelingForVolumesOn();
    });
  ExpectLeftToVtk("user-defined shaders",
    [](Stage& stage)
    {
      stage.Volume->GetShaderProperty()->AddFragmentShaderReplacement(
        "//VTK::Base::Dec", true, "//VTK::Base::Dec\n// of the user's\n", false);
    });
  ExpectLeftToVtk("two-dimensional",
    [](Stage& stage)
    {
      vtkNew<vtkImageData> table;
      table->SetDimensions(4, 4, 1);
      table->AllocateScalars(VTK_FLOAT, 4);
      std::fill_n(static_cast<float*>(table->GetScalarPointer()), 64, 0.5f);
      // Since VTK 9.3 the table alone does not change the mode.
      stage.Volume->GetProperty()->SetTransferFunction2D(table);
      stage.Volume->GetProperty()->SetTransferFunctionMode(vtkVolumeProperty::TF_2D);
    });
  ExpectLeftToVtk("RenderToImage is on", [&](Stage& stage) { gpu(stage)->RenderToImageOn(); });
  ExpectLeftToVtk("there are several inputs",
    [&](Stage& stage)
    {
      stage.Renderer->RemoveVolume(stage.Volume);
      vtkNew<vtkMultiVolume> several;
      several->SetMapper(stage.Mapper);
      several->SetVolume(stage.Volume, 0);
      stage.Renderer->AddVolume(several);
    });
  ExpectLeftToVtk("Isovalue 0 is nan",
    [](Stage& stage)
    {
      stage.Volume->GetProperty()->GetIsoSurfaceValues()->SetValue(
        0, std::numeric_limits<double>::quiet_NaN());
    });
}

/// The contours of the depth pass are for COMPOSITE_BLEND only, as in VTK's mapper.
void TestDepthPass()
{
  Stage stage(Made<vtkGPUVolumeRayCastMapper>());
  auto* mapper = vtkGPUVolumeRayCastMapper::SafeDownCast(stage.Mapper);
  mapper->SetBlendModeToIsoSurface();
  Expect(CountSeen(stage.Draw()) > 0, "depth pass off: the property's isosurface");
  mapper->UseDepthPassOn();
  mapper->GetDepthPassContourValues()->SetValue(0, 100.0);
  stage.Volume->GetProperty()->GetIsoSurfaceValues()->SetNumberOfContours(0);
  Expect(CountSeen(stage.Draw()) == 0, "depth pass on: no isosurface of its contours");
  Expect(stage.Door()->GetDrewIsosurfaces(), "depth pass on: not left to VTK");
}

/// The log has one line that our mapper draws, and one for each reason why VTK's does; none if ours
/// is switched off. No frame was drawn before.
void TestWhatIsLogged()
{
  const Log log;
  const char* const ours = "vtkTemporalCoherenceVolumeMapper";
  const char* const vtk = "vtkOpenGLGPUVolumeRayCastMapper";
  Stage off(Made<vtkGPUVolumeRayCastMapper>());
  off.Door()->TemporalCoherenceOff();
  off.Mapper->SetBlendModeToIsoSurface();
  off.Window->Render();
  Expect(log.Count("") == 0, "switched off: nothing");
  Expect(std::string(off.Door()->GetReason()) == "TemporalCoherence is off", "but the reason");
  Stage stage(Made<vtkGPUVolumeRayCastMapper>());
  stage.Window->Render();
  stage.Window->Render();
  Expect(log.Count(vtk) == 1 && log.Count(ours) == 0, "VTK's draws");
  stage.Mapper->SetBlendModeToIsoSurface();
  stage.Window->Render();
  stage.Window->Render();
  Expect(log.Count(vtk) == 1 && log.Count(ours) == 1, "then ours");
  stage.Mapper->SetBlendModeToComposite();
  stage.Window->Render();
  Stage other(Made<vtkGPUVolumeRayCastMapper>());
  other.Window->Render();
  other.Mapper->SetBlendModeToIsoSurface();
  other.Window->Render();
  Expect(log.Count(vtk) == 1 && log.Count(ours) == 1, "neither again, nor of another mapper");
  other.Renderer->SetUseDepthPeeling(1);
  other.Renderer->SetUseDepthPeelingForVolumes(1);
  other.Window->Render();
  Expect(log.Count(vtk) == 2 && log.Count(ours) == 1, "VTK's, for another reason");
}

/// Events and errors are those of the mapper that the program knows.
void TestWhatIsTold()
{
  Stage stage(Made<vtkGPUVolumeRayCastMapper>());
  const EventCounter starts(stage.Mapper, vtkCommand::VolumeMapperRenderStartEvent);
  const EventCounter ends(stage.Mapper, vtkCommand::VolumeMapperRenderEndEvent);
  stage.Window->Render();
  stage.Window->Render();
  stage.Mapper->SetBlendModeToIsoSurface();
  stage.Window->Render();
  stage.Window->Render();
  stage.Mapper->SetBlendModeToComposite();
  stage.Window->Render();
  Expect(starts.Count == 5 && ends.Count == 5, "each frame begins and ends once");
  std::ostringstream text;
  stage.Mapper->Print(text);
  Expect(text.str().find("Drawn by: vtkOpenGLGPUVolumeRayCastMapper") != std::string::npos &&
      text.str().find("Since: the blend mode is not ISOSURFACE_BLEND") != std::string::npos,
    "PrintSelf tells it, too");

  stage.Mapper->SetBlendModeToIsoSurface();
  stage.Window->Render();
  const EventCounter progress(stage.Mapper, vtkCommand::VolumeMapperRenderProgressEvent);
  stage.Renderer->GetActiveCamera()->Azimuth(3.0);
  stage.Window->Render();
  Expect(progress.Count > 0, "progress is told to who asks");
  double ratio[3] = {};
  stage.Door()->GetReductionRatio(ratio);
  Expect(ratio[0] == 1.0 && ratio[2] == 1.0, "nothing has to be made smaller");
}

/// A volume in two renderers, of which one peels volumes, is drawn by both mappers in turn. That is
/// not told in each frame.
void TestTwoRenderers()
{
  Stage stage(Made<vtkGPUVolumeRayCastMapper>());
  const Log log;
  stage.Mapper->SetBlendModeToIsoSurface();
  vtkNew<vtkRenderer> peeling;
  peeling->SetUseDepthPeeling(1);
  peeling->SetUseDepthPeelingForVolumes(1);
  peeling->AddVolume(stage.Volume);
  stage.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  peeling->SetViewport(0.5, 0.0, 1.0, 1.0);
  stage.Window->AddRenderer(peeling);
  for (int frame = 0; frame < 4; ++frame)
  {
    stage.Renderer->GetActiveCamera()->Azimuth(3.0);
    stage.Window->Render();
  }
  Expect(log.Count("") == 0, "two renderers: " + std::to_string(log.Count("")) + " lines");
}

/// What is drawn is what is picked, also by VTK's hardware selection.
void TestPicking()
{
  Stage stage(Made<vtkGPUVolumeRayCastMapper>());
  stage.Mapper->SetBlendModeToIsoSurface();
  stage.Window->Render();
  vtkTemporalCoherenceVolumeMapper* surfaces = stage.Door()->GetIsosurfaceMapper();
  int x = 0;
  double seen[3] = {};
  while (x < Size && !surfaces->PickPixel(x, Size / 3, seen, nullptr, nullptr))
  {
    ++x;
  }
  x += 2; // not at the very edge
  Expect(surfaces->PickPixel(x, Size / 3, seen, nullptr, nullptr), "something is seen");
  vtkNew<vtkTemporalCoherencePicker> picker;
  Expect(
    picker->Pick(x + 0.5, Size / 3 + 0.5, 0.0, stage.Renderer) && picker->GetIsovalueIndex() == 0,
    "the surface is picked");
  Expect(
    vtkMath::Distance2BetweenPoints(picker->GetPickPosition(), seen) < 1e-3, "where it is seen");
  vtkNew<vtkPropPicker> props;
  Expect(props->PickProp(x, Size / 3, stage.Renderer) && props->GetViewProp() == stage.Volume,
    "the volume is found where its surface is");
  Expect(!props->PickProp(0, 0, stage.Renderer), "and not beside it");
}

void TestSwitches()
{
  Stage stage(Made<vtkGPUVolumeRayCastMapper>());
  stage.Mapper->SetBlendModeToIsoSurface();
  stage.Window->Render();
  Expect(stage.Door()->GetDrewIsosurfaces(), "on by default");
  stage.Door()->TemporalCoherenceOff();
  stage.Window->Render();
  Expect(!stage.Door()->GetDrewIsosurfaces(), "off by a call");
  for (const char* word : { "OFF", "no", "False", "0" })
  {
    setenv("VTK_TEMPORAL_COHERENCE", word, 1);
    Stage other(Made<vtkGPUVolumeRayCastMapper>());
    other.Mapper->SetBlendModeToIsoSurface();
    other.Window->Render();
    Expect(!other.Door()->GetDrewIsosurfaces(), std::string("off by the environment: ") + word);
  }
  setenv("VTK_TEMPORAL_COHERENCE", "ON", 1);
  Expect(Stage(Made<vtkGPUVolumeRayCastMapper>()).Door()->GetTemporalCoherence() == 1,
    "other words switch nothing off");
  unsetenv("VTK_TEMPORAL_COHERENCE");
}

/// Who holds the inner mapper for longer than the outer one.
void TestLifeOfInnerMapper()
{
  auto outer =
    vtkTemporalCoherenceGPUVolumeRayCastMapper::SafeDownCast(vtkGPUVolumeRayCastMapper::New());
  const vtkSmartPointer<vtkTemporalCoherenceVolumeMapper> inner = outer->GetIsosurfaceMapper();
  outer->Delete();
  inner->InvokeEvent(vtkCommand::VolumeMapperRenderStartEvent);
}

}

int TestEverywhere(int, char*[])
{
  vtkFloatingPointExceptions::Disable();
  // TestBlendedEverywhere has the other rules.
  using Door = vtkTemporalCoherenceGPUVolumeRayCastMapper;
  Door::SetDefaultBlendVolumes(Door::BLEND_NEVER);
  TestFactory();
  TestWhatIsLogged();
  TestSwitching();
  TestReuse();
  TestWhatIsLeftToVtk();
  TestDepthPass();
  TestWhatIsTold();
  TestTwoRenderers();
  TestPicking();
  TestSwitches();
  TestLifeOfInnerMapper();
  vtkTemporalCoherenceObjectFactory::UseNowhere();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
