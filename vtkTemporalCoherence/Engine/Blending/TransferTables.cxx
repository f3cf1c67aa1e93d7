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
constexpr int FewestBins = 1024;

/// The integral of -ln(1 - x) from 0 to an opacity.
double SumOfDepths(double opacity)
{
  return opacity >= 1.0 ? 1.0 : (1.0 - opacity) * std::log1p(-opacity) + opacity;
}

/// The mean of -ln(1 - x) between two opacities, at most `most`.
double MeanDepth(double a, double b, double most)
{
  const double middle = 0.5 * (a + b);
  const double mean = std::abs(b - a) > 1e-4 ? (SumOfDepths(b) - SumOfDepths(a)) / (b - a)
                                             : (middle >= 1.0 ? most : -std::log1p(-middle));
  return std::min(mean, most);
}

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
  const double mostDepth = mostExtinction * look.UnitDistance;
  std::array<double, 4> sum{};
  for (int bin = -1; bin <= this->Bins; ++bin)
  {
    const glm::dvec4 first = nodeAt(bin), second = nodeAt(bin == -1 ? 0 : bin + 1);
    const double extinction = MeanDepth(first.w, second.w, mostDepth) / look.UnitDistance;
    const glm::dvec3 color = 0.5 * (glm::dvec3(first) + glm::dvec3(second));
    const std::array<double, 4> mean = { extinction, extinction * color.x, extinction * color.y,
      extinction * color.z };
    BinOfEmission made;
    for (std::size_t i = 0; i < 4; ++i)
    {
      made.Mean[i] = static_cast<float>(mean[i]);
      made.Sum[i] = static_cast<float>(sum[i]);
      sum[i] += bin == -1 ? 0.0 : mean[i];
    }
    this->All.push_back(made);
  }

  // Over 2 blocks on each side, as a stretch of a ray may reach so far.
  constexpr int around = 2;
  const int blocks = (this->Bins >> BlockBits) + 1;
  std::vector<float> own(static_cast<std::size_t>(blocks), 0.0f);
  for (int bin = 0; bin < this->Bins; ++bin)
  {
    const auto at = static_cast<std::size_t>(bin);
    float& most = own[at >> BlockBits];
    most = std::max(most, std::abs(this->All[at + 1].Mean[0] - this->All[at].Mean[0]));
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
