// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlendWays.h"

#include "OffScreenWindow.h"

#include <vtkCamera.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVolumeProperty.h>

#include <cstddef>

namespace BlendWays
{
namespace
{

/// This mapper, without a window.
class Ours : public Way
{
public:
  Ours(const Stage& stage, int mode, bool isCold)
    : Way(isCold ? "this mapper, cold" : "this mapper")
    , IsCold(isCold)
    , Caster(stage)
  {
    this->Caster.Mapper->SetBlendMode(mode);
    if (isCold)
    {
      this->Caster.Mapper->ReuseFramesOff();
      this->Caster.Mapper->IsomapOff();
    }
  }

  void BeforeChange(Stage& stage) override
  {
    if (this->IsCold)
    {
      // A small picture takes the place of the last one.
      constexpr int small = 16;
      vtkNew<vtkImageData> color, depth;
      this->Caster.Mapper->MakeImage(stage.Renderer, stage.Volume, small, small, color, depth);
    }
  }
  double Draw(Stage& stage) override { return this->Caster.Draw(stage); }

  Picture Shown() const override
  {
    vtkDataArray* colors = this->Caster.Color->GetPointData()->GetScalars();
    Picture picture(static_cast<std::size_t>(colors->GetNumberOfTuples()));
    for (std::size_t i = 0; i < picture.size(); ++i)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        picture[i][c] = static_cast<unsigned char>(
          colors->GetComponent(static_cast<vtkIdType>(i), static_cast<int>(c)));
      }
    }
    return picture;
  }

private:
  const bool IsCold;
  Drawer Caster;
};

/// A mapper of VTK, in a window of its own.
class Peer : public Way
{
public:
  Peer(const Stage& stage, const std::string& who, vtkVolumeMapper* mapper)
    : Way(who)
    , Window(Renderer, stage.Size)
  {
    mapper->SetInputData(stage.Image);
    this->Volume->SetMapper(mapper);
    this->Volume->SetProperty(stage.Volume->GetProperty());
    this->Renderer->AddVolume(this->Volume);
    this->Renderer->SetBackground(0.0, 0.0, 0.0);
  }

  double Draw(Stage& stage) override
  {
    this->Renderer->GetActiveCamera()->DeepCopy(stage.Renderer->GetActiveCamera());
    return this->Window.Draw();
  }

  Picture Shown() const override
  {
    constexpr int frontBuffer = 1;
    vtkRenderWindow* window = this->Renderer->GetRenderWindow();
    const int* size = window->GetSize();
    vtkNew<vtkUnsignedCharArray> pixels;
    window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, frontBuffer, pixels);
    Picture picture(static_cast<std::size_t>(pixels->GetNumberOfTuples()));
    for (std::size_t i = 0; i < picture.size(); ++i)
    {
      pixels->GetTypedTuple(static_cast<vtkIdType>(i), picture[i].data());
    }
    return picture;
  }

private:
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkVolume> Volume;
  OffScreenWindow Window;
};

/// One sample a voxel, one ray a pixel.
std::unique_ptr<Way> FixedPoint(const Stage& stage, int mode)
{
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  mapper->SetBlendMode(mode);
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetImageSampleDistance(1.0f);
  mapper->SetSampleDistance(static_cast<float>(stage.VoxelSize()));
  return std::make_unique<Peer>(stage, "vtkFixedPointVolumeRayCastMapper", mapper);
}

std::unique_ptr<Way> Gpu(const Stage& stage, int mode)
{
  const auto mapper = vtkSmartPointer<vtkGPUVolumeRayCastMapper>::New();
  mapper->SetBlendMode(mode);
  mapper->AutoAdjustSampleDistancesOff();
  mapper->UseJitteringOff();
  mapper->SetSampleDistance(static_cast<float>(stage.VoxelSize()));
  auto way = std::make_unique<Peer>(stage, "vtkGPUVolumeRayCastMapper", mapper);
  way->IsSlow = true;
  return way;
}

}

std::vector<std::unique_ptr<Way>> All(const Stage& stage, int mode, bool hasWindow)
{
  std::vector<std::unique_ptr<Way>> ways;
  ways.push_back(std::make_unique<Ours>(stage, mode, true));
  ways.push_back(std::make_unique<Ours>(stage, mode, false));
  if (hasWindow)
  {
    ways.push_back(FixedPoint(stage, mode));
    ways.push_back(Gpu(stage, mode));
  }
  return ways;
}

}
