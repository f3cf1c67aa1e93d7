// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A beam finds the surfaces that rays meet one after the other on walks, bit by bit, up to where a
// ray is opaque, on any field, from anywhere, on every kind of vectors.
#include "EachTarget.h"
#include "Grid.h"
#include "Kinds/RectilinearKind.h"
#include "Lattice/BeamCameras.h"
#include "Lattice/BothWays.h"
#include "Lattice/Coordinates.h"
#include "Lattice/RayPieces.h"
#include "Lattice/Waves.h"
#include "RefusedMemory.h"
#include "Scene/LayerBatch.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

namespace
{

using namespace TemporalCoherence;

/// Finds all layers of tiles both ways.
template <typename T>
class LayersBothWays : public BothWays<T>
{
public:
  using BothWays<T>::BothWays;

  /// All tiles of a view.
  /// \param alphas of the isovalues; empty if only shading tells them
  void CompareLayers(
    const View& view, const std::vector<float>& alphas, const Region& region = Region())
  {
    const IndexTransform transform;
    const RaySource source(view, transform, this->Dimensions, region);
    for (std::int64_t tile = 0; tile < NumberOfTiles(view.Size); ++tile)
    {
      const PixelRect part = PixelsOfTile(view.Size, tile);
      RayBatch rays;
      source.SetUp(part.First, part.Size, rays);
      this->CompareTile(source.Clipper, rays, alphas);
      if (testing::Test::HasFatalFailure())
      {
        return;
      }
    }
  }

  std::int64_t Layers = 0, Passes = 0;

private:
  /// All passes of a tile. What only shading tells is that rays are half opaque after each pass.
  void CompareTile(
    const RegionClipper& clipper, const RayBatch& rays, const std::vector<float>& alphas)
  {
    constexpr int most = 40;
    const auto count = static_cast<std::size_t>(rays.Count);
    LayerBatch walked, beamed;
    walked.Begin(count, alphas);
    beamed.Begin(count, alphas);
    RayBatch::Array<float> shaded;
    shaded.fill(1.0f);
    bool goesOn = true;
    for (int pass = 0; goesOn && pass < most; ++pass)
    {
      this->FindBothWays(clipper, rays, walked, beamed);
      ASSERT_EQ(beamed.Open, 0u);
      for (std::size_t ray = 0; ray < count; ++ray)
      {
        ASSERT_NO_FATAL_FAILURE(this->CompareRay(walked, beamed, ray));
        shaded[ray] = alphas.empty() ? PassedBehind(shaded[ray], 0.5f) : walked.Transmittance[ray];
      }
      ++this->Passes;
      goesOn = walked.BeginNext(count, shaded);
      ASSERT_EQ(beamed.BeginNext(count, shaded), goesOn);
    }
    this->Rays += rays.Count;
  }

  /// In threads of its own a frame cannot tell that memory is out: tiles need none.
  void FindBothWays(
    const RegionClipper& clipper, const RayBatch& rays, LayerBatch& walked, LayerBatch& beamed)
  {
    const RefusedMemory refused(0);
    FindLayersWithin(clipper, *this->Walks, rays, walked);
    FindLayersWithin(clipper, *this->Beams, rays, beamed);
  }

  void CompareRay(const LayerBatch& walked, const LayerBatch& beamed, std::size_t ray)
  {
    ASSERT_EQ(beamed.Count[ray], walked.Count[ray]);
    ASSERT_EQ(beamed.Transmittance[ray], walked.Transmittance[ray]);
    for (std::size_t i = 0; i < walked.Count[ray]; ++i)
    {
      const std::size_t a = walked.Place[i][ray], b = beamed.Place[i][ray];
      ASSERT_EQ(beamed.Distance[b], walked.Distance[a]);
      ASSERT_EQ(beamed.Surface[b], walked.Surface[a]);
      ASSERT_EQ(beamed.Kind[b], walked.Kind[a]);
      ASSERT_EQ(beamed.Ray[b], ray);
      ++this->Layers;
    }
  }
};

class LayerBeams : public EachTarget
{
protected:
  /// \param every how many cameras one is taken
  template <typename T>
  void Compare(Grid<T>& grid, const std::vector<double>& isovalues,
    const std::vector<float>& alphas, int pixels = 24, std::size_t every = 2,
    const Region& region = Region())
  {
    for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
    {
      LayersBothWays<T> ways(grid, isovalues, mode);
      const std::vector<Camera> cameras = CamerasFor(grid.Field.Dimensions);
      for (std::size_t i = 0; i < cameras.size(); i += every)
      {
        Camera camera = cameras[i];
        camera.Eye += 7.0 * this->Off;
        camera.Towards += this->Off;
        ways.CompareLayers(ViewFrom(camera, pixels), alphas, region);
        if (this->HasFatalFailure())
        {
          return;
        }
      }
      EXPECT_GT(ways.Layers, ways.Rays / 10);
      this->Layers += ways.Layers;
      this->Passes += ways.Passes;
    }
  }

  /// Where a walk goes in a plane between cells of a grid, it may go on either side: off them.
  glm::dvec3 Off{ 0.0 };
  std::int64_t Layers = 0, Passes = 0;
};

/// A grid of smooth bytes.
class SmoothGrid : public Grid<std::uint8_t>
{
public:
  explicit SmoothGrid(const glm::ivec3& dimensions = glm::ivec3(50, 41, 37))
    : Grid<std::uint8_t>(dimensions)
  {
    this->Fill([](int i, int j, int k) { return 120.0 + 80.0 * Wave(i, j, k); });
  }
};

TEST_F(LayerBeams, AreThoseOfWalksOnSmoothFields)
{
  Grid<float> waves(glm::ivec3(50, 41, 37));
  waves.Fill(Wave);
  this->Compare(waves, { 0.1 }, { 0.3f });
  Grid<std::int16_t> ball(glm::ivec3(41, 41, 41));
  ball.Fill([](int i, int j, int k)
    { return 100.0 * glm::length(glm::dvec3(i - 20.0, j - 20.0, k - 20.0)); });
  this->Compare(ball, { 1500.0 }, { 0.9f });
  EXPECT_GT(this->Layers, 10000);
}

TEST_F(LayerBeams, AreThoseOfWalksForSeveralIsovalues)
{
  SmoothGrid smooth;
  this->Compare(smooth, { 120.0, 60.0, 180.0 }, { 0.3f, 0.1f, 1.0f });
  // Some that no sample meets, some that lie close together, and more than are told at once.
  this->Compare(smooth, { 1e300, 120.0, 120.5, 121.0, 121.5, 122.0, 122.5, -1e300 },
    { 0.2f, 0.2f, 0.2f, 0.2f, 0.2f, 0.2f, 0.2f, 0.2f }, 24, 4);
  Grid<double> noise(glm::ivec3(20, 21, 22));
  noise.FillRandomly(-1.0, 1.0, 10);
  this->Compare(noise, { 0.7, -0.5 }, { 0.2f, 0.4f }, 16, 3);
}

TEST_F(LayerBeams, AreThoseOfWalksAtSamplesEqualToTheIsovalue)
{
  Grid<std::uint8_t> steps(glm::ivec3(33, 34, 35));
  steps.Fill([](int i, int j, int k) { return (i / 3 + j / 4 + k / 5) % 5; });
  this->Compare(steps, { 2.0, 1.0, 3.5 }, { 0.1f, 0.2f, 0.3f }, 16);
  Grid<std::uint8_t> noise(glm::ivec3(21, 22, 23));
  noise.FillRandomly(0.0, 4.0, 9);
  this->Compare(noise, { 2.0 }, { 0.2f }, 16);
  Grid<std::uint16_t> plane(glm::ivec3(20, 20, 20));
  plane.Fill([](int i, int, int) { return 100 * (i % 7); });
  this->Compare(plane, { 300.0, 200.0 }, { 0.1f, 0.2f }, 16);
}

TEST_F(LayerBeams, AreThoseOfWalksInManyPasses)
{
  Grid<std::uint8_t> checks(glm::ivec3(40, 41, 42));
  checks.Fill([](int i, int j, int k) { return (i + j + k) % 2; });
  this->Compare(checks, { 0.7 }, { 0.01f }, 16, 6);
  this->Compare(checks, { 0.7 }, {}, 16, 6);
  EXPECT_GT(this->Passes, 100);
}

/// In one cell a ray meets more surfaces than one pass finds.
TEST_F(LayerBeams, AreThoseOfWalksInCellsOfManySurfaces)
{
  Grid<std::uint8_t> noise(glm::ivec3(6, 7, 8));
  noise.FillRandomly(0.0, 255.0, 13);
  std::vector<double> isovalues;
  for (int i = 0; i < 100; ++i)
  {
    isovalues.push_back(0.3 + 2.5 * i);
  }
  this->Compare(noise, isovalues, std::vector<float>(isovalues.size(), 0.01f), 16, 16);
}

TEST_F(LayerBeams, AreThoseOfWalksInNumbersOfAnySize)
{
  for (const double unit : { 1e-300, 1e300 })
  {
    Grid<double> waves(glm::ivec3(24, 21, 27));
    waves.Fill([unit](int i, int j, int k) { return unit * Wave(i, j, k); });
    this->Compare(waves, { 0.1 * unit, -0.2 * unit }, { 0.3f, 0.2f }, 16, 4);
  }
  Grid<float> holes(glm::ivec3(24, 21, 27));
  holes.Fill(WaveWithHoles);
  this->Compare(holes, { 1e29, -4e29, 0.0 }, { 0.3f, 0.3f, 0.3f }, 16, 3);
}

TEST_F(LayerBeams, AreThoseOfWalksBesideHiddenCells)
{
  SmoothGrid smooth(glm::ivec3(30, 31, 27));
  const glm::ivec3 cells = smooth.Field.Dimensions - 1;
  std::vector<std::uint8_t> flags(static_cast<std::size_t>(cells.x * cells.y * cells.z));
  std::mt19937 random(5);
  for (std::size_t at = 0; at < flags.size(); ++at)
  {
    const auto k = static_cast<int>(at) / (cells.x * cells.y);
    flags[at] = k / 3 == 4 || random() % 8 == 0;
  }
  smooth.Field.Hidden = HiddenCells::Make(smooth.Field.Dimensions, { flags.data(), 1 });
  ASSERT_TRUE(smooth.Field.Hidden);
  this->Compare(smooth, { 120.0, 60.0, 180.0 }, { 0.3f, 0.1f, 0.2f }, 16, 3);
}

TEST_F(LayerBeams, AreThoseOfWalksInPiecesOfRays)
{
  SmoothGrid smooth;
  Region region;
  region.Crops = { glm::dvec2(15.2, 33.1), glm::dvec2(10.3, 29.4), glm::dvec2(12.5, 25.6) };
  region.Boxes = Region::AllBoxes & ~(1u << 13); // all but the one in the middle
  this->Compare(smooth, { 120.0, 60.0 }, { 0.3f, 0.1f }, 16, 3, region);
}

TEST_F(LayerBeams, AreThoseOfWalksOnRectilinearGrids)
{
  SmoothGrid smooth;
  const auto coordinates = Stretched(smooth.Field.Dimensions, 3.0, 4);
  smooth.Field.Shape = RectilinearKind(coordinates);
  this->Off = { 0.0137, 0.0071, 0.0093 };
  this->Compare(smooth, { 120.0, 60.0 }, { 0.3f, 0.1f }, 16, 3);
}

TEST_F(LayerBeams, AreTheSameOnEveryKindOfVectors)
{
  SmoothGrid smooth;
  Grid<double> noise(glm::ivec3(20, 21, 22));
  noise.FillRandomly(-1.0, 1.0, 10);
  this->ForEachTarget(
    [&](const char* target)
    {
      SCOPED_TRACE(target);
      this->Compare(smooth, { 120.0, 150.0 }, { 0.3f, 0.3f }, 16, 9);
      this->Compare(noise, { 0.7 }, { 0.3f }, 16, 9);
    });
}

}
