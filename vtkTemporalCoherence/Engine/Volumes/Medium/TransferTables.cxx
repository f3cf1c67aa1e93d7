// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Medium/TransferTables.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace TemporalCoherence
{
namespace
{

/// Number of bins in the range, at least.
constexpr int FewestBins = 2048;

/// Weight of an opaque range of values in sums, in bins of the largest extinction. Larger sums
/// would lose the digits of values behind the range.
constexpr double MostOfRange = 0.25;

/// Extinctions above this share of the largest one count as opaque.
constexpr double ShareOfOpaque = 1.0 / 256.0;

/// Relative precision of a typical mean of a stretch, and relative rounding error of floats.
constexpr double WantedDigits = 1e-3, Rounding = 6e-8;

/// Order has two digits for stretches with this share of the total extinction.
constexpr double ShareOfOrdered = 1e-3;

/// Rounding errors of values in bins, relative to the range, and to its low end.
constexpr double RoundingOfRange = 1e-6, RoundingOfLow = 3e-7;

/// The integral of -ln(1 - x) from 0 to an opacity.
double SumOfDepths(double opacity)
{
  return opacity >= 1.0 ? 1.0 : (1.0 - opacity) * std::log1p(-opacity) + opacity;
}

double DepthOf(double opacity)
{
  return -std::log1p(-opacity);
}

/// The optical depths at the ends of a bin, linear in between.
struct DepthOfBin
{
  double First, Last;
};

/// The depth has no bound where an opacity reaches 1, but a finite mean. A line with this mean
/// replaces it.
DepthOfBin DepthBetween(double a, double b, double most)
{
  if (a >= 1.0 && b >= 1.0)
  {
    return { most, most };
  }
  if (a < 1.0 && b < 1.0)
  {
    return { std::min(DepthOf(a), most), std::min(DepthOf(b), most) };
  }
  const double mean = (SumOfDepths(b) - SumOfDepths(a)) / (b - a);
  const double other = DepthOf(std::min(a, b));
  const double atOne = std::max(2.0 * mean - other, 0.0);
  return a >= 1.0 ? DepthOfBin{ atOne, other } : DepthOfBin{ other, atOne };
}

/// True for bins that are opaque from end to end.
bool IsOpaque(const DepthOfBin& depth, double most)
{
  return depth.First >= most && depth.Last >= most;
}

/// The depths of all bins.
/// \param function at the begin of each bin; the last bin has no width
std::vector<DepthOfBin> DepthsOf(const std::vector<glm::dvec4>& function, double most)
{
  std::vector<DepthOfBin> depths;
  for (std::size_t bin = 0; bin + 1 < function.size(); ++bin)
  {
    depths.push_back(DepthBetween(function[bin].w, function[bin + 1].w, most));
  }
  // A ramp that only reaches opacity 1 at the end of the range makes no values beyond it opaque.
  const DepthOfBin end = depths.back();
  depths.push_back(IsOpaque(end, most) ? end : DepthOfBin{ end.Last, end.Last });
  return depths;
}

/// The weight of each bin in sums, by the length of the opaque range around it.
std::vector<double> SharesCounted(const std::vector<DepthOfBin>& depths, double most)
{
  std::vector<double> shares(depths.size(), 1.0);
  for (std::size_t begin = 0; begin < depths.size(); ++begin)
  {
    std::size_t end = begin;
    while (end < depths.size() && IsOpaque(depths[end], most))
    {
      ++end;
    }
    const auto length = static_cast<double>(end - begin);
    std::fill(shares.begin() + static_cast<std::ptrdiff_t>(begin),
      shares.begin() + static_cast<std::ptrdiff_t>(end),
      std::min(1.0, MostOfRange / std::max(length, 1.0)));
    begin = std::max(begin, end);
  }
  return shares;
}

/// TransferTables::Steepness.
std::vector<float> SteepnessOf(const std::vector<EmissionBin>& bins, float opaque)
{
  const std::size_t blocks = (bins.size() >> TransferTables::BlockBits) + 1;
  std::vector<float> own(blocks, 0.0f), steepness;
  for (std::size_t bin = 0; bin < bins.size(); ++bin)
  {
    float& most = own[bin >> TransferTables::BlockBits];
    most = std::max(most, std::min(std::abs(bins[bin].Rise[0]), opaque));
    for (std::size_t color = 1; color < 4; ++color)
    {
      const float before = bin > 0 ? bins[bin - 1].Rise[color] : 0.0f;
      most = std::max(most, std::min(std::abs(bins[bin].Rise[color] - before), opaque));
    }
  }
  for (int level = 0; level < TransferTables::Levels; ++level)
  {
    const bool isHighest = level == TransferTables::Levels - 1;
    const std::size_t around = isHighest ? blocks : std::size_t(1) << level;
    for (std::size_t block = 0; block < blocks; ++block)
    {
      const auto begin =
        own.begin() + static_cast<std::ptrdiff_t>(block < around ? 0 : block - around);
      const auto end =
        own.begin() + static_cast<std::ptrdiff_t>(std::min(block + around + 1, blocks));
      steepness.push_back(*std::max_element(begin, end));
    }
  }
  return steepness;
}

/// The integral over a bin of each channel times the sum of extinction so far.
/// \param sum     of extinction before the bin
/// \param counted weight of the bin in sums
glm::dvec4 OrderIn(double sum, double counted, const glm::dvec4& value, const glm::dvec4& rise)
{
  const glm::dvec4 own =
    value * (value.x / 2.0 + rise.x / 6.0) + rise * (value.x / 3.0 + rise.x / 8.0);
  return counted * (sum * (value + 0.5 * rise) + counted * own);
}

}

TransferTables::TransferTables(const ComponentLook& look, double mostExtinction)
{
  const std::vector<glm::dvec4>& nodes = look.Transfer.Nodes;
  const auto between = static_cast<int>(nodes.size()) - 1;
  const int perNode = (FewestBins + between - 1) / between;
  this->Bins = perNode * between;
  this->Low = look.Transfer.Range.x;
  this->PerValue = this->Bins / (look.Transfer.Range.y - look.Transfer.Range.x);
  this->Beyond = static_cast<float>(
    std::max(RoundingOfRange * this->Bins, RoundingOfLow * std::abs(this->Low * this->PerValue)));
  this->MostExtinction = static_cast<float>(mostExtinction);
  this->MostCounted = static_cast<float>(ShareOfOpaque * mostExtinction);
  // The function at the begin of each bin.
  std::vector<glm::dvec4> at;
  for (int bin = 0; bin <= this->Bins; ++bin)
  {
    const int node = std::min(bin / perNode, between - 1);
    const double share = static_cast<double>(bin - node * perNode) / perNode;
    const auto before = static_cast<std::size_t>(node);
    at.push_back(glm::mix(nodes[before], nodes[before + 1], share));
  }
  const double most = mostExtinction * look.UnitDistance;
  const std::vector<DepthOfBin> depths = DepthsOf(at, most);
  const std::vector<double> counted = SharesCounted(depths, most);
  glm::dvec4 sum(0.0), order(0.0);
  double moment = 0.0;
  int walls = 0;
  for (int bin = 0; bin <= this->Bins; ++bin)
  {
    const auto here = static_cast<std::size_t>(bin);
    const glm::dvec4 node = at[here];
    const glm::dvec4 next = at[std::min(here + 1, at.size() - 1)];
    const glm::dvec4 value =
      depths[here].First / look.UnitDistance * glm::dvec4(1.0, glm::dvec3(node));
    const glm::dvec4 rise =
      depths[here].Last / look.UnitDistance * glm::dvec4(1.0, glm::dvec3(next)) - value;
    EmissionBin made;
    for (int i = 0; i < 4; ++i)
    {
      const auto place = static_cast<std::size_t>(i);
      made.Value[place] = static_cast<float>(value[i]);
      made.Rise[place] = static_cast<float>(rise[i]);
      made.Sum[place] = static_cast<float>(sum[i]);
    }
    made.Moment = static_cast<float>(moment);
    made.Order = { static_cast<float>(order.y), static_cast<float>(order.z),
      static_cast<float>(order.w) };
    walls += bin > 0 && IsOpaque(depths[here - 1], most) && !IsOpaque(depths[here], most) ? 1 : 0;
    const bool isPeak = node.w >= 1.0 && value.x > 0.0;
    this->AreOpaqueAnywhere |= isPeak || IsOpaque(depths[here], most);
    this->Opaque.push_back(
      { isPeak ? static_cast<float>(mostExtinction / value.x) : 1.0f, static_cast<float>(walls) });
    order += OrderIn(sum.x, counted[here], value, rise);
    sum += counted[here] * (value + 0.5 * rise);
    moment += counted[here] * ((bin + 0.5) * value.x + (0.5 * bin + 1.0 / 3.0) * rise.x);
    this->All.push_back(made);
  }
  this->Closest = static_cast<float>(std::clamp(sum.x * Rounding / WantedDigits, 0.25, 4.0));
  this->LeastOrdered = static_cast<float>(ShareOfOrdered * sum.x);
  this->Steepness = SteepnessOf(this->All, this->MostCounted);
  this->FindBends();
}

void TransferTables::FindBends()
{
  // Opaque bins deviate from any line by more than every tolerance.
  const double never = 1e9 * static_cast<double>(this->MostCounted);
  Emission before{};
  this->Bends = { 0.0 };
  this->Peaks = { 0.0 };
  for (std::size_t bin = 0; bin < this->All.size(); ++bin)
  {
    const EmissionBin& in = this->All[bin];
    const bool isLast = bin + 1 == this->All.size();
    double change = 0.0;
    for (std::size_t i = 0; i < before.size(); ++i)
    {
      const float rise = isLast ? 0.0f : in.Rise[i];
      change = std::max(change, std::abs(static_cast<double>(rise) - before[i]));
      before[i] = rise;
    }
    const bool isPeak = this->IsOpaqueIn(bin);
    this->Bends.push_back(this->Bends.back() + change);
    this->Peaks.push_back(this->Peaks.back() + (isPeak ? never : 0.0));
  }
}

GradientTable::GradientTable(const GradientOpacity& opacity)
{
  constexpr int Entries = 8192;
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
