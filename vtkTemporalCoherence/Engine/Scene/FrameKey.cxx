// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/FrameKey.h"

namespace TemporalCoherence
{

bool AreAlike(const Field& a, const Field& b)
{
  // Samples in files are not read as a whole to find out which of them changed.
  const auto canBeTold = [](const Field& field)
  {
    return field.HasCells() && field.Shape->Abilities().TimeSteps && !field.Flagged && !field.Known;
  };
  return canBeTold(a) && canBeTold(b) && AreSame(a.Shape, b.Shape) && a.Type == b.Type &&
    a.Between == b.Between && a.Dimensions == b.Dimensions;
}

FrameChange CompareFrames(const FrameKey& last, const FrameKey& next)
{
  FrameChange change;
  change.Data = !(last.Samples == next.Samples) || !(last.Transform == next.Transform) ||
    !(last.Region == next.Region);
  change.Samples = change.Data && last.Transform == next.Transform && last.Region == next.Region &&
    AreAlike(last.Samples, next.Samples);
  change.View = !(last.View == next.View);
  change.Surfaces = !AreMetAlike(last.Isosurfaces(), next.Isosurfaces());
  change.Opacity = !change.Surfaces && !(last.Isosurfaces() == next.Isosurfaces());
  change.Appearance = !(last.Appearance == next.Appearance);
  change.Blending = last.IsBlended() != next.IsBlended() ||
    (last.IsBlended() && !(last.Blended() == next.Blended()));
  return change;
}

bool MeetSameLayers(const FrameKey& a, const FrameKey& b)
{
  const FrameChange change = CompareFrames(a, b);
  return !change.Data && !change.View && !change.Surfaces && !change.Blending;
}

}
