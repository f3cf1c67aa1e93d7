// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// VTK's scenario TestGPURayCastIsosurface runs without errors, and each picture is right: the
// default list of isovalues, one contour, none and three, in a window.

#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Truth/BruteForceTracer.h"

#include <vtkContourValues.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRTAnalyticSource.h>
#include <vtkRenderWindow.h>
#include <vtkTestErrorObserver.h>

#include <cstdlib>
#include <string>
#include <vector>

int TestIsosurfaceScenario(int, char*[])
{
  // The software rasteriser behind some windows divides by zero by itself.
  vtkFloatingPointExceptions::Disable();
  vtkNew<vtkRTAnalyticSource> data;
  data->SetWholeExtent(-100, 100, -100, 100, -100, 100);
  vtkNew<vtkTemporalCoherenceVolumeMapper> mapper;
  mapper->SetInputConnection(data->GetOutputPort());
  mapper->SetBlendModeToIsoSurface();
  mapper->SetAntialiasingToOff();

  vtkNew<vtkColorTransferFunction> color;
  color->RemoveAllPoints();
  color->AddRGBPoint(220.0, 0.0, 1.0, 0.0);
  color->AddRGBPoint(150.0, 1.0, 1.0, 1.0);
  color->AddRGBPoint(190.0, 0.0, 1.0, 1.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(220.0, 1.0);
  opacity->AddPoint(150.0, 0.2);
  opacity->AddPoint(190.0, 0.6);

  vtkNew<vtkVolumeProperty> property;
  property->ShadeOn();
  property->SetInterpolationTypeToLinear();
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->SetProperty(property);
  vtkNew<vtkRenderer> renderer;
  renderer->AddVolume(volume);
  renderer->SetBackground(0.5, 0.5, 0.5);
  renderer->ResetCamera();
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(400, 300);
  window->AddRenderer(renderer);
  vtkNew<vtkTest::ErrorObserver> observer;
  mapper->AddObserver(vtkCommand::ErrorEvent, observer);
  window->AddObserver(vtkCommand::ErrorEvent, observer);

  // Render the present list and compare each pixel of a grid with brute force.
  const auto check = [&](const std::string& what, const std::vector<double>& isovalues)
  {
    window->Render();
    BruteForceTracer truth(vtkImageData::SafeDownCast(mapper->GetInputDataObject(0, 0)), volume);
    truth.Isovalues = isovalues;
    int wrong = 0, hits = 0;
    for (int y = 0; y < 300; y += 10)
    {
      for (int x = 0; x < 400; x += 10)
      {
        int isovalue = -1;
        mapper->PickPixel(x, y, nullptr, nullptr, &isovalue);
        wrong += isovalue != truth.Trace(renderer, x, y, 400, 300).Isovalue;
        hits += isovalue >= 0;
      }
    }
    const std::string found = std::to_string(hits) + " hits, " + std::to_string(wrong) + " wrong";
    const bool isSomethingSeen = !isovalues.empty() && isovalues[0] > 0.0;
    Expect(wrong == 0 && (hits > 0) == isSomethingSeen, what + ": " + found);
  };
  vtkContourValues* list = property->GetIsoSurfaceValues();
  check("default list", { 0.0 });
  list->SetValue(0, 220.0);
  check("one contour", { 220.0 });
  list->SetNumberOfContours(0);
  check("no contour", {});
  list->SetValue(0, 220.0);
  list->SetValue(1, 150.0);
  list->SetValue(2, 190.0);
  check("three contours", { 220.0, 150.0, 190.0 });
  Expect(!observer->GetError(), "an error was reported: " + observer->GetErrorMessage());
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
