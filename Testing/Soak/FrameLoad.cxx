// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameLoad.h"

#include "Checks/Stopper.h"
#include "Truth/BruteForceTracer.h"

#include <array>
#include <sstream>

void FrameLoad::DoOnce()
{
  static const std::array<Habits, 4> all = { Habits::MovingOn(), Habits::StandingStill(),
    Habits::Dressing(), Habits::Restless() };
  constexpr long FramesOfOne = 25;
  if (this->Frames % FramesOfOne == 0)
  {
    this->Scene.Arrange();
  }
  this->Scene.ChangeSome(all[static_cast<std::size_t>(this->Frames / FramesOfOne) % all.size()]);
  if (this->Frames > 0 && this->Scene.Views.Pick(10) == 0)
  {
    const Stopper stopper(this->Scene.Shown.Mapper, this->Scene.Views.Pick(4));
    this->Stopped += this->Scene.Views.Render() ? 0 : 1;
  }
  ++this->Frames;
  Expect(this->Scene.Views.Render(), "frame " + std::to_string(this->Frames) + ": rendered");
  ++this->Routes[this->Scene.Shown.Mapper->GetStatistics()->GetRouteAsString()];
  this->Features.merge(this->Scene.Features());
  if (this->Scene.Views.Pick(5) == 0)
  {
    this->Ask();
  }
}

/// What can be asked of a frame that is there.
void FrameLoad::Ask()
{
  struct Scene& shown = this->Scene.Shown;
  vtkNew<vtkImageData> frame;
  shown.Mapper->GetLastFrame(frame);
  int size[3];
  shown.Depth->GetDimensions(size);
  const int x = this->Scene.Views.Pick(size[0]), y = this->Scene.Views.Pick(size[1]);
  this->Picked += shown.Mapper->PickPixel(x, y, nullptr, nullptr, nullptr) ? 1 : 0;
  const BruteForceTracer::Line line =
    BruteForceTracer::LineThrough(shown.Renderer, x, y, size[0], size[1]);
  std::array<double, 3> begin, end, found;
  for (std::size_t a = 0; a < 3; ++a)
  {
    begin[a] = line.Origin[a] + line.Begin * line.Direction[a];
    end[a] = line.Origin[a] + line.End * line.Direction[a];
  }
  double t;
  shown.Mapper->IntersectWithLine(
    shown.Volume, begin.data(), end.data(), t, found.data(), nullptr, nullptr);
}

std::string FrameLoad::Describe() const
{
  std::ostringstream text;
  text << this->Stopped << " stopped, " << this->Picked << " picked, " << this->Features.size()
       << " features;";
  for (const auto& [route, count] : this->Routes)
  {
    text << ' ' << route << ' ' << count;
  }
  return text.str();
}

bool FrameLoad::HasReachedAll() const
{
  // Cold, Redisplay, Reshade, ImageCache, IsomapBuild and IsomapLookup.
  constexpr std::size_t AllRoutes = 6, AllFeatures = 18;
  return this->Routes.size() >= AllRoutes && this->Features.size() >= AllFeatures &&
    this->Stopped > 0 && this->Picked > 0;
}
