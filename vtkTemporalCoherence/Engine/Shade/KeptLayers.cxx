// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/KeptLayers.h"

#include "Scene/LayerBatch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace TemporalCoherence
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// The light that passes the layers of the pixels of a tile.
class PassedLight
{
public:
  explicit PassedLight(const std::vector<float>& alphas)
    : Alphas(alphas)
  {
    this->Passed.fill(1.0f);
  }

  bool Reaches(std::size_t place) const { return this->Passed[place] > 0.0f; }

  void Pass(std::size_t place, const LayerHit& hit)
  {
    this->Passed[place] =
      PassedBehind(this->Passed[place], this->Alphas[static_cast<std::size_t>(hit.Isovalue)]);
  }

  /// One bit for each pixel that is opaque.
  std::uint64_t Opaque() const
  {
    std::uint64_t opaque = 0;
    for (std::size_t place = 0; place < this->Passed.size(); ++place)
    {
      opaque |= static_cast<std::uint64_t>(!this->Reaches(place)) << place;
    }
    return opaque;
  }

private:
  const std::vector<float>& Alphas;
  RayBatch::Array<float> Passed;
};

}

KeptIsovalues::KeptIsovalues(const std::vector<double>& last, const std::vector<double>& next)
{
  const auto positionIn = [](const std::vector<double>& list, double isovalue)
  {
    const auto found = std::find(list.begin(), list.end(), isovalue);
    return found == list.end() ? Frame::NoSurface : static_cast<std::int16_t>(found - list.begin());
  };
  for (const double isovalue : last)
  {
    this->Next.push_back(positionIn(next, isovalue));
  }
  for (std::size_t i = 0; i < next.size(); ++i)
  {
    if (positionIn(last, next[i]) == Frame::NoSurface)
    {
      this->New.push_back(static_cast<std::int16_t>(i));
    }
  }
}

std::vector<double> LeastOpacitiesOf(const Surfaces& surfaces)
{
  std::vector<double> least = surfaces.Opacities;
  least.resize(surfaces.Isovalues.size(), 1.0);
  const std::vector<glm::dvec2>& nodes = surfaces.ByGradient.Nodes;
  if (!nodes.empty())
  {
    const auto lowest = std::min_element(nodes.begin(), nodes.end(),
      [](const glm::dvec2& a, const glm::dvec2& b) { return a.y < b.y; });
    // Between nodes rounding may go below them.
    constexpr double withoutRounding = 1.0 - 1e-6;
    for (double& opacity : least)
    {
      opacity *= withoutRounding * lowest->y;
    }
  }
  return least;
}

KeptLayers::KeptLayers(const KnownLayers& known, const PixelRect& part, int width,
  const std::vector<double>& isovalues, const KeptIsovalues& kept, const std::vector<float>& alphas)
{
  this->Limits.fill({ -Infinity, HitKind::None, 0.0 });
  PassedLight light(alphas);
  known.ForEach(
    [&](const LayerHit& hit)
    {
      const std::size_t place = PlaceInTile(part, width, hit.Pixel);
      if (!light.Reaches(place))
      {
        return;
      }
      const auto surface = static_cast<std::size_t>(hit.Isovalue);
      this->Limits[place] = { hit.Depth, hit.Kind, isovalues[surface] };
      if (kept.Next[surface] != Frame::NoSurface)
      {
        LayerHit& now = this->Hits.emplace_back(hit);
        now.Isovalue = kept.Next[surface];
        light.Pass(place, now);
      }
    });
  this->Limited = ~known.Ends() | light.Opaque();
}

double KeptLayers::EndOf(std::size_t place) const
{
  return this->Limited >> place & 1u ? std::nextafter(this->Limits[place].Distance, Infinity)
                                     : Infinity;
}

std::uint64_t DropUnlit(
  const PixelRect& part, int width, const std::vector<float>& alphas, std::vector<LayerHit>& layers)
{
  PassedLight light(alphas);
  layers.erase(std::remove_if(layers.begin(), layers.end(),
                 [&](const LayerHit& hit)
                 {
                   const std::size_t place = PlaceInTile(part, width, hit.Pixel);
                   const bool isLit = light.Reaches(place);
                   if (isLit)
                   {
                     light.Pass(place, hit);
                   }
                   return !isLit;
                 }),
    layers.end());
  return light.Opaque();
}

}
