// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Changes.h"

#include <utility>

namespace Fuzz
{
namespace Changes
{
namespace
{

/// All kinds, and whether they change who sees what.
const std::vector<std::pair<const ChangeKind*, bool>>& All()
{
  static const auto all = []
  {
    std::vector<std::pair<const ChangeKind*, bool>> kinds;
    const std::pair<const std::vector<ChangeKind>&, bool> groups[] = { { OfData(), false },
      { OfCamera(), true }, { OfIsovalues(), false }, { OfLook(), false }, { OfLights(), false },
      { OfRegion(), false }, { OfPlacement(), true }, { OfSettings(), false } };
    for (const auto& [group, isOfView] : groups)
    {
      for (const ChangeKind& kind : group)
      {
        kinds.emplace_back(&kind, isOfView);
      }
    }
    return kinds;
  }();
  return all;
}

}

void MakeOne(World& world)
{
  const auto theme = static_cast<std::size_t>(world.About);
  int sum = 0;
  for (const auto& [kind, isOfView] : All())
  {
    sum += kind->Weights[theme];
  }
  int choice = world.From.Pick(sum);
  for (const auto& [kind, isOfView] : All())
  {
    choice -= kind->Weights[theme];
    if (choice < 0)
    {
      Story::Tell(kind->Name);
      world.IsViewChanged = world.IsViewChanged || isOfView;
      kind->Make(world);
      return;
    }
  }
}

}
}
