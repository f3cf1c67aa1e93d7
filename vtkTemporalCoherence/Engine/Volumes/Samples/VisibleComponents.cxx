// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Samples/VisibleComponents.h"

#include "Volumes/Medium/VisibleBands.h"
#include "Volumes/Samples/ComponentLooks.h"

#include <cstddef>

namespace TemporalCoherence
{

std::optional<std::vector<std::vector<ValueBand>>> VisibleComponents(const Blending& volume)
{
  using Bands = std::vector<ValueBand>;
  if (volume.Others.empty())
  {
    const std::optional<Bands> bands = VisibleBands(volume);
    return bands ? std::optional(std::vector<Bands>{ *bands }) : std::nullopt;
  }
  if (volume.Mode != BlendMode::Composite)
  {
    return std::nullopt;
  }
  const ComponentLooks looks(volume);
  std::vector<Bands> all(looks.Components());
  for (std::size_t part = 0; part < looks.Parts(); ++part)
  {
    if (looks.WeightOf(part) > 0.0)
    {
      Blending alone;
      alone.Mode = volume.Mode;
      alone.Looks = { looks.Of(part) };
      all[looks.OpacityOf(part)] = *VisibleBands(alone);
    }
  }
  return all;
}

}
