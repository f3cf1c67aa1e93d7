// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/LineTracer.h"

#include "Render/FrameStructures.h"
#include "Render/ShadeSceneOf.h"
#include "Render/TileTracer.h"

namespace TemporalCoherence
{
namespace
{

/// A parallel view of one pixel, whose ray is the line.
View ViewAlong(const glm::dvec3& begin, const glm::dvec3& end)
{
  View view;
  view.Size = glm::ivec2(1);
  view.Parallel = true;
  view.Position = view.Origin = begin;
  view.Forward = view.Direction = glm::normalize(end - begin);
  view.Near = 0.0;
  view.Far = glm::distance(begin, end);
  return view;
}

}

std::optional<LineHit> TraceLine(
  const FrameKey& scene, const FieldRanges& ranges, const glm::dvec3& begin, const glm::dvec3& end)
{
  FrameKey key = FrameStructures::WithHidden(scene, ranges);
  const glm::dvec2& finiteRange = ranges.Pyramid->FiniteRange();
  key.View = ViewAlong(begin, end);
  key.Appearance = Appearance();
  key.Appearance.Colors.resize(key.Isosurfaces().Isovalues.size());
  Frame frame;
  FrameExtras extras;
  extras.Cells = key.Samples.Shape->Abilities().IsMesh;
  frame.Resize(key.View.Size, extras);
  frame.Layers.resize(key.Isosurfaces().IsTranslucent() ? 1 : 0);
  const PixelRect pixel{ glm::ivec2(0), glm::ivec2(1) };
  // No structures: building them pays for whole pictures only, and reading every cell on one line
  // is quick.
  const TileTracer tracer({ key, nullptr, nullptr, finiteRange });
  TileHits found;
  TraceCounts counts = tracer.Trace(0, pixel, frame, found);
  // Shade, so that surfaces made invisible by gradient opacity are not picked.
  TileShader(ShadeSceneOf(key, finiteRange, {}, nullptr), HitSet::All, HitSet::All)
    .Shade(0, pixel, nullptr, frame, counts);
  if (frame.Isovalues[0] == Frame::NoSurface)
  {
    return std::nullopt;
  }
  return LineHit{ frame.Depth[0], frame.Isovalues[0], begin + frame.Depth[0] * key.View.Direction,
    glm::dvec3(frame.Normals[0]), frame.Cells.empty() ? NoCell : frame.Cells[0] };
}

}
