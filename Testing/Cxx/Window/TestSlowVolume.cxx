// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A window does not wait for a slow volume: it shows what is finished over a coarse picture, and a
// refiner brings the rest. Images, and windows that nobody refines, wait for all samples.

#include "Checks/Expect.h"
#include "Scenes/OffScreen.h"
#include "Scenes/Scene.h"
#include "Volumes/Volumes.h"
#include "vtkTemporalCoherenceBrickSource.h"
#include "vtkTemporalCoherenceRefiner.h"

#include <vtkDataArray.h>
#include <vtkImageAlgorithm.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string>
#include <thread>

namespace
{

constexpr int N = 200; ///< more samples than the reader gives at a time

/// Gives parts of an image, and takes its time.
class SlowReader : public vtkImageAlgorithm
{
public:
  static SlowReader* New();
  vtkTypeMacro(SlowReader, vtkImageAlgorithm);

  vtkSmartPointer<vtkImageData> Whole;
  std::chrono::milliseconds Delay{ 0 };

protected:
  SlowReader() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(
    vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    vtkInformation* const output = outputs->GetInformationObject(0);
    output->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), this->Whole->GetExtent(), 6);
    output->Set(vtkDataObject::SPACING(), this->Whole->GetSpacing(), 3);
    output->Set(vtkDataObject::ORIGIN(), this->Whole->GetOrigin(), 3);
    output->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
    vtkDataObject::SetPointDataActiveScalarInfo(output, this->Whole->GetScalarType(), 1);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override
  {
    std::this_thread::sleep_for(this->Delay);
    auto* const image = vtkImageData::GetData(outputs);
    image->DeepCopy(this->Whole);
    image->Crop(
      vtkStreamingDemandDrivenPipeline::GetUpdateExtent(outputs->GetInformationObject(0)));
    return 1;
  }
};
vtkStandardNewMacro(SlowReader);

/// Four spheres in memory, and four spheres behind a slow reader.
struct Stage
{
  Stage()
    : Memory(Volumes::FourSpheres(N), { 100.0 })
    , Slow(nullptr, { 100.0 })
    , Folder(std::filesystem::temp_directory_path() / ("slow-" + std::to_string(std::rand())))
  {
    this->Reader->Whole = vtkImageData::SafeDownCast(this->Memory.Mapper->GetInputDataObject(0, 0));
    this->Source->SetReader(this->Reader);
    this->Source->SetRangesFolder(this->Folder.string());
    this->Open();
    this->Reader->Delay = std::chrono::milliseconds(100);
    this->Slow.Mapper->SetBrickSource(this->Source);
    this->Memory.LookFrom(1.0, 2.0, 0.5);
    this->Slow.Renderer->SetActiveCamera(this->Memory.Renderer->GetActiveCamera());
    this->Slow.Renderer->AddVolume(this->Slow.Volume);
    this->Memory.Renderer->AddVolume(this->Memory.Volume);
    OpenWindow(this->Window, this->Slow.Renderer, 120, 90);
    OpenWindow(this->OfMemory, this->Memory.Renderer, 120, 90);
    this->Window->OffScreenRenderingOn();
    this->OfMemory->OffScreenRenderingOn();
  }
  ~Stage()
  {
    std::error_code ignored;
    std::filesystem::remove_all(this->Folder, ignored);
  }
  Stage(const Stage&) = delete;
  Stage& operator=(const Stage&) = delete;

  /// Open the volume. Little of what was read for the value ranges stays in memory.
  void Open()
  {
    this->Source->SetMemoryLimit(1 << 20);
    this->Source->Update();
    this->Source->SetMemoryLimit(64 << 20);
  }

  bool ShowTheSame()
  {
    this->OfMemory->Render();
    const auto a = PixelsOf(this->Window), b = PixelsOf(this->OfMemory);
    return std::memcmp(a->GetVoidPointer(0), b->GetVoidPointer(0),
             static_cast<std::size_t>(a->GetNumberOfValues())) == 0;
  }

  Scene Memory, Slow;
  std::filesystem::path Folder;
  vtkNew<SlowReader> Reader;
  vtkNew<vtkTemporalCoherenceBrickSource> Source;
  vtkNew<vtkRenderWindow> Window, OfMemory;
};

void TestRefined()
{
  Stage stage;
  vtkNew<vtkTemporalCoherenceRefiner> refiner;
  refiner->SetRenderWindow(stage.Window);
  stage.Window->Render();
  const auto& mapper = stage.Slow.Mapper;
  Expect(std::string(mapper->GetStatistics()->GetRouteAsString()) == "FewerRays" &&
      !mapper->GetFrameIsFinal() && mapper->GetFrameProgress() < 1.0,
    "the first frame does not wait");
  Expect(refiner->Refine() && mapper->GetFrameIsFinal(), "a refiner brings the rest");
  Expect(stage.ShowTheSame(), "the final picture is that of samples in memory");

  // Another view, in which much is known.
  stage.Slow.Renderer->GetActiveCamera()->Azimuth(40.0);
  stage.Window->Render();
  Expect(refiner->Refine() && stage.ShowTheSame(), "the final picture after a turn");

  // Translucent surfaces, a solid that is cut, and another isovalue.
  for (Scene* const scene : { &stage.Slow, &stage.Memory })
  {
    scene->Mapper->SetSurfaceModeToThreshold();
    scene->Mapper->CroppingOn();
    scene->Mapper->SetCroppingRegionPlanes(20.0, 90.0, 10.0, 70.0, 30.0, 80.0);
    scene->Mapper->SetCroppingRegionFlagsToSubVolume();
    scene->SetIsovalues({ 60.0 });
  }
  stage.Source->Close(); // nothing is known again
  stage.Open();
  stage.Window->Render();
  Expect(refiner->Refine() && stage.ShowTheSame(), "the final picture of a solid");
}

void TestWaiting()
{
  Stage stage;
  stage.Window->Render();
  Expect(stage.Slow.Mapper->GetFrameIsFinal() && stage.ShowTheSame(),
    "a window that nobody refines waits");
  Stage other;
  vtkNew<vtkTemporalCoherenceRefiner> refiner;
  refiner->SetRenderWindow(other.Window);
  Expect(other.Slow.Render(80, 60) && other.Memory.Render(80, 60) &&
      AreIdentical(other.Slow.Color, other.Memory.Color),
    "an image waits");
}

}

int TestSlowVolume(int, char*[])
{
  TestRefined();
  TestWaiting();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
