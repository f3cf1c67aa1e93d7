// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blending/CompositeTracer.h"

#include "Blending/KernelsEmission.h"
#include "Blending/KernelsVolumeSegments.h"
#include "Blending/SegmentReader.h"
#include "Blending/SegmentWalk.h"
#include "Blending/TransferTables.h"
#include "Blending/VisibleBands.h"
#include "Blending/VolumeSegments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace TemporalCoherence
{
namespace
{

using EmissionKernels::LeastPassed;

/// Optical depth of the shortest edge of a cell where the opacity is 1.
constexpr double MostDepth = 65536.0;

/// What may be seen, in bins; a list that is too long counts as one band.
SegmentsKernels::SeenBins SeenBinsOf(
  const std::optional<std::vector<ValueBand>>& bands, const TransferTables& tables)
{
  SegmentsKernels::SeenBins seen;
  if (!bands || bands->size() > SegmentsKernels::SeenBins::Most)
  {
    return seen;
  }
  // A list without bands shows nothing.
  seen.Count = std::max<std::size_t>(bands->size(), 1);
  seen.Bands[0] = { std::numeric_limits<float>::infinity(),
    -std::numeric_limits<float>::infinity() };
  const auto binOf = [&](double value)
  { return static_cast<float>((value - tables.Low) * tables.PerValue); };
  for (std::size_t i = 0; i < bands->size(); ++i)
  {
    seen.Bands[i] = { binOf((*bands)[i].Low), binOf((*bands)[i].High) };
  }
  return seen;
}

template <typename T>
class CompositeTracer final
  : public BlendTracer
  , private LeafSource
{
public:
  explicit CompositeTracer(const BlendScene& scene)
    : Samples(scene.Key.Samples)
    , Look(scene.Key.Volume.Looks.front())
    , Tables(Look, MostDepth / ShortestEdge(scene))
    , Reader(Samples, Tables.Low, Tables.PerValue)
    , ByGradient(Look.ByGradient)
    , Active(scene.Visible)
    , Seen(SeenBinsOf(VisibleBands(scene.Key.Volume), Tables))
    , Lights(scene.Key.Appearance, Look.Material)
    , Volume{ Tables, ByGradient, Look.Material.Shade ? &Lights : nullptr }
    , Position(scene.Key.View.Position)
    , IsParallel(scene.Key.View.Parallel)
    , WorldFromIndex(scene.Key.Transform.WorldFromIndex)
  {
    // Kernels make gradients of differences of samples that are two steps apart, in bins.
    this->Volume.PerStep = glm::vec3(this->Look.ByGradient.PerStep * (0.5 / this->Tables.PerValue));
    this->Volume.WorldFromGradient = NormalMatrix(scene.Key.Transform);
    if (!this->Active)
    {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      this->All.BuildVisible(this->Samples, *scene.Ranges, { { -infinity, infinity } });
      this->Active = &this->All;
    }
  }

  void Trace(const RayBatch& rays, const WorldDirections& world, BlendedRays& seen) const override
  {
    std::uint64_t which = 0;
    EmissionKernels::LitRays lit;
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      if (rays.HasWalk(ray) && seen.Passed[ray] > LeastPassed)
      {
        which |= std::uint64_t(1) << ray;
      }
      for (std::size_t a = 0; a < 3; ++a)
      {
        lit.Direction[a][ray] = static_cast<float>(world[a][ray]);
        lit.Begin[a][ray] =
          static_cast<float>(this->BeginOf(rays, world, ray)[static_cast<int>(a)]);
      }
    }
    if (which == 0)
    {
      return;
    }
    BlendedRays::Array<double> first;
    first.fill(std::numeric_limits<double>::infinity());
    std::swap(first, seen.First);
    const WalkScene scene{ *this->Active, *this, this->Samples.Dimensions - 1 };
    seen.CellsRead +=
      SegmentWalk<T>(scene, this->Reader, this->Seen)
        .Trace(
          rays, which,
          [&](const VolumeSegments& segments) { this->AddSegments(lit, segments, seen); },
          [&](std::size_t ray) { return seen.Passed[ray] > LeastPassed; });
    // Kernels count distances from where rays begin.
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      seen.First[ray] = std::min(first[ray], rays.Begin[ray] + seen.First[ray]);
    }
  }

private:
  static double ShortestEdge(const BlendScene& scene)
  {
    return scene.Key.Samples.Kind->VoxelSizeIn(scene.Key.Transform).Shortest;
  }

  /// From gradients of index space to normals in the world, of about the same length.
  static glm::mat3 NormalMatrix(const IndexTransform& transform)
  {
    const glm::dmat3 matrix = glm::transpose(glm::dmat3(transform.IndexFromWorld));
    double largest = 0.0;
    for (int column = 0; column < 3; ++column)
    {
      for (int row = 0; row < 3; ++row)
      {
        largest = std::max(largest, std::abs(matrix[column][row]));
      }
    }
    return glm::mat3(largest > 0.0 ? matrix / largest : matrix);
  }

  /// Where a ray begins, in the world.
  glm::dvec3 BeginOf(const RayBatch& rays, const WorldDirections& world, std::size_t ray) const
  {
    if (!this->IsParallel)
    {
      return this->Position +
        rays.Begin[ray] * glm::dvec3(world[0][ray], world[1][ray], world[2][ray]);
    }
    const double t = rays.Begin[ray];
    const glm::dvec3 inIndex(rays.Origin[0][ray] + t * rays.Direction[0][ray],
      rays.Origin[1][ray] + t * rays.Direction[1][ray],
      rays.Origin[2][ray] + t * rays.Direction[2][ray]);
    return glm::dvec3(this->WorldFromIndex * glm::dvec4(inIndex, 1.0));
  }

  std::uint64_t CellsOf(std::int64_t node, const glm::ivec3& cell) const override
  {
    return this->Active->CellsOf(TypedField<T>(this->Samples), node, cell);
  }

  void AddSegments(
    const EmissionKernels::LitRays& rays, const VolumeSegments& segments, BlendedRays& seen) const
  {
    if constexpr (sizeof(T) <= 2)
    {
      if (this->Reader.IsNarrow() && (!this->Volume.HasGradients() || this->AreInside(segments)))
      {
        EmissionKernels::AddSegments(this->Volume, rays, segments, NarrowSamples<T>(this->Samples),
          static_cast<float>(this->Tables.PerValue), seen);
        return;
      }
    }
    SamplesAround around;
    if (this->Volume.HasGradients())
    {
      this->ReadAround(segments, around);
    }
    EmissionKernels::AddSegments(this->Volume, rays, segments, around, seen);
  }

  /// True if no cell is at the boundary.
  bool AreInside(const VolumeSegments& segments) const
  {
    bool areInside = true;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const int last = this->Samples.Dimensions[static_cast<int>(a)] - 2;
      for (std::size_t i = 0; i < static_cast<std::size_t>(segments.Count); ++i)
      {
        areInside &= segments.Cell[a][i] > 0 && segments.Cell[a][i] < last;
      }
    }
    return areInside;
  }

  /// Read the samples around cells. Beyond the boundary the field goes on as it ends, so that
  /// central differences are one-sided ones there.
  void ReadAround(const VolumeSegments& segments, SamplesAround& around) const
  {
    const TypedField<T> samples(this->Samples);
    const glm::ivec3 last = this->Samples.Dimensions - 1;
    for (std::size_t i = 0; i < static_cast<std::size_t>(segments.Count); ++i)
    {
      const glm::ivec3 cell(segments.Cell[0][i], segments.Cell[1][i], segments.Cell[2][i]);
      const auto at = [&](int x, int y, int z)
      {
        const glm::ivec3 place = cell + glm::ivec3(x, y, z);
        const glm::ivec3 near = glm::clamp(place, glm::ivec3(0), last);
        const float value = this->Reader.BinOf(*samples.At(near));
        return place == near ? value
                             : 2.0f * value - this->Reader.BinOf(*samples.At(2 * near - place));
      };
      for (int row = 0; row < 4; ++row)
      {
        for (int x = 0; x < 4; ++x)
        {
          around.Along[static_cast<std::size_t>(row)][static_cast<std::size_t>(x)][i] =
            at(x - 1, row & 1, row >> 1);
        }
      }
      for (int row = 0; row < 8; ++row)
      {
        const int across = (row & 2) != 0 ? 2 : -1, end = row & 1;
        for (int x = 0; x < 2; ++x)
        {
          around.Beside[static_cast<std::size_t>(row)][static_cast<std::size_t>(x)][i] =
            row < 4 ? at(x, across, end) : at(x, end, across);
        }
      }
    }
    FillLastVectors(segments, around);
  }

  /// So that no lane of the last vector is uninitialised.
  static void FillLastVectors(const VolumeSegments& segments, SamplesAround& around)
  {
    const auto count = static_cast<std::ptrdiff_t>(segments.Count);
    const auto fill = [count](auto& rows)
    {
      for (auto& row : rows)
      {
        for (auto& values : row)
        {
          std::fill_n(values.begin() + count, WidestVector, 0.0f);
        }
      }
    };
    fill(around.Along);
    fill(around.Beside);
  }

  const Field& Samples;
  const ComponentLook& Look;
  TransferTables Tables;
  SegmentReader<T> Reader;
  GradientTable ByGradient;
  const ActiveCells* Active;
  ActiveCells All; ///< all cells, if none are left out
  SegmentsKernels::SeenBins Seen;
  VolumeLights Lights;
  EmissionKernels::EmittingVolume Volume;
  glm::dvec3 Position;
  bool IsParallel;
  glm::dmat4 WorldFromIndex;
};

}

std::shared_ptr<const BlendTracer> MakeCompositeTracer(const BlendScene& scene)
{
  return DispatchScalarType(scene.Key.Samples.Type,
    [&](auto type) -> std::shared_ptr<const BlendTracer>
    { return std::make_shared<CompositeTracer<decltype(type)>>(scene); });
}

}
