// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Changes/Changes.h"

namespace Fuzz
{
namespace Changes
{
namespace
{

using Kinds = std::vector<const ChangeKind*>;

void Append(Kinds& kinds, const std::vector<ChangeKind>& group)
{
  for (const ChangeKind& kind : group)
  {
    kinds.push_back(&kind);
  }
}

Kinds MakeKinds(bool ofMeshes, bool ofManyLayers, bool ofLabels = false)
{
  Kinds kinds;
  for (const auto* group : { &OfData(), &OfCamera(), &OfIsovalues(), &OfAppearance(), &OfLights(),
         &OfRegion(), &OfTransform(), &OfSettings() })
  {
    Append(kinds, *group);
  }
  if (ofMeshes)
  {
    Append(kinds, OfMeshes());
  }
  if (ofManyLayers)
  {
    Append(kinds, OfManyLayers());
  }
  if (ofLabels)
  {
    Append(kinds, OfLabels());
  }
  return kinds;
}

/// All that may happen in a world.
const Kinds& KindsOf(const World& world)
{
  static const Kinds ofLattices = MakeKinds(false, false), ofMeshes = MakeKinds(true, false),
                     ofLarge = MakeKinds(true, true), ofLabels = MakeKinds(false, false, true);
  return world.IsLarge ? ofLarge
    : world.IsOfMeshes ? ofMeshes
    : world.IsOfLabels ? ofLabels
                       : ofLattices;
}

}

void MakeOne(World& world)
{
  const auto theme = static_cast<std::size_t>(world.About);
  int sum = 0;
  for (const ChangeKind* kind : KindsOf(world))
  {
    sum += kind->Weights[theme];
  }
  int choice = world.From.Pick(sum);
  for (const ChangeKind* kind : KindsOf(world))
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
