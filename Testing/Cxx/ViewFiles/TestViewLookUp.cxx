// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Wherever a view is sure, its depths are those of the mapper's isomap, bit for bit, and those of
// the cold picture within the tolerance: for all types of samples, places of volumes, cameras and
// cuts.

#include "ViewScene.h"
#include "Volumes/Volumes.h"

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkPlane.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <numeric>

namespace
{

constexpr int Width = 61, Height = 47; // with tiles that are not full
constexpr int Steps = 17;

/// A volume in a scene, and the isovalues to write.
struct Case
{
  std::string Name;
  vtkSmartPointer<vtkImageData> Image;
  double Low, High;
  std::function<void(Scene&)> Arrange;
  double Tolerance = 0.1;
};

/// What a look-up is compared with.
class Judge
{
public:
  Judge(const Case& subject, ViewScene& scene)
    : Subject(subject)
    , Of(scene)
  {
    for (vtkTemporalCoherenceVolumeMapper* mapper : { this->Cold.Get(), this->Mapped.Get() })
    {
      mapper->SetInputData(subject.Image);
      mapper->SetClippingPlanes(scene.Mapper->GetClippingPlanes());
      mapper->SetCropping(scene.Mapper->GetCropping());
      mapper->SetCroppingRegionPlanes(scene.Mapper->GetCroppingRegionPlanes());
      mapper->SetCroppingRegionFlags(scene.Mapper->GetCroppingRegionFlags());
      mapper->SetAntialiasingToOff();
    }
    this->Cold->IsomapOff();
    this->Cold->ReuseFramesOff();
    double range[2];
    scene.View->GetRange(0, range);
    this->Mapped->SetIsomapRange(range);
    this->Mapped->SetIsomapTolerance(subject.Tolerance);
    this->Draw(this->Mapped, this->FromMap);
    scene.Volume->SetMapper(this->Mapped);
    Expect(this->Mapped->BuildIsomap(scene.Renderer, scene.Volume), subject.Name + ": built");
    scene.Volume->SetMapper(scene.Mapper);
    const double* const spacing = subject.Image->GetSpacing();
    this->Distance = 1.0001 * subject.Tolerance * *std::min_element(spacing, spacing + 3) +
      4e-7 * scene.Renderer->GetActiveCamera()->GetClippingRange()[1];
  }

  void Compare(double isovalue)
  {
    this->Of.SetIsovalues({ isovalue });
    Expect(this->Of.View->LookUp(0, isovalue, this->Found), this->Subject.Name + ": looked up");
    if (!this->Draw(this->Cold, this->Truth) || !this->Draw(this->Mapped, this->FromMap))
    {
      return;
    }
    const float* const depth = Floats(this->Found, "Depth");
    const float* const truth = Floats(this->Truth, "Depth");
    const float* const mapped = Floats(this->FromMap, "Depth");
    vtkDataArray* const answers = this->Found->GetPointData()->GetArray("Answer");
    for (vtkIdType pixel = 0; pixel < Width * Height; ++pixel)
    {
      this->Pixels += std::isfinite(truth[pixel]);
      const double answer = answers->GetTuple1(pixel);
      const bool isHit = std::isfinite(depth[pixel]);
      if (answer == 2.0)
      {
        ++this->Unsure;
        continue;
      }
      this->WrongAnswers += isHit != (answer == 1.0);
      this->Others += std::memcmp(depth + pixel, mapped + pixel, sizeof(float)) != 0;
      this->OtherMisses += isHit != std::isfinite(truth[pixel]);
      if (isHit && std::isfinite(truth[pixel]))
      {
        this->Farther +=
          std::abs(static_cast<double>(depth[pixel]) - truth[pixel]) > this->Distance;
        this->AddNormal(pixel);
      }
    }
  }

  void Tell() const
  {
    const auto expectNone = [this](int count, const std::string& what)
    {
      Expect(count == 0,
        this->Subject.Name + ": " + std::to_string(count) + " of " + std::to_string(this->Pixels) +
          " pixels " + what);
    };
    expectNone(this->WrongAnswers, "have an answer that does not fit their depth");
    expectNone(this->Others, "are sure, and not those of the isomap");
    expectNone(
      this->OtherMisses, "are sure, and hit where the truth misses, or the other way round");
    expectNone(this->Farther, "are farther from the truth than the tolerance");
    expectNone(this->BadNormals, "have a normal that has no unit length, or faces away");
    Expect(this->Pixels > 2000, this->Subject.Name + ": surfaces are seen");
    Expect(5 * this->Unsure < this->Pixels,
      this->Subject.Name + ": " + std::to_string(this->Unsure) + " pixels are unsure, of " +
        std::to_string(this->Pixels));
    std::vector<double> cosines = this->Cosines;
    std::sort(cosines.begin(), cosines.end());
    Expect(!cosines.empty() && cosines[cosines.size() / 2] > 0.998 &&
        cosines[cosines.size() / 10] > 0.95,
      this->Subject.Name + ": normals are those of the field: half within " +
        std::to_string(cosines.empty() ? 0.0 : cosines[cosines.size() / 2]) +
        ", nine tenths within " +
        std::to_string(cosines.empty() ? 0.0 : cosines[cosines.size() / 10]));
  }

private:
  static const float* Floats(vtkImageData* image, const char* name)
  {
    return static_cast<const float*>(image->GetPointData()->GetArray(name)->GetVoidPointer(0));
  }

  bool Draw(vtkTemporalCoherenceVolumeMapper* mapper, vtkImageData* image)
  {
    this->Of.Volume->SetMapper(mapper);
    const bool isDrawn =
      mapper->MakeImage(this->Of.Renderer, this->Of.Volume, Width, Height, image);
    Expect(isDrawn, this->Subject.Name + ": drawn");
    this->Of.Volume->SetMapper(this->Of.Mapper);
    return isDrawn;
  }

  void AddNormal(vtkIdType pixel)
  {
    const float* const found = Floats(this->Found, "Normals") + 3 * pixel;
    const float* const truth = Floats(this->Truth, "Normals") + 3 * pixel;
    const double length = std::sqrt(std::inner_product(found, found + 3, found, 0.0));
    this->BadNormals += std::abs(length - 1.0) > 1e-5;
    this->Cosines.push_back(std::inner_product(found, found + 3, truth, 0.0));
  }

  const Case& Subject;
  ViewScene& Of;
  double Distance;
  vtkNew<vtkTemporalCoherenceVolumeMapper> Cold, Mapped;
  vtkNew<vtkImageData> Found, Truth, FromMap;
  int Pixels = 0, Unsure = 0, WrongAnswers = 0, Others = 0, OtherMisses = 0, Farther = 0,
      BadNormals = 0;
  std::vector<double> Cosines;
};

void TestCase(const Case& subject, const ScratchFolder& folder)
{
  ViewScene scene(subject.Image, { 0.5 * (subject.Low + subject.High) });
  if (subject.Arrange)
  {
    subject.Arrange(scene);
  }
  scene.Writer->SetSize(Width, Height);
  scene.Writer->SetTolerance(subject.Tolerance);
  scene.Writer->SetRange(subject.Low, subject.High);
  const std::string path = folder / "case.tcview";
  const bool isGood = scene.Write(path) && scene.View->Read(path.c_str());
  Expect(isGood, subject.Name + ": written and read: " + scene.Said());
  if (!isGood)
  {
    return;
  }
  double range[2];
  scene.View->GetRange(0, range);
  Judge judge(subject, scene);
  for (int step = 0; step < Steps; ++step)
  {
    const double share = step / (Steps - 1.0);
    judge.Compare(step + 1 == Steps ? range[1] : range[0] + share * (range[1] - range[0]));
  }
  judge.Tell();
}

vtkSmartPointer<vtkImageData> Hills(int type)
{
  return Volumes::FromFormula(28, type,
    [](double x, double y, double z)
    { return 100.0 * std::sin(4.0 * x + y) * std::cos(3.0 * y) + 60.0 * std::sin(5.0 * z); });
}

void LookFromInside(Scene& scene)
{
  vtkCamera* const camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0.1, 0.05, 0.0);
  camera->SetFocalPoint(1.0, 0.4, 0.2);
  camera->SetViewAngle(70.0);
  camera->SetClippingRange(0.001, 10.0);
}

std::vector<Case> AllCases()
{
  std::vector<Case> cases = { { "bytes", Volumes::FourSpheres(32), 20.0, 200.0, {} },
    { "shorts", Volumes::Waves(), -1000.0, 1000.0, {} },
    { "floats", Hills(VTK_FLOAT), -120.0, 120.0, {} },
    { "doubles", Hills(VTK_DOUBLE), -120.0, 120.0, {} },
    { "noise", Volumes::Noise(10, VTK_UNSIGNED_CHAR, 20.0, 220.0), 60.0, 200.0, {} },
    { "small tolerance", Hills(VTK_FLOAT), -120.0, 120.0, {}, 0.02 },
    { "large tolerance", Hills(VTK_FLOAT), -120.0, 120.0, {}, 1.0 } };
  const auto slanted = Hills(VTK_FLOAT);
  slanted->SetSpacing(0.05, 0.08, 0.13);
  slanted->SetOrigin(3.0, -2.0, 1.0);
  // The tolerance is one of the shortest edges, in which fields along long ones are steep.
  cases.push_back({ "long voxels, rotated", slanted, -120.0, 120.0,
    [](Scene& scene)
    {
      scene.Volume->RotateX(30.0);
      scene.Volume->RotateZ(-50.0);
      scene.Renderer->ResetCamera();
    },
    0.5 });
  cases.push_back({ "parallel", Hills(VTK_FLOAT), -120.0, 120.0,
    [](Scene& scene) { scene.Renderer->GetActiveCamera()->ParallelProjectionOn(); } });
  cases.push_back({ "inside", Hills(VTK_FLOAT), -120.0, 120.0, LookFromInside });
  cases.push_back({ "clipped", Hills(VTK_FLOAT), -120.0, 120.0,
    [](Scene& scene)
    {
      vtkNew<vtkPlane> plane;
      plane->SetNormal(-1.0, -0.5, 0.2);
      plane->SetOrigin(0.2, 0.1, 0.0);
      scene.Mapper->AddClippingPlane(plane);
    } });
  cases.push_back({ "cropped", Hills(VTK_FLOAT), -120.0, 120.0,
    [](Scene& scene)
    {
      scene.Mapper->CroppingOn();
      scene.Mapper->SetCroppingRegionPlanes(-0.7, 0.8, -0.9, 0.6, -0.5, 0.9);
      scene.Mapper->SetCroppingRegionFlagsToSubVolume();
    } });
  return cases;
}

}

int TestViewLookUp(int, char*[])
{
  const ScratchFolder folder;
  for (const Case& subject : AllCases())
  {
    TestCase(subject, folder);
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
