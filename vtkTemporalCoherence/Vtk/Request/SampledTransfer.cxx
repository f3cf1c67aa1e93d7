// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Request/SampledTransfer.h"

#include "Input/SettingCheck.h"

#include <vtkColorTransferFunction.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace TemporalCoherence
{
namespace
{

/// Intervals between samples, before and after samples are left out.
constexpr std::size_t MostIntervals = 1 << 16, FewestIntervals = 1 << 4;

/// What straight lines between nodes may differ by from the samples. Opacities add up along a ray.
constexpr double LargestColorError = 0.0005, LargestOpacityError = 1e-5;

/// The functions of a component.
struct Functions
{
  Functions(vtkVolumeProperty* property, int component)
    : Color(property->GetColorChannels(component) == 3 ? property->GetRGBTransferFunction(component)
                                                       : nullptr)
    , Gray(this->Color ? nullptr : property->GetGrayTransferFunction(component))
    , Opacity(property->GetScalarOpacity(component))
  {
  }

  vtkObject* Colors() const
  {
    return this->Color ? static_cast<vtkObject*>(this->Color) : this->Gray;
  }

  vtkColorTransferFunction* Color; ///< or null
  vtkPiecewiseFunction* Gray;      ///< or null
  vtkPiecewiseFunction* Opacity;
};

/// The values of the nodes of functions.
struct NodeRange
{
  void Include(double value)
  {
    this->Low = std::min(this->Low, value);
    this->High = std::max(this->High, value);
  }

  double Low = std::numeric_limits<double>::infinity();
  double High = -std::numeric_limits<double>::infinity();
};

bool CheckShape(SettingCheck& check, const double* midpointAndSharpness, const char* remedy)
{
  const NumberRange share = { 0.0, 1.0 };
  check("Midpoint", midpointAndSharpness[0], share, remedy);
  check("Sharpness", midpointAndSharpness[1], share, remedy);
  return check.HasPassed();
}

/// \param name of the function, in words
bool CheckNodes(vtkPiecewiseFunction* function, const NumberRange& allowed, const char* name,
  const char* remedy, NodeRange& range, std::string& error)
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
    range.Include(node[0]);
  }
  return true;
}

bool CheckNodes(vtkColorTransferFunction* function, NodeRange& range, std::string& error)
{
  const char* const remedy = "GetRGBTransferFunction()->SetNodeValue or AddRGBPoint";
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[6]; // position, colour, midpoint, sharpness
    function->GetNodeValue(i, node);
    SettingCheck check({ "node", i, "the colours of the volume's property" }, error);
    check("Position", node[0], Allowed::FieldValue, remedy);
    check("Colour", node + 1, Allowed::Color, remedy);
    if (!CheckShape(check, node + 4, remedy))
    {
      return false;
    }
    range.Include(node[0]);
  }
  return true;
}

bool CheckNodes(const Functions& functions, NodeRange& range, std::string& error)
{
  const bool areColorsFine = functions.Color
    ? CheckNodes(functions.Color, range, error)
    : CheckNodes(functions.Gray, Allowed::Color, "the gray values of the volume's property",
        "GetGrayTransferFunction()->SetNodeValue or AddPoint", range, error);
  return areColorsFine &&
    CheckNodes(functions.Opacity, Allowed::Opacity, "the scalar opacity of the volume's property",
      "GetScalarOpacity()->SetNodeValue or AddPoint", range, error);
}

/// A number that is invalid although the nodes are valid, as by logarithms of negative positions.
double ShareOf(double value)
{
  return value >= 0.0 ? std::min(value, 1.0) : 0.0;
}

/// Samples functions at equal distances, from below their first node to above their last.
class Sampler
{
public:
  Sampler(const Functions& functions, const NodeRange& nodes)
    : Of(functions)
  {
    // Four of the intervals may lie beyond the nodes.
    const auto intervals = static_cast<double>(MostIntervals);
    const double inside = intervals - 4.0;
    const double largest = std::max(std::abs(nodes.Low), std::abs(nodes.High));
    const double smallest =
      std::max(largest * 0x1p-50, std::numeric_limits<double>::min() * 0x1p60);
    this->Step =
      std::exp2(std::ceil(std::log2(std::max((nodes.High - nodes.Low) / inside, smallest))));
    this->First = (std::floor(nodes.Low / this->Step) - 1.0) * this->Step;
    this->Made.Range = { this->First, this->First + intervals * this->Step };
    this->Made.Nodes.resize(MostIntervals + 1);
    this->SampleColors();
    this->SampleOpacities();
  }

  TransferFunction Made;

private:
  double At(std::size_t i) const { return this->First + static_cast<double>(i) * this->Step; }
  int Count() const { return static_cast<int>(this->Made.Nodes.size()); }

  void SampleColors()
  {
    std::vector<glm::dvec4>& nodes = this->Made.Nodes;
    const glm::dvec2& range = this->Made.Range;
    if (this->Of.Color && this->Of.Color->GetScale() == VTK_CTF_LINEAR)
    {
      std::vector<glm::dvec3> colors(nodes.size());
      this->Of.Color->GetTable(range.x, range.y, this->Count(), &colors.front().x);
      for (std::size_t i = 0; i < nodes.size(); ++i)
      {
        nodes[i] = glm::dvec4(colors[i], 0.0);
      }
    }
    else if (this->Of.Color)
    {
      for (std::size_t i = 0; i < nodes.size(); ++i)
      {
        this->Of.Color->GetColor(this->At(i), &nodes[i].x);
      }
    }
    else
    {
      std::vector<double> grays(nodes.size());
      this->Of.Gray->GetTable(range.x, range.y, this->Count(), grays.data());
      for (std::size_t i = 0; i < nodes.size(); ++i)
      {
        nodes[i] = glm::dvec4(glm::dvec3(grays[i]), 0.0);
      }
    }
  }

  /// Sample opacities, and bring all shares into their range.
  void SampleOpacities()
  {
    std::vector<double> opacities(this->Made.Nodes.size());
    this->Of.Opacity->GetTable(
      this->Made.Range.x, this->Made.Range.y, this->Count(), opacities.data());
    for (std::size_t i = 0; i < opacities.size(); ++i)
    {
      glm::dvec4& node = this->Made.Nodes[i];
      node = { ShareOf(node.x), ShareOf(node.y), ShareOf(node.z), ShareOf(opacities[i]) };
    }
  }

  Functions Of;
  double Step = 1.0, First = 0.0;
};

/// True if straight lines between every `stride`-th sample meet all samples.
bool IsEnough(const std::vector<glm::dvec4>& samples, std::size_t stride)
{
  for (std::size_t first = 0; first + stride < samples.size(); first += stride)
  {
    const glm::dvec4 &low = samples[first], &high = samples[first + stride];
    for (std::size_t i = 1; i < stride; ++i)
    {
      const double share = static_cast<double>(i) / static_cast<double>(stride);
      const glm::dvec4 error = glm::abs(low + share * (high - low) - samples[first + i]);
      if (std::max({ error.x, error.y, error.z }) > LargestColorError ||
        error.w > LargestOpacityError)
      {
        return false;
      }
    }
  }
  return true;
}

/// Leave out samples that others tell.
void Thin(TransferFunction& transfer)
{
  const std::vector<glm::dvec4>& samples = transfer.Nodes;
  std::size_t stride = 1;
  while ((samples.size() - 1) / (2 * stride) >= FewestIntervals && IsEnough(samples, 2 * stride))
  {
    stride *= 2;
  }
  std::vector<glm::dvec4> nodes;
  for (std::size_t i = 0; i < samples.size(); i += stride)
  {
    nodes.push_back(samples[i]);
  }
  transfer.Nodes.swap(nodes);
}

}

bool SampledTransfer::Sample(vtkVolumeProperty* property, int component, std::string& error)
{
  const Functions functions(property, component);
  const vtkMTimeType colorTime = functions.Colors()->GetMTime();
  const vtkMTimeType opacityTime = functions.Opacity->GetMTime();
  if (!this->Transfer.Nodes.empty() && this->Colors == functions.Colors() &&
    this->Opacities == functions.Opacity && this->ColorTime == colorTime &&
    this->OpacityTime == opacityTime)
  {
    return true;
  }
  NodeRange nodes;
  if (!CheckNodes(functions, nodes, error))
  {
    return false;
  }
  if (nodes.Low > nodes.High)
  {
    nodes = { 0.0, 0.0 }; // without nodes, functions are 0 everywhere
  }
  this->Transfer = Sampler(functions, nodes).Made;
  Thin(this->Transfer);
  this->Colors = functions.Colors();
  this->Opacities = functions.Opacity;
  this->ColorTime = colorTime;
  this->OpacityTime = opacityTime;
  return true;
}

}
