// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Walks/FeatureWalk.h"

#include "Checks/Expect.h"
#include "Checks/Stopper.h"
#include "Truth/BruteForceTracer.h"
#include "Walks/FeatureChanges.h"

#include <vtkMath.h>
#include <vtkSMPTools.h>

#include <algorithm>
#include <array>
#include <cmath>

using Mapper = vtkTemporalCoherenceVolumeMapper;

FeatureWalk::FeatureWalk(unsigned seed)
  : ChangingScene(seed, 96)
  , Seed(seed)
{
}

void FeatureWalk::Go(const Habits& habits, int steps)
{
  this->Arrange();
  for (int step = 0; step < steps; ++step)
  {
    ++this->Steps;
    this->ChangeSome(habits);
    this->Step();
    if (this->CountHits() == 0 && this->Views.Pick(2) == 0)
    {
      // Where nothing is seen, nothing is tested.
      this->Arrange();
      const double x = this->Views.Between(-1.0, 1.0), y = this->Views.Between(-1.0, 1.0);
      this->Shown.LookFrom(x, y, 0.5);
      this->Shown.SetIsovalues({ this->Views.Between(-500.0, 900.0) });
    }
  }
}

std::string FeatureWalk::Where() const
{
  std::string what =
    "seed " + std::to_string(this->Seed) + ", step " + std::to_string(this->Steps) + " (";
  for (const std::string& feature : this->Features())
  {
    what += feature + ", ";
  }
  return what + this->Shown.Mapper->GetStatistics()->GetRouteAsString() + ")";
}

void FeatureWalk::Step()
{
  this->StopSometimes();
  Expect(this->Views.Render(), this->Where() + ": rendered");
  ExpectPromise(this->Shown, this->Cold, this->Where());
  this->ExpectSameColors();
  this->ExpectSameSurfaces();
  if (this->CountHits() > this->Shown.Depth->GetNumberOfPoints() / 50)
  {
    for (const std::string& feature : this->Features())
    {
      ++this->Counted[feature][this->Shown.Mapper->GetStatistics()->GetRouteAsString()];
    }
  }
  if (this->Views.Pick(12) == 0)
  {
    this->ExpectOnePicture();
  }
  if (this->Views.Pick(5) == 0)
  {
    this->ExpectSameLines();
  }
  if (this->Views.Pick(8) == 0)
  {
    ExpectRefined(this->Shown, this->Views, this->Cold, this->Where());
  }
}

/// A frame that is stopped leaves the last picture.
void FeatureWalk::StopSometimes()
{
  if (this->Steps < 2 || this->Views.Pick(10) != 0)
  {
    return;
  }
  vtkNew<vtkImageData> color, depth, after, depthAfter;
  this->Shown.GetLastFrame(color, depth);
  const Stopper stopper(this->Shown.Mapper, this->Views.Pick(4));
  if (!this->Views.Render())
  {
    ++this->Stopped;
    this->Shown.GetLastFrame(after, depthAfter);
    Expect(AreIdentical(color, after) && AreIdentical(depth, depthAfter),
      this->Where() + ": a stopped frame changed the last picture");
  }
}

/// Where the image cache finds the first surface, what is behind it is as in the cold picture.
void FeatureWalk::ExpectSameColors()
{
  Mapper* mapper = this->Shown.Mapper;
  if (!IsRoute(this->Shown, "ImageCache") || mapper->GetColorByAnswer() ||
    mapper->GetImageCacheShading() == Mapper::INTERPOLATE)
  {
    return;
  }
  const auto* here = static_cast<const float*>(this->Shown.Depth->GetScalarPointer());
  const auto* there = static_cast<const float*>(this->Cold.Depth->GetScalarPointer());
  const auto* shown = static_cast<const unsigned char*>(this->Shown.Color->GetScalarPointer());
  const auto* cold = static_cast<const unsigned char*>(this->Cold.Color->GetScalarPointer());
  int different = 0;
  for (vtkIdType i = 0; i < this->Shown.Depth->GetNumberOfPoints(); ++i)
  {
    const bool isSame = std::equal(shown + 4 * i, shown + 4 * i + 4, cold + 4 * i);
    different += here[i] == there[i] && !isSame;
  }
  Expect(different <= 3,
    this->Where() + ": other colours at " + std::to_string(different) + " of the same depths");
}

/// An exact picture has the isovalues and the normals of the cold one.
void FeatureWalk::ExpectSameSurfaces()
{
  if (!this->Cold.IsIdentical(this->Shown))
  {
    return;
  }
  vtkNew<vtkImageData> normals, indices, coldNormals, coldIndices;
  this->Shown.Mapper->GetLastFrame(normals, Mapper::FRAME_NORMALS);
  this->Shown.Mapper->GetLastFrame(indices, Mapper::FRAME_ISOVALUE_INDEX);
  this->Cold.Mapper->GetLastFrame(coldNormals, Mapper::FRAME_NORMALS);
  this->Cold.Mapper->GetLastFrame(coldIndices, Mapper::FRAME_ISOVALUE_INDEX);
  Expect(AreIdentical(indices, coldIndices), this->Where() + ": other isovalues");
  Expect(this->Shown.Mapper->GetIsomapShading() == Mapper::INTERPOLATE ||
      AreIdentical(normals, coldNormals),
    this->Where() + ": other normals");
}

/// A line of sight meets what its pixel shows in the cold picture.
void FeatureWalk::ExpectSameLines()
{
  int size[3];
  this->Cold.Depth->GetDimensions(size);
  for (int i = 0; i < 10; ++i)
  {
    const int x = this->Views.Pick(size[0]), y = this->Views.Pick(size[1]);
    const BruteForceTracer::Line line =
      BruteForceTracer::LineThrough(this->Shown.Renderer, x, y, size[0], size[1]);
    std::array<double, 3> begin, end, found, picked;
    for (std::size_t a = 0; a < 3; ++a)
    {
      begin[a] = line.Origin[a] + line.Begin * line.Direction[a];
      end[a] = line.Origin[a] + line.End * line.Direction[a];
    }
    double t;
    int isovalue = -1, expected = -1;
    this->Shown.Mapper->IntersectWithLine(
      this->Shown.Volume, begin.data(), end.data(), t, found.data(), nullptr, &isovalue);
    this->Cold.Mapper->PickPixel(x, y, picked.data(), nullptr, &expected);
    ++this->Lines;
    this->LinesHit += expected >= 0;
    const bool isSame = isovalue == expected &&
      (expected < 0 ||
        std::sqrt(vtkMath::Distance2BetweenPoints(found.data(), picked.data())) < 1e-5);
    this->OtherLines += !isSame;
    if (!isSame)
    {
      std::cout << this->Where() << ": a line meets " << isovalue << ", pixel (" << x << ", " << y
                << ") shows " << expected << "\n";
    }
  }
}

vtkIdType FeatureWalk::CountHits() const
{
  const auto* depths = static_cast<const float*>(this->Shown.Depth->GetScalarPointer());
  return std::count_if(depths, depths + this->Shown.Depth->GetNumberOfPoints(),
    [](float depth) { return std::isfinite(depth); });
}

/// By any number of threads, with and without leaping.
void FeatureWalk::ExpectOnePicture()
{
  ColdWitness other;
  other.Mapper->SpaceLeapingOff();
  const int threads = vtkSMPTools::GetEstimatedNumberOfThreads();
  vtkSMPTools::Initialize(1 + this->Views.Pick(5));
  Expect(other.Draw(this->Shown), this->Where() + ": rendered without leaping");
  Expect(AreIdentical(other.Color, this->Cold.Color) && AreIdentical(other.Depth, this->Cold.Depth),
    this->Where() + ": another picture by other threads, without leaping");
  vtkSMPTools::Initialize(threads);
}

void FeatureWalk::ComeHome()
{
  FeatureChanges::SwitchOff(this->Shown);
  this->Inputs.Changes().back().Make();
  this->Inputs.Show(ManyInputs::InImage, ManyInputs::OfPoints);
  Scene plain(this->Inputs.Image, { 0.0 });
  plain.Renderer->SetActiveCamera(this->Shown.Renderer->GetActiveCamera());
  this->Shown.LookFrom(0.7, -1.0, 0.5);
  // Without a range, isomaps are built by the time they take.
  this->Shown.Mapper->SetIsomapRange(50.0, 120.0);
  plain.Mapper->SetIsomapRange(50.0, 120.0);
  // First from wherever it comes, then from nothing: each frame costs what it costs a new mapper.
  for (const bool isNew : { false, true })
  {
    if (isNew)
    {
      this->Shown.Mapper->ClearCache();
      plain.Mapper->ClearCache();
    }
    for (int frame = 0; frame < 12; ++frame)
    {
      vtkCamera* camera = plain.Renderer->GetActiveCamera();
      camera->Azimuth(frame < 5 ? 1.0 : 0.0);
      for (Scene* scene : { &this->Shown, &plain })
      {
        scene->SetIsovalues({ frame < 6 ? 0.0 : 10.0 * frame });
        Expect(scene->Render(120, 100), "rendered at home");
      }
      const std::string what = "seed " + std::to_string(this->Seed) + ", at home, frame " +
        std::to_string(frame) + (isNew ? ", new" : "");
      Mapper* a = this->Shown.Mapper;
      Mapper* b = plain.Mapper;
      if (isNew || frame == 5)
      {
        Expect(AreIdentical(this->Shown.Color, plain.Color) &&
            AreIdentical(this->Shown.Depth, plain.Depth),
          what + ": not the picture of a new mapper");
      }
      if (isNew)
      {
        Expect(a->GetStatistics()->GetRoute() == b->GetStatistics()->GetRoute() &&
            a->GetStatistics()->GetNumberOfTracedRays() ==
              b->GetStatistics()->GetNumberOfTracedRays() &&
            a->GetStatistics()->GetNumberOfFieldSamples() ==
              b->GetStatistics()->GetNumberOfFieldSamples() &&
            a->GetStatistics()->GetNumberOfDefiniteHits() ==
              b->GetStatistics()->GetNumberOfDefiniteHits() &&
            a->GetStatistics()->GetIsomapMemory() == b->GetStatistics()->GetIsomapMemory(),
          what + ": not at the cost of a new mapper");
      }
    }
  }
}
