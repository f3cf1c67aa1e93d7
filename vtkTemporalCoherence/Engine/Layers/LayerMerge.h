// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LayerMerge_h
#define TemporalCoherence_LayerMerge_h

#include "Layers/KnownLayers.h"
#include "Scene/Frame.h"
#include "Scene/HitOrder.h"
#include "Scene/LayerBatch.h"
#include "Scene/RayBatch.h"
#include "Scene/Surfaces.h"
#include "Scene/Tiles.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// From the surfaces of the last picture to those of the next one. Isovalues are compared by value.
struct SurfaceChange
{
  /// \throws std::bad_alloc
  SurfaceChange(const Surfaces& last, const Surfaces& next);

  std::vector<double> Last, Next; ///< isovalues
  /// For each isovalue of the last picture, its position in the next one; or Frame::NoSurface.
  std::vector<std::int16_t> Kept;
  /// Positions in the next picture of those that the last one lacks.
  std::vector<std::int16_t> New;
  /// Opacities in the next picture, or what they are at least if only shading tells them.
  std::vector<float> LeastAlphas;
};

/// Merges the known layers of a tile with those of new isovalues, which are searched alone.
///
/// Known layers of kept isovalues reach up to a *limit* on each ray: to the last layer of all that
/// are known, or to where no light passes. What is behind it is searched once more or forgotten.
class LayerMerge
{
public:
  /// \param width  of the picture
  /// \param change must outlive this
  LayerMerge(const PixelRect& part, int width, const SurfaceChange& change)
    : Part(part)
    , Width(width)
    , Change(change)
  {
    this->First.fill(None);
    this->Last.fill(None);
  }

  /// Take the known layers of kept isovalues.
  /// \throws std::bad_alloc
  void Keep(const KnownLayers& known);

  /// How many rays have a limit only because nothing is known behind a layer of an isovalue that
  /// goes. Light will go on there, most likely, so that they are searched for all isovalues.
  std::size_t CountUncovered() const { return hwy::PopCount(this->Uncovered); }

  /// The least t behind the limit of a ray, or infinity.
  double EndOf(std::size_t place) const;

  /// Add a layer of a new isovalue, if it is in front of the limit. Those of a ray come from front
  /// to back.
  /// \param hit by its position in the next picture
  /// \throws std::bad_alloc
  void Add(std::size_t place, const LayerHit& hit);

  /// All layers up to where no light passes, or where more are to be found.
  /// \throws std::bad_alloc
  KnownLayers Finish() const;

private:
  struct Node
  {
    LayerHit Hit;
    std::int32_t Next; ///< place of the next layer of the pixel; or None
  };
  static constexpr std::int32_t None = -1;

  MetSurface SurfaceOf(const LayerHit& hit) const
  {
    return { hit.Depth, hit.Kind, this->Change.Next[static_cast<std::size_t>(hit.Isovalue)] };
  }

  float AlphaOf(std::int16_t isovalue) const
  {
    return this->Change.LeastAlphas[static_cast<std::size_t>(isovalue)];
  }

  bool IsInFront(const LayerHit& a, const LayerHit& b) const;
  void Link(std::size_t place, std::int32_t before, const LayerHit& hit, std::int16_t isovalue);

  const PixelRect Part;
  const int Width;
  const SurfaceChange& Change;
  std::vector<Node> Nodes;
  RayBatch::Array<std::int32_t> First; ///< for each pixel; or None
  RayBatch::Array<std::int32_t> Last;  ///< that were kept or added
  std::uint64_t Limited = 0;           ///< one bit for each pixel whose ray has a limit
  RayBatch::Array<MetSurface> Limits;
  std::uint64_t Uncovered = 0; ///< CountUncovered()
};

}

#endif
