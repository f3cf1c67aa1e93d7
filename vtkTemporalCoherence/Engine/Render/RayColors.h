// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RayColors_h
#define TemporalCoherence_RayColors_h

#include "Render/LooseRays.h"
#include "Render/Routes.h"
#include "Scene/Frame.h"
#include "Scene/FramePlanes.h"

#include <cstdint>
#include <memory>

namespace TemporalCoherence
{

/// Finds the colours of rays that go anywhere through a tile, as a frame with pixels there would.
class RayColors
{
public:
  virtual ~RayColors() = default;
  RayColors(const RayColors&) = delete;
  RayColors& operator=(const RayColors&) = delete;

  /// Thread-safe.
  /// \param made a frame of one row, whose pixels are the rays. Its colours are the result
  /// \return the cost
  virtual TraceCounts Find(std::int64_t tile, const LooseRays& rays, Frame& made) const = 0;

protected:
  RayColors() = default;
};

/// Prepare to find the colours of isosurfaces. The task must outlive the result.
/// \param light that reaches the surfaces; null: all of it does
/// \throws std::bad_alloc
std::unique_ptr<RayColors> MakeSurfaceColors(FrameTask& task, SurfaceLight* light);

/// Prepare to find the colours of a blended volume. The task must outlive the result.
/// \throws std::bad_alloc
std::unique_ptr<RayColors> MakeBlendedColors(FrameTask& task);

}

#endif
