// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Lists of layers of a tile are merged in the order in which rays meet surfaces: none is lost, none
// is there twice, and the result has the order of Frame::Layers.

#include "Scene/HitOrder.h"
#include "Shade/LayerMerge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <tuple>
#include <vector>

namespace
{

using namespace TemporalCoherence;

class LayerMerge : public ::testing::Test
{
protected:
  /// A tile at the upper right corner of a picture.
  const int Width = 30;
  const PixelRect Part{ { 24, 8 }, { 6, 5 } };
  const std::vector<double> Isovalues{ 3.0, -1.0, 7.0 };

  MetSurface SurfaceOf(const LayerHit& hit) const
  {
    return { hit.Depth, hit.Kind, this->Isovalues[static_cast<std::size_t>(hit.Isovalue)] };
  }

  /// Layers as rays meet them: few distances, so that many are equal or lie at one distance.
  std::vector<LayerHit> AnyLayers(std::mt19937& engine, std::size_t most) const
  {
    std::vector<LayerHit> layers(engine() % (most + 1));
    for (LayerHit& hit : layers)
    {
      const int x = this->Part.First.x + static_cast<int>(engine() % 6);
      const int y = this->Part.First.y + static_cast<int>(engine() % 5);
      hit.Depth = static_cast<double>(engine() % 9);
      hit.Pixel = y * this->Width + x;
      hit.Isovalue = static_cast<std::int16_t>(engine() % 3);
      hit.Kind = std::array{ HitKind::Entry, HitKind::Exit, HitKind::Cap }[engine() % 3];
    }
    return layers;
  }

  /// The layers of each pixel in their order, each once.
  std::map<std::int32_t, std::vector<LayerHit>> InOrder(std::vector<LayerHit> layers) const
  {
    const auto isInFront = [this](const LayerHit& a, const LayerHit& b)
    { return IsInFront(this->SurfaceOf(a), this->SurfaceOf(b)); };
    std::map<std::int32_t, std::vector<LayerHit>> ordered;
    for (const LayerHit& hit : layers)
    {
      std::vector<LayerHit>& ofPixel = ordered[hit.Pixel];
      const auto at = std::find_if_not(ofPixel.begin(), ofPixel.end(),
        [&](const LayerHit& other) { return isInFront(other, hit); });
      if (at == ofPixel.end() || isInFront(hit, *at))
      {
        ofPixel.insert(at, hit);
      }
    }
    return ordered;
  }
};

TEST_F(LayerMerge, IsInTheOrderOfRaysAndOfRounds)
{
  for (unsigned int seed = 0; seed < 200; ++seed)
  {
    std::mt19937 engine(seed);
    std::vector<LayerHit> layers;
    const auto lists = 1 + engine() % 3;
    for (std::size_t list = 0; list < lists; ++list)
    {
      const std::vector<LayerHit> more = this->AnyLayers(engine, 300);
      layers.insert(layers.end(), more.begin(), more.end());
    }
    const auto expected = this->InOrder(layers);
    MergeLayers(this->Part, this->Width, this->Isovalues, layers);
    std::map<std::int32_t, std::size_t> count;
    std::tuple<std::size_t, std::int32_t> last(0, -1);
    for (const LayerHit& hit : layers)
    {
      const std::size_t round = count[hit.Pixel]++;
      ASSERT_LT(last, std::tuple(round, hit.Pixel)) << seed;
      last = { round, hit.Pixel };
      const std::vector<LayerHit>& ofPixel = expected.at(hit.Pixel);
      ASSERT_LT(round, ofPixel.size()) << seed;
      ASSERT_EQ(hit.Depth, ofPixel[round].Depth) << seed;
      ASSERT_EQ(hit.Kind, ofPixel[round].Kind) << seed;
      ASSERT_EQ(hit.Isovalue, ofPixel[round].Isovalue) << seed;
    }
    for (const auto& [pixel, ofPixel] : expected)
    {
      ASSERT_EQ(count[pixel], ofPixel.size()) << seed;
    }
  }
}

/// At one distance caps come first, the highest isovalue before the others; then entries, the
/// lowest first; then exits, the highest first.
TEST_F(LayerMerge, GoesByValueWhereSurfacesLieAtOneDistance)
{
  const std::int32_t pixel = 9 * this->Width + 25;
  std::vector<LayerHit> layers;
  for (const HitKind kind : { HitKind::Exit, HitKind::Entry, HitKind::Cap })
  {
    for (const std::int16_t isovalue : { 0, 1, 2 })
    {
      layers.push_back({ 2.0, pixel, isovalue, kind });
    }
  }
  MergeLayers(this->Part, this->Width, this->Isovalues, layers);
  std::vector<int> order;
  for (const LayerHit& hit : layers)
  {
    order.push_back(hit.Isovalue);
  }
  EXPECT_EQ(order, (std::vector{ 2, 0, 1, 1, 0, 2, 2, 0, 1 }));
  EXPECT_EQ(layers[0].Kind, HitKind::Cap);
  EXPECT_EQ(layers[3].Kind, HitKind::Entry);
  EXPECT_EQ(layers[6].Kind, HitKind::Exit);
}

TEST_F(LayerMerge, NothingIsNothing)
{
  std::vector<LayerHit> layers;
  MergeLayers(this->Part, this->Width, this->Isovalues, layers);
  EXPECT_TRUE(layers.empty());
}

}
