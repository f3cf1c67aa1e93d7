// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// What is stored of a ray for a band of isovalues must hold every cell in which the ray meets any
// of them. On any field, from anywhere: what a search of these cells finds are the surfaces that
// the ray meets on a walk, bit by bit, whether passages were found by beams or by walks, on every
// kind of vectors. Rays with more passages than are stored tell so.
#include "EachTarget.h"
#include "Fields/BeamCameras.h"
#include "Fields/Coordinates.h"
#include "Fields/RectilinearKind.h"
#include "Fields/Waves.h"
#include "Grid.h"
#include "Isomap/BandTracer.h"
#include "Passages/PassageSearch.h"
#include "Scene/Tiles.h"
#include "Trace/RaySource.h"
#include "Tracing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <random>
#include <vector>

namespace
{

using namespace TemporalCoherence;

/// Looks up tiles in bands, and compares with walks.
template <typename T>
class LookUps
{
public:
  LookUps(Grid<T>& grid, const std::vector<ValueBand>& bands, const std::vector<double>& isovalues,
    SurfaceMode mode)
    : Dimensions(grid.Field.Dimensions)
    , Traced(grid, isovalues, mode)
    , Actives(bands.size())
  {
    this->Traced.Scene.By = Traversal::Walks;
    this->Walks = SurfaceTracer::Make(this->Traced.Scene);
    for (std::size_t i = 0; i < bands.size(); ++i)
    {
      this->AddBand(bands[i], this->Actives[i]);
    }
  }

  void Compare(const View& view)
  {
    const RaySource source(view, IndexTransform(), this->Dimensions);
    for (std::int64_t tile = 0; tile < NumberOfTiles(view.Size); ++tile)
    {
      const PixelRect part = PixelsOfTile(view.Size, tile);
      RayBatch rays;
      source.SetUp(part.First, part.Size, rays);
      LayerBatch walked;
      this->Begin(rays, walked);
      this->Walks->FindLayers(rays, walked);
      for (const std::vector<std::shared_ptr<const BandTracer>>* tracers :
        { &this->ByWalks, &this->ByBeams })
      {
        LayerBatch found;
        this->LookUp(rays, *tracers, found);
        ASSERT_NO_FATAL_FAILURE(this->CompareTile(rays, walked, found)) << "tile " << tile;
      }
    }
  }

  std::int64_t Layers = 0, MustTrace = 0;

private:
  void AddBand(const ValueBand& band, ActiveCells& active)
  {
    const TraceScene& traced = this->Traced.Scene;
    active.Build(traced.Samples, this->Traced.Pyramid, band, traced.Isosurfaces.Mode);
    BandScene scene;
    scene.Samples = traced.Samples;
    scene.FiniteRange = traced.FiniteRange;
    scene.Pyramid = &this->Traced.Pyramid;
    scene.Active = &active;
    scene.Band = band;
    scene.Mode = traced.Isosurfaces.Mode;
    scene.Form.HasPassages = true;
    scene.By = Traversal::Walks;
    this->ByWalks.push_back(BandTracer::Make(scene));
    scene.By = Traversal::Beams;
    this->ByBeams.push_back(BandTracer::Make(scene));
    this->Scales.emplace_back(traced.Samples.Type, band, traced.FiniteRange);
    this->Bands.push_back(band);
  }

  static void Begin(const RayBatch& rays, LayerBatch& layers)
  {
    layers.Begin(static_cast<std::size_t>(rays.Count), {});
    layers.Limit = LayerBatch::MostLayers;
  }

  /// Each isovalue in the first band that holds it.
  void LookUp(const RayBatch& rays, const std::vector<std::shared_ptr<const BandTracer>>& tracers,
    LayerBatch& layers)
  {
    std::vector<TileKnots> knots(tracers.size());
    for (std::size_t i = 0; i < tracers.size(); ++i)
    {
      tracers[i]->Trace(rays, knots[i]);
    }
    this->Begin(rays, layers);
    const std::vector<double>& isovalues = this->Traced.Scene.Isosurfaces.Isovalues;
    PassageSearch search(*this->Walks, rays, isovalues.size(), layers);
    for (std::size_t surface = 0; surface < isovalues.size(); ++surface)
    {
      const auto band = std::find_if(this->Bands.begin(), this->Bands.end(),
        [&](const ValueBand& each) { return each.Holds(isovalues[surface]); });
      const auto place = static_cast<std::size_t>(band - this->Bands.begin());
      const BandScale& scale = this->Scales[place];
      search.Add(surface, knots[place],
        static_cast<PassageKey>(scale.InKeys(scale.DifferenceOf(isovalues[surface]))));
    }
    layers.Open &= search.Search();
    this->MustTrace += static_cast<std::int64_t>(hwy::PopCount(layers.Open));
    this->Walks->FindLayers(rays, layers); // those that must be traced
  }

  void CompareTile(const RayBatch& rays, const LayerBatch& walked, const LayerBatch& found)
  {
    for (std::size_t ray = 0; ray < static_cast<std::size_t>(rays.Count); ++ray)
    {
      ASSERT_EQ(found.Count[ray], walked.Count[ray]) << "ray " << ray;
      for (std::size_t i = 0; i < walked.Count[ray]; ++i)
      {
        const std::size_t a = walked.Place[i][ray], b = found.Place[i][ray];
        ASSERT_EQ(found.Distance[b], walked.Distance[a]);
        ASSERT_EQ(found.Surface[b], walked.Surface[a]);
        ASSERT_EQ(found.Kind[b], walked.Kind[a]);
        ++this->Layers;
      }
    }
  }

  glm::ivec3 Dimensions;
  Tracing<T> Traced;
  std::vector<ActiveCells> Actives;
  std::vector<ValueBand> Bands;
  std::vector<BandScale> Scales;
  std::shared_ptr<const SurfaceTracer> Walks;
  std::vector<std::shared_ptr<const BandTracer>> ByWalks, ByBeams;
};

class Passages : public EachTarget
{
protected:
  template <typename T>
  void Compare(Grid<T>& grid, const std::vector<ValueBand>& bands,
    const std::vector<double>& isovalues, int pixels = 16, std::size_t every = 5)
  {
    for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
    {
      LookUps<T> lookUps(grid, bands, isovalues, mode);
      const std::vector<Camera> cameras = CamerasFor(grid.Field.Dimensions);
      for (std::size_t i = 0; i < cameras.size(); i += every)
      {
        SCOPED_TRACE(testing::Message() << "mode " << static_cast<int>(mode) << " camera " << i);
        Camera camera = cameras[i];
        camera.Eye += 7.0 * this->Off;
        camera.Towards += this->Off;
        ASSERT_NO_FATAL_FAILURE(lookUps.Compare(ViewFrom(camera, pixels)));
      }
      this->Layers += lookUps.Layers;
      this->MustTrace += lookUps.MustTrace;
    }
    EXPECT_GT(this->Layers, 500 / static_cast<std::int64_t>(EveryNthCamera));
  }

  /// Each isovalue alone.
  template <typename T>
  void CompareEach(Grid<T>& grid, const ValueBand& band, const std::vector<double>& isovalues,
    std::size_t every = 7)
  {
    for (const double isovalue : isovalues)
    {
      SCOPED_TRACE(testing::Message() << "isovalue " << isovalue);
      this->Compare(grid, { band }, { isovalue }, 16, every);
    }
  }

  glm::dvec3 Off{ 0.0 }; ///< off planes between cells
  std::int64_t Layers = 0, MustTrace = 0;
};

TEST_F(Passages, HoldEverySurfaceOfSmoothFields)
{
  Grid<std::uint8_t> bytes(glm::ivec3(40, 31, 37));
  bytes.Fill([](int i, int j, int k) { return 120.0 + 80.0 * Wave(i, j, k); });
  this->CompareEach(bytes, { 100.0, 140.0 }, { 100.0, 111.5, 120.0, 139.9, 140.0 });
  this->CompareEach(bytes, { 120.0, 120.0 }, { 120.0 });
  EXPECT_LT(this->MustTrace, this->Layers / 50) << "hardly a ray is to be traced";
  Grid<float> floats(glm::ivec3(30, 41, 37));
  floats.Fill(Wave);
  this->CompareEach(floats, { -0.5, 0.9 }, { -0.5, 0.1, 0.9 });
}

TEST_F(Passages, HoldSurfacesAtSamplesEqualToTheIsovalue)
{
  Grid<std::uint8_t> steps(glm::ivec3(33, 34, 35));
  steps.Fill([](int i, int j, int k) { return (i / 3 + j / 4 + k / 5) % 5; });
  this->CompareEach(steps, { 1.0, 3.0 }, { 1.0, 2.0, 2.5, 3.0 });
  Grid<std::uint16_t> plane(glm::ivec3(20, 20, 20));
  plane.Fill([](int i, int, int) { return 100 * (i % 7); });
  this->CompareEach(plane, { 200.0, 400.0 }, { 200.0, 300.0, 400.0 });
}

TEST_F(Passages, HoldEverySurfaceInNoiseOfAnyType)
{
  Grid<double> doubles(glm::ivec3(20, 21, 22));
  doubles.FillRandomly(-1.0, 1.0, 10);
  this->CompareEach(doubles, { 0.6, 0.9 }, { 0.6, 0.75, 0.9 });
  Grid<std::uint16_t> steep(glm::ivec3(20, 20, 25));
  steep.FillRandomly(0.0, 60000.0, 12);
  this->CompareEach(steep, { 30000.0, 30000.01 }, { 30000.0, 30000.005 });
  for (const double unit : { 1e-300, 1e300 })
  {
    Grid<double> waves(glm::ivec3(24, 21, 27));
    waves.Fill([unit](int i, int j, int k) { return unit * Wave(i, j, k); });
    this->CompareEach(waves, { 0.1 * unit, 0.4 * unit }, { 0.1 * unit, 0.3 * unit });
  }
  Grid<float> holes(glm::ivec3(24, 21, 27));
  holes.Fill(WaveWithHoles);
  this->CompareEach(holes, { -4e29, 1e29 }, { -4e29, 0.0, 1e29 });
  holes.Field.Between = Interpolation::Nearest;
  this->CompareEach(holes, { -4e29, 1e29 }, { -4e29, 0.0, 1e29 });
}

TEST_F(Passages, OfSeveralIsovaluesAreSearchedInTheirOrder)
{
  Grid<std::uint8_t> bytes(glm::ivec3(40, 31, 37));
  bytes.Fill([](int i, int j, int k) { return 120.0 + 80.0 * Wave(i, j, k); });
  this->Compare(bytes, { { 100.0, 121.0 }, { 150.0, 190.0 } }, { 160.0, 120.0, 121.0, 180.0 });
  Grid<std::uint8_t> noise(glm::ivec3(12, 13, 14));
  noise.FillRandomly(0.0, 255.0, 13);
  this->Compare(
    noise, { { 0.0, 100.0 }, { 90.0, 250.0 } }, { 20.0, 60.0, 61.0, 99.0, 128.0, 129.5, 240.0 });
}

TEST_F(Passages, BesideHiddenCells)
{
  Grid<std::uint8_t> bytes(glm::ivec3(30, 31, 27));
  bytes.Fill([](int i, int j, int k) { return 120.0 + 80.0 * Wave(i, j, k); });
  const glm::ivec3 cells = bytes.Field.Dimensions - 1;
  std::vector<std::uint8_t> flags(static_cast<std::size_t>(cells.x * cells.y * cells.z));
  std::mt19937 random(5);
  for (std::uint8_t& flag : flags)
  {
    flag = random() % 8 == 0;
  }
  bytes.Field.Hidden = HiddenCells::Make(bytes.Field.Dimensions, { flags.data(), 1 });
  ASSERT_TRUE(bytes.Field.Hidden);
  this->Compare(bytes, { { 100.0, 130.0 }, { 60.0, 70.0 } }, { 120.0, 60.0 });
}

TEST_F(Passages, OfRectilinearGridsAndNearestSamples)
{
  Grid<std::uint8_t> bytes(glm::ivec3(30, 31, 27));
  bytes.Fill([](int i, int j, int k) { return 120.0 + 80.0 * Wave(i, j, k); });
  bytes.Field.Between = Interpolation::Nearest;
  this->Compare(bytes, { { 100.0, 130.0 } }, { 120.0 });
  this->Off = { 0.0137, 0.0071, 0.0093 };
  bytes.Field.Kind = RectilinearKind(Stretched(bytes.Field.Dimensions, 3.0, 4));
  this->Compare(bytes, { { 100.0, 130.0 } }, { 120.0 });
  bytes.Field.Between = Interpolation::Linear;
  this->Compare(bytes, { { 100.0, 130.0 }, { 60.0, 70.0 } }, { 120.0, 60.0 });
}

/// A ray has more passages than are stored: the surfaces behind the last one are traced.
TEST_F(Passages, ThatAreTooManyAreToldToBe)
{
  // Every cell passes isovalues of the band, few of them the one that is looked up.
  Grid<float> checks(glm::ivec3(64, 63, 62));
  checks.Fill([](int i, int j, int k)
    { return ((i + j + k) % 2 ? 1.0 : -1.0) * ((i * 7 + j * 3 + k) % 97 ? 0.5 : 1.0); });
  this->Compare(checks, { { 0.1, 0.9 } }, { 0.8 }, 16, 3);
  EXPECT_GT(this->MustTrace, 100 / static_cast<std::int64_t>(EveryNthCamera));
}

TEST_F(Passages, AreFoundOnEveryKindOfVectors)
{
  Grid<std::uint8_t> bytes(glm::ivec3(30, 31, 27));
  bytes.Fill([](int i, int j, int k) { return 120.0 + 80.0 * Wave(i, j, k); });
  Grid<double> noise(glm::ivec3(12, 13, 14));
  noise.FillRandomly(-1.0, 1.0, 10);
  this->ForEachTarget(
    [&](const char* target)
    {
      SCOPED_TRACE(target);
      this->Compare(bytes, { { 100.0, 150.0 } }, { 120.0, 145.0 }, 16, 11);
      this->Compare(noise, { { 0.6, 0.7 } }, { 0.65 }, 16, 11);
    });
}

}
