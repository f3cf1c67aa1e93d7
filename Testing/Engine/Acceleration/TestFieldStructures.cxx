// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Renderers of the same data share value ranges and active cells, and do not disturb one another.
// What none of them holds is freed.

#include "Acceleration/FieldStructures.h"
#include "Grid.h"
#include "Render/FrameRenderer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace
{

using namespace TemporalCoherence;

class FieldStructuresTest : public ::testing::Test
{
protected:
  FieldStructuresTest()
    : Samples(glm::ivec3(40, 30, 50))
  {
    this->Samples.Fill([](int i, int j, int k)
      { return 120.0 + 100.0 * std::sin(0.3 * i) * std::cos(0.2 * j + k); });
  }

  FrameKey KeyFrom(const glm::dvec3& direction, double isovalue) const
  {
    FrameKey key;
    key.Samples = this->Samples.Field;
    key.View = LookAt(this->Samples.Field.Dimensions, direction, { 90, 70 });
    key.EditIsosurfaces().Isovalues = { isovalue };
    key.Appearance.Colors = { { 1.0, 0.5, 0.2 } };
    return key;
  }

  Grid<std::uint8_t> Samples;
  FieldStructures Shared;
};

TEST_F(FieldStructuresTest, WhoAsksForTheSameGetsTheSame)
{
  std::shared_ptr<const FieldRanges> one, two;
  this->Shared.Provide(this->Samples.Field, one);
  this->Shared.Provide(this->Samples.Field, two);
  EXPECT_FALSE(one->Pyramid->IsEmpty());
  EXPECT_EQ(one, two);

  Surfaces low, high;
  low.Isovalues = { 100.0 };
  high.Isovalues = { 150.0 };
  std::shared_ptr<const SurfaceCells> cells, same, others;
  this->Shared.Provide(*one, low, cells);
  this->Shared.Provide(*one, low, same);
  this->Shared.Provide(*one, high, others);
  EXPECT_EQ(cells, same);
  EXPECT_NE(cells, others);
  EXPECT_GT(cells->Active->MemoryInBytes(), 0u);

  // Who holds the old keeps the old.
  Field later = this->Samples.Field;
  ++later.Stamp;
  this->Shared.Provide(later, two);
  EXPECT_NE(one, two);
  EXPECT_TRUE(one->Samples == this->Samples.Field);
  EXPECT_TRUE(two->Samples == later);
}

TEST_F(FieldStructuresTest, NothingIsKeptThatNobodyHolds)
{
  std::shared_ptr<const FieldRanges> held;
  this->Shared.Provide(this->Samples.Field, held);
  const std::weak_ptr<const FieldRanges> before = held;
  Field later = this->Samples.Field;
  ++later.Stamp;
  this->Shared.Provide(later, held);
  EXPECT_TRUE(before.expired());
}

TEST_F(FieldStructuresTest, RenderersThatShareDoNotDisturbOneAnother)
{
  const SharedByViewers shared;
  FrameRenderer left(shared), right(shared);
  const auto expectCold = [](const FrameRenderer& renderer)
  {
    FrameRenderer cold;
    cold.Render(renderer.LastKey(), {});
    const auto &a = renderer.LastFrame().Depth, &b = cold.LastFrame().Depth;
    ASSERT_EQ(a.size(), b.size());
    EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])), 0);
  };
  for (int step = 0; step < 4; ++step)
  {
    // The same data throughout; in the last step other samples, of which the left is told first.
    if (step == 3)
    {
      this->Samples.Fill([](int i, int j, int k) { return 3.0 * i + 2.0 * j + k; });
      ++this->Samples.Field.Stamp;
    }
    left.Render(this->KeyFrom({ 1.0, 0.2, 0.3 }, 100.0 + 10.0 * (step / 2)), {});
    expectCold(left);
    right.Render(this->KeyFrom({ 0.1, 1.0, 0.3 }, 130.0 - 10.0 * (step % 2)), {});
    expectCold(right);
    EXPECT_EQ(right.Statistics().Made == Route::Cold, step == 0 || step == 3) << step;
    if (step == 1)
    {
      left.Release();
      EXPECT_TRUE(left.LastFrame().IsEmpty());
    }
  }
}

}
