// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Measures the mapper, scenario by scenario: prints Markdown tables and writes all figures into one
// JSON file; draws plots of some.

#include "CommandLine.h"
#include "Display.h"
#include "GrowthSteps.h"
#include "Measuring.h"
#include "Report.h"
#include "Scenario.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace
{

/// What is small and short with --quick, unless another number is given.
constexpr int QuickSize = 256;
constexpr int QuickSteps = 8;
constexpr int QuickLargest = 256;

/// Options; numbers that were not given are 0.
struct Asked
{
  std::vector<std::string> Scenarios;
  std::vector<std::string> Framings;
  bool IsQuick = false;
  int Size = 0;
  int Frames = 0;
  int Steps = 0;
  int Largest = 0;
  std::string Json;
  std::string Plots;
  std::vector<Volumes::Sample> Volumes;
};

Settings SettingsOf(const Asked& asked)
{
  const auto choose = [&asked](int given, int quick, int usual) {
    return given > 0 ? given : asked.IsQuick ? quick : usual;
  };
  Settings settings;
  settings.IsQuick = asked.IsQuick;
  settings.Size = choose(asked.Size, QuickSize, settings.Size);
  settings.Frames = asked.Frames;
  settings.Steps = choose(asked.Steps, QuickSteps, settings.Steps);
  settings.Largest = choose(asked.Largest, QuickLargest, settings.Largest);
  settings.Volumes = asked.Volumes;
  settings.Plots = asked.Plots;
  return settings;
}

/// The file holds the scenarios measured so far, whatever becomes of the rest.
void Save(const JsonWriter& json, const std::string& file)
{
  if (!file.empty())
  {
    json.Write(file);
  }
}

/// True if one of these names was asked for; without any, all are.
bool IsAsked(const std::string& name, const std::vector<std::string>& asked)
{
  return asked.empty() || std::find(asked.begin(), asked.end(), name) != asked.end();
}

/// The framings that were asked for, or those of every table.
std::vector<Framing> FramingsOf(const Asked& asked)
{
  const std::vector<std::string> names =
    !asked.Framings.empty() ? asked.Framings : std::vector<std::string>{ "afar", "close" };
  std::vector<Framing> framings;
  std::copy_if(AllFramings().begin(), AllFramings().end(), std::back_inserter(framings),
    [&names](const Framing& framing) { return IsAsked(framing.Name, names); });
  return framings;
}

/// Run one scenario in one view. What goes wrong is told in a sentence, and others may follow.
/// \return false if something went wrong
bool RunScenario(
  const Scenario& scenario, const Settings& settings, JsonWriter& json, bool& isMeasured)
{
  std::cerr << scenario.Name << ", " << settings.From.Name << std::endl;
  std::cout << "### View " << settings.From.Name << ": " << settings.From.Meaning << "\n\n";
  const std::size_t depth = json.Depth();
  bool isRight = true;
  json.OpenObject(settings.From.Name);
  try
  {
    isMeasured = scenario.Run(settings, json) || isMeasured;
  }
  catch (const Measuring::Failure& failure)
  {
    std::cerr << scenario.Name << ": " << failure.what() << std::endl;
    isRight = false;
  }
  json.CloseTo(depth);
  std::cout << '\n';
  return isRight;
}

/// Run one scenario in all views that it has.
/// \return false if something went wrong
bool RunViews(const Scenario& scenario, const std::vector<Framing>& framings, Settings settings,
  JsonWriter& json, bool& isMeasured)
{
  std::cout << "## " << scenario.Name << "\n\n" << scenario.Purpose << "\n\n";
  json.OpenObject(scenario.Name);
  bool areRight = true;
  for (const Framing& framing : framings)
  {
    settings.From = framing;
    areRight = RunScenario(scenario, settings, json, isMeasured) && areRight;
    if (!scenario.HasViews)
    {
      break;
    }
    settings.Plots.clear(); // are those of the first view
  }
  json.Close();
  return areRight;
}

/// False if nothing was measured.
/// \throws Measuring::Failure if something went wrong
bool RunScenarios(const Asked& asked)
{
  const Settings settings = SettingsOf(asked);
  if (!settings.Plots.empty())
  {
    RequireDisplay();
    RequireFolder(settings.Plots);
  }
  std::cout << settings.Size << " x " << settings.Size << " pixels, "
            << vtkSMPTools::GetEstimatedNumberOfThreads() << " threads\n\n";
  JsonWriter json;
  AddMachine(json, settings.Size);
  Save(json, asked.Json);
  bool isMeasured = false, areRight = true;
  for (const Scenario& scenario : Scenarios::All())
  {
    if (IsAsked(scenario.Name, asked.Scenarios))
    {
      areRight = RunViews(scenario, FramingsOf(asked), settings, json, isMeasured) && areRight;
      Save(json, asked.Json);
    }
  }
  if (!areRight)
  {
    throw Measuring::Failure("Not everything could be measured, for the reasons above.");
  }
  return isMeasured;
}

std::vector<CommandLine::Choice> ScenarioChoices()
{
  std::vector<CommandLine::Choice> choices;
  for (const Scenario& scenario : Scenarios::All())
  {
    choices.push_back({ scenario.Name, scenario.Purpose });
  }
  return choices;
}

std::vector<CommandLine::Choice> FramingChoices()
{
  std::vector<CommandLine::Choice> choices;
  for (const Framing& framing : AllFramings())
  {
    choices.push_back({ framing.Name, framing.Meaning });
  }
  return choices;
}

}

int main(int argc, char* argv[])
{
  Asked asked;
  CommandLine options("Benchmark",
    "Measure the mapper, as Markdown tables. What needs a window is left out without a display.\n"
    "Each scenario has its own volumes, unless some are named.");
  options.Choices(
    "--scenarios", "only these (all)", "scenario", ScenarioChoices(), asked.Scenarios);
  options.Choices("--views", "only these (afar,close)", "view", FramingChoices(), asked.Framings);
  options.Flag("--quick", "small pictures, few frames and volumes: a minute", asked.IsQuick);
  options.Number("--size", "pixels of a picture in each direction (1024)", asked.Size);
  options.Number("--frames", "frames of each kind (each scenario's own)", asked.Frames);
  options.Number("--steps", "isovalues of a drag (40)", asked.Steps);
  options.Number("--largest", "samples a side where growth ends (512)", asked.Largest,
    GrowthSteps::Smallest, Volumes::LargestSize);
  options.Text("--json", "write all figures to this file too", asked.Json);
  options.Text("--plots", "draw plots of some scenarios into this folder", asked.Plots);
  options.Volumes(asked.Volumes);
  return options.Run(argc, argv, [&asked] { return RunScenarios(asked); });
}
