// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Request/TransferNodes.h"

#include "Input/SettingCheck.h"

#include <vtkColorTransferFunction.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace TemporalCoherence
{
namespace
{

bool CheckShape(SettingCheck& check, const double* midpointAndSharpness, const char* remedy)
{
  const NumberRange share = { 0.0, 1.0 };
  check("Midpoint", midpointAndSharpness[0], share, remedy);
  check("Sharpness", midpointAndSharpness[1], share, remedy);
  return check.HasPassed();
}

/// \param name of the function, in words
bool CheckNodes(vtkPiecewiseFunction* function, const NumberRange& allowed, const char* name,
  const char* remedy, std::vector<double>& nodes, std::string& error)
{
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[4]; // position, value, midpoint, sharpness
    function->GetNodeValue(i, node);
    SettingCheck check({ "node", i, name }, error);
    check("Position", node[0], Allowed::FieldValue, remedy);
    check("Value", node[1], allowed, remedy);
    if (!CheckShape(check, node + 2, remedy))
    {
      return false;
    }
    nodes.push_back(node[0]);
  }
  return true;
}

/// \param name of the function, in words
bool CheckNodes(vtkColorTransferFunction* function, const char* name, const char* remedy,
  std::vector<double>& nodes, std::string& error)
{
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[6]; // position, colour, midpoint, sharpness
    function->GetNodeValue(i, node);
    SettingCheck check({ "node", i, name }, error);
    check("Position", node[0], Allowed::FieldValue, remedy);
    check("Colour", node + 1, Allowed::Color, remedy);
    if (!CheckShape(check, node + 4, remedy))
    {
      return false;
    }
    nodes.push_back(node[0]);
  }
  return true;
}

/// \param label that has the function; 0: none
std::string NameOf(const char* function, int label)
{
  return std::string(function) + (label != 0 ? " of label " + std::to_string(label) : "") +
    " of the volume's property";
}

bool CheckNodes(const TransferFunctions& functions, std::vector<double>& nodes, std::string& error)
{
  const std::string colors = NameOf("the colours", functions.LabelOfColor);
  const std::string opacity = NameOf("the scalar opacity", functions.LabelOfOpacity);
  const bool areColorsFine = functions.Color
    ? CheckNodes(functions.Color, colors.c_str(),
        functions.LabelOfColor != 0 ? "GetLabelColor(label)->SetNodeValue or AddRGBPoint"
                                    : "GetRGBTransferFunction()->SetNodeValue or AddRGBPoint",
        nodes, error)
    : CheckNodes(functions.Gray, Allowed::Color, "the gray values of the volume's property",
        "GetGrayTransferFunction()->SetNodeValue or AddPoint", nodes, error);
  return areColorsFine &&
    CheckNodes(functions.Opacity, Allowed::Opacity, opacity.c_str(),
      functions.LabelOfOpacity != 0 ? "GetLabelScalarOpacity(label)->SetNodeValue or AddPoint"
                                    : "GetScalarOpacity()->SetNodeValue or AddPoint",
      nodes, error);
}

}

TransferFunctions::TransferFunctions(vtkVolumeProperty* property, int component)
{
  if (property->GetColorChannels(component) == 3)
  {
    this->Color = property->GetRGBTransferFunction(component);
  }
  else
  {
    this->Gray = property->GetGrayTransferFunction(component);
  }
  this->Opacity = property->GetScalarOpacity(component);
}

TransferFunctions::TransferFunctions(vtkVolumeProperty* property, int component, int label)
  : TransferFunctions(property, component)
{
  if (vtkColorTransferFunction* const own = property->GetLabelColor(label))
  {
    this->Color = own;
    this->LabelOfColor = label;
  }
  if (vtkPiecewiseFunction* const own = property->GetLabelScalarOpacity(label))
  {
    this->Opacity = own;
    this->LabelOfOpacity = label;
  }
}

vtkObject* TransferFunctions::Colors() const
{
  return this->Color ? static_cast<vtkObject*>(this->Color) : this->Gray;
}

bool FindNodes(const TransferFunctions& functions, std::vector<double>& nodes, std::string& error)
{
  nodes.clear();
  if (functions.Color && functions.Color->GetColorSpace() == VTK_CTF_LAB_CIEDE2000)
  {
    error = "Volumes are not blended in the colour space Lab/CIEDE2000, of which VTK takes a tenth "
            "of a second for each colour; call SetColorSpaceToLab() of the colour function.";
    return false;
  }
  if (!CheckNodes(functions, nodes, error))
  {
    return false;
  }
  if (nodes.empty())
  {
    nodes.push_back(0.0); // functions are 0 everywhere
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return true;
}

double CommonStep(const std::vector<double>& nodes, double width, double most)
{
  constexpr int MostParts = 12;
  constexpr double Rounding = 1e-6;
  double gap = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < nodes.size(); ++i)
  {
    gap = std::min(gap, nodes[i] - nodes[i - 1]);
  }
  for (int parts = 1; parts <= MostParts && width * parts <= most * gap; ++parts)
  {
    const double step = gap / parts;
    const auto isMet = [&](double node)
    {
      const double steps = (node - nodes.front()) / step;
      return std::abs(steps - std::round(steps)) <= Rounding;
    };
    if (nodes.size() > 1 && std::all_of(nodes.begin(), nodes.end(), isMet))
    {
      return step;
    }
  }
  return 0.0;
}

}
