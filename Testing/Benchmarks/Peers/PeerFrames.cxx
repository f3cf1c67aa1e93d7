// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PeerFrames.h"

#include "Measuring.h"
#include "OffScreenWindow.h"
#include "OpenVkl.h"
#include "Peers.h"

#include <vtkFlyingEdges3D.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <string>

namespace PeerFrames
{
namespace
{

using Measuring::None;

constexpr double Degrees = 2.0; ///< of the orbit, a frame
constexpr int FewestFrames = 3;
constexpr int FewestGpuFrames = 2;

/// How many frames a way has, and how many of them are drawn.
struct Way
{
  /// The first frame that is drawn, then every so many.
  int Stride() const { return std::max(1, this->Frames / this->Drawn); }

  int Frames, Drawn;
};

/// New views around the stage, and then new isovalues in the last one. A first frame, which makes
/// what all others need, is not measured.
void TimeFrames(Stage& stage, const Way& way, const std::function<void(double)>& setIsovalue,
  const std::function<double()>& draw, Times& times)
{
  const double isovalue = stage.Isovalue();
  std::vector<double> views, isovalues;
  stage.ResetView();
  setIsovalue(isovalue);
  draw();
  for (int frame = way.Stride(); frame <= way.Frames; frame += way.Stride())
  {
    stage.Orbit(Degrees * way.Stride());
    views.push_back(draw());
  }
  for (int frame = way.Stride(); frame <= way.Frames; frame += way.Stride())
  {
    setIsovalue(isovalue + stage.SweepStep(frame - 1));
    isovalues.push_back(draw());
  }
  setIsovalue(isovalue);
  times.NewView = Measuring::Median(views);
  times.NewIsovalue = Measuring::Median(isovalues);
}

Times OursWithoutWindow(Stage& stage, const Way& way)
{
  Times times{ "vtkTemporalCoherenceVolumeMapper, no window", true, stage.Size };
  Drawer drawer(stage);
  drawer.Mapper->ReuseFramesOff();
  TimeFrames(
    stage, way, [&stage](double isovalue) { stage.SetIsovalue(isovalue); },
    [&] { return drawer.Draw(stage); }, times);
  times.PercentDrawn = PercentHit(drawer);
  return times;
}

/// Triangles that nobody draws.
Times Extraction(Stage& stage, const Way& way)
{
  Times times{ "vtkFlyingEdges3D, not drawn", false, stage.Size };
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(stage.Image);
  contour->ComputeNormalsOn();
  contour->ComputeScalarsOff();
  TimeFrames(
    stage, way, [&contour](double isovalue) { contour->SetValue(0, isovalue); },
    [&contour] { return Measuring::TimeOf([&contour] { contour->Update(); }); }, times);
  times.NewView = None;
  times.PercentDrawn = None;
  return times;
}

/// Frames of Open VKL, of each kind of volume that it has.
std::vector<Times> OfOpenVkl(Stage& stage, const Way& way)
{
  std::vector<Times> all;
  for (const std::string& kind : OpenVkl::Kinds())
  {
    const std::unique_ptr<OpenVkl> peer = OpenVkl::Make(stage, kind);
    if (peer)
    {
      Times times{ "Open VKL, " + kind, false, stage.Size };
      TimeFrames(
        stage, way, [&peer](double isovalue) { peer->SetIsovalue(isovalue); },
        [&] { return peer->Draw(stage); }, times);
      times.PercentDrawn = peer->PercentHit();
      all.push_back(times);
    }
  }
  return all;
}

Times InWindow(Stage& stage, const Way& way, bool hasWindow, const Peers::Peer& peer)
{
  Times times{ peer.Name, false, stage.Size, None, None, None };
  if (hasWindow)
  {
    stage.Renderer->AddViewProp(peer.Prop);
    OffScreenWindow window(stage.Renderer, stage.Size);
    TimeFrames(
      stage, way, peer.SetIsovalue, [&window] { return window.Draw(); }, times);
    times.PercentDrawn = window.PercentDrawn();
    stage.Renderer->RemoveViewProp(peer.Prop);
  }
  return times;
}

Times OursInWindow(Stage& stage, const Way& way, bool hasWindow)
{
  Times times = InWindow(stage, way, hasWindow, Peers::Ours(stage));
  times.IsOurs = true;
  return times;
}

}

std::vector<Times> Measure(Stage& stage, int frames, bool hasWindow)
{
  const Way all{ frames, frames };
  const Way some{ frames, std::min(frames, std::max(FewestFrames, frames / 4)) };
  const Way fewest{ frames, std::min(frames, FewestGpuFrames) };
  Stage small(stage.Image, stage.Isovalue(), std::min(stage.Size, SmallSize), stage.From);
  std::vector<Times> times = { OursWithoutWindow(stage, all) };
  const std::vector<Times> openVkl = OfOpenVkl(stage, some);
  times.insert(times.end(), openVkl.begin(), openVkl.end());
  times.insert(times.end(),
    { Extraction(stage, some), OursInWindow(stage, all, hasWindow),
      InWindow(stage, some, hasWindow, Peers::Polygons(stage)),
      InWindow(stage, some, hasWindow, Peers::FixedPoint(stage)),
      OursInWindow(small, all, hasWindow), InWindow(small, fewest, hasWindow, Peers::Gpu(small)) });
  return times;
}

}
