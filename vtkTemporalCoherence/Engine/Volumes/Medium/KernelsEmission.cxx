// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Medium/KernelsEmission.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Volumes/Medium/KernelsEmission.cxx"
#include <hwy/foreach_target.h>

#include "Volumes/Medium/KernelsCellGradients-inl.h"
#include "Volumes/Medium/KernelsEmittingSegments-inl.h"
#include "Volumes/Medium/KernelsHardSegments-inl.h"
#include "Volumes/Medium/KernelsVectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace EmissionKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Lower bound of the transmittance that a hard segment is expected to have: one step estimates it
/// poorly.
constexpr float LeastOfHard = 0.5f;

/// Estimate the transmittance in front of each hard segment.
template <std::size_t Colors>
void ExpectLight(const VolumeSegments& segments, const SegmentSums& sums, LitRays& rays,
  HardSegments<Colors>& hard)
{
  std::size_t next = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(segments.Count); ++i)
  {
    float& expected = rays.Expected[static_cast<std::size_t>(segments.Ray[i])];
    if (next < hard.Count && hard.Number[next] == static_cast<std::int32_t>(i))
    {
      hard.Shown[next++] = expected;
      expected *= std::max(sums.Passed[i], LeastOfHard);
    }
    else
    {
      expected *= sums.Passed[i];
    }
  }
}

/// Composite segments behind the light of their rays so far.
inline void Composite(const VolumeSegments& segments, const SegmentSums& sums, BlendedRays& seen)
{
  for (std::size_t i = 0; i < static_cast<std::size_t>(segments.Count); ++i)
  {
    const auto ray = static_cast<std::size_t>(segments.Ray[i]);
    const float shown = seen.Passed[ray];
    if (shown > LeastPassed)
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        seen.Color[a][ray] += shown * sums.Color[a][i];
      }
      if (sums.First[i] < SegmentSums::Never && shown > 1.0f - LeastSeen)
      {
        seen.First[ray] = std::min(seen.First[ray], static_cast<double>(sums.First[i]));
      }
      seen.Passed[ray] = shown * sums.Passed[i];
    }
  }
}

/// Reads the cells of vectors of segments.
class CellsOfVector
{
public:
  CellsOfVector(const VolumeSegments& segments, const VolumeCells& cells)
    : Segments(segments)
    , Source(cells)
  {
  }

  /// The gradients of the cells of segments from `first` on. Lanes behind the last segment repeat
  /// it.
  HWY_INLINE CornerGradients At(std::size_t first)
  {
    const std::size_t last = static_cast<std::size_t>(this->Segments.Count) - 1;
    constexpr auto size = static_cast<std::int32_t>(sizeof(VolumeCell) / sizeof(float));
    std::int32_t places[WidestVector], read = -1;
    glm::ivec3 before(-1);
    for (std::size_t lane = 0; lane < hn::Lanes(Floats()); ++lane)
    {
      const std::size_t i = std::min(first + lane, last);
      const auto& cells = this->Segments.Cell;
      const glm::ivec3 cell(cells[0][i], cells[1][i], cells[2][i]);
      if (cell != before)
      {
        this->Source.Read(cell, this->Read[static_cast<std::size_t>(++read)]);
        before = cell;
      }
      places[lane] = read * size;
    }
    return CornerGradients(this->Read.data(), places);
  }

private:
  const VolumeSegments& Segments;
  const VolumeCells& Source;
  std::array<VolumeCell, WidestVector> Read;
};

template <std::size_t Colors>
HWY_INLINE void AddColors(const EmittingVolume& volume, LitRays& rays,
  const VolumeSegments& segments, const VolumeCells& cells, BlendedRays& seen)
{
  SegmentSums sums;
  HardSegments<Colors> hard;
  CellsOfVector ofVector(segments, cells);
  for (std::size_t i = 0; i < static_cast<std::size_t>(segments.Count); i += hn::Lanes(Floats()))
  {
    const CornerGradients corners = volume.HasGradients() ? ofVector.At(i) : CornerGradients();
    AddInOneStep<Colors>(volume, rays, segments, i, corners, hn::Set(Floats(), 1.0f), hard, sums);
  }
  ExpectLight(segments, sums, rays, hard);
  hard.KeepHard();
  AddHard(volume, rays, segments, hard, sums);
  Composite(segments, sums, seen);
}

void AddAll(const EmittingVolume& volume, LitRays& rays, VolumeSegments& segments,
  const VolumeCells& cells, BlendedRays& seen)
{
  segments.FillLastVector();
  if (volume.HasColoredLights())
  {
    AddColors<3>(volume, rays, segments, cells, seen);
    return;
  }
  AddColors<1>(volume, rays, segments, cells, seen);
}

}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{
namespace EmissionKernels
{

HWY_EXPORT(AddAll);

void AddSegments(const EmittingVolume& volume, LitRays& rays, VolumeSegments& segments,
  const VolumeCells& cells, BlendedRays& seen)
{
  HWY_DYNAMIC_DISPATCH(AddAll)(volume, rays, segments, cells, seen);
}

}
}
#endif
