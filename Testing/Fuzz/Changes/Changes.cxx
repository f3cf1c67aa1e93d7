// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Changes/Changes.h"

namespace Fuzz
{
namespace Changes
{
namespace
{

const std::vector<const ChangeKind*>& All()
{
  static const auto all = []
  {
    std::vector<const ChangeKind*> kinds;
    for (const auto* group : { &OfData(), &OfCamera(), &OfIsovalues(), &OfAppearance(), &OfLights(),
           &OfRegion(), &OfTransform(), &OfSettings() })
    {
      for (const ChangeKind& kind : *group)
      {
        kinds.push_back(&kind);
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
  for (const ChangeKind* kind : All())
  {
    sum += kind->Weights[theme];
  }
  int choice = world.From.Pick(sum);
  for (const ChangeKind* kind : All())
  {
    choice -= kind->Weights[theme];
    if (choice < 0)
    {
      Story::Tell(kind->Name);
      kind->Make(world);
      return;
    }
  }
}

}
}
