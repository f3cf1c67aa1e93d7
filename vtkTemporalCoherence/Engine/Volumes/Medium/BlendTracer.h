// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BlendTracer_h
#define TemporalCoherence_BlendTracer_h

#include "Acceleration/ActiveCells.h"
#include "Acceleration/ValueRangePyramid.h"
#include "Scene/FrameKey.h"
#include "Scene/RayBatch.h"
#include "Scene/TileHits.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace TemporalCoherence
{

/// The volume that rays look through. All of it outlives its tracers.
struct BlendScene
{
  const FrameKey& Key;
  const ActiveCells* Visible = nullptr;      ///< cells with visible values; null: all cells
  const ValueRangePyramid* Ranges = nullptr; ///< of Key.Samples
};

/// Light and values that the rays of a tile have gathered so far, from front to back.
struct BlendedRays
{
  template <typename T>
  using Array = RayBatch::Array<T>;

  std::array<Array<float>, 3> Color; ///< multiplied by its opacity
  Array<float> Passed;               ///< share of the light from behind that passes
  Array<double> Value; ///< Maximum, Minimum: the extreme so far, or NaN; else a sum over length
  std::array<Array<double>, 3> OtherValues;  ///< Value of components 1 to 3
  std::array<Array<double>, 3> OtherLengths; ///< Length of components 1 to 3
  Array<double> Length;                      ///< Average: world distance over which values counted
  Array<double> First;                       ///< t of the first visible point, or infinity
  std::int64_t CellsRead = 0;                ///< cells whose eight samples were read

  /// Reset to rays that have seen nothing.
  void Clear()
  {
    for (Array<float>& channel : this->Color)
    {
      channel.fill(0.0f);
    }
    this->Passed.fill(1.0f);
    this->Value.fill(0.0);
    for (std::size_t other = 0; other < this->OtherValues.size(); ++other)
    {
      this->OtherValues[other].fill(0.0);
      this->OtherLengths[other].fill(0.0);
    }
    this->Length.fill(0.0);
    this->First.fill(std::numeric_limits<double>::infinity());
    this->CellsRead = 0;
  }
};

/// Blends a volume along rays, in one mode, for one kind of field. The result of a ray depends on
/// the ray, its Begin and its End, but not on the start of its walk. Neighbouring rays change it by
/// rounding only.
class BlendTracer
{
public:
  virtual ~BlendTracer() = default;
  BlendTracer(const BlendTracer&) = delete;
  BlendTracer& operator=(const BlendTracer&) = delete;

  /// Reset the rays, before the first Trace.
  virtual void Begin(BlendedRays& seen) const { seen.Clear(); }

  /// Blend the volume from Begin to End of each ray. If a region cuts rays into pieces, this is
  /// called for each piece, from front to back. Thread-safe.
  /// \param world directions of the rays in the world, of unit length
  virtual void Trace(
    const RayBatch& rays, const WorldDirections& world, BlendedRays& seen) const = 0;

  /// Make colours of the values, in modes of projections.
  virtual void Finish(const RayBatch& rays, const WorldDirections& world, BlendedRays& seen) const
  {
    static_cast<void>(rays);
    static_cast<void>(world);
    static_cast<void>(seen);
  }

protected:
  BlendTracer() = default;
};

}

#endif
