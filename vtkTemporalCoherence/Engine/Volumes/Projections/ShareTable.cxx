// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Projections/ShareTable.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace TemporalCoherence
{
namespace
{

/// Number of bins in the range, at least.
constexpr int FewestBins = 2048;

/// The largest sum, in quanta.
constexpr double LargestSum = 1 << 30;

/// Opacity and share at nodes.
struct Functions
{
  std::vector<double> Opacity, Share;

  double Product(std::size_t node) const { return this->Opacity[node] * this->Share[node]; }

  /// The integral over a bin: both are linear in it.
  double SumOf(std::size_t bin) const
  {
    const double rise = this->Opacity[bin + 1] - this->Opacity[bin];
    const double step = this->Share[bin + 1] - this->Share[bin];
    return this->Product(bin) + 0.5 * (this->Opacity[bin] * step + rise * this->Share[bin]) +
      rise * step / 3.0;
  }
};

Functions FunctionsOf(const TransferFunction& transfer, const glm::dvec2& range, int bins)
{
  const std::vector<glm::dvec4>& nodes = transfer.Nodes;
  const auto between = static_cast<int>(nodes.size()) - 1;
  const int perNode = bins / between;
  const double width = range.y - range.x;
  Functions functions;
  for (int bin = 0; bin <= bins; ++bin)
  {
    const int node = std::min(bin / perNode, between - 1);
    const double share = static_cast<double>(bin - node * perNode) / perNode;
    functions.Opacity.push_back(glm::mix(
      nodes[static_cast<std::size_t>(node)].w, nodes[static_cast<std::size_t>(node + 1)].w, share));
    const double value =
      glm::mix(transfer.Range.x, transfer.Range.y, static_cast<double>(bin) / bins);
    functions.Share.push_back(width > 0.0 ? (value - range.x) / width : 0.0);
  }
  return functions;
}

/// The bend between some bins.
ShareTable::Bend BendOf(const Functions& functions, int first, int last)
{
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double least = infinity, most = -infinity, flattest = infinity, steepest = -infinity;
  for (int bin = first; bin < last; ++bin)
  {
    const double from = functions.Product(static_cast<std::size_t>(bin));
    const double to = functions.Product(static_cast<std::size_t>(bin + 1));
    least = std::min({ least, from, to });
    most = std::max({ most, from, to });
    flattest = std::min(flattest, to - from);
    steepest = std::max(steepest, to - from);
  }
  return { static_cast<float>(steepest - flattest), static_cast<float>(most - least) };
}

}

ShareTable::ShareTable(const TransferFunction& transfer, const glm::dvec2& range)
{
  const auto between = static_cast<int>(transfer.Nodes.size()) - 1;
  this->Bins = (FewestBins + between - 1) / between * between;
  this->Low = transfer.Range.x;
  this->PerValue = this->Bins / (transfer.Range.y - transfer.Range.x);
  const Functions functions = FunctionsOf(transfer, range, this->Bins);
  this->SharePerBin =
    static_cast<float>((functions.Share.back() - functions.Share.front()) / this->Bins);

  std::vector<double> sums{ 0.0 };
  double largest = std::numeric_limits<double>::min();
  for (std::size_t bin = 0; bin < static_cast<std::size_t>(this->Bins); ++bin)
  {
    sums.push_back(sums.back() + functions.SumOf(bin));
    largest = std::max(largest, std::abs(sums.back()));
  }
  this->Quantum = static_cast<float>(largest / LargestSum);
  for (std::size_t bin = 0; bin < static_cast<std::size_t>(this->Bins); ++bin)
  {
    const double opacity = functions.Opacity[bin];
    this->Nodes.push_back(
      { static_cast<float>(opacity), static_cast<float>(functions.Opacity[bin + 1] - opacity),
        static_cast<float>(functions.Share[bin]),
        static_cast<std::int32_t>(std::lround(sums[bin] / largest * LargestSum)) });
  }

  // Cover 2 blocks on each side, as a stretch of a ray may reach so far. The function bends at both
  // ends of the range, too.
  constexpr int around = 2, size = 1 << BlockBits;
  for (int begin = 0; begin <= this->Bins; begin += size)
  {
    const int first = std::max(begin - around * size, 0);
    const int last = std::min(begin + (around + 1) * size, this->Bins);
    this->Bends.push_back(BendOf(functions, first, last));
  }
  this->Largest = BendOf(functions, 0, this->Bins);
}

}
