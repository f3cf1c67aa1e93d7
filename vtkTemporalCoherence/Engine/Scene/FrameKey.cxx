// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/FrameKey.h"

namespace TemporalCoherence
{

bool AreAlike(const Field& a, const Field& b)
{
  const auto canBeTold = [](const Field& field)
  { return field.HasCells() && field.Kind->Abilities().TimeSteps && !field.Hidden; };
  return canBeTold(a) && canBeTold(b) && AreSame(a.Kind, b.Kind) && a.Type == b.Type &&
    a.Between == b.Between && a.Dimensions == b.Dimensions;
}

FrameChange CompareFrames(const FrameKey& last, const FrameKey& next)
{
  FrameChange change;
  change.Data = !(last.Samples == next.Samples) || !(last.Transform == next.Transform) ||
    !(last.Kept == next.Kept);
  change.Samples = change.Data && last.Transform == next.Transform && last.Kept == next.Kept &&
    AreAlike(last.Samples, next.Samples);
  change.View = !(last.Seen == next.Seen);
  change.Surfaces = !AreMetAlike(last.Sought, next.Sought);
  change.Opacity = !change.Surfaces && !(last.Sought == next.Sought);
  change.Raised = change.Surfaces && last.Sought.Mode == next.Sought.Mode &&
    last.Sought.Isovalues.size() == 1 && next.Sought.Isovalues.size() == 1 &&
    next.Sought.Isovalues[0] > last.Sought.Isovalues[0];
  change.Appearance = !(last.Look == next.Look);
  return change;
}

bool AreHitsOrdered(const FrameKey& key)
{
  return key.Kept.IsConvex() && (!key.Samples.Hidden || key.Sought.Mode == SurfaceMode::Threshold);
}

}
