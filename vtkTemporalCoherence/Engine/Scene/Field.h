// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Field_h
#define TemporalCoherence_Field_h

#include "Bricks/BrickCache.h"
#include "Scene/FieldShape.h"
#include "Scene/KnownRanges.h"
#include "Scene/ScalarType.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <limits>
#include <memory>
#include <type_traits>

namespace TemporalCoherence
{

class HiddenCells;
class LabelSets;

/// How the field continues between samples.
enum class Interpolation : std::uint8_t
{
  Linear, ///< trilinear in each cell of eight samples
  Nearest ///< the value of the nearest sample: the field is made of boxes around the samples
};

/// One component of a regular array of samples. The samples are read in place, not copied or owned.
///
/// Index space: sample (i, j, k) lies at the point (i, j, k); cell (i, j, k) is the box between the
/// samples (i, j, k) and (i + 1, j + 1, k + 1). The field is defined on the box of all cells.
///
/// This describes a *uniform* field. Fields of other kinds fill the same box, and Shape tells what
/// is in it: a rectilinear field has its samples at other coordinates; others may have no samples.
struct Field
{
  /// Address of sample (0, 0, 0) of the chosen component. Of samples in bricks: of Bricks.
  const void* Samples = nullptr;
  ScalarType Type = ScalarType::UInt8;
  Interpolation Between = Interpolation::Linear;
  glm::ivec3 Dimensions{ 0 };      ///< samples along each axis
  glm::i64vec3 Strides{ 1, 0, 0 }; ///< scalars from one sample to the next along each axis
  std::uint64_t Stamp = 0;         ///< differs whenever the samples may have changed
  /// Samples of a large volume, which are read on demand; null: all samples are in memory. Strides
  /// count within a brick.
  std::shared_ptr<const BrickCache> Bricks;
  /// The value ranges, if they are known from elsewhere; else null.
  std::shared_ptr<const KnownRanges> Known;
  std::shared_ptr<const FieldShape> Shape = UniformShape(); ///< never null
  /// Cells that flags hide, whatever their samples are; null for none.
  std::shared_ptr<const HiddenCells> Flagged;
  /// Cells that hold no surface: flagged cells, and cells with a NaN sample. Null for none. Derived
  /// from the other members, together with the value ranges (FieldRanges).
  std::shared_ptr<const HiddenCells> Hidden;
  /// The labels, if samples are labels, which have no order; else null. Derived from the other
  /// members. Isovalues are the labels that are drawn then: solids that begin where the nearest
  /// sample becomes their label.
  std::shared_ptr<const LabelSets> Labels;

  /// True if the samples do not fit into a processor's caches, so that prefetching pays.
  bool IsLarge() const
  {
    constexpr std::int64_t Many = std::int64_t(1) << 25;
    return static_cast<std::int64_t>(this->Dimensions.x) * this->Dimensions.y * this->Dimensions.z >
      Many;
  }

  /// True if the field has any cell.
  bool HasCells() const { return glm::all(glm::greaterThan(this->Dimensions, glm::ivec3(1))); }
};

inline bool operator==(const Field& a, const Field& b)
{
  return a.Samples == b.Samples && a.Type == b.Type && a.Between == b.Between &&
    a.Dimensions == b.Dimensions && a.Strides == b.Strides && a.Stamp == b.Stamp &&
    AreSame(a.Shape, b.Shape) && a.Flagged == b.Flagged;
}

/// The affine transform from index space to world coordinates, and its inverse.
struct IndexTransform
{
  glm::dmat4 WorldFromIndex{ 1.0 };
  glm::dmat4 IndexFromWorld{ 1.0 };
};

inline bool operator==(const IndexTransform& a, const IndexTransform& b)
{
  return a.WorldFromIndex == b.WorldFromIndex;
}

/// The samples of a field, by their C++ type.
template <typename T>
struct TypedField
{
  explicit TypedField(const Field& field)
    : Samples(static_cast<const T*>(field.Samples))
    , Dimensions(field.Dimensions)
    , Strides(field.Strides)
    , Bricks(field.Bricks.get())
  {
  }

  /// The address of a sample. Strides reach the neighbouring samples from here: one before, two
  /// behind along each axis. Of samples in bricks the address is valid for one SampleUse.
  const T* At(int i, int j, int k) const
  {
    if (this->Bricks)
    {
      return this->Bricks->template At<T>(i, j, k);
    }
    return this->Samples + i * this->Strides.x + j * this->Strides.y + k * this->Strides.z;
  }
  const T* At(const glm::ivec3& s) const { return this->At(s.x, s.y, s.z); }

  const T* Samples;
  glm::ivec3 Dimensions;
  glm::i64vec3 Strides;
  const BrickCache* Bricks; ///< null: all samples lie in one array
};

/// Integers of 8 or 16 bits that are adjacent along x, for vectors that gather them.
template <typename T>
struct NarrowSamples
{
  /// True if a field has such samples, and offsets of 32 bits, in bytes from the first sample,
  /// reach each of them.
  /// \pre field.HasCells()
  static bool Are(const Field& field)
  {
    const glm::i64vec3& strides = field.Strides;
    if (sizeof(T) > 2 || field.Bricks || strides.x != 1 || strides.y < 0 || strides.z < 0)
    {
      return false;
    }
    // Each product is compared first, so that none overflows.
    constexpr std::int64_t most =
      std::numeric_limits<std::int32_t>::max() / static_cast<std::int64_t>(sizeof(T));
    const glm::i64vec3 last = glm::i64vec3(field.Dimensions) - std::int64_t(1);
    return strides.y <= most / last.y && strides.z <= most / last.z &&
      strides.y * last.y + strides.z * last.z + field.Dimensions.x <= most;
  }

  explicit NarrowSamples(const Field& field)
    : Samples(static_cast<const T*>(field.Samples))
    , StrideY(static_cast<std::int32_t>(field.Strides.y))
    , StrideZ(static_cast<std::int32_t>(field.Strides.z))
  {
  }

  const T* Samples;
  std::int32_t StrideY, StrideZ;
};

/// The type the engine computes with: samples of 8 and 16 bits are exact in float, with 8 bits of
/// the mantissa to spare for interpolation; all others need double.
template <typename T>
using RealOf = std::conditional_t<sizeof(T) <= 2, float, double>;

}

#endif
