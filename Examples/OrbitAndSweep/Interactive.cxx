// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Interactive.h"

#include "Isovalue.h"
#include "Options.h"
#include "Scene.h"
#include "Silence.h"

#include <vtkCallbackCommand.h>
#include <vtkErrorCode.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkPNGWriter.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkSliderRepresentation2D.h>
#include <vtkSliderWidget.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>

#ifdef ORBIT_AND_SWEEP_X11
#include <X11/Xlib.h>
#endif

namespace
{

void CheckDisplay()
{
#if !defined(_WIN32) && !defined(__APPLE__)
  const char* name = std::getenv("DISPLAY");
  if (!name || !*name)
  {
    throw UserError(
      "--interactive needs a display, but DISPLAY is not set; log in with ssh -X, run "
      "under xvfb-run, or leave the option out: pictures need no display.");
  }
#ifdef ORBIT_AND_SWEEP_X11
  Display* display = XOpenDisplay(name);
  if (!display)
  {
    throw UserError("--interactive needs a display, but '" + std::string(name) +
      "' (DISPLAY) cannot be opened; set DISPLAY to one that runs, or leave the option out.");
  }
  XCloseDisplay(display);
#endif
#endif
}

// Renders with the isovalue of the slider. Called while it is dragged.
void OnSlider(vtkObject* caller, unsigned long, void* clientData, void*)
{
  auto* slider = static_cast<vtkSliderWidget*>(caller);
  auto* representation = static_cast<vtkSliderRepresentation*>(slider->GetRepresentation());
  static_cast<Scene*>(clientData)->SetIsovalue(representation->GetValue());
}

// The line is drawn over the finished volume, so it can tell of the very frame it stands in.
struct StatusLine
{
  Scene* Shown;
  vtkNew<vtkTextActor> Text;

  static void OnFrame(vtkObject*, unsigned long, void* clientData, void*)
  {
    auto* self = static_cast<StatusLine*>(clientData);
    vtkTemporalCoherenceVolumeMapper* mapper = self->Shown->Mapper;
    char line[120];
    std::snprintf(line, sizeof(line), "%s  %.1f ms", mapper->GetRouteAsString(),
      1000.0 * mapper->GetFrameTime());
    self->Text->SetInput(line);
    // A text actor writes its picture at this stage, which is over for this frame.
    self->Text->RenderOpaqueGeometry(self->Shown->Renderer);
  }
};

void SetUpSlider(vtkSliderWidget* slider, const IsovalueChoice& isovalue)
{
  vtkNew<vtkSliderRepresentation2D> look;
  look->SetMinimumValue(isovalue.Range[0]);
  look->SetMaximumValue(isovalue.Range[1]);
  look->SetValue(isovalue.Value);
  look->SetTitleText("isovalue");
  look->SetLabelFormat("%.4g");
  look->GetPoint1Coordinate()->SetCoordinateSystemToNormalizedDisplay();
  look->GetPoint1Coordinate()->SetValue(0.15, 0.08);
  look->GetPoint2Coordinate()->SetCoordinateSystemToNormalizedDisplay();
  look->GetPoint2Coordinate()->SetValue(0.85, 0.08);
  look->SetSliderLength(0.02);
  look->SetSliderWidth(0.025);
  look->SetTubeWidth(0.006);
  look->SetEndCapLength(0.004);
  look->SetTitleHeight(0.022);
  look->SetLabelHeight(0.022);
  slider->SetRepresentation(look);
  slider->SetAnimationModeToJump();
}

void SaveScreenshot(vtkRenderWindow* window, const std::string& path)
{
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grab->GetOutputPort());
  writer->SetFileName(path.c_str());
  {
    const Silence silence;
    writer->Write();
  }
  if (writer->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw UserError("'" + path + "' cannot be written; name another file with --screenshot.");
  }
  std::printf("Screenshot: %s\n", path.c_str());
}

}

void RunInteractive(Scene& scene, const IsovalueChoice& isovalue, const Options& options)
{
  CheckDisplay();
  scene.Renderer->GradientBackgroundOn();
  scene.Renderer->SetBackground(0.29, 0.32, 0.38);
  scene.Renderer->SetBackground2(0.11, 0.13, 0.16);

  vtkNew<vtkRenderWindow> window;
  window->SetWindowName("Orbit and sweep");
  window->SetMultiSamples(0); // the picture is ray cast; samples would only cost
  window->SetSize(options.Width, options.Height);
  window->AddRenderer(scene.Renderer);

  StatusLine status;
  status.Shown = &scene;
  status.Text->SetInput("no frame yet");
  status.Text->GetTextProperty()->SetFontSize(18);
  status.Text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  status.Text->SetPosition(0.015, 0.945);
  scene.Renderer->AddViewProp(status.Text);
  vtkNew<vtkCallbackCommand> onFrame;
  onFrame->SetClientData(&status);
  onFrame->SetCallback(&StatusLine::OnFrame);
  scene.Mapper->AddObserver(vtkCommand::VolumeMapperRenderEndEvent, onFrame);

  vtkNew<vtkRenderWindowInteractor> interactor;
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  interactor->SetInteractorStyle(style);
  interactor->SetRenderWindow(window);
  vtkNew<vtkSliderWidget> slider;
  SetUpSlider(slider, isovalue);
  slider->SetInteractor(interactor);
  vtkNew<vtkCallbackCommand> onSlider;
  onSlider->SetClientData(&scene);
  onSlider->SetCallback(OnSlider);
  slider->AddObserver(vtkCommand::InteractionEvent, onSlider);

  interactor->Initialize();
  slider->EnabledOn();
  window->Render();
  if (!options.Screenshot.empty())
  {
    SaveScreenshot(window, options.Screenshot);
  }
  else
  {
    std::printf("Drag to turn, wheel to zoom, slide for the isovalue; q ends.\n");
    interactor->Start();
  }
  scene.Mapper->RemoveObserver(onFrame);
}
