// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Runs/Acts.h"

#include "vtkTemporalCoherencePicker.h"

#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cmath>
#include <cstring>
#include <sstream>

namespace Fuzz
{
namespace Acts
{
namespace
{

void BuildIsomap(World& world, Oracle& oracle)
{
  const bool isBuilt = world.Subject->BuildIsomap(world.Renderer(), world.Volume());
  Story::Tell("  an isomap is ", isBuilt ? "built" : "not built");
  if (isBuilt)
  {
    oracle.ExpectNoError("BuildIsomap");
  }
  oracle.ExpectOneErrorAtMost("BuildIsomap");
  oracle.ExpectLastPicture("after BuildIsomap");
}

void ReplaceMapper(World& world, Oracle& oracle)
{
  const auto next = oracle.MakeFresh();
  next->ReuseFramesOn();
  next->IsomapOn();
  world.Subject = next;
  for (const auto& volume : world.Volumes)
  {
    volume->SetMapper(next);
  }
  oracle.BeginAnew();
  world.HasSilentChange = false;
}

void ReplaceVolume(World& world)
{
  const auto next = vtkSmartPointer<vtkVolume>::New();
  if (!world.From.OneIn(4))
  {
    next->SetMapper(world.Subject); // which MakeImage does not look at
  }
  next->SetProperty(world.Property());
  for (const auto& renderer : world.Renderers)
  {
    renderer->RemoveVolume(world.Volume());
    renderer->AddVolume(next);
  }
  world.Volumes[world.AtVolume] = next;
}

void ReplaceRenderer(World& world)
{
  const auto next = vtkSmartPointer<vtkRenderer>::New();
  next->SetActiveCamera(world.Camera());
  next->AddVolume(world.Volume());
  world.Renderers[world.AtRenderer] = next;
}

/// Samples that were written in secret are known from now on.
void TellLate(World& world)
{
  if (vtkDataObject* data = world.Subject->GetDataObjectInput())
  {
    data->Modified();
  }
  if (vtkImageData* image = world.Image())
  {
    image->Modified();
  }
  world.Shelf.clear();
  world.Subject->ClearCache();
  world.HasSilentChange = false;
}

void AskEverything(World& world)
{
  std::ostringstream text;
  world.Subject->PrintSelf(text, vtkIndent());
  world.Subject->IsOpaque(world.Volume());
  world.Subject->GetBounds();
  world.Volume()->HasOpaqueGeometry();
  world.Volume()->HasTranslucentPolygonalGeometry();
  world.Subject->ReleaseGraphicsResources(nullptr);
  Require(text.str().size() > 100, "PrintSelf says little");
}

/// The pixels of the last picture, one by one.
void PickPixels(World& world, Oracle& oracle)
{
  const Picture& last = oracle.Last();
  if (last.IsEmpty() || oracle.IsLastRefused())
  {
    return;
  }
  int size[3];
  last.Frame->GetDimensions(size);
  for (int i = 0; i < 6; ++i)
  {
    const int x = world.From.Pick(size[0] + 1) - world.From.OneIn(20),
              y = world.From.Pick(size[1] + 1);
    double position[3] = { 0.0, 0.0, 0.0 }, normal[3];
    int isovalue = -7;
    const bool isHit = world.Subject->PickPixel(x, y, position, normal, &isovalue);
    const bool isInside = x >= 0 && y >= 0 && x < size[0] && y < size[1];
    const int shown = isInside ? last.IsovalueAt(x, y) : -1;
    const bool isSeen = isInside && last.IsHit(y * static_cast<vtkIdType>(size[0]) + x);
    Require(isHit == isSeen && isovalue == (isHit ? shown : -7),
      "pixel " + std::to_string(x) + ", " + std::to_string(y) + " shows isovalue " +
        std::to_string(shown) + ", but picked is " + std::to_string(isovalue));
    Require(!std::isnan(position[0] + position[1] + position[2]), "what is picked is nowhere");
  }
}

void FindVisibleSurface(World& world, Oracle& oracle)
{
  vtkNew<vtkPolyData> points;
  const bool isThere = world.Subject->GetVisibleSurface(points);
  if (!oracle.Last().IsEmpty() && oracle.Last().IsBlended)
  {
    Require(!isThere || oracle.IsLastRefused(), "a blended volume has a visible surface");
    oracle.ExpectOneErrorAtMost("GetVisibleSurface");
    return;
  }
  Require(isThere == !oracle.Last().IsEmpty() || oracle.IsLastRefused(),
    "GetVisibleSurface and the last frame");
  if (isThere && !oracle.Last().IsEmpty())
  {
    Require(points->GetNumberOfPoints() == oracle.Last().CountHits() &&
        points->GetNumberOfVerts() == points->GetNumberOfPoints(),
      "the visible surface has " + std::to_string(points->GetNumberOfPoints()) + " points");
  }
}

/// The first surface on a line, which a mapper without a past finds where this one does.
void MeetLine(World& world, Oracle& oracle)
{
  Bytes& from = world.From;
  double ends[2][3];
  double bounds[6];
  world.Volume()->GetBounds();
  world.Subject->GetBounds(bounds);
  for (auto& end : ends)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool isThere =
        std::isfinite(bounds[2 * axis]) && bounds[2 * axis] <= bounds[2 * axis + 1];
      const double low = isThere ? bounds[2 * axis] : -1.0,
                   high = isThere ? bounds[2 * axis + 1] : 9.0;
      end[axis] = from.IsWild() ? from.Wild() : low + from.Between(-0.5, 1.5) * (high - low);
    }
  }
  Story::Tell("  a line from ", ends[0][0], ", ", ends[0][1], ", ", ends[0][2], " to ", ends[1][0],
    ", ", ends[1][1], ", ", ends[1][2]);
  const auto fresh = oracle.MakeFresh();
  const Ear ear(fresh);
  struct Met
  {
    double T = -1.0, Position[3] = { 0.0, 0.0, 0.0 }, Normal[3] = { 0.0, 0.0, 0.0 };
    int Isovalue = -1;
    bool Is = false;
  };
  Met met[2];
  Mapper* mappers[2] = { world.Subject, fresh };
  for (int i = 0; i < 2; ++i)
  {
    met[i].Is = mappers[i]->IntersectWithLine(
      world.Volume(), ends[0], ends[1], met[i].T, met[i].Position, met[i].Normal, &met[i].Isovalue);
  }
  oracle.ExpectOneErrorAtMost("IntersectWithLine");
  Require(ear.Errors <= 1 && !(ear.Errors == 1 && met[1].Is), "IntersectWithLine: " + ear.Text);
  if (world.HasSilentChange)
  {
    return;
  }
  Require(met[0].Is == met[1].Is && met[0].T == met[1].T && met[0].Isovalue == met[1].Isovalue &&
      std::memcmp(met[0].Position, met[1].Position, sizeof(met[0].Position)) == 0 &&
      std::memcmp(met[0].Normal, met[1].Normal, sizeof(met[0].Normal)) == 0,
    "a line meets isovalue " + std::to_string(met[0].Isovalue) + " at " + std::to_string(met[0].T) +
      ", without a past " + std::to_string(met[1].Isovalue) + " at " + std::to_string(met[1].T));
  Require(!met[0].Is || (met[0].T >= 0.0 && met[0].T <= 1.0),
    "a line is met at " + std::to_string(met[0].T));
}

void UsePicker(World& world, Oracle& oracle)
{
  Bytes& from = world.From;
  vtkNew<vtkTemporalCoherencePicker> picker;
  picker->SetPickCroppingPlanes(from.OneIn(4));
  picker->SetPickClippingPlanes(from.OneIn(4));
  double p1[3], p2[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    p1[axis] = from.Number(-20.0, 20.0);
    p2[axis] = from.Number(0.0, 8.0);
  }
  picker->Pick3DPoint(p1, p2, world.Renderer());
  oracle.ExpectErrorsAtMost(2, "vtkTemporalCoherencePicker"); // one for each volume
  Story::Tell("  picked isovalue ", picker->GetIsovalueIndex(), " in cell ", picker->GetCellId());
}

}

void Before(World& world, Oracle& oracle, Tally& tally)
{
  const auto count = [&](const char* act)
  {
    ++tally.Acts[act];
    Story::Tell(act);
  };
  if (world.HasSilentChange && world.From.OneIn(3))
  {
    count("told late");
    TellLate(world);
    oracle.ForgetFrames();
  }
  switch (world.From.Pick(world.About == Theme::Sweep ? 40 : 64))
  {
    case 2:
    case 3:
      count("BuildIsomap");
      BuildIsomap(world, oracle);
      break;
    case 4:
      count("ClearCache");
      world.Subject->ClearCache();
      oracle.ExpectNoError("ClearCache");
      oracle.ForgetFrames();
      break;
    case 5:
      count("another mapper");
      ReplaceMapper(world, oracle);
      break;
    case 6:
      count("another volume");
      ReplaceVolume(world);
      break;
    case 7:
      count("another renderer");
      ReplaceRenderer(world);
      break;
    case 8:
    case 9:
      count("interrupted");
      Interrupt(world, oracle, tally);
      break;
    case 10:
      count("asked in vain");
      AskInVain(world, oracle);
      break;
    default:
      break;
  }
}

void After(World& world, Oracle& oracle, Tally& tally)
{
  const auto count = [&](const char* act)
  {
    ++tally.Acts[act];
    Story::Tell(act);
  };
  switch (world.From.Pick(32))
  {
    case 2:
      count("PickPixel");
      PickPixels(world, oracle);
      break;
    case 3:
      count("GetVisibleSurface");
      FindVisibleSurface(world, oracle);
      break;
    case 4:
    case 5:
      count("IntersectWithLine");
      MeetLine(world, oracle);
      break;
    case 6:
      count("picker");
      UsePicker(world, oracle);
      break;
    case 7:
      count("asked everything");
      AskEverything(world);
      oracle.ExpectNoError("questions");
      break;
    case 8:
      oracle.ExpectLastPicture("asked again");
      break;
    default:
      break;
  }
}

}
}
