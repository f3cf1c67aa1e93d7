// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Samples/MediumTables.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

/// A range without width is a step: a ramp of this width, relative to its value.
constexpr double WidthOfStep = 1e-6;

std::array<float, 4> OpacityAndColor(const glm::dvec4& node)
{
  const glm::vec3 color(node);
  return { SingleOpacity(node.w), color.x, color.y, color.z };
}

MediumBin BinBetween(const glm::dvec4& a, const glm::dvec4& b)
{
  MediumBin bin{ OpacityAndColor(a), OpacityAndColor(b) };
  for (std::size_t i = 0; i < bin.Rise.size(); ++i)
  {
    bin.Rise[i] -= bin.Value[i];
  }
  return bin;
}

}

MediumTable::MediumTable(const TransferFunction& transfer)
  : Low(transfer.Range.x)
{
  const std::vector<glm::dvec4>& nodes = transfer.Nodes;
  const double width = transfer.Range.y - transfer.Range.x;
  const double least = WidthOfStep * std::max(std::abs(this->Low), 1.0);
  this->PerValue = static_cast<double>(nodes.size() - 1) / (width > 0.0 ? width : least);
  this->Bins.reserve(nodes.size() + 1);
  this->Bins.push_back(BinBetween(nodes.front(), nodes.front()));
  for (std::size_t i = 1; i < nodes.size(); ++i)
  {
    this->Bins.push_back(BinBetween(nodes[i - 1], nodes[i]));
  }
  this->Bins.push_back(BinBetween(nodes.back(), nodes.back()));
  this->SeenBefore.reserve(this->Bins.size() + 1);
  this->SeenBefore.push_back(0);
  for (const MediumBin& bin : this->Bins)
  {
    const bool isSeen = bin.Value[0] > 0.0f || bin.Rise[0] > 0.0f;
    this->SeenBefore.push_back(this->SeenBefore.back() + (isSeen ? 1u : 0u));
  }
}

}
