// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Request/SampledTransfer.h"

#include "Acceleration/RareValues.h"

#include <vtkColorTransferFunction.h>
#include <vtkPiecewiseFunction.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <optional>

namespace TemporalCoherence
{
namespace
{

/// Intervals between samples.
constexpr std::size_t MostIntervals = 1 << 16;

/// Intervals at each end, among MostIntervals, in which the function goes over to its farther end.
constexpr std::size_t IntervalsOfEnd = MostIntervals / 16;

/// Clamp a number to [0, 1]. Valid nodes may give NaN, for example by logarithms of negative
/// positions.
double ShareOf(double value)
{
  return value >= 0.0 ? std::min(value, 1.0) : 0.0;
}

/// Samples functions at equal distances.
class Sampler
{
public:
  Sampler(
    const TransferFunctions& functions, const std::vector<double>& nodes, const AskedValues& asked)
    : Of(functions)
  {
    this->Spread(nodes, asked);
    constexpr auto intervals = static_cast<double>(MostIntervals);
    this->Made.Range = { this->First, this->First + intervals * this->Step };
    this->Made.Nodes.resize(MostIntervals + 1);
    this->SampleColors();
    this->SampleOpacities(asked);
    this->SampleFarEnds();
  }

  TransferFunction Made;

private:
  double At(std::size_t i) const { return this->First + static_cast<double>(i) * this->Step; }
  int Count() const { return static_cast<int>(this->Made.Nodes.size()); }

  /// Choose the places of samples.
  void Spread(const std::vector<double>& nodes, const AskedValues& asked)
  {
    const glm::dvec2 whole(std::clamp(nodes.front(), asked.Range.x, asked.Range.y),
      std::clamp(nodes.back(), asked.Range.x, asked.Range.y));
    if (this->SpreadOverNodes(nodes, whole))
    {
      return;
    }
    constexpr auto intervals = static_cast<double>(MostIntervals);
    const glm::dvec2 near(std::max(whole.x, asked.Dense.x), std::min(whole.y, asked.Dense.y));
    this->FarLow = near.x > whole.x ? std::optional<double>(asked.Range.x) : std::nullopt;
    this->FarHigh = near.y < whole.y ? std::optional<double>(asked.Range.y) : std::nullopt;
    if (near != whole && this->SpreadOverNodes(nodes, near))
    {
      return;
    }
    // Four intervals may lie beyond the nodes. A step must exceed rounding errors.
    const double largest = std::max(std::abs(near.x), std::abs(near.y));
    const double least = std::max(largest * 0x1p-50, 0x1p-960);
    this->Step =
      std::exp2(std::ceil(std::log2(std::max((near.y - near.x) / (intervals - 4.0), least))));
    this->First = (std::floor(near.x / this->Step) - 1.0) * this->Step;
  }

  /// Choose places that meet all nodes in a range.
  /// \return false if there are no such places
  bool SpreadOverNodes(const std::vector<double>& nodes, const glm::dvec2& range)
  {
    constexpr auto intervals = static_cast<double>(MostIntervals);
    constexpr double rounding = 1e-6;
    const std::vector<double> between(std::lower_bound(nodes.begin(), nodes.end(), range.x),
      std::upper_bound(nodes.begin(), nodes.end(), range.y));
    const double common = StepBetween(between, range.y - range.x);
    if (!(common > 0.0))
    {
      return false;
    }
    // Each node keeps its sample even if others are left out later.
    const double anchor = between.front();
    const double before = std::ceil((anchor - range.x) / common - rounding) + 1.0;
    const double behind = std::ceil((range.y - anchor) / common - rounding) + 1.0;
    this->Step = common / std::exp2(std::floor(std::log2(intervals / (before + behind))));
    this->First = anchor - before * common;
    return true;
  }

  /// A step that meets every node and covers a range with the available samples; 0 if there is
  /// none.
  static double StepBetween(const std::vector<double>& nodes, double width)
  {
    constexpr double most = 0.5 * MostIntervals;
    if (nodes.size() != 1)
    {
      return nodes.empty() ? 0.0 : CommonStep(nodes, width, most);
    }
    // A single node gets at least a few samples on each side. Curved functions keep more of them.
    const double step = std::exp2(std::ceil(std::log2(width))) / 16.0;
    return step > std::abs(nodes.front()) * 0x1p-34 && std::isfinite(step) ? step : 0.0;
  }

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

  /// Correct a sample: a table of VTK that begins before the first node is black at this node.
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

  /// Sample opacities, and clamp all numbers to their range.
  void SampleOpacities(const AskedValues& asked)
  {
    std::vector<double> opacities(this->Made.Nodes.size());
    this->Of.Opacity->GetTable(
      this->Made.Range.x, this->Made.Range.y, this->Count(), opacities.data());
    const glm::dvec2& range = asked.Range;
    for (std::size_t i = 0; i < opacities.size(); ++i)
    {
      if (const double at = this->At(i); asked.AreClamped && (at < range.x || at > range.y))
      {
        opacities[i] = this->Of.Opacity->GetValue(at < range.x ? range.x : range.y);
      }
      glm::dvec4& node = this->Made.Nodes[i];
      node = { ShareOf(node.x), ShareOf(node.y), ShareOf(node.z), ShareOf(opacities[i]) };
    }
  }

  /// Let values beyond the samples look like the farthest ones.
  void SampleFarEnds()
  {
    std::vector<glm::dvec4>& nodes = this->Made.Nodes;
    const auto goOver = [&](double far, auto place)
    {
      const glm::dvec4 end = this->LookAt(far), begin = nodes[place(IntervalsOfEnd)];
      for (std::size_t i = 0; i < IntervalsOfEnd; ++i)
      {
        const double share = static_cast<double>(i) / static_cast<double>(IntervalsOfEnd);
        nodes[place(i)] = glm::mix(end, begin, share);
      }
    };
    if (this->FarLow)
    {
      goOver(*this->FarLow, [](std::size_t i) { return i; });
    }
    if (this->FarHigh)
    {
      goOver(*this->FarHigh, [](std::size_t i) { return MostIntervals - i; });
    }
  }

  glm::dvec4 LookAt(double value) const
  {
    glm::dvec4 look(0.0);
    if (this->Of.Color)
    {
      this->Of.Color->GetColor(value, &look.x);
    }
    else
    {
      look = glm::dvec4(glm::dvec3(this->Of.Gray->GetValue(value)), 0.0);
    }
    look.w = this->Of.Opacity->GetValue(value);
    return { ShareOf(look.x), ShareOf(look.y), ShareOf(look.z), ShareOf(look.w) };
  }

  TransferFunctions Of;
  double Step = 1.0, First = 0.0;
  std::optional<double> FarLow, FarHigh; ///< values beyond the samples, where functions go on
};

/// Sample functions at equal distances over the range that the data and the nodes have in common,
/// and slightly beyond. Nodes far from the data leave no trace. Each node in this range has a
/// sample if all nodes there fit one grid.
/// \param nodes of the functions (FindNodes)
TransferFunction SampleFunctions(
  const TransferFunctions& functions, const std::vector<double>& nodes, const AskedValues& asked)
{
  return Sampler(functions, nodes, asked).Made;
}

/// Mix a share of another function, sampled at equal values, into a function. The other function
/// counts as black where its opacity is 0.
void MixIn(const TransferFunction& other, double share, TransferFunction& into)
{
  assert(other.Range == into.Range && other.Nodes.size() == into.Nodes.size());
  for (std::size_t i = 0; i < into.Nodes.size(); ++i)
  {
    const glm::dvec4& node = other.Nodes[i];
    into.Nodes[i] = glm::mix(into.Nodes[i], node.w > 0.0 ? node : glm::dvec4(0.0), share);
  }
}

/// A slightly wider range with rounded ends, so that functions need not be sampled again for each
/// time step.
glm::dvec2 Rounded(const glm::dvec2& range)
{
  const double width = range.y - range.x;
  const double step = std::exp2(std::floor(std::log2(width)) - 3.0);
  const glm::dvec2 rounded = { std::floor(range.x / step) * step,
    std::ceil(range.y / step) * step };
  return width > 0.0 && step > 0.0 && std::isfinite(rounded.y - rounded.x) ? rounded : range;
}

/// Lower limit of intervals between the remaining samples.
constexpr std::size_t FewestIntervals = 1 << 4;

/// Largest difference between straight lines and left-out samples. Opacities add up along a ray.
constexpr double LargestColorError = 0.0005, LargestOpacityError = 1e-5;

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

/// Leave out samples that interpolation of the others gives.
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

SampledTransfer::Found::Found(const TransferFunctions& functions)
  : Functions(functions)
  , Colors(functions.Colors())
  , Opacities(functions.Opacity)
  , ColorTime(functions.Colors()->GetMTime())
  , OpacityTime(functions.Opacity->GetMTime())
{
}

bool SampledTransfer::Found::operator==(const Found& other) const
{
  return this->Colors == other.Colors && this->Opacities == other.Opacities &&
    this->ColorTime == other.ColorTime && this->OpacityTime == other.OpacityTime;
}

bool SampledTransfer::Find(const TransferFunctions& functions, std::string& error)
{
  return this->Find({ Found(functions) }, 1.0, error);
}

bool SampledTransfer::FindMixture(const TransferFunctions& functions, double share,
  const TransferFunctions& others, std::string& error)
{
  return this->Find({ Found(functions), Found(others) }, share, error);
}

bool SampledTransfer::Find(const std::vector<Found>& sources, double share, std::string& error)
{
  if (this->Sources == sources && this->Share == share)
  {
    return true;
  }
  this->Sources.clear();
  this->Transfer.Nodes.clear();
  std::vector<double> nodes;
  for (const Found& source : sources)
  {
    if (!FindNodes(source.Functions, this->Nodes, error))
    {
      return false;
    }
    nodes.insert(nodes.end(), this->Nodes.begin(), this->Nodes.end());
  }
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  this->Nodes.swap(nodes);
  this->Sources = sources;
  this->Share = share;
  return true;
}

/// The surroundings of nodes that lie close together, if the other nodes in a range are so far away
/// that samples between all of them would not tell the close ones apart; else the range.
glm::dvec2 SampledTransfer::RangeOfCloseNodes(const glm::dvec2& range) const
{
  // A gap of so many times their width leaves too few samples to close nodes.
  constexpr double far = 256.0, around = 4.0;
  constexpr std::size_t most = 64; // larger tables are regular
  std::vector<double> places;
  for (const double node : this->Nodes)
  {
    const double place = std::clamp(node, range.x, range.y);
    if (places.empty() || place > places.back())
    {
      places.push_back(place);
    }
  }
  if (places.size() < 3 || places.size() > most)
  {
    return range;
  }
  double widest = 0.0;
  glm::dvec2 close = range;
  for (std::size_t first = 0; first < places.size(); ++first)
  {
    for (std::size_t last = first + 1; last < places.size(); ++last)
    {
      const double width = places[last] - places[first];
      const bool endsLow = first == 0;
      const bool endsHigh = last + 1 == places.size();
      if (width > widest && !(endsLow && endsHigh) &&
        (endsLow || places[first] - places[first - 1] > far * width) &&
        (endsHigh || places[last + 1] - places[last] > far * width))
      {
        widest = width;
        close = { endsLow ? range.x : places[first] - around * width,
          endsHigh ? range.y : places[last] + around * width };
      }
    }
  }
  return close;
}

const TransferFunction& SampledTransfer::Sample(const AskedValues& asked)
{
  assert(!this->Sources.empty());
  if (this->Transfer.Nodes.empty() || !(this->Asked == asked))
  {
    this->Transfer = SampleFunctions(this->Sources.front().Functions, this->Nodes, asked);
    if (this->Sources.size() > 1)
    {
      const TransferFunction others =
        SampleFunctions(this->Sources.back().Functions, this->Nodes, asked);
      MixIn(others, 1.0 - this->Share, this->Transfer);
    }
    Thin(this->Transfer);
    this->Asked = asked;
  }
  return this->Transfer;
}

const TransferFunction& SampledTransfer::SampleFor(
  const Field& field, const glm::dvec2& range, bool mayLeaveOutRare)
{
  AskedValues asked{ Rounded(range), {}, false };
  asked.Dense = asked.Range;
  const glm::dvec2 close = this->RangeOfCloseNodes(asked.Range);
  if (mayLeaveOutRare && close != asked.Range && field.HasCells() &&
    AreRareBeyond(field, close, range))
  {
    asked.Dense = close;
  }
  return this->Sample(asked);
}

}
