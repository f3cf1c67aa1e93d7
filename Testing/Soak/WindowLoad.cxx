// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WindowLoad.h"

#include "Scenes/OffScreen.h"
#include "Volumes/Volumes.h"

#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderer.h>

namespace
{

constexpr int Size = 96; ///< of a window, in pixels

/// Like ours, it makes its pictures on the CPU and shows them as a texture.
vtkSmartPointer<vtkProp> MakeOther(vtkImageData* image)
{
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  mapper->SetInputData(image);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(100.0, 0.0);
  opacity->AddPoint(200.0, 0.8);
  const auto volume = vtkSmartPointer<vtkVolume>::New();
  volume->SetMapper(mapper);
  volume->GetProperty()->SetScalarOpacity(opacity);
  return volume;
}

/// Opaque, or with surfaces behind one another, for which the depth buffer is read back.
vtkSmartPointer<vtkProp> MakeVolume(vtkImageData* image, bool isOpaque)
{
  Scene scene(image, { 200.0 });
  if (!isOpaque)
  {
    scene.SetIsovalues({ 200.0, -300.0 });
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0.0, 0.4);
    scene.Volume->GetProperty()->SetScalarOpacity(opacity);
  }
  return scene.Volume.Get();
}

}

WindowLoad::WindowLoad(Contents contents)
  : Shown(contents)
  , Image(Volumes::Waves())
  , Always(contents == Ours ? MakeVolume(Image, true) : MakeOther(Image))
{
}

void WindowLoad::AddProps(vtkRenderer* renderer)
{
  renderer->AddViewProp(this->Always);
  // The other one lies beside it, and both are seen.
  const vtkSmartPointer<vtkProp> own =
    this->Shown == Ours ? MakeVolume(this->Image, this->Windows % 2 == 0) : MakeOther(this->Image);
  vtkProp3D::SafeDownCast(own)->SetPosition(2.2, 0.0, 0.0);
  renderer->AddViewProp(own);
  renderer->ResetCamera();
}

void WindowLoad::DoOnce()
{
  vtkNew<vtkRenderer> renderer;
  this->AddProps(renderer);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  OpenWindow(window, renderer, Size, Size);
  for (int frame = 0; frame < 3; ++frame)
  {
    window->Render();
    renderer->GetActiveCamera()->Azimuth(3.0);
  }
  const vtkNew<vtkUnsignedCharArray> pixels = PixelsOf(window);
  int drawn = 0;
  for (vtkIdType i = 0; i < pixels->GetNumberOfTuples(); ++i)
  {
    drawn += pixels->GetComponent(i, 0) > 0.0 ? 1 : 0;
  }
  ++this->Windows;
  const bool isSeen = drawn > Size * Size / 20;
  this->Drawn += isSeen ? 1 : 0;
  Expect(isSeen,
    "window " + std::to_string(this->Windows) + ": only " + std::to_string(drawn) +
      " pixels show something");
}

std::string WindowLoad::Describe() const
{
  return std::to_string(this->Drawn) + " of " + std::to_string(this->Windows) + " showed something";
}
