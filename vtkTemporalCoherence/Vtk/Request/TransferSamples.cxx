// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Request/TransferSamples.h"

#include "Request/TransferNodes.h"

#include <vtkColorTransferFunction.h>
#include <vtkPiecewiseFunction.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace TemporalCoherence
{
namespace
{

/// Intervals between samples.
constexpr std::size_t MostIntervals = 1 << 16;

/// A number that is invalid although the nodes are valid, as by logarithms of negative positions.
double ShareOf(double value)
{
  return value >= 0.0 ? std::min(value, 1.0) : 0.0;
}

/// Samples functions at equal distances, from below their first node to above their last.
class Sampler
{
public:
  Sampler(const TransferFunctions& functions, const std::vector<double>& nodes)
    : Of(functions)
  {
    constexpr auto intervals = static_cast<double>(MostIntervals);
    const double low = nodes.front(), range = nodes.back() - low;
    const double common = CommonStep(nodes, 0.5 * intervals);
    if (common > 0.0)
    {
      // Also where samples are left out, there is one at each node.
      const double parts = std::floor(std::log2(intervals / (range / common + 2.0)));
      this->Step = common / std::exp2(parts);
      this->First = low - common;
    }
    else
    {
      // Of the intervals, four may lie beyond the nodes. A step is more than a rounding error.
      const double largest = std::max(std::abs(low), std::abs(nodes.back()));
      const double least = std::max(largest * 0x1p-50, 0x1p-960);
      this->Step = std::exp2(std::ceil(std::log2(std::max(range / (intervals - 4.0), least))));
      this->First = (std::floor(low / this->Step) - 1.0) * this->Step;
    }
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
      this->MendFirstNode();
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

  /// A table of VTK that begins before the first node is black at that node itself.
  void MendFirstNode()
  {
    double node[6]; // position, colour, midpoint, sharpness
    if (this->Of.Color->GetSize() > 0 && this->Of.Color->GetNodeValue(0, node) == 1)
    {
      const double place = std::round((node[0] - this->First) / this->Step);
      const auto at = static_cast<std::size_t>(std::clamp(place, 0.0, this->Count() - 1.0));
      this->Of.Color->GetColor(this->At(at), &this->Made.Nodes[at].x);
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

  TransferFunctions Of;
  double Step = 1.0, First = 0.0;
};

}

TransferFunction SampleFunctions(
  const TransferFunctions& functions, const std::vector<double>& nodes)
{
  return Sampler(functions, nodes).Made;
}

}
