// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshPeers.h"

#include "Measuring.h"
#include "OffScreenWindow.h"
#include "Report.h"
#include "SampleMeshes.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkContour3DLinearGrid.h>
#include <vtkContourFilter.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkResampleToImage.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace MeshPeers
{
namespace
{

/// Samples that vtkResampleToImage makes in some seconds; it takes microseconds for each.
constexpr double MostResampled = 4e6;

constexpr double ManyCells = 1e6;
constexpr int RoundsOfSlow = 3; ///< of contour filters and many cells, one is enough

Stage StageOf(const Subject& subject, vtkDataSet* data)
{
  return Stage(data, subject.Isovalue, subject.Size, subject.From);
}

/// This mapper, with a mesh or an image.
class Cast : public Way
{
public:
  Cast(const std::string& who, const Subject& subject, vtkDataSet* data)
    : Way(who)
    , Scene(StageOf(subject, data))
    , Caster(this->Scene)
  {
  }

  void SetIsovalue(double isovalue) override { this->Scene.SetIsovalue(isovalue); }
  void SetCamera(vtkCamera* camera) override
  {
    this->Scene.Renderer->GetActiveCamera()->DeepCopy(camera);
  }
  double Draw() override { return this->Caster.Draw(this->Scene); }
  double DrawCold() override { return this->Caster.DrawCold(this->Scene); }
  const Drawer* Ours() const override { return &this->Caster; }
  double PercentDrawn() override { return PercentHit(this->Caster); }

private:
  Stage Scene;
  Drawer Caster;
};

/// A filter that makes triangles, and a window that shows them if there is one.
template <typename Filter>
class Polygons : public Way
{
public:
  Polygons(const std::string& who, const Subject& subject, bool hasWindow)
    : Way(who + (hasWindow ? " + vtkPolyDataMapper" : ", not drawn"))
    , Scene(StageOf(subject, subject.Mesh))
  {
    this->Contour->SetInputData(subject.Mesh);
    this->Contour->SetValue(0, subject.Isovalue);
    this->Contour->UseScalarTreeOn();
    this->Contour->ComputeScalarsOff();
    this->Memory = Measuring::None;
    if (hasWindow)
    {
      this->Mapper->ScalarVisibilityOff();
      vtkNew<vtkActor> actor;
      actor->SetMapper(this->Mapper);
      this->Scene.Renderer->AddViewProp(actor);
      this->Window = std::make_unique<OffScreenWindow>(this->Scene.Renderer, subject.Size);
    }
  }

  void SetIsovalue(double isovalue) override
  {
    this->Contour->SetValue(0, isovalue);
    this->IsMade = false;
  }
  void SetCamera(vtkCamera* camera) override
  {
    this->Scene.Renderer->GetActiveCamera()->DeepCopy(camera);
  }
  double Draw() override
  {
    return Measuring::TimeOf(
      [this]
      {
        // Not by the pipeline: with a scalar tree the filter would run for each frame.
        if (!this->IsMade)
        {
          this->Contour->Update();
          this->Mapper->SetInputDataObject(this->Contour->GetOutputDataObject(0));
          this->IsMade = true;
        }
        if (this->Window)
        {
          this->Window->Draw();
        }
      });
  }
  double PercentDrawn() override
  {
    return this->Window ? this->Window->PercentDrawn() : Measuring::None;
  }

  vtkNew<Filter> Contour;

private:
  Stage Scene;
  vtkNew<vtkPolyDataMapper> Mapper;
  std::unique_ptr<OffScreenWindow> Window;
  bool IsMade = false;
};

std::unique_ptr<Way> Linear(const Subject& subject, bool hasWindow, bool isSmooth)
{
  auto way = std::make_unique<Polygons<vtkContour3DLinearGrid>>(
    std::string("vtkContour3DLinearGrid (scalar tree, ") +
      (isSmooth ? "points merged, normals)" : "flat)"),
    subject, hasWindow);
  way->Contour->SetMergePoints(isSmooth);
  way->Contour->SetComputeNormals(isSmooth);
  return way;
}

/// The mesh as an image of as many bytes. Those of generated meshes are samples of the formula
/// itself, which is better than resampling can be; of others so many samples that it ends.
std::unique_ptr<Way> Resampled(const Subject& subject)
{
  const double* b = subject.Mesh->GetBounds();
  const std::array<double, 3> edges = { b[1] - b[0], b[3] - b[2], b[5] - b[4] };
  const bool isGenerated = SampleMeshes::IsGenerated(subject.Name);
  const double bytes = 1024.0 * static_cast<double>(subject.Mesh->GetActualMemorySize());
  const double samples =
    std::min(bytes / static_cast<double>(sizeof(float)), isGenerated ? HUGE_VAL : MostResampled);
  const double spacing = std::cbrt(edges[0] * edges[1] * edges[2] / samples);
  std::array<int, 3> n{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    n[axis] = std::max(2, static_cast<int>(edges[axis] / spacing) + 1);
  }
  vtkSmartPointer<vtkImageData> image;
  const double time = Measuring::TimeOf(
    [&]
    {
      if (isGenerated)
      {
        image = SampleMeshes::Image(n[0]);
        return;
      }
      vtkNew<vtkResampleToImage> resample;
      resample->SetInputDataObject(subject.Mesh);
      resample->SetSamplingDimensions(n.data());
      resample->Update();
      image = resample->GetOutput();
      image->GetPointData()->SetActiveScalars(
        subject.Mesh->GetPointData()->GetScalars()->GetName());
    });
  const std::string size =
    std::to_string(n[0]) + " x " + std::to_string(n[1]) + " x " + std::to_string(n[2]);
  auto way = std::make_unique<Cast>(
    (isGenerated ? "an image of the formula, " : "vtkResampleToImage, ") + size + ", this mapper",
    subject, image);
  way->Memory = 1024.0 * static_cast<double>(image->GetActualMemorySize());
  way->Remark = isGenerated ? "" : Fixed(1e-3 * time, 1) + " s to resample";
  return way;
}

}

double Way::DrawCold()
{
  return Measuring::None;
}

std::vector<std::unique_ptr<Way>> All(const Subject& subject, bool hasWindow)
{
  std::vector<std::unique_ptr<Way>> ways;
  ways.push_back(std::make_unique<Cast>("this mapper", subject, subject.Mesh));
  const bool isLarge = static_cast<double>(subject.Mesh->GetNumberOfCells()) > ManyCells;
  if (vtkUnstructuredGrid::SafeDownCast(subject.Mesh))
  {
    ways.push_back(Linear(subject, hasWindow, false));
    ways.push_back(Linear(subject, hasWindow, true));
  }
  auto contour =
    std::make_unique<Polygons<vtkContourFilter>>("vtkContourFilter", subject, hasWindow);
  contour->Contour->UseScalarTreeOff();
  contour->SlowerBy = isLarge ? RoundsOfSlow : 1;
  ways.push_back(std::move(contour));
  ways.push_back(Resampled(subject));
  return ways;
}

}
