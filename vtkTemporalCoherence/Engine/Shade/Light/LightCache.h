// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LightCache_h
#define TemporalCoherence_LightCache_h

#include "Scene/FrameKey.h"
#include "Shade/Light/PatchPlace.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// What the rays from a small piece of a surface found: their number, and how much of their light
/// passed the surfaces that they met.
class LightSum
{
public:
  static constexpr std::uint32_t Whole = 255;     ///< light of a ray that nothing stops
  static constexpr std::uint32_t MostRays = 4095; ///< more rays are not counted

  std::uint32_t Rays() const { return this->Packed & MostRays; }
  std::uint32_t Light() const { return this->Packed >> RayBits; }

  void Add(std::uint32_t rays, std::uint32_t light)
  {
    if (this->Rays() + rays <= MostRays)
    {
      this->Packed += (light << RayBits) + rays;
    }
  }

private:
  static constexpr std::uint32_t RayBits = 12;

  std::uint32_t Packed = 0;
};

/// Keeps the light of surface points from frame to frame, whatever the camera does.
///
/// Patches have about the size of pixels. The first rays of a patch also count for the larger
/// patches around it. These help where a patch is new, for example when the camera comes near or
/// goes away.
///
/// While a frame is made the cache does not change, so the frame does not depend on the order of
/// its tiles. What a frame finds is added when it is finished.
class LightCache
{
public:
  /// Forget the light of other surfaces, of another radius, and of lights that moved.
  /// \throws std::bad_alloc
  void Follow(const FrameKey& key);

  /// Sizes of larger patches that share the light of a patch.
  static constexpr std::size_t LargerSizes = 2;

  /// A patch with this many rays of its own needs no larger patch. Larger patches blur the light.
  static constexpr std::uint32_t FewRays = 64;

  static constexpr std::uint32_t NoBlock = ~std::uint32_t(0);

  /// The light that is known of a patch.
  struct Known
  {
    std::uint32_t Block = NoBlock; ///< position of its block; or NoBlock
    LightSum Own;
    /// Larger patches around the patch, each twice as large as the one before. Empty if the patch
    /// has FewRays.
    std::array<LightSum, LargerSizes> Larger;
  };

  /// Prepare to find a patch, in two steps: reads of memory overlap if each step is taken for many
  /// patches before the next one.
  void PrepareSlot(std::uint64_t hash) const;
  void PrepareBlock(std::uint64_t hash, const PatchPlace& place) const;

  /// \param hash HashOfBlock(place)
  Known Find(std::uint64_t hash, const PatchPlace& place) const;

  /// What a frame found in a patch.
  struct Found
  {
    PatchPlace Place;
    std::uint32_t Block; ///< position of its block; or NoBlock
    std::uint32_t Rays, Light;
  };

  using FoundInTiles = std::vector<std::vector<Found>>;

  /// Add what the tiles of a frame found, in their order. A frame is added once.
  /// \param mostBytes of memory. Beyond it, the patches that were not seen for the longest time are
  ///                  dropped, but no patch of this frame. If memory runs out, all are dropped.
  void Add(const FoundInTiles& tiles, std::size_t mostBytes);

  /// Number of frames that were added since the cache was empty.
  std::uint32_t NumberOfFrames() const { return this->Frames; }

  std::size_t Bytes() const;
  void Clear();

private:
  /// A block of patches.
  struct Block
  {
    PatchPlace Place;       ///< its Patch is 0
    std::uint32_t Larger;   ///< position of the block of the next larger patches; or NoBlock
    std::uint32_t LastSeen; ///< number of a frame
  };
  using Patches = std::array<LightSum, 64>;

  std::uint32_t FindBlock(std::uint64_t hash, const PatchPlace& place) const;
  std::uint32_t ProvideBlock(const PatchPlace& place);
  void Add(const Found& found);
  void Insert(std::uint32_t block);
  void Resize(std::size_t slots);
  void ReserveFor(const FoundInTiles& tiles);
  void Drop(std::size_t mostBytes);
  template <typename IsKept>
  void KeepOnly(const IsKept& isKept);

  std::vector<std::uint32_t> Slots; ///< a hash table of blocks; its size is a power of two
  std::vector<Block> Blocks;
  std::vector<Patches> Sums; ///< one element for each block
  std::uint32_t Frames = 0;

  /// What the light depends on.
  struct Scene
  {
    Field Samples;
    IndexTransform Transform;
    TemporalCoherence::Region Region;
    Surfaces Isosurfaces;
  };
  Scene Of;
  double Radius = 0.0;       ///< of ambient occlusion
  std::vector<Light> Lights; ///< of the appearance
};

}

#endif
