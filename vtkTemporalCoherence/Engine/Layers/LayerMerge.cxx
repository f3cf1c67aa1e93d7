// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/LayerMerge.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace TemporalCoherence
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// The position of each number of a list in another list, or Frame::NoSurface.
std::vector<std::int16_t> PositionsIn(
  const std::vector<double>& list, const std::vector<double>& numbers)
{
  std::map<double, std::int16_t> positions;
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    positions.emplace(list[i], static_cast<std::int16_t>(i));
  }
  std::vector<std::int16_t> found;
  for (const double number : numbers)
  {
    const auto position = positions.find(number);
    found.push_back(position == positions.end() ? Frame::NoSurface : position->second);
  }
  return found;
}

std::vector<float> LeastAlphasOf(const Surfaces& surfaces)
{
  double share = 1.0;
  const std::vector<glm::dvec2>& nodes = surfaces.ByGradient.Nodes;
  if (!nodes.empty())
  {
    const auto lowest = std::min_element(nodes.begin(), nodes.end(),
      [](const glm::dvec2& a, const glm::dvec2& b) { return a.y < b.y; });
    // Between nodes rounding may go below them.
    constexpr double withoutRounding = 1.0 - 1e-6;
    share = withoutRounding * lowest->y;
  }
  std::vector<double> opacities = surfaces.Opacities;
  opacities.resize(surfaces.Isovalues.size(), 1.0);
  std::vector<float> alphas;
  for (const double opacity : opacities)
  {
    alphas.push_back(static_cast<float>(opacity * share));
  }
  return alphas;
}

/// The bits of all pixels for which test(place) is true.
template <typename Test>
std::uint64_t PixelsWhere(const Test& test)
{
  std::uint64_t bits = 0;
  for (std::size_t place = 0; place < RayBatch::Capacity; ++place)
  {
    bits |= static_cast<std::uint64_t>(test(place)) << place;
  }
  return bits;
}

}

SurfaceChange::SurfaceChange(const Surfaces& last, const Surfaces& next)
  : Last(last.Isovalues)
  , Next(next.Isovalues)
  , Kept(PositionsIn(next.Isovalues, last.Isovalues))
  , LeastAlphas(LeastAlphasOf(next))
{
  const std::vector<std::int16_t> before = PositionsIn(last.Isovalues, next.Isovalues);
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    if (before[i] == Frame::NoSurface)
    {
      this->New.push_back(static_cast<std::int16_t>(i));
    }
  }
}

/// Put a layer behind another one of its pixel, or first.
void LayerMerge::Link(
  std::size_t place, std::int32_t before, const LayerHit& hit, std::int16_t isovalue)
{
  const auto at = static_cast<std::int32_t>(this->Nodes.size());
  std::int32_t& next =
    before == None ? this->First[place] : this->Nodes[static_cast<std::size_t>(before)].Next;
  const std::int32_t behind = std::exchange(next, at);
  // Member by member: to copy the whole would wait for what was written last.
  Node& node = this->Nodes.emplace_back();
  node.Hit.Depth = hit.Depth;
  node.Hit.Pixel = hit.Pixel;
  node.Hit.Isovalue = isovalue;
  node.Hit.Kind = hit.Kind;
  node.Next = behind;
  this->Last[place] = at;
}

void LayerMerge::Keep(const KnownLayers& known)
{
  this->Nodes.reserve(2 * (known.Composited().size() + known.Behind().size()));
  this->Limits.fill({ -Infinity, HitKind::None, 0.0 });
  RayBatch::Array<float> passed;
  passed.fill(1.0f);
  std::uint64_t goes = 0; // one bit for each pixel whose last layer is of an isovalue that goes
  const PlaceFinder places(this->Part, this->Width);
  known.ForEach(
    [&](const LayerHit& hit)
    {
      const std::size_t place = places.Find(hit.Pixel);
      if (passed[place] == 0.0f)
      {
        return;
      }
      const auto surface = static_cast<std::size_t>(hit.Isovalue);
      this->Limits[place] = { hit.Depth, hit.Kind, this->Change.Last[surface] };
      const std::int16_t kept = this->Change.Kept[surface];
      const std::uint64_t bit = std::uint64_t(1) << place;
      goes = kept == Frame::NoSurface ? goes | bit : goes & ~bit;
      if (kept != Frame::NoSurface)
      {
        this->Link(place, this->Last[place], hit, kept);
        passed[place] = PassedBehind(passed[place], this->AlphaOf(kept));
      }
    });
  this->Uncovered = goes & ~known.Ends();
  this->Limited =
    ~known.Ends() | PixelsWhere([&](std::size_t place) { return passed[place] == 0.0f; });
  this->Last.fill(None); // new ones are searched from the front
}

double LayerMerge::EndOf(std::size_t place) const
{
  return this->Limited >> place & 1u ? std::nextafter(this->Limits[place].Distance, Infinity)
                                     : Infinity;
}

bool LayerMerge::IsInFront(const LayerHit& a, const LayerHit& b) const
{
  return a.Depth == b.Depth ? TemporalCoherence::IsInFront(this->SurfaceOf(a), this->SurfaceOf(b))
                            : a.Depth < b.Depth;
}

void LayerMerge::Add(std::size_t place, const LayerHit& hit)
{
  if (this->Limited >> place & 1u &&
    !TemporalCoherence::IsInFront(this->SurfaceOf(hit), this->Limits[place]))
  {
    return;
  }
  std::int32_t before = this->Last[place];
  std::int32_t next =
    before == None ? this->First[place] : this->Nodes[static_cast<std::size_t>(before)].Next;
  while (next != None && this->IsInFront(this->Nodes[static_cast<std::size_t>(next)].Hit, hit))
  {
    before = next;
    next = this->Nodes[static_cast<std::size_t>(next)].Next;
  }
  this->Link(place, before, hit, hit.Isovalue);
}

KnownLayers LayerMerge::Finish() const
{
  std::vector<LayerHit> layers;
  layers.reserve(this->Nodes.size());
  RayBatch::Array<float> passed;
  passed.fill(1.0f);
  RayBatch::Array<std::int32_t> next = this->First;
  std::uint64_t left = PixelsWhere([&](std::size_t place) { return next[place] != None; });
  std::uint64_t opaque = 0;
  while (left != 0)
  {
    // One round: the next layer of each pixel.
    ForEachRay(left,
      [&](std::size_t place)
      {
        const Node& node = this->Nodes[static_cast<std::size_t>(next[place])];
        layers.push_back(node.Hit);
        next[place] = node.Next;
        passed[place] = PassedBehind(passed[place], this->AlphaOf(node.Hit.Isovalue));
        const bool isOpaque = passed[place] == 0.0f;
        opaque |= static_cast<std::uint64_t>(isOpaque) << place;
        left &= ~(static_cast<std::uint64_t>(isOpaque || node.Next == None) << place);
      });
  }
  return KnownLayers(std::move(layers), ~(this->Limited | opaque));
}

}
