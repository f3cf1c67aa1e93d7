// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Samples/ComponentLooks.h"

namespace TemporalCoherence
{
namespace
{

/// Smaller changes of slope are no bends.
constexpr double Straight = 1e-9;

/// Bends of a curve are at most this many times as sharp as the bends two nodes away.
constexpr double MostOfCurve = 4.0;

/// A sharper bend always counts, whatever its neighbours are.
constexpr double Sharp = 1.0 / 256.0;

/// The largest change of slope at each node, of all channels.
std::vector<double> SharpnessOf(const std::vector<glm::dvec4>& nodes)
{
  const std::size_t last = nodes.size() - 1;
  std::vector<double> sharpness;
  for (std::size_t i = 0; i <= last; ++i)
  {
    const glm::dvec4 bend =
      glm::abs(nodes[i == 0 ? 0 : i - 1] - 2.0 * nodes[i] + nodes[std::min(i + 1, last)]);
    sharpness.push_back(std::max({ bend.x, bend.y, bend.z, bend.w }));
  }
  return sharpness;
}

/// True if a channel turns at a node.
bool IsTurn(const std::vector<glm::dvec4>& nodes, std::size_t i)
{
  if (i == 0 || i + 1 == nodes.size())
  {
    return false;
  }
  const glm::dvec4 turn = (nodes[i] - nodes[i - 1]) * (nodes[i + 1] - nodes[i]);
  return std::min({ turn.x, turn.y, turn.z, turn.w }) < 0.0;
}

}

std::vector<double> ComponentLooks::BendsOf(std::size_t component) const
{
  if (this->Volume.Use == ComponentUse::RgbOpacity && component < 3)
  {
    return { this->Volume.ScalarRanges[component].x, this->Volume.ScalarRanges[component].y };
  }
  const TransferFunction& transfer = this->Of(component).Transfer;
  const std::vector<double> sharpness = SharpnessOf(transfer.Nodes);
  std::vector<double> bends;
  for (std::size_t i = 0; i < sharpness.size(); ++i)
  {
    if (sharpness[i] > Straight)
    {
      bends.push_back(ValueAt(transfer, i));
    }
  }
  return bends;
}

std::vector<double> ComponentLooks::KinksOf(std::size_t component) const
{
  if (this->Volume.Use == ComponentUse::RgbOpacity && component < 3)
  {
    return this->BendsOf(component);
  }
  const TransferFunction& transfer = this->Of(component).Transfer;
  const std::vector<double> sharpness = SharpnessOf(transfer.Nodes);
  std::vector<double> kinks;
  for (std::size_t i = 0; i < sharpness.size(); ++i)
  {
    const double before = i >= 2 ? sharpness[i - 2] : 0.0;
    const double behind = i + 2 < sharpness.size() ? sharpness[i + 2] : 0.0;
    const double least =
      std::min(Sharp, std::max(MostOfCurve * std::max(before, behind), Straight));
    if (sharpness[i] > least || (sharpness[i] > Straight && IsTurn(transfer.Nodes, i)))
    {
      kinks.push_back(ValueAt(transfer, i));
    }
  }
  return kinks;
}

}
