// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameRenderer.h"
#include "Grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace
{

using namespace TemporalCoherence;

template <typename T>
bool AreIdentical(const T& a, const T& b)
{
  return a.size() == b.size() && !std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0]));
}

void ExpectColdPlanes(const Frame& made, const Frame& cold)
{
  EXPECT_TRUE(AreIdentical(made.Depth, cold.Depth));
  EXPECT_TRUE(AreIdentical(made.Disparities, cold.Disparities));
  EXPECT_TRUE(AreIdentical(made.Normals, cold.Normals));
  EXPECT_TRUE(AreIdentical(made.Isovalues, cold.Isovalues));
  EXPECT_TRUE(AreIdentical(made.Colors, cold.Colors));
  // A contact may be told too near, never too far: a cell counts although only its corner is equal
  // to the isovalue.
  std::size_t farther = 0, otherwise = 0;
  for (std::size_t i = 0; i < cold.Contacts.size(); ++i)
  {
    const bool isOfAMiss = cold.Kinds[i] == HitKind::None && made.Kinds[i] == HitKind::Within;
    farther += made.Contacts[i] < cold.Contacts[i];
    otherwise += made.Kinds[i] != cold.Kinds[i] && !isOfAMiss;
  }
  EXPECT_EQ(farther, 0u);
  EXPECT_EQ(otherwise, 0u);
}

/// A view whose isovalues change, beside cold frames of the same.
class IsomapTest : public ::testing::Test
{
protected:
  template <typename T>
  static FrameKey KeyOf(const Grid<T>& grid, bool parallel = false)
  {
    FrameKey key;
    key.Samples = grid.Seen;
    key.Seen = LookAt(grid.Seen.Dimensions, { 1.0, 2.0, 0.7 }, { 93, 71 }, parallel);
    key.Look.Shade = true;
    key.Look.Lights = { Light() };
    return key;
  }

  void Show(FrameKey& key, const std::vector<double>& isovalues)
  {
    key.Sought.Isovalues = isovalues;
    key.Look.Colors.assign(isovalues.size(), glm::dvec3(0.9, 0.6, 0.3));
    ASSERT_TRUE(this->Renderer.Render(key, this->Options));
    FrameRenderer cold;
    cold.Render(key, {});
    ASSERT_EQ(cold.Statistics().Made, Route::Cold);
    SCOPED_TRACE(testing::Message()
      << "isovalue " << isovalues[0] << " route " << NameOf(this->Renderer.Statistics().Made));
    ExpectColdPlanes(this->Renderer.LastFrame(), cold.LastFrame());
  }

  /// Isovalues up and down and far away.
  void Sweep(FrameKey& key, double low, double high)
  {
    const double range = high - low;
    for (const double share : { 0.5, 0.51, 0.52, 0.6, 0.55, 0.49, 0.4, 0.1, 0.11, 0.9, 0.95, 0.0, 1.0,
           -0.1, 1.1, 0.5, 0.3, 0.31 })
    {
      this->Show(key, { low + share * range });
    }
  }

  FrameRenderer Renderer;
  FrameRenderer::Options Options;
};

double Waves(int i, int j, int k)
{
  return 120.0 + 100.0 * std::sin(0.2 * i) * std::cos(0.25 * j) * std::sin(0.3 * k);
}

TEST_F(IsomapTest, IsTheColdPictureForAnyIsovalue)
{
  Grid<std::uint8_t> bytes(glm::ivec3(60, 50, 40));
  bytes.Fill(Waves);
  Grid<float> floats(glm::ivec3(30, 50, 40));
  floats.Fill(Waves);
  Grid<double> noise(glm::ivec3(20, 21, 22));
  noise.FillRandomly(20.0, 220.0, 3);
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    for (const Interpolation between : { Interpolation::Linear, Interpolation::Nearest })
    {
      for (FrameKey key : { KeyOf(bytes), KeyOf(floats, true), KeyOf(noise) })
      {
        SCOPED_TRACE(testing::Message() << "type " << static_cast<int>(key.Samples.Type) << " mode "
                                        << static_cast<int>(mode) << " between "
                                        << static_cast<int>(between));
        key.Sought.Mode = mode;
        key.Samples.Between = between;
        this->Sweep(key, 20.0, 220.0);
      }
    }
  }
}

TEST_F(IsomapTest, SeveralIsovalues)
{
  Grid<std::uint8_t> bytes(glm::ivec3(60, 50, 40));
  bytes.Fill(Waves);
  for (const SurfaceMode mode : { SurfaceMode::Crossing, SurfaceMode::Threshold })
  {
    FrameKey key = KeyOf(bytes);
    key.Sought.Mode = mode;
    this->Show(key, { 150.0, 90.0 });
    this->Show(key, { 149.0, 90.0 });
    this->Show(key, { 148.0, 91.0, 200.0 });
    this->Show(key, { 148.0 });
  }
}

}
