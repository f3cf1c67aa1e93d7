// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A few whole pictures are like stored ones: light and colour, which the numbers of other tests do
// not see. A picture that differs is left in the temporary directory of the tests.

#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Volumes/Volumes.h"

#include <vtkLight.h>
#include <vtkRTAnalyticSource.h>
#include <vtkTesting.h>
#include <vtkTrivialProducer.h>

#include <cstdlib>

namespace
{

/// The picture on a grey background, without alpha, as baselines are.
vtkSmartPointer<vtkImageData> OnGrey(vtkImageData* picture)
{
  auto opaque = vtkSmartPointer<vtkImageData>::New();
  opaque->SetDimensions(picture->GetDimensions());
  opaque->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const auto* from = static_cast<const unsigned char*>(picture->GetScalarPointer());
  auto* to = static_cast<unsigned char*>(opaque->GetScalarPointer());
  for (vtkIdType pixel = 0; pixel < picture->GetNumberOfPoints(); ++pixel)
  {
    for (int c = 0; c < 3; ++c)
    {
      to[3 * pixel + c] = from[4 * pixel + 3] ? from[4 * pixel + c] : 128;
    }
  }
  return opaque;
}

void ExpectStored(const std::string& name, Scene& scene)
{
  scene.Renderer->GetActiveCamera()->Zoom(1.6);
  Expect(scene.Render(320, 240), name + ": rendered");
  vtkSmartPointer<vtkImageData> picture = OnGrey(scene.Color);
  vtkNew<vtkTrivialProducer> source;
  source->SetOutput(picture);
  vtkNew<vtkTesting> testing;
  testing->AddArgument("-V");
  testing->AddArgument((std::string(TEMPORAL_COHERENCE_BASELINES "/") + name + ".png").c_str());
  testing->AddArgument("-T");
  testing->AddArgument(TEMPORAL_COHERENCE_TEMPORARY);
  Expect(testing->RegressionTest(source, 1.0) == vtkTesting::PASSED, name + ": the stored picture");
}

void TestContours()
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  wavelet->SetWholeExtent(-30, 30, -30, 30, -30, 30);
  wavelet->Update();
  Scene scene(wavelet->GetOutput(), { 220.0, 150.0, 190.0 });
  vtkColorTransferFunction* color = scene.Volume->GetProperty()->GetRGBTransferFunction();
  color->RemoveAllPoints();
  color->AddRGBPoint(150.0, 0.9, 0.9, 0.9);
  color->AddRGBPoint(190.0, 0.1, 0.6, 0.8);
  color->AddRGBPoint(220.0, 0.2, 0.8, 0.2);
  scene.LookFrom(-1.0, -2.0, 0.8);
  ExpectStored("Contours", scene);
}

void TestCapsAndNearest()
{
  Scene scene(Volumes::MarschnerLobb(40), { 128.0 });
  scene.Mapper->SetSurfaceModeToThreshold();
  scene.Volume->GetProperty()->SetInterpolationTypeToNearest();
  scene.LookFrom(-1.0, -2.0, 1.4);
  ExpectStored("CapsAndNearest", scene);
}

void TestLights()
{
  Scene scene(Volumes::FourSpheres(64), { 100.0 });
  scene.LookFrom(1.0, -2.0, 0.4);
  scene.Volume->GetProperty()->SetSpecular(0.6);
  scene.Volume->GetProperty()->SetSpecularPower(40.0);
  vtkNew<vtkLight> red;
  red->SetLightTypeToSceneLight();
  red->SetPosition(-100.0, -100.0, 100.0);
  red->SetFocalPoint(32.0, 32.0, 32.0);
  red->SetColor(1.0, 0.3, 0.2);
  vtkNew<vtkLight> spot;
  spot->SetLightTypeToCameraLight();
  spot->SetPosition(0.3, 0.3, 1.0);
  spot->SetFocalPoint(0.0, 0.0, 0.0);
  spot->PositionalOn();
  spot->SetConeAngle(8.0);
  spot->SetExponent(2.0);
  spot->SetColor(0.3, 0.5, 1.0);
  scene.Renderer->AddLight(red);
  scene.Renderer->AddLight(spot);
  ExpectStored("Lights", scene);
}

}

int TestPictures(int, char*[])
{
  TestContours();
  TestCapsAndNearest();
  TestLights();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
