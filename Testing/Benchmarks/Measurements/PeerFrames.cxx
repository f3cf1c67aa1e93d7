// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PeerFrames.h"

#include "Measuring.h"
#include "OffScreenWindow.h"
#include "Peers.h"

#include <vtkFlyingEdges3D.h>

#include <algorithm>
#include <functional>

namespace PeerFrames
{
namespace
{

using Measuring::None;

constexpr double Degrees = 2.0; ///< of the orbit, a frame
constexpr int FewestFrames = 3;
constexpr int FewestGpuFrames = 2;

/// New views around the stage, and then new isovalues in the last one. A first frame, which makes
/// what all others need, is not measured.
void TimeFrames(Stage& stage, int frames, const std::function<void(double)>& setIsovalue,
  const std::function<double()>& draw, Times& times)
{
  const double isovalue = stage.Isovalue();
  std::vector<double> views, isovalues;
  stage.ResetView();
  setIsovalue(isovalue);
  draw();
  for (int frame = 0; frame < frames; ++frame)
  {
    stage.Orbit(Degrees);
    views.push_back(draw());
  }
  for (int frame = 0; frame < frames; ++frame)
  {
    setIsovalue(isovalue + stage.SweepStep(frame));
    isovalues.push_back(draw());
  }
  setIsovalue(isovalue);
  times.NewView = Measuring::Median(views);
  times.NewIsovalue = Measuring::Median(isovalues);
}

Times OursWithoutWindow(Stage& stage, int frames)
{
  Times times{ "vtkTemporalCoherenceVolumeMapper, no window", true, stage.Size };
  Drawer drawer(stage);
  drawer.Mapper->ImageCacheOff();
  TimeFrames(
    stage, frames, [&stage](double isovalue) { stage.SetIsovalue(isovalue); },
    [&] { return drawer.Draw(stage); }, times);
  times.PercentDrawn = PercentHit(drawer);
  return times;
}

/// Triangles that nobody draws.
Times Extraction(Stage& stage, int frames)
{
  Times times{ "vtkFlyingEdges3D, not drawn", false, stage.Size };
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(stage.Image);
  contour->ComputeNormalsOn();
  contour->ComputeScalarsOff();
  TimeFrames(
    stage, frames, [&contour](double isovalue) { contour->SetValue(0, isovalue); },
    [&contour] { return Measuring::TimeOf([&contour] { contour->Update(); }); }, times);
  times.NewView = None;
  times.PercentDrawn = None;
  return times;
}

Times InWindow(Stage& stage, int frames, bool hasWindow, const Peers::Peer& peer)
{
  Times times{ peer.Name, false, stage.Size, None, None, None };
  if (hasWindow)
  {
    stage.Renderer->AddViewProp(peer.Prop);
    OffScreenWindow window(stage.Renderer, stage.Size);
    TimeFrames(
      stage, frames, peer.SetIsovalue, [&window] { return window.Draw(); }, times);
    times.PercentDrawn = window.PercentDrawn();
    stage.Renderer->RemoveViewProp(peer.Prop);
  }
  return times;
}

Times OursInWindow(Stage& stage, int frames, bool hasWindow)
{
  Times times = InWindow(stage, frames, hasWindow, Peers::Ours(stage));
  times.IsOurs = true;
  return times;
}

}

std::vector<Times> Measure(Stage& stage, int frames, bool hasWindow)
{
  const int fewer = std::max(FewestFrames, frames / 4);
  Stage small(stage.Image, stage.Isovalue(), std::min(stage.Size, SmallSize));
  return { OursWithoutWindow(stage, frames), Extraction(stage, fewer),
    OursInWindow(stage, frames, hasWindow),
    InWindow(stage, fewer, hasWindow, Peers::Polygons(stage)),
    InWindow(stage, fewer, hasWindow, Peers::FixedPoint(stage)),
    OursInWindow(small, frames, hasWindow),
    InWindow(small, FewestGpuFrames, hasWindow, Peers::Gpu(small)) };
}

}
