// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SmoothLabels_h
#define TemporalCoherence_SmoothLabels_h

#include "Scene/CellBlocks.h"
#include "Scene/CellBox.h"
#include "Scene/Field.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>

namespace TemporalCoherence
{

/// Smooth surfaces between labels. The *share* of a label at a sample is the mean over the samples
/// around it, weighted by a Gaussian, of 1 where they have the label and 0 elsewhere. Between
/// samples it is interpolated. A point belongs to the label with the largest share, so labels that
/// touch have one surface in common.
///
/// A sample always keeps its own label, whose share there is more than 1/2. So no part of a label
/// vanishes, and surfaces lie in the cells in which those of voxels lie. Normals are gradients of
/// shares that are smoothed more: rounding of positions shows little, that of normals much.
class SmoothLabels
{
public:
  /// The samples of a leaf along an edge.
  static constexpr int Edge = CellBlocks::LeafSize + 1;

  /// Shares and gradients of a label at the samples of a leaf, x fastest.
  struct Block
  {
    template <typename T>
    using Samples = std::array<T, static_cast<std::size_t>(Edge* Edge* Edge)>;

    Samples<float> Share;
    std::array<Samples<float>, 3> Gradient; ///< differences over two steps along each axis

    void Set(std::size_t at, bool isOwn, float share, const glm::vec3& gradient);
  };

  /// \param field  of labels, whose samples must live as long as Of() is called
  /// \param radius standard deviation of the Gaussian of normals, in samples; above 0, at most 8
  /// \throws std::bad_alloc
  SmoothLabels(const Field& field, double radius);
  ~SmoothLabels();
  SmoothLabels(const SmoothLabels&) = delete;
  void operator=(const SmoothLabels&) = delete;

  double Radius() const { return this->Deviation; }

  /// Shares and gradients of a label in the leaf of a cell. Thread-safe: the first caller computes
  /// them.
  /// \throws std::bad_alloc
  const Block& Of(const glm::ivec3& cell, std::int64_t label) const;

  /// Bytes of all blocks.
  std::size_t Memory() const { return sizeof(Block) * this->Count; }

  /// Forget all blocks. Not thread-safe: no block may be in use.
  void Clear() const;

  /// Samples in some cells have changed: forget the blocks that depend on them. Not thread-safe.
  void Forget(const CellBox& changed) const;

  /// The farthest samples that a sample is smoothed with.
  int Reach() const;

  /// The position of a sample in a block, from its place in the leaf.
  static std::size_t PlaceOf(const glm::ivec3& inLeaf)
  {
    return static_cast<std::size_t>(inLeaf.x + Edge * (inLeaf.y + Edge * inLeaf.z));
  }

private:
  /// A block in the list of its leaf.
  struct Entry
  {
    std::int64_t Label;
    const Entry* Next;
    Block Of;
  };

  using Head = std::atomic<const Entry*>;
  struct Smoothing;

  void Clear(Head& head) const;
  const Block& Add(Head& head, std::unique_ptr<Entry> made) const;
  bool Make(const glm::ivec3& firstSample, Entry& made, Entry& other) const;

  Field Samples;
  double Deviation; ///< of normals
  std::unique_ptr<const Smoothing> OfShares, OfNormals;
  glm::i64vec3 Leaves;           ///< along each axis
  std::unique_ptr<Head[]> Heads; ///< of the list of each leaf
  mutable std::atomic<std::size_t> Count{ 0 };
};

}

#endif
