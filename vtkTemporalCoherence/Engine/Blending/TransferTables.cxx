// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blending/TransferTables.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace TemporalCoherence
{
namespace
{

/// Bins are at most as wide as this share of the range.
constexpr int FewestBins = 2048;

}

TransferTables::TransferTables(const ComponentLook& look, double mostExtinction)
{
  const std::vector<glm::dvec4>& nodes = look.Transfer.Nodes;
  const auto between = static_cast<int>(nodes.size()) - 1;
  const int perNode = (FewestBins + between - 1) / between;
  this->Bins = perNode * between;
  this->Low = look.Transfer.Range.x;
  const double width = look.Transfer.Range.y - look.Transfer.Range.x;
  this->PerValue = this->Bins / width;
  const auto nodeAt = [&](int bin)
  {
    const int clamped = std::clamp(bin, 0, this->Bins);
    const int node = std::min(clamped / perNode, between - 1);
    const double share = static_cast<double>(clamped - node * perNode) / perNode;
    return glm::mix(
      nodes[static_cast<std::size_t>(node)], nodes[static_cast<std::size_t>(node + 1)], share);
  };
  const auto emissionAt = [&](int bin)
  {
    const glm::dvec4 node = nodeAt(bin);
    const double depth = node.w >= 1.0 ? mostExtinction * look.UnitDistance : -std::log1p(-node.w);
    const double extinction = std::min(depth / look.UnitDistance, mostExtinction);
    return extinction * glm::dvec4(1.0, glm::dvec3(node));
  };
  glm::dvec4 sum(0.0);
  double moment = 0.0;
  for (int bin = 0; bin < this->Bins; ++bin)
  {
    const glm::dvec4 value = emissionAt(bin), rise = emissionAt(bin + 1) - value;
    EmissionNode made;
    for (int i = 0; i < 4; ++i)
    {
      const auto at = static_cast<std::size_t>(i);
      made.Value[at] = static_cast<float>(value[i]);
      made.Rise[at] = static_cast<float>(rise[i]);
      made.Sum[at] = static_cast<float>(sum[i]);
    }
    made.Moment = static_cast<float>(moment);
    sum += value + 0.5 * rise;
    moment += (bin + 0.5) * value.x + (0.5 * bin + 1.0 / 3.0) * rise.x;
    this->Nodes.push_back(made);
  }

  // Over 2 blocks on each side, as a stretch of a ray may reach so far.
  constexpr int around = 2;
  const int blocks = (this->Bins >> BlockBits) + 1;
  std::vector<float> own(static_cast<std::size_t>(blocks), 0.0f);
  for (int bin = 0; bin < this->Bins; ++bin)
  {
    const auto at = static_cast<std::size_t>(bin);
    float& most = own[at >> BlockBits];
    most = std::max(most, std::abs(this->Nodes[at].Rise[0]));
  }
  for (int block = 0; block < blocks; ++block)
  {
    const auto begin = own.begin() + std::max(block - around, 0);
    const auto end = own.begin() + std::min(block + around + 1, blocks);
    this->Steepness.push_back(*std::max_element(begin, end));
  }
}

GradientTable::GradientTable(const GradientOpacity& opacity)
{
  constexpr int Entries = 4096;
  if (opacity.Nodes.empty())
  {
    return;
  }
  const double low = opacity.Nodes.front().x, high = opacity.Nodes.back().x;
  this->Low = low;
  this->PerMagnitude = high > low ? (Entries - 1) / (high - low) : 0.0;
  for (int i = 0; i < Entries; ++i)
  {
    const double at = low + (high - low) * i / (Entries - 1);
    this->Opacities.push_back(static_cast<float>(opacity.At(at)));
  }
}

}
