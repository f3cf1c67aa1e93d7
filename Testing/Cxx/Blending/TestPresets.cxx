// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Presets are found by name, move with the offset and the scale, and refuse what makes no sense.
// A window and a level go from black to white.

#include "Checks/Expect.h"

#include <vtkColorTransferFunction.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkTemporalCoherencePresets.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

namespace
{

using Presets = vtkTemporalCoherencePresets;
constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();

bool IsNear(double left, double right)
{
  return std::abs(left - right) < 1e-9;
}

void EachIsApplied()
{
  Expect(Presets::GetNumberOfPresets() == 4, "four presets");
  for (int i = 0; i < Presets::GetNumberOfPresets(); ++i)
  {
    const std::string name = Presets::GetPresetName(i);
    vtkNew<vtkVolumeProperty> plain, moved;
    Expect(Presets::Apply(name.c_str(), plain), name + ": applied");
    Expect(Presets::Apply(name.c_str(), moved, 100.0, 2.0), name + ": moved");
    vtkPiecewiseFunction* opacities = plain->GetScalarOpacity();
    Expect(opacities->GetSize() >= 4, name + ": has nodes");
    double before = -1.0;
    for (int node = 0; node < opacities->GetSize(); ++node)
    {
      double at[4];
      opacities->GetNodeValue(node, at);
      Expect(at[1] > before && at[1] <= 1.0, name + ": opacities grow");
      before = at[1];
      const double there = 100.0 + 2.0 * at[0];
      Expect(IsNear(moved->GetScalarOpacity()->GetValue(there), at[1]), name + ": opacity moved");
      double color[3], colorThere[3];
      plain->GetRGBTransferFunction()->GetColor(at[0], color);
      moved->GetRGBTransferFunction()->GetColor(there, colorThere);
      Expect(IsNear(color[0], colorThere[0]) && IsNear(color[2], colorThere[2]),
        name + ": colour moved");
    }
    Expect(IsNear(opacities->GetValue(opacities->GetRange()[0]), 0.0),
      name + ": nothing is seen at its least value");
  }
  Expect(Presets::GetPresetIsInHounsfieldUnits("ct bone"), "bone: Hounsfield units");
  Expect(!Presets::GetPresetIsInHounsfieldUnits("mr"), "mr: shares");
}

void NonsenseIsRefused()
{
  vtkNew<vtkVolumeProperty> property;
  property->GetScalarOpacity()->AddPoint(3.0, 0.5);
  const vtkMTimeType before = property->GetMTime();
  Expect(!Presets::GetPresetName(-1) && !Presets::GetPresetName(4), "no such index");
  Expect(!Presets::GetPresetIsInHounsfieldUnits(nullptr), "no name");
  Expect(!Presets::Apply("ct bones", property), "no such name");
  Expect(!Presets::Apply(nullptr, property), "no name to apply");
  Expect(!Presets::Apply("mr", nullptr), "no property");
  Expect(!Presets::Apply("mr", property, NotANumber), "no offset");
  Expect(!Presets::Apply("mr", property, 0.0, 0.0), "no scale");
  Expect(!Presets::ApplyWindowLevel(property, 0.0, 10.0), "no window");
  Expect(!Presets::ApplyWindowLevel(property, 10.0, NotANumber), "no level");
  Expect(!Presets::ApplyWindowLevel(nullptr, 10.0, 1.0), "no property of a window");
  Expect(property->GetMTime() == before, "refused: nothing changes");
}

void WindowGoesFromBlackToWhite()
{
  vtkNew<vtkVolumeProperty> property;
  Expect(Presets::ApplyWindowLevel(property, 40.0, 100.0), "window: applied");
  for (const double value : { 50.0, 80.0, 90.0, 100.0, 120.0, 150.0 })
  {
    const double grey = std::min(std::max((value - 80.0) / 40.0, 0.0), 1.0);
    double color[3];
    property->GetRGBTransferFunction()->GetColor(value, color);
    Expect(IsNear(color[0], grey) && IsNear(color[1], grey) && IsNear(color[2], grey),
      "window: grey of " + std::to_string(value));
    Expect(IsNear(property->GetScalarOpacity()->GetValue(value), 1.0), "window: opaque");
  }
}

}

int TestPresets(int, char*[])
{
  EachIsApplied();
  NonsenseIsRefused();
  WindowGoesFromBlackToWhite();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
