// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTemporalCoherencePresets.h"

#include "vtkColorTransferFunction.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkTemporalCoherencePresets);

namespace
{

struct Node
{
  double Value;
  double Red, Green, Blue;
  double Opacity;
};

struct Preset
{
  const char* Name;
  bool IsInHounsfieldUnits;
  std::vector<Node> Nodes;
};

const std::vector<Preset>& AllPresets()
{
  static const std::vector<Preset> presets = {
    { "ct bone", true,
      { { 150.0, 0.55, 0.25, 0.15, 0.0 }, { 300.0, 0.90, 0.75, 0.55, 0.35 },
        { 700.0, 1.00, 0.95, 0.85, 0.70 }, { 1500.0, 1.00, 1.00, 0.95, 0.85 } } },
    { "ct soft tissue", true,
      { { -200.0, 0.55, 0.25, 0.15, 0.0 }, { -50.0, 0.85, 0.60, 0.45, 0.05 },
        { 60.0, 0.80, 0.35, 0.25, 0.15 }, { 150.0, 0.90, 0.70, 0.55, 0.30 },
        { 400.0, 1.00, 0.95, 0.85, 0.70 } } },
    { "ct vessels", true,
      { { 120.0, 0.45, 0.05, 0.05, 0.0 }, { 200.0, 0.80, 0.15, 0.10, 0.35 },
        { 350.0, 0.95, 0.55, 0.35, 0.60 }, { 700.0, 1.00, 0.95, 0.85, 0.80 } } },
    { "mr", false,
      { { 0.25, 0.45, 0.20, 0.12, 0.0 }, { 0.45, 0.85, 0.55, 0.40, 0.06 },
        { 0.70, 0.95, 0.80, 0.60, 0.25 }, { 1.00, 1.00, 0.97, 0.92, 0.70 } } },
  };
  return presets;
}

/// Null if there is none.
const Preset* PresetOf(const char* name)
{
  const auto& all = AllPresets();
  const auto at = std::find_if(all.begin(), all.end(),
    [&](const Preset& preset) { return name && std::string(name) == preset.Name; });
  return at == all.end() ? nullptr : &*at;
}

void SetFunctions(vtkVolumeProperty* property, const std::vector<Node>& nodes)
{
  vtkNew<vtkColorTransferFunction> colors;
  vtkNew<vtkPiecewiseFunction> opacities;
  for (const Node& node : nodes)
  {
    colors->AddRGBPoint(node.Value, node.Red, node.Green, node.Blue);
    opacities->AddPoint(node.Value, node.Opacity);
  }
  property->SetColor(colors);
  property->SetScalarOpacity(opacities);
}

}

//------------------------------------------------------------------------------
int vtkTemporalCoherencePresets::GetNumberOfPresets()
{
  return static_cast<int>(AllPresets().size());
}

//------------------------------------------------------------------------------
const char* vtkTemporalCoherencePresets::GetPresetName(int index)
{
  return index >= 0 && index < GetNumberOfPresets()
    ? AllPresets()[static_cast<std::size_t>(index)].Name
    : nullptr;
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherencePresets::GetPresetIsInHounsfieldUnits(const char* name)
{
  const Preset* preset = PresetOf(name);
  return preset && preset->IsInHounsfieldUnits;
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherencePresets::Apply(
  const char* name, vtkVolumeProperty* property, double offset, double scale)
{
  const Preset* preset = PresetOf(name);
  if (!preset || !property || !std::isfinite(offset) || !std::isfinite(scale) || !(scale > 0.0))
  {
    return false;
  }
  std::vector<Node> nodes = preset->Nodes;
  for (Node& node : nodes)
  {
    node.Value = offset + scale * node.Value;
  }
  SetFunctions(property, nodes);
  return true;
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherencePresets::ApplyWindowLevel(
  vtkVolumeProperty* property, double window, double level)
{
  if (!property || !std::isfinite(window) || !std::isfinite(level) || !(window > 0.0))
  {
    return false;
  }
  const double black = level - 0.5 * window, white = level + 0.5 * window;
  SetFunctions(property, { { black, 0.0, 0.0, 0.0, 1.0 }, { white, 1.0, 1.0, 1.0, 1.0 } });
  return true;
}
VTK_ABI_NAMESPACE_END
