// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TileShader_h
#define TemporalCoherence_TileShader_h

#include "Scene/FrameKey.h"
#include "Scene/FramePlanes.h"
#include "Scene/TileHits.h"
#include "Shade/Shader.h"
#include "Shade/TileCompositor.h"

#include <cstdint>
#include <memory>

namespace TemporalCoherence
{

/// Which hits to shade.
enum class HitSet : std::uint8_t
{
  None,
  NotDefinite, ///< all but definite hits
  All
};

/// Shades tiles: normals and colours of hits and, if surfaces are translucent, of the layers
/// behind.
class TileShader
{
public:
  /// The key must outlive the shader.
  /// \param finiteRange smallest and largest finite sample
  /// \param space       for the search of translucent layers
  /// \throws std::bad_alloc
  TileShader(const FrameKey& key, const glm::dvec2& finiteRange, const LeapedSpace& space,
    HitSet normalsOf, HitSet colorsOf);

  /// Shade `part`, which is tile number `tile`. Thread-safe.
  /// \param found its rays and hits, if they are at hand; null: the planes tell them. Layers are
  ///              used up
  void Shade(std::int64_t tile, const PixelRect& part, TileHits* found, Frame& frame,
    TraceCounts& counts) const;

  /// Make and shade a tile from the last frame, from which only opacities and the appearance
  /// differ. Thread-safe. \throws std::bad_alloc
  void ShadeKnown(std::int64_t tile, const PixelRect& part, const Frame& last, Frame& frame,
    TraceCounts& counts) const;

private:
  const FrameKey& Key;
  NormalSource Source;
  HitSet NormalsOf, ColorsOf;
  std::unique_ptr<TileCompositor> Compositor; ///< null: all surfaces are opaque
};

}

#endif
