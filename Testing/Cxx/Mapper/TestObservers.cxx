// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Whatever observers do while a frame is made, it is the frame that was asked for.

#include "Checks/Expect.h"
#include "Checks/Meddler.h"
#include "Scenes/Scene.h"
#include "Volumes/Volumes.h"

#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <cstdlib>
#include <vector>

namespace
{

vtkSmartPointer<vtkImageData> Noise()
{
  return Volumes::Noise(20, VTK_FLOAT, 0.0, 200.0);
}

/// The only reference to the samples is the mapper's, and an observer gives it others.
void TestOtherInput()
{
  Scene usual(Noise(), { 100.0 });
  usual.LookFrom(1.0, 2.0, 0.5);
  Expect(usual.Render(60, 60), "rendered");

  Scene scene(Noise(), { 100.0 });
  scene.Renderer->SetActiveCamera(usual.Renderer->GetActiveCamera());
  std::vector<vtkSmartPointer<vtkImageData>> others; // take the memory that may have become free
  const Meddler meddler(scene.Mapper, vtkCommand::VolumeMapperRenderProgressEvent, 0,
    [&]
    {
      scene.Mapper->SetInputData(Volumes::Noise(5, VTK_FLOAT, 0.0, 1.0));
      scene.Mapper->IsOpaque(scene.Volume); // looks for the samples of what is the input now
      for (int i = 0; i < 40; ++i)
      {
        others.push_back(Noise());
        others.back()->GetPointData()->GetScalars()->Fill(0.0);
      }
    });
  Expect(scene.Render(60, 60) && meddler.IsDone, "rendered in spite of the observer");
  Expect(AreIdentical(scene.Color, usual.Color) && AreIdentical(scene.Depth, usual.Depth),
    "an input that is replaced while a frame is made stays as long as the frame needs it");
}

/// Who hears that a frame is made may make the next one.
void TestNextFrame()
{
  Scene scene(Noise(), { 100.0 });
  scene.LookFrom(1.0, 2.0, 0.5);
  vtkNew<vtkImageData> small;
  const Meddler meddler(scene.Mapper, vtkCommand::VolumeMapperRenderEndEvent, 0,
    [&] { scene.Mapper->MakeImage(scene.Renderer, scene.Volume, 8, 7, small, nullptr); });
  Expect(scene.Render(60, 60) && meddler.IsDone, "rendered");
  Expect(small->GetNumberOfPoints() == 56, "and the next frame");
  Expect(scene.Color->GetNumberOfPoints() == 3600 && scene.Depth->GetNumberOfPoints() == 3600,
    "each frame is written where it was asked for");
}

}

int TestObservers(int, char*[])
{
  TestOtherInput();
  TestNextFrame();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
