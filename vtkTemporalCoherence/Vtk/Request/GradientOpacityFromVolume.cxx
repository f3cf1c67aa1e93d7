// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Request/GradientOpacityFromVolume.h"

#include "Input/SettingCheck.h"

#include <vtkPiecewiseFunction.h>
#include <vtkVolumeProperty.h>

#include <algorithm>

namespace TemporalCoherence
{
namespace
{

/// \param owner  of the function, in words
/// \param remedy the function to call with other numbers
bool MakeNodes(vtkPiecewiseFunction* function, const char* owner, const char* remedy,
  GradientOpacity& made, std::string& error)
{
  // Straight lines join the nodes, unless they have their own midpoint or sharpness.
  constexpr int ManyNodes = 4096;
  const NumberRange share = { 0.0, 1.0 };
  bool isStraight = true;
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[4]; // position, value, midpoint, sharpness
    function->GetNodeValue(i, node);
    isStraight = isStraight && node[2] == 0.5 && node[3] == 0.0;
    made.Nodes.emplace_back(node[0], node[1]);
    SettingCheck check({ "node", i, owner }, error);
    check("Position", node[0], Allowed::GradientMagnitude, remedy);
    check("Value", node[1], Allowed::Opacity, remedy);
    check("Midpoint", node[2], share, remedy);
    check("Sharpness", node[3], share, remedy);
    if (!check.HasPassed())
    {
      return false;
    }
  }
  if (!isStraight)
  {
    // Every pair of neighbours gets equally many nodes, because pairs may be far apart.
    const std::vector<glm::dvec2> few = made.Nodes;
    const auto between = std::max(ManyNodes / static_cast<int>(few.size()), 16);
    made.Nodes.clear();
    for (std::size_t node = 1; node < few.size(); ++node)
    {
      for (int i = 0; i < between; ++i)
      {
        const double at = glm::mix(few[node - 1].x, few[node].x, static_cast<double>(i) / between);
        made.Nodes.emplace_back(at, function->GetValue(at));
      }
    }
    made.Nodes.emplace_back(few.back().x, function->GetValue(few.back().x));
  }
  for (glm::dvec2& node : made.Nodes)
  {
    node.y = std::min(std::max(node.y, 0.0), 1.0);
  }
  if (std::all_of(
        made.Nodes.begin(), made.Nodes.end(), [](const glm::dvec2& node) { return node.y == 1.0; }))
  {
    made.Nodes.clear();
  }
  return true;
}

}

bool MakeGradientOpacity(
  vtkVolumeProperty* property, int component, GradientOpacity& made, std::string& error)
{
  made.Nodes.clear();
  return property->GetDisableGradientOpacity(component) ||
    !property->HasGradientOpacity(component) ||
    MakeNodes(property->GetGradientOpacity(component),
      "the gradient opacity of the volume's property",
      "GetGradientOpacity()->SetNodeValue or AddPoint", made, error);
}

bool MakeLabelGradientOpacity(
  vtkVolumeProperty* property, int label, GradientOpacity& made, std::string& error)
{
  made.Nodes.clear();
  vtkPiecewiseFunction* const own = property->GetLabelGradientOpacity(label);
  const std::string owner =
    "the gradient opacity of label " + std::to_string(label) + " of the volume's property";
  return !own ||
    MakeNodes(
      own, owner.c_str(), "GetLabelGradientOpacity(label)->SetNodeValue or AddPoint", made, error);
}

void LeaveOutBeyond(double steepest, GradientOpacity& opacity)
{
  if (opacity.Nodes.empty())
  {
    return;
  }
  std::vector<glm::dvec2> nodes{ { 0.0, opacity.At(0.0) } };
  for (const glm::dvec2& node : opacity.Nodes)
  {
    if (node.x > 0.0 && node.x < steepest)
    {
      nodes.push_back(node);
    }
  }
  if (opacity.Nodes.back().x >= steepest)
  {
    nodes.emplace_back(steepest, opacity.At(steepest));
  }
  opacity.Nodes.swap(nodes);
}

}
