// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Floor.h"
#include "Kinds/FieldKind.h"

#include "Acceleration/ActiveCells.h"
#include "Acceleration/ValueRangePyramid.h"
#include "Input/FieldFromImage.h"
#include "KernelsFloor.h"
#include "Lattice/RaySource.h"
#include "Lattice/SurfaceTracer.h"
#include "Measuring.h"
#include "Request/ViewFromRenderer.h"
#include "Scene/Parallel.h"
#include "Scene/Tiles.h"

#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace Floor
{
namespace
{

using namespace TemporalCoherence;
using FloorKernel::Picture;
using FloorKernel::Tile;

void Require(bool isMade, const std::string& error)
{
  if (!isMade)
  {
    throw Measuring::Failure(error);
  }
}

/// What is drawn, as the engine sees it.
struct Scene
{
  explicit Scene(Stage& stage)
  {
    std::string error;
    Require(MakeField(stage.Image, stage.Image->GetPointData()->GetScalars(), false, 0,
              this->Samples, error),
      error);
    Require(MakeIndexTransform(stage.Image, false, stage.Volume, this->Transform, error), error);
    // The kernel fills whole tiles.
    const glm::ivec2 size(TileSize * ((stage.Size + TileSize - 1) / TileSize));
    Require(MakeView(stage.Renderer, size, 1.0, this->Camera, error), error);
  }

  bool HasFloor() const
  {
    const bool isTypeKnown = this->Samples.Type == ScalarType::UInt8 ||
      this->Samples.Type == ScalarType::Int16 || this->Samples.Type == ScalarType::Float32;
    const glm::ivec3& n = this->Samples.Dimensions;
    constexpr std::int64_t most = std::int64_t(1) << 29; // offsets have 32 bits
    return isTypeKnown && this->Samples.Strides.x == 1 && std::min({ n.x, n.y, n.z }) >= 4 &&
      this->Samples.Strides.z * n.z < most;
  }

  Field Samples;
  IndexTransform Transform;
  View Camera;
};

/// The hits of a tile and their cells. What is no hit gets the cell of one.
Tile TileOf(const Scene& scene, const RayBatch& rays, const HitBatch& hits, const PixelRect& part)
{
  Tile tile{ part.First.x, part.First.y, 0, {} };
  std::size_t last = 0;
  for (std::size_t i = 0; i < RayBatch::Capacity; ++i)
  {
    const bool isHit = std::isfinite(hits.Depth[i]);
    tile.Hits |= static_cast<std::uint64_t>(isHit) << i;
    last = isHit ? i : last;
  }
  for (std::size_t i = 0; i < RayBatch::Capacity; ++i)
  {
    const std::size_t of = tile.Hits >> i & 1 ? i : last;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const int most = scene.Samples.Dimensions[static_cast<int>(a)] - 3;
      const double at = rays.Origin[a][of] + hits.Depth[of] * rays.Direction[a][of];
      tile.Cell[a][i] = tile.Hits == 0 ? 1 : std::clamp(static_cast<int>(at), 1, most);
    }
  }
  return tile;
}

std::vector<Tile> FindHits(const Scene& scene, double isovalue)
{
  ValueRangePyramid pyramid;
  pyramid.Build(scene.Samples);
  ActiveCells active;
  const Surfaces surfaces = { { isovalue }, SurfaceMode::Crossing };
  active.Build(scene.Samples, pyramid, surfaces);
  const RaySource source(scene.Camera, scene.Transform, scene.Samples.Dimensions);
  TraceScene traced;
  traced.Samples = scene.Samples;
  traced.Isosurfaces = surfaces;
  traced.FiniteRange = pyramid.FiniteRange();
  traced.Active = &active;
  const auto tracer = MakeSurfaceTracer(traced);
  const auto count = static_cast<std::size_t>(NumberOfTiles(scene.Camera.Size));
  std::vector<Tile> all(count);
  ParallelFor(static_cast<std::int64_t>(count), TileGrain,
    [&](std::int64_t number)
    {
      const PixelRect part = PixelsOfTile(scene.Camera.Size, number);
      RayBatch rays;
      HitBatch hits;
      source.SetUp(part.First, part.Size, rays);
      tracer->Trace(rays, hits);
      all[static_cast<std::size_t>(number)] = TileOf(scene, rays, hits, part);
    });
  all.erase(std::remove_if(all.begin(), all.end(), [](const Tile& tile) { return tile.Hits == 0; }),
    all.end());
  return all;
}

FloorKernel::Vector<float> Floats(const glm::dvec3& v)
{
  return { static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z) };
}

Picture PictureOf(const Scene& scene, double isovalue, std::vector<float>& depth,
  std::vector<std::uint32_t>& colors)
{
  const View& view = scene.Camera;
  const glm::dmat3 turn(scene.Transform.IndexFromWorld);
  const glm::dvec2 perPixel = 2.0 / glm::dvec2(view.Size);
  const glm::dvec3 first = view.Direction + (0.5 * perPixel.x - 1.0) * view.DirectionX +
    (0.5 * perPixel.y - 1.0) * view.DirectionY;
  depth.assign(static_cast<std::size_t>(view.Size.x * view.Size.y), 1.0f);
  colors.assign(depth.size(), 0);
  Picture picture{};
  picture.Samples = scene.Samples.Samples;
  picture.StrideY = static_cast<std::int32_t>(scene.Samples.Strides.y);
  picture.StrideZ = static_cast<std::int32_t>(scene.Samples.Strides.z);
  picture.Isovalue = static_cast<float>(isovalue);
  picture.Origin =
    Floats(glm::dvec3(scene.Transform.IndexFromWorld * glm::dvec4(view.Origin, 1.0)));
  picture.Direction = Floats(turn * first);
  picture.DirectionX = Floats(perPixel.x * (turn * view.DirectionX));
  picture.DirectionY = Floats(perPixel.y * (turn * view.DirectionY));
  picture.Color = { 0.9f, 0.8f, 0.7f };
  picture.Ambient = 0.1f;
  picture.Diffuse = 0.7f;
  picture.Specular = 0.2f;
  picture.Width = view.Size.x;
  picture.Depth = depth.data();
  picture.Colors = colors.data();
  return picture;
}

void Draw(const Picture& picture, const std::vector<Tile>& tiles, ScalarType type)
{
  ParallelFor(static_cast<std::int64_t>(tiles.size()), TileGrain,
    [&](std::int64_t i)
    {
      const Tile& tile = tiles[static_cast<std::size_t>(i)];
      if (type == ScalarType::UInt8)
      {
        DrawTile(picture, tile, std::uint8_t());
      }
      else if (type == ScalarType::Int16)
      {
        DrawTile(picture, tile, std::int16_t());
      }
      else
      {
        DrawTile(picture, tile, float());
      }
    });
}

}

Times Measure(Stage& stage, int frames)
{
  const Scene scene(stage);
  if (!scene.HasFloor())
  {
    return { Measuring::None, Measuring::None, Measuring::None };
  }
  const std::vector<Tile> tiles = FindHits(scene, stage.Isovalue());
  std::vector<float> depth;
  std::vector<std::uint32_t> colors;
  const Picture picture = PictureOf(scene, stage.Isovalue(), depth, colors);
  std::vector<double> walls;
  double least = Measuring::None;
  for (int frame = 0; frame < frames; ++frame)
  {
    const double begin = Measuring::CpuTime();
    walls.push_back(Measuring::TimeOf([&] { Draw(picture, tiles, scene.Samples.Type); }));
    least = std::fmin(least, Measuring::CpuTime() - begin);
  }
  const auto hits = static_cast<double>(
    std::count_if(colors.begin(), colors.end(), [](std::uint32_t color) { return color != 0; }));
  return { hits, Measuring::Median(walls), 1e6 * Measuring::Ratio(least, hits) };
}

}
