// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TileShader_h
#define TemporalCoherence_TileShader_h

#include "Scene/FrameKey.h"
#include "Scene/FramePlanes.h"
#include "Shade/Shader.h"
#include "Shade/TileCompositor.h"

#include <cstdint>
#include <memory>

namespace TemporalCoherence
{

/// Which hits of a picture are worked on.
enum class HitSet : std::uint8_t
{
  None,
  NotDefinite, ///< not those that were known before
  All
};

/// Gives the hits of tiles their normals and colours, and those of what shines through them.
class TileShader
{
public:
  /// \param finiteRange smallest and largest finite sample
  /// \param space       where translucent surfaces are looked for
  /// The key must outlive the shader.
  /// \throws std::bad_alloc
  TileShader(const FrameKey& key, const glm::dvec2& finiteRange, const LeapedSpace& space,
    HitSet normalsOf, HitSet colorsOf);

  /// Shade `part`, which is tile number `tile`. Safe from many threads.
  void Shade(std::int64_t tile, const PixelRect& part, Frame& frame, TraceCounts& counts) const;

private:
  const FrameKey& Key;
  NormalSource Source;
  HitSet NormalsOf, ColorsOf;
  std::unique_ptr<TileCompositor> Compositor; ///< null: all surfaces are opaque
};

}

#endif
