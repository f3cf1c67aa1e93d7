// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BlendTracer_h
#define TemporalCoherence_BlendTracer_h

#include "Acceleration/ActiveCells.h"
#include "Acceleration/ValueRangePyramid.h"
#include "Scene/FrameKey.h"
#include "Scene/RayBatch.h"
#include "Scene/TileHits.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>

namespace TemporalCoherence
{

/// The volume that rays look through. All of it outlives its tracers.
struct BlendScene
{
  const FrameKey& Key;
  const ActiveCells* Visible = nullptr;      ///< cells with values that are seen; null: all may be
  const ValueRangePyramid* Ranges = nullptr; ///< of Key.Samples
};

/// What the rays of a tile have seen so far, from front to back.
struct BlendedRays
{
  template <typename T>
  using Array = RayBatch::Array<T>;

  std::array<Array<float>, 3> Color; ///< multiplied by its opacity
  Array<float> Passed;               ///< share of the light from behind that passes
  Array<double> Value; ///< Maximum, Minimum: the extreme so far, or NaN; else a sum over length
  std::array<Array<double>, 3> OtherValues;  ///< the same of components 1 to 3
  std::array<Array<double>, 3> OtherLengths; ///< Length of components 1 to 3
  Array<double> Length;                      ///< Average: world distance over which values counted
  Array<double> First;                       ///< t of the first thing seen, or infinity
  std::int64_t CellsRead = 0;                ///< cells whose eight samples were read

  /// Nothing is seen yet.
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

/// Thrown where a volume cannot be blended: its kind of field has no tracer for what is asked.
struct NoBlendTracer : std::exception
{
  const char* what() const noexcept override { return "the field has no tracer for this blending"; }
};

/// Blends what rays see of a volume, in one mode, for one kind of field. What a ray sees depends on
/// the ray and on its Begin and End, but not on where its walk starts; on the rays beside it only
/// as far as rounding goes.
class BlendTracer
{
public:
  /// Make the tracer for the mode and the kind of the scene's field. Null if the kind can only be
  /// drawn by isosurfaces.
  /// \throws std::bad_alloc
  static std::shared_ptr<const BlendTracer> Make(const BlendScene& scene)
  {
    return scene.Key.Samples.Kind->MakeBlendTracer(scene);
  }

  virtual ~BlendTracer() = default;
  BlendTracer(const BlendTracer&) = delete;
  BlendTracer& operator=(const BlendTracer&) = delete;

  /// Set what has been seen to nothing.
  virtual void Begin(BlendedRays& seen) const { seen.Clear(); }

  /// Add what each ray sees from Begin to End. Where a region keeps several pieces of rays, this is
  /// called for each, from front to back. Thread-safe.
  /// \param world directions of the rays in the world, of unit length
  virtual void Trace(
    const RayBatch& rays, const WorldDirections& world, BlendedRays& seen) const = 0;

  /// Make colours of values, where the mode has any.
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
