// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Runs/Acts.h"

#include "Checks/Meddler.h"
#include "World/Inputs.h"

#include <vtkPolyData.h>

#include <limits>

namespace Fuzz
{
namespace Acts
{
namespace
{

/// What observers must not do: it is refused.
void DoWhatIsForbidden(World& world)
{
  Mapper* mapper = world.Subject;
  vtkNew<vtkImageData> color;
  double t;
  const double p1[3] = { -9.0, 1.0, 2.0 }, p2[3] = { 9.0, 3.0, 2.0 };
  switch (world.From.Pick(5))
  {
    case 0:
      Require(!mapper->MakeImage(world.Renderer(), world.Volume(), 9, 9, color, nullptr),
        "a frame within a frame");
      break;
    case 1:
      Require(!mapper->BuildIsomap(world.Renderer(), world.Volume()), "an isomap within a frame");
      break;
    case 2:
      mapper->ClearCache();
      break;
    case 3:
      Require(!mapper->IntersectWithLine(world.Volume(), p1, p2, t, nullptr, nullptr, nullptr),
        "a line within a frame");
      break;
    default:
      mapper->Render(world.Renderer(), world.Volume());
      break;
  }
}

/// What observers may do, odd as it is.
void DoWhatIsAllowed(World& world)
{
  Mapper* mapper = world.Subject;
  vtkNew<vtkImageData> color;
  vtkNew<vtkPolyData> points;
  switch (world.From.Pick(8))
  {
    case 6:
      mapper->SetInputDataObject(nullptr);
      mapper->IsOpaque(world.Volume());
      break;
    case 7:
      mapper->SetInputDataObject(Inputs::MakeAny(world));
      mapper->GetBounds();
      mapper->ReleaseGraphicsResources(nullptr);
      break;
    case 0:
      mapper->GetLastFrame(color, Mapper::FRAME_COLOR);
      break;
    case 1:
      mapper->GetVisibleSurface(points);
      break;
    case 2:
      mapper->PickPixel(3, 3, nullptr, nullptr, nullptr);
      break;
    case 3:
      mapper->GetBounds();
      mapper->IsOpaque(world.Volume());
      break;
    case 4:
      mapper->GetStatistics()->GetRouteAsString();
      mapper->GetStatistics()->GetNumberOfFieldSamples();
      break;
    default:
      mapper->SetIsomapTolerance(0.3);
      mapper->SetIsomapTolerance(0.0);
      break;
  }
}

}

void Interrupt(World& world, Oracle& oracle, Tally& tally)
{
  Bytes& from = world.From;
  Mapper* mapper = world.Subject;
  if (from.OneIn(4))
  {
    // An isomap that is stopped. (Its progress falls where the pipeline has reported its own
    // before.)
    const Meddler stopper(
      mapper, vtkCommand::ProgressEvent, from.Pick(12), [&] { mapper->SetAbortExecute(1); });
    mapper->BuildIsomap(world.Renderer(), world.Volume());
    oracle.ExpectOneErrorAtMost("a stopped isomap");
    oracle.ExpectLastPicture("after a stopped isomap");
    return;
  }
  const int report = from.Pick(from.OneIn(3) ? 40 : 6);
  const int kind = from.Pick(3);
  const unsigned long event = vtkCommand::VolumeMapperRenderProgressEvent;
  if (kind == 0)
  {
    Picture none;
    bool isMade = false, isStopped = false;
    {
      const Meddler stopper(mapper, event, report, [&] { mapper->SetAbortExecute(1); });
      isMade = none.Render(world, mapper);
      isStopped = stopper.IsDone;
      Require(stopper.IsRising, "the progress of a frame falls");
    }
    Story::Tell("  at report ", report, isStopped ? ", stopped, " : ", not stopped, ",
      isMade ? "made" : "not made");
    if (isMade)
    {
      oracle.TakeFrame(none);
    }
    else
    {
      tally.Acts["stopped"] += isStopped;
      if (isStopped)
      {
        oracle.ExpectNoError("a stopped frame");
      }
      oracle.ExpectOneErrorAtMost("a frame that may be stopped");
      oracle.ExpectLastPicture("after a stop");
    }
    return;
  }
  Picture picture;
  bool isMade = false, isForbidden = false;
  {
    const Meddler meddler(mapper, event, report,
      [&]
      {
        isForbidden = kind == 2;
        kind == 2 ? DoWhatIsForbidden(world) : DoWhatIsAllowed(world);
      });
    isMade = picture.Render(world, mapper);
    Require(meddler.IsRising, "the progress of a frame falls");
  }
  oracle.ExpectErrorsAtMost(isForbidden ? 2 : 1, "a frame that is meddled with");
  if (isMade)
  {
    oracle.TakeFrame(picture);
  }
  else
  {
    oracle.ExpectLastPicture("after a frame that was meddled with");
  }
}

void AskInVain(World& world, Oracle& oracle)
{
  Bytes& from = world.From;
  Mapper* mapper = world.Subject;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double p1[3] = { 0.0, 0.0, 0.0 };
  double t;
  vtkNew<vtkImageData> image;
  switch (from.Pick(10))
  {
    case 0:
      Require(!mapper->MakeImage(nullptr, world.Volume(), 9, 9, nullptr, nullptr), "no renderer");
      break;
    case 1:
      Require(!mapper->MakeImage(world.Renderer(), nullptr, 9, 9, image, nullptr), "no volume");
      break;
    case 2:
      Require(!mapper->BuildIsomap(nullptr, world.Volume()), "no renderer");
      break;
    case 3:
      Require(!mapper->IntersectWithLine(world.Volume(), p1, p1, t, nullptr, nullptr, nullptr),
        "no line");
      break;
    case 4:
      Require(
        !mapper->IntersectWithLine(nullptr, p1, p1, t, nullptr, nullptr, nullptr), "no volume");
      break;
    case 5:
      mapper->SetIsomapTolerance(nan);
      break;
    case 6:
      mapper->SetImageSampleDistance(static_cast<float>(nan));
      break;
    case 7:
      mapper->SetMaximumImageSampleDistance(static_cast<float>(nan));
      break;
    case 8:
      Require(!mapper->GetVisibleSurface(nullptr), "no polygons");
      break;
    default:
      Require(!mapper->GetLastFrame(nullptr), "no image");
      mapper->PickPixel(from.WildInt(), from.WildInt(), nullptr, nullptr, nullptr);
      break;
  }
  oracle.ExpectOneErrorAtMost("a question in vain");
  oracle.ExpectLastPicture("after a question in vain");
}

}
}
