// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TileShader_h
#define TemporalCoherence_TileShader_h

#include "FramePlanes.h"
#include "ReusePlan.h"
#include "Shader.h"

#include <cstdint>

namespace TemporalCoherence
{

/// Which hits of a picture are worked on.
enum class HitSet : std::uint8_t
{
  None,
  NotDefinite, ///< not those that were known before
  All
};

/// Gives the hits of tiles their normals and colours.
class TileShader
{
public:
  /// \param finiteRange smallest and largest finite sample
  /// The key must outlive the shader.
  TileShader(const FrameKey& key, const glm::dvec2& finiteRange, HitSet normalsOf, HitSet colorsOf);

  /// Shade `part`, which is tile number `tile`. Safe from many threads.
  void Shade(std::int64_t tile, const PixelRect& part, Frame& frame, TraceCounts& counts) const;

private:
  const FrameKey& Key;
  NormalSource Source;
  HitSet NormalsOf, ColorsOf;
};

}

#endif
