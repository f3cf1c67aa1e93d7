// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ShadeSceneOf_h
#define TemporalCoherence_ShadeSceneOf_h

#include "Acceleration/TileBounds.h"
#include "Kinds/FieldKind.h"
#include "Shade/TileShader.h"

namespace TemporalCoherence
{

/// Gather the input for shading the tiles of a frame. The arguments must outlive it.
/// \param finiteRange smallest and largest finite sample
/// \param space       for the search of translucent layers
/// \param light       that reaches the surfaces; null: all of it does
/// \throws std::bad_alloc
inline ShadeScene ShadeSceneOf(
  const FrameKey& key, const glm::dvec2& finiteRange, const LeapedSpace& space, SurfaceLight* light)
{
  const bool isTranslucent = key.Isosurfaces().IsTranslucent();
  return { key, KindOf(key.Samples), finiteRange,
    isTranslucent ? MakeSurfaceTracer({ key.Samples, key.Isosurfaces(), finiteRange, space.Active })
                  : nullptr,
    space.Active ? space.Bounds : nullptr, light };
}

}

#endif
