// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RaySource_h
#define TemporalCoherence_RaySource_h

#include "Lattice/RegionClipper.h"
#include "Scene/Field.h"
#include "Scene/RayBatch.h"
#include "Scene/TileHits.h"
#include "Scene/View.h"

#include <glm/glm.hpp>

#include <array>

namespace TemporalCoherence
{

/// Where 64 rays go through the picture, in normalised device coordinates.
struct RayPlaces
{
  RayBatch::Array<double> X, Y;
};

/// Sets up the rays of a view in index space. Made once for a frame. A field more than 2^44 voxels
/// away is not visible.
class RaySource
{
public:
  RaySource(const View& view, const IndexTransform& transform, const glm::ivec3& dimensions,
    const Region& region = Region());

  /// Set up the rays through the pixels first .. first + size - 1 and clip them to the box of the
  /// field, to the clipping planes of the camera, and to their first and last points in the region.
  /// The walk is the whole clipped ray.
  /// \param world gets the directions of the rays in the world; may be null
  void SetUp(const glm::ivec2& first, const glm::ivec2& size, RayBatch& rays,
    WorldDirections* world = nullptr) const;

  /// Set up rays as SetUp does. Pixel counts them. A full batch lies like the pixels of a tile.
  /// Other rays may go anywhere: their PerDepth is 0.
  void SetUpAt(
    const RayPlaces& at, std::size_t count, RayBatch& rays, WorldDirections* world) const;

  /// A vector that is linear in normalised device coordinates: V[0] + x V[1] + y V[2].
  using LinearVector = std::array<glm::dvec3, 3>;

  glm::ivec2 Size;
  glm::dvec3 Last; ///< highest corner of the field's box
  double Near, Far;
  LinearVector World;             ///< direction in the world, of any length
  LinearVector Direction, Origin; ///< in index space, the direction as long as World
  glm::dvec3 Forward;             ///< component of World along the optical axis, linear too
  RegionClipper Clipper;
};

}

#endif
