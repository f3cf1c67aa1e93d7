// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Samples/VisibleComponents.h"

#include "Scene/LabelSets.h"
#include "Volumes/Medium/VisibleBands.h"
#include "Volumes/Samples/ComponentLooks.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace TemporalCoherence
{

namespace
{

using Bands = std::vector<ValueBand>;

/// The labels with the volume's look.
std::vector<double> WithoutLook(const LabelMap& map)
{
  std::vector<double> labels;
  for (const std::int64_t label : map.Samples.Labels->Labels())
  {
    const auto own = std::lower_bound(map.Looks.begin(), map.Looks.end(), label,
      [](const LabelledLook& look, std::int64_t value) { return look.Label < value; });
    if (own == map.Looks.end() || own->Label != label)
    {
      labels.push_back(static_cast<double>(label));
    }
  }
  return labels;
}

/// Add ranges that count for some labels, together with others that are equal.
void Add(const Bands& bands, const std::vector<double>& labels, std::vector<SeenBands>& all)
{
  const auto same = std::find_if(
    all.begin() + 1, all.end(), [&](const SeenBands& other) { return other.Bands == bands; });
  if (same != all.end())
  {
    same->CountFor.insert(same->CountFor.end(), labels.begin(), labels.end());
  }
  else if (!bands.empty())
  {
    SeenBands& seen = all.emplace_back();
    seen.Bands = bands;
    seen.HasLabels = true;
    seen.CountFor = labels;
  }
}

std::vector<SeenBands> VisibleLabels(const Blending& volume)
{
  const LabelMap& map = *volume.Labels;
  std::vector<SeenBands> all(1); // nothing counts for all labels
  Add(OpaqueBands(volume.Looks.front().Transfer), WithoutLook(map), all);
  for (const LabelledLook& own : map.Looks)
  {
    Add(OpaqueBands(own.Look.Transfer), { static_cast<double>(own.Label) }, all);
  }
  for (SeenBands& seen : all)
  {
    std::sort(seen.CountFor.begin(), seen.CountFor.end());
  }
  return all;
}

}

std::optional<std::vector<SeenBands>> VisibleComponents(const Blending& volume)
{
  if (volume.Labels)
  {
    return VisibleLabels(volume);
  }
  if (volume.Others.empty())
  {
    std::optional<Bands> bands = VisibleBands(volume);
    if (!bands)
    {
      return std::nullopt;
    }
    std::vector<SeenBands> all(1);
    all.front().Bands = std::move(*bands);
    return all;
  }
  if (volume.Mode != BlendMode::Composite)
  {
    return std::nullopt;
  }
  const ComponentLooks looks(volume);
  std::vector<SeenBands> all(1);
  for (std::size_t part = 0; part < looks.Parts(); ++part)
  {
    const std::size_t component = looks.OpacityOf(part);
    if (looks.WeightOf(part) > 0.0)
    {
      Bands bands = OpaqueBands(looks.Of(part).Transfer);
      if (component == 0)
      {
        all.front().Bands = std::move(bands);
      }
      else if (!bands.empty())
      {
        SeenBands& seen = all.emplace_back();
        seen.Component = component;
        seen.Bands = std::move(bands);
      }
    }
  }
  return all;
}

}
