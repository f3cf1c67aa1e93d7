// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Linked to one of VTK's examples, this takes the place of its user: the interactor that the
// example makes is one that, instead of waiting for the mouse, raises the isovalue step by step,
// turns the camera, and tells what each took. So the example itself need not be touched.
//
// environment: TEMPORAL_COHERENCE_PICTURE, the file (PNG) that the first picture is written to;
//              TEMPORAL_COHERENCE_FRAMES, the number of frames of which a time is the median (15)

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkContourFilter.h>
#include <vtkContourValues.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPNGWriter.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtkVersion.h>
#include <vtkVolume.h>
#include <vtkVolumeCollection.h>
#include <vtkVolumeProperty.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <vector>

namespace
{

constexpr int UsualFrames = 15;
constexpr double IsovalueStep = 2.0;
constexpr double Degrees = 2.0;

/// The filter that the surfaces of an actor come from; null if there is none.
vtkContourFilter* ContoursOf(vtkActor* actor)
{
  vtkAlgorithm* algorithm = actor->GetMapper();
  while (algorithm && algorithm->GetNumberOfInputPorts() > 0 &&
    algorithm->GetNumberOfInputConnections(0) > 0)
  {
    algorithm = algorithm->GetInputAlgorithm(0, 0);
    if (auto* contours = vtkContourFilter::SafeDownCast(algorithm))
    {
      return contours;
    }
  }
  return nullptr;
}

/// What is transparent below a value is so below a higher one.
void ShiftOpacity(vtkPiecewiseFunction* opacity, double by)
{
  for (int i = opacity->GetSize() - 1; i >= 0; --i)
  {
    std::array<double, 4> node{};
    opacity->GetNodeValue(i, node.data());
    node[0] += by;
    opacity->SetNodeValue(i, node.data());
  }
}

/// Raise all isovalues of polygons and of volumes.
void RaiseIsovalues(vtkRenderer* renderer, double by)
{
  vtkActorCollection* actors = renderer->GetActors();
  for (int i = 0; i < actors->GetNumberOfItems(); ++i)
  {
    if (vtkContourFilter* contours = ContoursOf(vtkActor::SafeDownCast(actors->GetItemAsObject(i))))
    {
      contours->SetValue(0, contours->GetValue(0) + by);
    }
  }
  vtkVolumeCollection* volumes = renderer->GetVolumes();
  for (int i = 0; i < volumes->GetNumberOfItems(); ++i)
  {
    auto* volume = vtkVolume::SafeDownCast(volumes->GetItemAsObject(i));
    if (vtkFixedPointVolumeRayCastMapper::SafeDownCast(volume->GetMapper()))
    {
      ShiftOpacity(volume->GetProperty()->GetScalarOpacity(), by);
      continue;
    }
    vtkContourValues* isovalues = volume->GetProperty()->GetIsoSurfaceValues();
    for (int contour = 0; contour < isovalues->GetNumberOfContours(); ++contour)
    {
      isovalues->SetValue(contour, isovalues->GetValue(contour) + by);
    }
  }
}

double MillisecondsOf(vtkRenderWindow* window)
{
  const auto begin = std::chrono::steady_clock::now();
  window->Render();
  window->WaitForCompletion();
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin)
    .count();
}

/// Median of frames, each after a change.
double MedianOf(vtkRenderWindow* window, const std::function<void()>& change)
{
  const char* asked = std::getenv("TEMPORAL_COHERENCE_FRAMES");
  const int frames = asked ? std::max(1, std::atoi(asked)) : UsualFrames;
  std::vector<double> times;
  for (int frame = 0; frame < frames; ++frame)
  {
    change();
    times.push_back(MillisecondsOf(window));
  }
  std::sort(times.begin(), times.end());
  return times[times.size() / 2];
}

void WritePicture(vtkRenderWindow* window)
{
  if (const char* file = std::getenv("TEMPORAL_COHERENCE_PICTURE"))
  {
    vtkNew<vtkWindowToImageFilter> grab;
    grab->SetInput(window);
    grab->ReadFrontBufferOff();
    vtkNew<vtkPNGWriter> writer;
    writer->SetInputConnection(grab->GetOutputPort());
    writer->SetFileName(file);
    writer->Write();
  }
}

class Conductor : public vtkRenderWindowInteractor
{
public:
  static Conductor* New();
  vtkTypeMacro(Conductor, vtkRenderWindowInteractor);

  void Initialize() override { this->Initialized = 1; }

  void Start() override
  {
    vtkRenderWindow* window = this->GetRenderWindow();
    window->SetMultiSamples(0);
    std::cout << "first " << MillisecondsOf(window) << '\n';
    WritePicture(window);
    vtkRenderer* renderer = window->GetRenderers()->GetFirstRenderer();
    std::cout << "isovalue "
              << MedianOf(window, [renderer] { RaiseIsovalues(renderer, IsovalueStep); }) << '\n';
    const auto turn = [renderer]
    {
      renderer->GetActiveCamera()->Azimuth(Degrees);
      renderer->ResetCameraClippingRange();
    };
    std::cout << "orbit " << MedianOf(window, turn) << '\n';
  }

private:
  Conductor() = default;
};

vtkStandardNewMacro(Conductor);

VTK_CREATE_CREATE_FUNCTION(Conductor);

class ConductorFactory : public vtkObjectFactory
{
public:
  static ConductorFactory* New();
  vtkTypeMacro(ConductorFactory, vtkObjectFactory);

  const char* GetVTKSourceVersion() override { return VTK_SOURCE_VERSION; }
  const char* GetDescription() override { return "an interactor that is its own user"; }

private:
  ConductorFactory()
  {
    this->RegisterOverride("vtkRenderWindowInteractor", "Conductor", "measure, do not wait", 1,
      vtkObjectFactoryCreateConductor);
  }
};

vtkStandardNewMacro(ConductorFactory);

/// Before main(): no other factory may make the interactor.
struct Registration
{
  Registration()
  {
    vtkObjectFactory::SetAllEnableFlags(0, "vtkRenderWindowInteractor");
    vtkNew<ConductorFactory> factory;
    vtkObjectFactory::RegisterFactory(factory);
  }
};
const Registration Registered;

}
