// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TileShader_h
#define TemporalCoherence_TileShader_h

#include "Lattice/RaySource.h"
#include "Scene/FrameKey.h"
#include "Scene/FramePlanes.h"
#include "Scene/TileHits.h"
#include "Shade/KeptHitValues.h"
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

/// Input for shading tiles. It must outlive the shader.
struct ShadeScene
{
  const FrameKey& Key;
  const FieldNormals& Normals;                 ///< of the key's field
  glm::dvec2 FiniteRange{ 0.0 };               ///< smallest and largest finite sample
  std::shared_ptr<const SurfaceTracer> Tracer; ///< of translucent surfaces; else null
  const TileBounds* Bounds =
    nullptr;                     ///< of the active cells that the tracer leaps between; or null
  SurfaceLight* Light = nullptr; ///< that reaches the surfaces; null: all of it does
  KeptHitValues* Values =
    nullptr; ///< of the hits of the last frame, which are shaded again; or null
};

/// Shades tiles: normals and colours of hits and, if surfaces are translucent, of the layers
/// behind.
class TileShader
{
public:
  /// \throws std::bad_alloc
  TileShader(const ShadeScene& scene, HitSet normalsOf, HitSet colorsOf);

  /// Shade `part`, which is tile number `tile`. Thread-safe.
  /// \param found its rays and hits; null: takes them from the planes. Layers are used up
  void Shade(std::int64_t tile, const PixelRect& part, TileHits* found, Frame& frame,
    TraceCounts& counts) const;

  /// Shade rays that go anywhere through a tile of the picture. Thread-safe.
  /// \param found the rays and their hits; translucent surfaces are found here
  /// \param rays  a frame of one row, whose pixels show these rays: only its colours are
  ///              valid afterwards
  void ShadeAt(std::int64_t tile, const RayPlaces& at, TileHits& found, Frame& rays,
    TraceCounts& counts) const;

  /// Make and shade a tile from the last frame, which differs only in opacities and the appearance.
  /// Thread-safe.
  /// \throws std::bad_alloc
  void ShadeKnown(std::int64_t tile, const PixelRect& part, const Frame& last, Frame& frame,
    TraceCounts& counts) const;

private:
  const FrameKey& Key;
  NormalSource Source;
  HitSet NormalsOf, ColorsOf;
  SurfaceLight* Light;
  KeptHitValues* Values;
  std::unique_ptr<TileCompositor> Compositor; ///< null: all surfaces are opaque
};

}

#endif
