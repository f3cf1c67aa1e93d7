// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Cold frames of meshes are what a search of every cell for every ray finds, and every route makes
// the cold one.

#include "Acceleration/ValueRangePyramid.h"
#include "Checks/Infinity.h"
#include "Checks/Sanitized.h"
#include "Grid.h"
#include "Kinds/MeshKind.h"
#include "Mesh/Cells/KernelsCells.h"
#include "Mesh/Tiles/MeshDifference.h"
#include "Mesh/Tree/MeshTree.h"
#include "Render/FrameRenderer.h"
#include "SameFrames.h"
#include "Volumes/Meshes.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace
{

using namespace TemporalCoherence;

/// Steps of a random walk.
constexpr int Steps = IsMemorySanitized ? 8 : 50;

/// Steps of a drag.
constexpr int DragSteps = IsMemorySanitized ? 3 : 16;

Meshes::Block Small()
{
  Meshes::Block block;
  block.Cubes = { 6, 5, 6 };
  return block;
}

class MeshFrames : public ::testing::TestWithParam<Meshes::Cells>
{
protected:
  MeshFrames() { this->Show(Meshes::MeshOf(Meshes::MakeBlock(this->GetParam(), Small()))); }

  void Show(std::shared_ptr<const Mesh> mesh, bool averagedGradients = false)
  {
    MeshProblem problem;
    this->Tree = MeshTree::Build(mesh, nullptr, ~std::size_t(0), problem);
    ASSERT_TRUE(this->Tree);
    this->Key.Samples = MeshField(*this->Tree, MeshKind(this->Tree, averagedGradients));
    this->Key.EditIsosurfaces().Isovalues = { 0.3 };
    this->Key.Appearance.Colors.assign(3, { 1.0, 0.5, 0.2 });
    this->Key.Appearance.Shade = true;
    this->Key.Appearance.Lights = { Light() };
    this->LookFrom({ 1.0, 2.0, 0.7 });
  }

  void LookFrom(
    const glm::dvec3& direction, bool parallel = false, const glm::ivec2& size = { 61, 47 })
  {
    const glm::ivec3 box(glm::ceil(glm::dvec3(1.0 / this->Tree->Scale())));
    this->Key.View = LookAt(box + 1, direction, size, parallel);
  }

  Frame Cold() const
  {
    FrameRenderer renderer;
    renderer.Render(this->Key, {});
    EXPECT_EQ(renderer.Statistics().Made, Route::Cold);
    return renderer.LastFrame();
  }

  /// The first surface of a ray: every cell is searched.
  struct Met
  {
    double Distance = Infinity;
    SurfaceIndex Isovalue = Frame::NoSurface;
  };
  std::vector<Met> SearchAllCells() const
  {
    const int width = this->Key.View.Size.x, count = width * this->Key.View.Size.y;
    std::vector<Met> all(static_cast<std::size_t>(count));
    for (int first = 0; first < count; first += 64)
    {
      MeshKernels::MeshRays rays;
      rays.Count = static_cast<std::size_t>(std::min(count - first, 64));
      for (std::size_t i = 0; i < rays.Count; ++i)
      {
        const int pixel = first + static_cast<int>(i);
        const Ray ray = this->Key.View.RayThrough(pixel % width, pixel / width);
        const glm::dvec3 origin = this->Tree->ToMesh(ray.Origin);
        for (std::size_t a = 0; a < 3; ++a)
        {
          const auto axis = static_cast<int>(a);
          rays.Origin[a][i] = origin[axis];
          rays.Direction[a][i] = this->Tree->Scale() * ray.Direction[axis];
        }
        const double perDepth = 1.0 / glm::dot(ray.Direction, this->Key.View.Forward);
        rays.Begin[i] = this->Key.View.Near * perDepth;
        rays.End[i] = this->Key.View.Far * perDepth;
      }
      rays.Prepare();
      this->SearchAllCells(rays, &all[static_cast<std::size_t>(first)]);
    }
    return all;
  }

  std::shared_ptr<const MeshTree> Tree;
  FrameKey Key;

private:
  void SearchAllCells(const MeshKernels::MeshRays& rays, Met* met) const
  {
    const std::uint64_t which = ~std::uint64_t(0) >> (64 - rays.Count);
    const std::vector<double>& isovalues = this->Key.Isosurfaces().Isovalues;
    for (std::uint32_t number = 0; number < this->Tree->TheMesh().NumberOfCells(); ++number)
    {
      MeshCell cell;
      this->Tree->Reader().Read(number, cell);
      for (std::size_t i = 0; i < isovalues.size() && cell.Shape != MeshCellShape::None; ++i)
      {
        MeshKernels::CellDifferences differences;
        if (MeshDifference(isovalues[i], { -3.0, 3.0 }).Of(cell, differences))
        {
          MeshKernels::Crossings found;
          MeshKernels::CellCrossings(cell, differences, rays, which, found);
          for (std::size_t k = 0; k < found.Count; ++k)
          {
            if (found.T[k] < met[found.Ray[k]].Distance)
            {
              met[found.Ray[k]] = { found.T[k], static_cast<SurfaceIndex>(i) };
            }
          }
        }
      }
    }
  }
};

TEST_P(MeshFrames, ColdFramesFindWhatEveryCellHolds)
{
  this->Key.EditIsosurfaces().Isovalues = { 0.3, -0.5 };
  for (const bool isParallel : { false, true })
  {
    this->LookFrom({ 1.0, 2.0, 0.7 }, isParallel);
    const Frame frame = this->Cold();
    const std::vector<Met> truth = this->SearchAllCells();
    int hits = 0, wrong = 0;
    for (std::size_t pixel = 0; pixel < truth.size(); ++pixel)
    {
      hits += truth[pixel].Isovalue != Frame::NoSurface;
      const bool isSame = frame.Isovalues[pixel] == truth[pixel].Isovalue &&
        (truth[pixel].Isovalue == Frame::NoSurface ||
          std::abs(frame.Depth[pixel] - truth[pixel].Distance) <= 1e-9 * truth[pixel].Distance);
      wrong += !isSame;
    }
    EXPECT_GT(hits, 200) << isParallel;
    EXPECT_EQ(wrong, 0) << isParallel;
  }
}

TEST_P(MeshFrames, HitsTellTheirCellsAndNormalsFaceTheViewer)
{
  const Frame frame = this->Cold();
  for (std::size_t pixel = 0; pixel < frame.Depth.size(); ++pixel)
  {
    const bool isHit = frame.Isovalues[pixel] != Frame::NoSurface;
    EXPECT_EQ(frame.Cells[pixel] != NoCell, isHit) << pixel;
    if (isHit)
    {
      const int x = static_cast<int>(pixel) % frame.Size.x,
                y = static_cast<int>(pixel) / frame.Size.x;
      const glm::dvec3 direction = this->Key.View.RayThrough(x, y).Direction;
      EXPECT_LE(glm::dot(glm::dvec3(frame.Normals[pixel]), direction), 1e-6) << pixel;
      EXPECT_NEAR(glm::length(frame.Normals[pixel]), 1.0f, 1e-5f) << pixel;
    }
  }
}

/// The isovalues of a drag, and what each route has to show.
TEST_P(MeshFrames, SweepsAreColdFrames)
{
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    for (const bool isTranslucent : { false, true })
    {
      this->Key.EditIsosurfaces().Mode = mode;
      this->Key.EditIsosurfaces().Opacities.assign(isTranslucent ? 1 : 0, 0.5);
      FrameRenderer renderer;
      std::map<Route, int> routes;
      for (int step = 0; step < DragSteps; ++step)
      {
        this->Key.EditIsosurfaces().Isovalues = { 0.3 + 0.02 * step };
        renderer.Render(this->Key, {});
        ++routes[renderer.Statistics().Made];
        const Frame cold = this->Cold();
        ASSERT_TRUE(ShowTheSame(renderer.LastFrame(), cold))
          << step << NameOf(renderer.Statistics().Made) << int(mode) << isTranslucent;
        ASSERT_TRUE(IsSamePlane(renderer.LastFrame().Cells, cold.Cells)) << step;
        ASSERT_TRUE(HaveTheSameLayers(renderer.LastFrame(), cold)) << step;
      }
      EXPECT_GT(routes[Route::IsomapBuild] + routes[Route::IsomapLookup], DragSteps / 3);
    }
  }
}

TEST_P(MeshFrames, RangesOfIsomapsServeLookUps)
{
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    this->Key.EditIsosurfaces().Mode = mode;
    this->Key.EditIsosurfaces().Isovalues = { 0.3 };
    FrameRenderer::Options options;
    options.Map.Range = { -0.5, 1.5 };
    FrameRenderer renderer;
    renderer.Render(this->Key, options);
    ASSERT_EQ(renderer.BuildIsomap(this->Key, options), Isomap::Outcome::Built);
    for (int step = 0; step < 8; ++step)
    {
      this->Key.EditIsosurfaces().Isovalues = { -0.45 + 0.23 * step };
      renderer.Render(this->Key, options);
      EXPECT_EQ(renderer.Statistics().Made, Route::IsomapLookup);
      const Frame cold = this->Cold();
      ASSERT_TRUE(ShowTheSame(renderer.LastFrame(), cold)) << step;
      ASSERT_TRUE(IsSamePlane(renderer.LastFrame().Cells, cold.Cells)) << step;
    }
  }
}

/// Ranges narrower than a cell, and a little wider, from any side: of a cell only the part within
/// the range is looked at.
TEST_P(MeshFrames, NarrowRangesOfIsomapsServeLookUps)
{
  std::mt19937 engine(11);
  std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
  int lookedUp = 0, hits = 0;
  for (int round = 0; round < (IsMemorySanitized ? 3 : 30); ++round)
  {
    const bool isParallel = round % 4 == 3;
    this->LookFrom(
      { anywhere(engine), anywhere(engine), anywhere(engine) }, isParallel, { 73, 81 });
    this->Key.EditIsosurfaces().Mode =
      round % 5 == 4 ? SurfaceMode::Threshold : SurfaceMode::Crossing;
    const double low = 0.9 * anywhere(engine), width = std::pow(10.0, -3 + round % 3);
    FrameRenderer::Options options;
    options.Map.Range = { low, low + width };
    this->Key.EditIsosurfaces().Isovalues = { low };
    FrameRenderer renderer;
    renderer.Render(this->Key, options);
    ASSERT_EQ(renderer.BuildIsomap(this->Key, options), Isomap::Outcome::Built);
    for (const double share : { 0.0, 0.3, 0.5, 0.8, 1.0 })
    {
      this->Key.EditIsosurfaces().Isovalues = { share < 1.0 ? low + share * width : low + width };
      renderer.Render(this->Key, options);
      lookedUp += renderer.Statistics().Made == Route::IsomapLookup ? 1 : 0;
      const Frame cold = this->Cold();
      ASSERT_TRUE(ShowTheSame(renderer.LastFrame(), cold)) << round << ", " << share;
      ASSERT_TRUE(IsSamePlane(renderer.LastFrame().Cells, cold.Cells)) << round << ", " << share;
      hits += static_cast<int>(std::count_if(
        cold.Depth.begin(), cold.Depth.end(), [](auto depth) { return std::isfinite(depth); }));
    }
  }
  EXPECT_GT(lookedUp, IsMemorySanitized ? 10 : 50);
  EXPECT_GT(hits, IsMemorySanitized ? 300 : 1000);
}

/// Slabs with gaps between them: a ray leaves the mesh at one value, and enters it again at another
/// one that it has not passed. Slabs that overlap: what is behind in one may be nearer in another.
TEST_P(MeshFrames, RangesOfIsomapsServeLookUpsInSlabs)
{
  std::mt19937 engine(3);
  const auto random = [&](double low, double high)
  { return std::uniform_real_distribution<double>(low, high)(engine); };
  FrameRenderer::Options options;
  options.Map.Range = { -0.6, 0.6 };
  int lookedUp = 0;
  for (int round = 0; round < (IsMemorySanitized ? 4 : 24); ++round)
  {
    const double thickness = round % 4 < 2 ? 0.12 : 0.35;
    this->Key.EditIsosurfaces().Mode =
      round % 3 == 2 ? SurfaceMode::Threshold : SurfaceMode::Crossing;
    Meshes::Block block;
    block.Cubes = { 3, 1, 3 };
    std::vector<Meshes::DoubleArrays> slabs;
    for (int i = 0; i < 5; ++i)
    {
      const double offset = random(-1.0, 1.0), slope = random(-2.0, 2.0), wave = random(0.0, 1.0);
      slabs.push_back(Meshes::MakeBlock(this->GetParam(), block,
        [&](const glm::dvec3& p)
        { return offset + slope * (p.y - 0.5) + wave * std::sin(5.0 * (p.x + p.z)); }));
      Meshes::Transform(slabs.back(),
        glm::scale(
          glm::translate(glm::dmat4(1.0), { 0.0, 0.2 * i, 0.0 }), { 1.0, thickness, 1.0 }));
    }
    this->Show(Meshes::MeshOf(slabs[0], slabs[1], slabs[2], slabs[3], slabs[4]));
    this->LookFrom({ 0.2, round % 2 == 0 ? 1.0 : -1.0, 0.3 });
    FrameRenderer renderer;
    renderer.Render(this->Key, options);
    ASSERT_EQ(renderer.BuildIsomap(this->Key, options), Isomap::Outcome::Built);
    for (int step = 0; step < 12; ++step)
    {
      this->Key.EditIsosurfaces().Isovalues = { random(-0.59, 0.59) };
      renderer.Render(this->Key, options);
      lookedUp += renderer.Statistics().Made == Route::IsomapLookup ? 1 : 0;
      ASSERT_TRUE(ShowTheSame(renderer.LastFrame(), this->Cold())) << round << ", " << step;
    }
  }
  EXPECT_GT(lookedUp, 10);
}

/// Views, isovalues, opacities, modes and clipping change at random.
TEST_P(MeshFrames, RandomWalksAreColdFrames)
{
  std::mt19937 engine(7);
  const auto chance = [&](unsigned int of) { return engine() % of == 0; };
  std::uniform_real_distribution<double> anywhere(-1.0, 1.0);
  FrameRenderer renderer;
  std::map<Route, int> routes;
  for (int step = 0; step < Steps; ++step)
  {
    if (chance(4))
    {
      this->LookFrom({ anywhere(engine), anywhere(engine), anywhere(engine) }, chance(3));
    }
    if (chance(2))
    {
      this->Key.EditIsosurfaces().Isovalues = { 0.2 + anywhere(engine) };
      if (chance(3))
      {
        this->Key.EditIsosurfaces().Isovalues.push_back(anywhere(engine) - 1.0);
      }
    }
    if (chance(5))
    {
      this->Key.EditIsosurfaces().Mode = chance(2) ? SurfaceMode::Crossing : SurfaceMode::Threshold;
    }
    const bool isTranslucent = chance(3);
    this->Key.EditIsosurfaces().Opacities.assign(
      isTranslucent ? this->Key.Isosurfaces().Isovalues.size() : 0, 0.4);
    this->Key.Appearance.Ambient = 0.1 * (engine() % 3);
    renderer.Render(this->Key, {});
    ++routes[renderer.Statistics().Made];
    const Frame cold = this->Cold();
    ASSERT_TRUE(ShowTheSame(renderer.LastFrame(), cold))
      << step << NameOf(renderer.Statistics().Made);
    ASSERT_TRUE(HaveTheSameLayers(renderer.LastFrame(), cold)) << step;
  }
  EXPECT_GT(routes.size(), IsMemorySanitized ? 1u : 3u);
}

TEST_P(MeshFrames, ThreadsMakeNoDifference)
{
  this->Key.EditIsosurfaces().Opacities = { 0.5 };
  const Frame frame = this->Cold();
  const std::string before = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("Sequential");
  const Frame alone = this->Cold();
  vtkSMPTools::SetBackend(before.c_str());
  EXPECT_TRUE(ShowTheSame(frame, alone));
  EXPECT_TRUE(HaveTheSameLayers(frame, alone));
}

/// A solid that fills the mesh shows its faces.
TEST_P(MeshFrames, SolidsAreCappedWhereTheMeshEnds)
{
  this->Key.EditIsosurfaces().Mode = SurfaceMode::Threshold;
  this->Key.EditIsosurfaces().Isovalues = { -4.0 };
  const Frame frame = this->Cold();
  int caps = 0;
  for (std::size_t pixel = 0; pixel < frame.Kinds.size(); ++pixel)
  {
    if (frame.Isovalues[pixel] != Frame::NoSurface)
    {
      ASSERT_EQ(frame.Kinds[pixel], HitKind::Cap);
      ++caps;
    }
  }
  EXPECT_GT(caps, 500);
  // Seen through, it has one cap on each ray that meets it, and no surface within.
  this->Key.EditIsosurfaces().Opacities = { 0.4 };
  const Frame clear = this->Cold();
  std::size_t layers = 0;
  for (const std::vector<LayerHit>& tile : clear.Layers)
  {
    layers += tile.size();
  }
  // Where cells are missing, a ray may leave and enter again.
  const bool isWhole = this->GetParam() != Meshes::Cells::Mixed;
  EXPECT_GE(layers, static_cast<std::size_t>(caps));
  EXPECT_LE(layers, static_cast<std::size_t>(isWhole ? caps + 2 : 2 * caps));
}

/// The normals of a sphere: those of averaged gradients are nearer to the truth.
TEST_P(MeshFrames, AveragedGradientsAreSmooth)
{
  const glm::dvec3 centre(0.5);
  const auto mesh = Meshes::MeshOf(Meshes::MakeBlock(
    this->GetParam(), {}, [&](const glm::dvec3& p) { return glm::distance(p, centre); }));
  std::array<double, 2> error{};
  for (const bool areAveraged : { false, true })
  {
    this->Show(mesh, areAveraged);
    this->Key.EditIsosurfaces().Isovalues = { 0.35 };
    const Frame frame = this->Cold();
    int hits = 0;
    for (std::size_t pixel = 0; pixel < frame.Depth.size(); ++pixel)
    {
      if (frame.Isovalues[pixel] != Frame::NoSurface)
      {
        const int x = static_cast<int>(pixel) % frame.Size.x;
        const Ray ray = this->Key.View.RayThrough(x, static_cast<int>(pixel) / frame.Size.x);
        const glm::dvec3 point =
          this->Tree->ToMesh(ray.Origin + frame.Depth[pixel] * ray.Direction);
        const glm::dvec3 normal(frame.Normals[pixel]);
        error[areAveraged] += 1.0 - std::abs(glm::dot(normal, glm::normalize(point - centre)));
        ++hits;
      }
    }
    EXPECT_GT(hits, 50);
    error[areAveraged] /= hits;
  }
  EXPECT_LT(error[0], 0.05);
  EXPECT_LT(error[1], 0.7 * error[0]);
}

/// No leaf is free of values that are not finite, and the range of the others is known all the
/// same.
TEST_P(MeshFrames, FiniteRangeBesideOtherValues)
{
  auto arrays = Meshes::MakeBlock(this->GetParam(), Small());
  for (std::size_t i = 0; i < arrays.Values.size(); ++i)
  {
    arrays.Values[i] = i % 17 == 0 ? std::nan("") : i % 9 == 1 ? Infinity : arrays.Values[i];
  }
  const auto mesh = Meshes::MeshOf(arrays);
  glm::dvec2 finite(Infinity, -Infinity), all = finite;
  const MeshReader reader(*mesh);
  for (std::int64_t number = 0; number < mesh->NumberOfCells(); ++number)
  {
    MeshCell cell;
    reader.Read(number, cell); // no points if a value is not a number
    for (int i = 0; i < cell.NumberOfPoints(); ++i)
    {
      const double value = cell.Values[static_cast<std::size_t>(i)];
      all = { std::min(all.x, value), std::max(all.y, value) };
      finite = std::isinf(value) ? finite
                                 : glm::dvec2(std::min(finite.x, value), std::max(finite.y, value));
    }
  }
  this->Show(mesh);
  ValueRangePyramid pyramid;
  pyramid.Build(this->Key.Samples);
  EXPECT_EQ(pyramid.FiniteRange(), finite);
  EXPECT_EQ(pyramid.WholeRange(), all);
  for (double& value : arrays.Values)
  {
    value = std::nan("");
  }
  this->Show(Meshes::MeshOf(arrays));
  pyramid.Build(this->Key.Samples);
  EXPECT_EQ(pyramid.FiniteRange(), glm::dvec2(0.0)) << "no value is finite";
}

TEST_P(MeshFrames, ValuesThatAreNotFiniteDoNoHarm)
{
  Meshes::DoubleArrays arrays = Meshes::MakeBlock(this->GetParam(), Small());
  for (std::size_t point = 0; point < arrays.Values.size(); point += 7)
  {
    arrays.Values[point] = point % 2 == 0 ? std::numeric_limits<double>::quiet_NaN() : Infinity;
  }
  this->Show(Meshes::MeshOf(std::move(arrays)));
  FrameRenderer renderer;
  for (int step = 0; step < 6; ++step)
  {
    this->Key.EditIsosurfaces().Isovalues = { 0.3 + 0.02 * step };
    renderer.Render(this->Key, {});
    const Frame cold = this->Cold();
    EXPECT_TRUE(ShowTheSame(renderer.LastFrame(), cold)) << step;
    EXPECT_TRUE(std::all_of(cold.Normals.begin(), cold.Normals.end(),
      [](const glm::vec3& normal) { return std::isfinite(normal.x + normal.y + normal.z); }));
    EXPECT_GT(std::count(cold.Kinds.begin(), cold.Kinds.end(), HitKind::Entry), 50);
  }
}

INSTANTIATE_TEST_SUITE_P(AllCells, MeshFrames,
  ::testing::Values(Meshes::Cells::FiveTetrahedra, Meshes::Cells::SixTetrahedra,
    Meshes::Cells::Hexahedra, Meshes::Cells::Wedges, Meshes::Cells::Pyramids,
    Meshes::Cells::Mixed));

}
