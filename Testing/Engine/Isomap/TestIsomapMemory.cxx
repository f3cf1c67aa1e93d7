// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Wherever memory ends while an isomap is built, the isomap counts what is left of it.

#include "Grid.h"
#include "Isomap/RangeBuild.h"
#include "Kinds/FieldKind.h"
#include "RefusedMemory.h"
#include "Render/FrameRenderer.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <new>
#include <string>

namespace
{

using namespace TemporalCoherence;

class IsomapMemory : public ::testing::Test
{
protected:
  IsomapMemory()
    : Before(vtkSMPTools::GetBackend())
    , Samples(glm::ivec3(20, 21, 22))
  {
    vtkSMPTools::SetBackend("Sequential"); // through which exceptions pass
    this->Samples.Fill([](int i, int j, int k)
      { return i % 4 == 1 && k % 4 == 2 ? std::nan("") : 10.0 * std::sin(0.3 * i) + j; });
    this->Key.Samples = this->Samples.Field;
    this->Key.View = LookAt(this->Samples.Field.Dimensions, { 1.0, 2.0, 0.7 }, { 93, 71 });
    this->Key.EditIsosurfaces().Isovalues = { 10.0 };
    this->Key.Appearance.Colors = { glm::dvec3(0.9, 0.6, 0.3) };
  }
  ~IsomapMemory() override { vtkSMPTools::SetBackend(this->Before.c_str()); }

  /// Call work() with ever more memory, and check the isomap after each, until it succeeds.
  /// \return how often it did not
  template <typename Prepare, typename Work, typename Check>
  int UntilMemorySuffices(const Prepare& prepare, const Work& work, const Check& check)
  {
    int thrown = 0;
    for (std::int64_t allowed = 0; thrown < 1000; allowed += 1 + allowed / 8)
    {
      SCOPED_TRACE(testing::Message() << allowed << " allocations");
      prepare();
      try
      {
        const RefusedMemory refused(allowed);
        work();
      }
      catch (const std::bad_alloc&)
      {
        check();
        ++thrown;
        continue;
      }
      check();
      return thrown;
    }
    return thrown;
  }

  static void ExpectCounted(const Isomap& map, std::size_t fixed)
  {
    std::size_t bands = 0;
    const std::size_t bytes = map.MemoryOf(
      [&bands](const GroupBand&)
      {
        ++bands;
        return true;
      });
    EXPECT_EQ(map.NumberOfBands(), bands);
    EXPECT_EQ(map.MemoryInBytes(), map.Size() > 0 ? bytes + map.MemoryOfBounds() + fixed : 0);
  }

  std::string Before;
  Grid<float> Samples;
  FrameKey Key;
};

TEST_F(IsomapMemory, OfARangeIsCounted)
{
  ValueRangePyramid pyramid;
  pyramid.Build(this->Key.Samples);
  Isomap map;
  std::int64_t cells = 0;
  bool isDropped = false;
  const auto add = [&](const ValueBand& band)
  {
    constexpr std::size_t plenty = std::size_t(1) << 30;
    BuildRange(
      { { this->Key, pyramid, MakeBandTracer }, band, plenty, 1 }, map, {}, isDropped, cells);
  };
  const int thrown = this->UntilMemorySuffices(
    [&]
    {
      map.Begin(this->Key, {});
      add({ 2.0, 3.0 });
    },
    [&] {
      add({ 10.0, 10.5 });
    },
    [&]
    {
      ExpectCounted(map, Isomap::FixedMemory(this->Key));
      EXPECT_EQ(map.NumberOfBands() % map.Size(), 0u) << "all groups or none";
    });
  EXPECT_GT(thrown, 10);
  EXPECT_EQ(map.NumberOfBands(), 2 * map.Size());
}

TEST_F(IsomapMemory, OfAFrameIsCounted)
{
  FrameRenderer renderer;
  FrameRenderer::Options options;
  options.Map.Tolerance = 0.1; // rays through cells without finite samples are traced in the end
  const int thrown = this->UntilMemorySuffices(
    [&]
    {
      renderer.Release();
      this->Key.EditIsosurfaces().Isovalues = { 10.0 };
      renderer.Render(this->Key, options);
      this->Key.EditIsosurfaces().Isovalues = { 10.1 };
    },
    [&]
    {
      renderer.Render(this->Key, options);
      // Where memory ends while bands are built, the frame is traced, and the isomap given up.
      if (renderer.IsomapOfLastView().NumberOfBands() == 0)
      {
        throw std::bad_alloc();
      }
    },
    [&] { ExpectCounted(renderer.IsomapOfLastView(), Isomap::FixedMemory(this->Key)); });
  EXPECT_GT(thrown, 3);
  EXPECT_GT(renderer.IsomapOfLastView().NumberOfBands(), 0u);
  EXPECT_GT(renderer.Statistics().TracedRays, 0);
}

}
