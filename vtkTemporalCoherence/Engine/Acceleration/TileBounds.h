// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_TileBounds_h
#define TemporalCoherence_TileBounds_h

#include "Acceleration/ActiveCells.h"
#include "Scene/CellBox.h"
#include "Scene/RayBatch.h"
#include "Scene/Tiles.h"
#include "Scene/View.h"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace TemporalCoherence
{

/// 1 for each tile in which some ray may pass through one of the boxes of cells, else 0.
/// \param shape of the field
/// \throws std::bad_alloc
std::vector<std::uint8_t> FindTiles(const View& view, const IndexTransform& transform,
  const std::vector<CellBox>& boxes, const FieldShape& shape);

/// For each tile of 8 x 8 pixels, the range of distances in which its rays may meet active leaves.
///
/// Every active leaf is projected and widens the ranges of the tiles that it can touch. If a node
/// is small in the picture, the box around its active leaves is projected instead. A tile that no
/// box touches sees no surface. The bounds are conservative: rays may start at Near and stop at Far
/// without changing the picture.
class TileBounds
{
public:
  /// Distances along the rays of a tile, in world units; empty if Near > Far.
  struct Bounds
  {
    float Near = std::numeric_limits<float>::infinity();
    float Far = -std::numeric_limits<float>::infinity();

    bool IsEmpty() const { return !(this->Near <= this->Far); }
  };

  /// \param shape of the field
  /// \throws std::bad_alloc; the bounds are then unusable
  void Build(const View& view, const IndexTransform& transform, const ActiveCells& active,
    const FieldShape& shape);

  /// Make the bounds of a picture with fewer rays in the same view: each tile gets the bounds of
  /// all tiles that it covers. \param all    bounds of the picture of `pixels` \param fewer  rays
  /// along each axis \throws std::bad_alloc; the bounds are then unusable
  void Unite(const TileBounds& all, const glm::ivec2& pixels, const glm::ivec2& fewer);

  const glm::ivec2& Tiles() const { return this->Size; }
  const Bounds& At(std::int64_t tile) const { return this->All[static_cast<std::size_t>(tile)]; }

  /// Free the scratch memory, which only the next Build() would use.
  void ReleaseScratch() { std::vector<std::vector<Bounds>>().swap(this->Parts); }

  /// Bytes of these bounds, and bytes of a picture's bounds without scratch memory.
  std::size_t MemoryInBytes() const;
  static std::size_t MemoryFor(const glm::ivec2& pixels);

  /// Narrow the walks of a tile's rays to its bounds.
  void Narrow(std::int64_t tile, RayBatch& rays) const;

private:
  glm::ivec2 Size{ 0 };
  std::vector<Bounds> All;
  std::vector<std::vector<Bounds>> Parts; ///< the bounds of all tiles, for each part of the nodes
};

/// The structures for space leaping.
struct LeapedSpace
{
  const ActiveCells* Active = nullptr; ///< of a frame's isovalues; null: no leaping
  const TileBounds* Bounds = nullptr;  ///< of Active
};

}

#endif
