// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A program for one of VTK's volume mappers needs to change nothing but the name of the class: what
// it sets is kept, and what has no meaning here changes no picture.

#include "Checks/EventCounter.h"
#include "Checks/Expect.h"
#include "Scenes/Mistake.h"
#include "Scenes/OffScreen.h"
#include "Scenes/Scene.h"
#include "Volumes/Volumes.h"

#include <vtkContourValues.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkFloatArray.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkMultiVolume.h>
#include <vtkRenderWindow.h>
#include <vtkSmartVolumeMapper.h>
#include <vtkTrivialProducer.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace
{

constexpr int Size = 80;

/// A ball of radius 0.5 in a box from -1 to 1, at the isovalue -0.5.
vtkSmartPointer<vtkImageData> Ball()
{
  return Volumes::FromFormula(
    33, VTK_FLOAT, [](double x, double y, double z) { return -std::hypot(x, y, z); });
}

/// Set by every name that VTK's mapper of class T has, and returned.
#define EXPECT_KEPT(Setting, value)                                                                \
  mapper->Set##Setting(value);                                                                     \
  Expect(mapper->Get##Setting() == (value), #Setting " is kept");

template <typename T>
void SetWhatGpuMappersHave(T* mapper)
{
  EXPECT_KEPT(AutoAdjustSampleDistances, 0)
  EXPECT_KEPT(LockSampleDistanceToInputSpacing, 1)
  EXPECT_KEPT(UseJittering, 1)
  EXPECT_KEPT(UseDepthPass, 1)
  EXPECT_KEPT(SampleDistance, 0.25f)
  EXPECT_KEPT(ImageSampleDistance, 0.5f)
  EXPECT_KEPT(MinimumImageSampleDistance, 0.5f)
  EXPECT_KEPT(MaximumImageSampleDistance, 4.0f)
  EXPECT_KEPT(FinalColorWindow, 1.5f)
  EXPECT_KEPT(FinalColorLevel, 0.25f)
  EXPECT_KEPT(MaxMemoryInBytes, 12345)
  EXPECT_KEPT(MaxMemoryFraction, 0.5f)
  EXPECT_KEPT(ReportProgress, false)
  EXPECT_KEPT(MaskType, 0)
  EXPECT_KEPT(MaskBlendFactor, 0.5f)
  EXPECT_KEPT(RenderToImage, 1)
  EXPECT_KEPT(DepthImageScalarType, VTK_UNSIGNED_SHORT)
  EXPECT_KEPT(ClampDepthToBackface, 1)
  EXPECT_KEPT(ColorRangeType, 1)
  EXPECT_KEPT(ScalarOpacityRangeType, 1)
  EXPECT_KEPT(GradientOpacityRangeType, 1)
  vtkNew<vtkImageData> mask;
  mapper->SetMaskInput(mask);
  Expect(mapper->GetMaskInput() == mask, "the mask is kept");
  mapper->SetTransfer2DYAxisArray("y");
  Expect(std::strcmp(mapper->GetTransfer2DYAxisArray(), "y") == 0, "the second axis is kept");
  Expect(mapper->IsRenderSupported(nullptr, nullptr) == 1, "every window will do");
  double ratio[3] = {};
  mapper->GetReductionRatio(ratio);
  Expect(ratio[0] == 1.0 && ratio[1] == 1.0 && ratio[2] == 1.0, "nothing is made smaller");
}

template <typename T>
void SetWhatSmartMappersHave(T* mapper)
{
  EXPECT_KEPT(RequestedRenderMode, T::GPURenderMode)
  mapper->SetRequestedRenderModeToRayCast();
  Expect(mapper->GetRequestedRenderMode() == T::RayCastRenderMode, "the render mode is kept");
  mapper->SetRequestedRenderModeToOSPRay();
  mapper->SetRequestedRenderModeToDefault();
  EXPECT_KEPT(MaxMemoryInBytes, 12345)
  EXPECT_KEPT(MaxMemoryFraction, 0.5f)
  EXPECT_KEPT(InterpolationMode, VTK_RESLICE_LINEAR)
  mapper->SetInterpolationModeToCubic();
  Expect(mapper->GetInterpolationMode() == VTK_RESLICE_CUBIC, "the interpolation is kept");
  EXPECT_KEPT(InteractiveUpdateRate, 5.0)
  EXPECT_KEPT(InteractiveAdjustSampleDistances, 0)
  EXPECT_KEPT(AutoAdjustSampleDistances, 0)
  EXPECT_KEPT(SampleDistance, 0.25f)
  EXPECT_KEPT(FinalColorWindow, 1.5f)
  EXPECT_KEPT(FinalColorLevel, 0.25f)
  EXPECT_KEPT(VectorMode, T::COMPONENT)
  EXPECT_KEPT(VectorComponent, 2)
}

template <typename T>
void SetWhatFixedPointMappersHave(T* mapper)
{
  EXPECT_KEPT(SampleDistance, 0.25f)
  EXPECT_KEPT(InteractiveSampleDistance, 0.75f)
  EXPECT_KEPT(ImageSampleDistance, 2.0f)
  EXPECT_KEPT(MinimumImageSampleDistance, 2.0f)
  EXPECT_KEPT(MaximumImageSampleDistance, 4.0f)
  EXPECT_KEPT(AutoAdjustSampleDistances, 0)
  EXPECT_KEPT(LockSampleDistanceToInputSpacing, 1)
  EXPECT_KEPT(NumberOfThreads, 2)
  EXPECT_KEPT(IntermixIntersectingGeometry, 0)
  EXPECT_KEPT(FinalColorWindow, 1.5f)
  EXPECT_KEPT(FinalColorLevel, 0.25f)
}

void TestSettings()
{
  // The names are VTK's: these calls compile and hold for its own classes, too.
  SetWhatSmartMappersHave(vtkNew<vtkSmartVolumeMapper>().Get());
  SetWhatFixedPointMappersHave(vtkNew<vtkFixedPointVolumeRayCastMapper>().Get());
  SetWhatGpuMappersHave(vtkNew<vtkTemporalCoherenceVolumeMapper>().Get());
  SetWhatSmartMappersHave(vtkNew<vtkTemporalCoherenceVolumeMapper>().Get());
  SetWhatFixedPointMappersHave(vtkNew<vtkTemporalCoherenceVolumeMapper>().Get());

  vtkNew<vtkTemporalCoherenceVolumeMapper> mapper;
  vtkGPUVolumeRayCastMapper* base = mapper;
  SetWhatGpuMappersHave(base);
  Expect(mapper->GetImageSampleDistance() == 0.5f && mapper->GetAutoAdjustSampleDistances() == 0 &&
      mapper->GetLastUsedRenderMode() == vtkTemporalCoherenceVolumeMapper::RayCastRenderMode,
    "what is set through a pointer to VTK's class is set here");
  base->SetImageSampleDistance(1000.0f);
  Expect(mapper->GetImageSampleDistance() == 100.0f, "and within the same bounds");
  mapper->SetPartitions(2, 3, 4);
  Expect(mapper->GetPartitions()[2] == 4, "parts are kept");
  mapper->SetGlobalIlluminationReach(0.5f);
  mapper->SetVolumetricScatteringBlending(1.5f);
  mapper->ComputeNormalFromOpacityOn();
  Expect(mapper->GetGlobalIlluminationReach() == 0.5f &&
      mapper->GetVolumetricScatteringBlending() == 1.5f && mapper->GetComputeNormalFromOpacity(),
    "what VTK 9.2 added is kept");
}

/// Draw a scene into a window of its own.
vtkNew<vtkUnsignedCharArray> Draw(Scene& scene)
{
  vtkNew<vtkRenderWindow> window;
  OpenWindow(window, scene.Renderer, Size, Size);
  window->Render();
  auto pixels = PixelsOf(window);
  window->RemoveRenderer(scene.Renderer);
  scene.Mapper->ReleaseGraphicsResources(window);
  return pixels;
}

bool AreSame(vtkUnsignedCharArray* a, vtkUnsignedCharArray* b)
{
  return a->GetNumberOfValues() == b->GetNumberOfValues() &&
    std::memcmp(
      a->GetPointer(0), b->GetPointer(0), static_cast<std::size_t>(a->GetNumberOfValues())) == 0;
}

/// What is documented as without effect has none.
void TestWithoutEffect()
{
  Scene plain(Volumes::FourSpheres(32), { 100.0 }), scene(Volumes::FourSpheres(32), { 100.0 });
  const auto expected = Draw(plain);
  auto* mapper = scene.Mapper.Get();
  mapper->SetSampleDistance(7.0f);
  mapper->LockSampleDistanceToInputSpacingOn();
  mapper->UseJitteringOn();
  mapper->SetMaxMemoryInBytes(1);
  mapper->SetReportProgress(false);
  mapper->SetRequestedRenderModeToOSPRay();
  mapper->SetInterpolationModeToNearestNeighbor();
  mapper->SetInteractiveUpdateRate(1e-10);
  mapper->SetInteractiveSampleDistance(9.0f);
  mapper->IntermixIntersectingGeometryOff();
  mapper->SetNumberOfThreads(1);
  mapper->SetPartitions(2, 2, 2);
  mapper->SetGlobalIlluminationReach(1.0f);
  Expect(AreSame(expected, Draw(scene)), "settings without effect change no pixel");
}

/// Where a pixel shows a surface, its depth is that of the buffer of a window; elsewhere the far
/// end of the volume or 1.
void TestBufferImages()
{
  Scene scene(Ball(), { -0.5 });
  scene.LookFrom(0.0, 0.0, 1.0);
  vtkNew<vtkRenderWindow> window;
  OpenWindow(window, scene.Renderer, Size, Size);
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  scene.Mapper->RenderToImageOn();
  window->Render();
  const auto* nothing = PixelsOf(window)->GetPointer(4 * (Size / 2 * Size + Size / 2));
  Expect(nothing[0] == 0 && nothing[1] == 0 && nothing[2] == 0, "the window stays empty");

  vtkNew<vtkImageData> color, depth, far, bytes;
  scene.Mapper->GetColorImage(color);
  scene.Mapper->GetDepthImage(depth);
  scene.Mapper->ClampDepthToBackfaceOn();
  scene.Mapper->GetDepthImage(far);
  scene.Mapper->SetDepthImageScalarTypeToUnsignedShort();
  scene.Mapper->GetDepthImage(bytes);
  scene.Mapper->RenderToImageOff();
  window->Render();
  vtkNew<vtkFloatArray> buffer;
  window->GetZbufferData(0, 0, Size - 1, Size - 1, buffer);
  const auto shown = PixelsOf(window);
  Expect(scene.Render(Size, Size), "rendered");
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  double* range = camera->GetClippingRange();
  const double toBack = camera->GetPosition()[2] + 1.0;
  const double back = (1.0 / range[0] - 1.0 / toBack) / (1.0 / range[0] - 1.0 / range[1]);
  int hits = 0;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      const auto* pixel = static_cast<unsigned char*>(color->GetScalarPointer(x, y, 0));
      const float z = *static_cast<float*>(depth->GetScalarPointer(x, y, 0));
      const float clamped = *static_cast<float*>(far->GetScalarPointer(x, y, 0));
      const auto share = *static_cast<unsigned short*>(bytes->GetScalarPointer(x, y, 0));
      Expect(share == std::lround(clamped * 65535.0f), "depths as shares of 65535");
      const vtkIdType at = y * Size + x;
      if (std::isfinite(scene.DepthAt(x, y)))
      {
        ++hits;
        Expect(std::memcmp(pixel, scene.ColorAt(x, y), 4) == 0, "colours are the picture's");
        Expect(std::abs(z - buffer->GetValue(at)) < 1e-6f && clamped == z,
          "depths are those of the window");
        Expect(std::abs(shown->GetValue(4 * at) - pixel[0]) <= 1, "and so are colours");
      }
      else
      {
        const unsigned char expected = clamped == 1.0f ? 255 : 0;
        Expect(
          pixel[0] == expected && pixel[1] == expected && pixel[2] == expected && pixel[3] == 0,
          "nothing where nothing is hit, transparent white beside the volume");
        Expect(z == 1.0f, "the far end where nothing is hit");
      }
    }
  }
  Expect(hits > 200, "something is seen");
  // Beside the ball, where the ray leaves the box by its far face.
  const int beside = Size / 2 + Size / 5;
  Expect(!std::isfinite(scene.DepthAt(beside, beside)) &&
      std::abs(*static_cast<float*>(far->GetScalarPointer(beside, beside, 0)) - back) < 1e-5,
    "or the back of the volume");
  Expect(
    *static_cast<float*>(far->GetScalarPointer(0, 0, 0)) == 1.0f, "but not where it is passed by");
}

/// Contour values of the depth pass serve where the property has none.
void TestDepthPass()
{
  const auto data = Volumes::FourSpheres(32);
  Scene expected(data, { 100.0 }), scene(data, { 0.0 });
  const auto picture = Draw(expected);
  scene.Mapper->UseDepthPassOn();
  scene.Mapper->GetDepthPassContourValues()->SetValue(0, 100.0);
  Expect(AreSame(picture, Draw(scene)), "the depth pass's contours");
  scene.SetIsovalues({});
  Expect(AreSame(picture, Draw(scene)), "also where the property's list is empty");
  scene.Mapper->UseDepthPassOff();
  Expect(!AreSame(picture, Draw(scene)), "not without the depth pass");
  scene.Mapper->UseDepthPassOn();
  scene.Mapper->GetDepthPassContourValues()->SetValue(0, 50.0);
  scene.SetIsovalues({ 100.0 });
  Expect(AreSame(picture, Draw(scene)), "the property's own come first");
}

/// What is not drawn is refused in one sentence that names who draws it.
void TestRefusals()
{
  const auto data = Ball();
  {
    Scene scene(data, { -0.5 });
    Mistake mistake(scene, "vtkGPUVolumeRayCastMapper");
    scene.Mapper->SetBlendModeToSlice();
    mistake.ExpectRefused();
    scene.Mapper->SetBlendModeToIsoSurface();
    mistake.ExpectMended();
  }
  {
    Scene scene(data, { -0.5 });
    Mistake mistake(scene, "There is an input at port 1");
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(data);
    scene.Mapper->SetInputConnection(1, producer->GetOutputPort());
    mistake.ExpectRefused();
    scene.Mapper->RemoveInputConnection(1, 0);
    mistake.ExpectMended();
  }
  Scene scene(data, { -0.5 });
  vtkNew<vtkTest::ErrorObserver> observer;
  scene.Mapper->AddObserver(vtkCommand::ErrorEvent, observer);
  const EventCounter errors(scene.Mapper, vtkCommand::ErrorEvent);
  vtkNew<vtkMultiVolume> several;
  Expect(scene.Mapper->IsOpaque(several), "no volume hides nothing");
  several->SetMapper(scene.Mapper);
  several->SetVolume(scene.Volume, 0);
  scene.Renderer->RemoveVolume(scene.Volume);
  scene.Renderer->AddVolume(several);
  vtkNew<vtkRenderWindow> window;
  OpenWindow(window, scene.Renderer, Size, Size);
  window->Render();
  window->Render();
  Expect(
    errors.Count == 1 && observer->GetErrorMessage().find("vtkMultiVolume") != std::string::npos,
    "vtkMultiVolume is refused once");
}

/// Blocks are no input that the superclass knows: what it does with it must not fail.
void TestBlocksBehindTheSuperclass()
{
  vtkNew<vtkTemporalCoherenceVolumeMapper> mapper;
  vtkNew<vtkMultiBlockDataSet> blocks;
  const auto block = Ball();
  blocks->SetBlock(0, block);
  mapper->SetInputDataObject(blocks);
  Expect(mapper->GetInput() == nullptr && mapper->GetInputCount() == 1, "blocks are no data set");
  vtkGPUVolumeRayCastMapper* base = mapper;
  Expect(base->GetBoundsFromPort(0) != nullptr, "bounds of what has no points");
  Expect(std::equal(block->GetBounds(), block->GetBounds() + 6, mapper->GetBounds()),
    "bounds of the blocks");
}

}

int TestDropIn(int, char*[])
{
  vtkFloatingPointExceptions::Disable();
  TestSettings();
  TestWithoutEffect();
  TestBufferImages();
  TestDepthPass();
  TestRefusals();
  TestBlocksBehindTheSuperclass();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
