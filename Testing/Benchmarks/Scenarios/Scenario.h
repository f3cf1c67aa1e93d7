// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_Scenario_h
#define Benchmarks_Scenario_h

#include "Report.h"
#include "Stage.h"
#include "Volumes/Volumes.h"

#include <functional>
#include <string>
#include <vector>

/// What the user asks of all scenarios.
struct Settings
{
  bool IsQuick = false;                 ///< only to see that all works
  int Size = 1024;                      ///< pixels of a picture in each direction
  Framing From = AllFramings().front(); ///< how the camera begins
  int Frames = 0;                       ///< 0: each scenario's own number
  int Steps = 40;                       ///< isovalues of a drag
  int Largest = 512;                    ///< samples a side where growth ends
  std::vector<Volumes::Sample> Volumes; ///< none: each scenario's own
  std::string Plots;                    ///< folder for plots; empty: none are made

  /// Frames of each kind, of a scenario that usually draws so many.
  int FramesOr(int usual) const;

  /// Volumes of a scenario that usually looks at these.
  std::vector<::Volumes::Sample> VolumesOr(const std::vector<::Volumes::Sample>& usual) const;
};

/// A question to the mapper, answered by tables and figures.
struct Scenario
{
  std::string Name;
  std::string Purpose; ///< a line of the help

  /// Measure, print tables, and add the figures to the object that is open in the report.
  /// \return false if nothing was measured, the reason being told on the error stream
  std::function<bool(const Settings&, JsonWriter&)> Run;

  bool HasViews = true; ///< false: measured in the first view only
};

/// Measure volumes one after the other; those that are not there are left out.
/// \param usual the volumes of the scenario, if the settings name none
/// \return false if none was there
bool ForEachStage(const Settings& settings, const std::vector<Volumes::Sample>& usual,
  const std::function<void(const Volumes::Sample&, Stage&)>& measure);

/// The same, and an object for each volume in the report's list "volumes", open while it is
/// measured.
bool ReportVolumes(const Settings& settings, const std::vector<Volumes::Sample>& usual,
  JsonWriter& json, const std::function<void(const Volumes::Sample&, Stage&)>& measure);

/// Volumes of scenarios that look at everything, and of those for which a few are enough.
const std::vector<Volumes::Sample>& ManyVolumes();
const std::vector<Volumes::Sample>& FewVolumes();

namespace Scenarios
{

Scenario Routes();
Scenario Peers();
Scenario LayerPeers();
Scenario Meshes();
Scenario ImageCache();
Scenario Drift();
Scenario Isomap();
Scenario Drags();
Scenario Growth();
Scenario Threads();
Scenario Vectors();
Scenario Structures();
Scenario Window();
Scenario Features();
Scenario Opacities();
Scenario Floor();
Scenario BlendedVolumes();
Scenario ColorJumps();

/// All of these, in the order in which they are run.
std::vector<Scenario> All();

}

#endif
