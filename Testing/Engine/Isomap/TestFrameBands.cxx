// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// While an isomap is built, no frame of a drag costs more than 1.4 cold ones, whatever building
// costs, and a drag gets cheaper where it can. Costs are numbers of cells, which the tests name.
// Memory stays within its limits.

#include "Checks/Sanitized.h"
#include "Grid.h"
#include "Isomap/FrameBands.h"
#include "Isomap/IsomapBuilder.h"
#include "Kinds/FieldKind.h"
#include "Scene/Parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using namespace TemporalCoherence;

/// What a group of tiles costs; a cold one costs 1000.
struct Prices
{
  std::int64_t Trace = 1000, LookUp = 300, Build = 2000;
};

/// What a frame did.
struct Made
{
  double Cost = 0.0; ///< of a cold frame
  std::vector<GroupWork> Work;

  std::ptrdiff_t CountOf(GroupWork work) const
  {
    return std::count(this->Work.begin(), this->Work.end(), work);
  }
};

/// Drags an isovalue through a field in a picture of many tiles.
class FrameBandsTest : public ::testing::Test
{
protected:
  FrameBandsTest()
    : Field(glm::ivec3(14, 15, 16))
  {
    this->Field.Fill(
      [](int i, int j, int k) { return 100.0 + 60.0 * std::sin(0.4 * i + 0.3 * j) + 3.0 * k; });
    this->Key.Samples = this->Field.Field;
    this->Key.View = LookAt(this->Field.Field.Dimensions, { 1.0, 2.0, 0.7 }, Size);
    this->Key.EditIsosurfaces().Isovalues = { this->At(0.2) };
    this->Pyramid.Build(this->Key.Samples);
  }

  static constexpr glm::ivec2 Size{ IsMemorySanitized ? 256 : 512, IsMemorySanitized ? 192 : 384 };

  /// The isovalue at a share of the range.
  double At(double share) const { return 45.0 + 160.0 * share; }

  BandSource Source() const { return { this->Key, this->Pyramid, MakeBandTracer }; }

  /// Make the frame of the next isovalues.
  Made Show(const std::vector<double>& isovalues)
  {
    const std::vector<double> before = this->Key.Isosurfaces().Isovalues;
    this->Key.EditIsosurfaces().Isovalues = isovalues;
    const BandSource source = this->Source();
    EXPECT_EQ(this->Builder.Prepare(source, this->Options, {}), Isomap::Outcome::Built);
    FrameBands bands(
      { source, this->Options, before }, this->Builder.ToBuild(), this->Builder.Drag());
    bands.MakeBuilders();
    const std::size_t groups = this->Builder.Built().Size();
    Made made;
    made.Work.resize(groups);
    ParallelFor(static_cast<std::int64_t>(groups), 1,
      [&](std::int64_t i)
      {
        const auto group = static_cast<std::size_t>(i);
        TraceCounts counts;
        const GroupWork work = bands.Prepare(group, counts);
        made.Work[group] = work;
        bands.Done(group, this->PriceOf(work));
      });
    for (const GroupWork work : made.Work)
    {
      made.Cost += static_cast<double>(this->PriceOf(work));
    }
    made.Cost /= static_cast<double>(this->Price.Trace) * static_cast<double>(groups);
    if (!this->IsStopped)
    {
      bands.Finish();
    }
    return made;
  }

  std::int64_t PriceOf(GroupWork work) const
  {
    return work == GroupWork::Trace ? this->Price.Trace
      : work == GroupWork::LookUp   ? this->Price.LookUp
                                    : this->Price.Build;
  }

  Grid<float> Field;
  FrameKey Key;
  ValueRangePyramid Pyramid;
  Isomap::Options Options;
  IsomapBuilder Builder;
  Prices Price;
  bool IsStopped = false;
};

TEST_F(FrameBandsTest, NoFrameCostsMuchMoreThanACold)
{
  for (const std::int64_t build : { 1100, 2000, 4000, 20000 })
  {
    for (const std::int64_t lookUp : { 100, 500, 1000 })
    {
      for (const double step : { 0.002, 0.01, 0.045, 0.3 })
      {
        SCOPED_TRACE(
          testing::Message() << "build " << build << " look-up " << lookUp << " step " << step);
        this->Price = { 1000, lookUp, build };
        this->Builder = IsomapBuilder();
        this->Key.EditIsosurfaces().Isovalues = { this->At(0.1) };
        for (int i = 1; i <= 40; ++i)
        {
          const double share = std::fmod(0.1 + step * i, 1.6);
          const Made made = this->Show({ this->At(std::min(share, 1.6 - share)) });
          ASSERT_LE(made.Cost, 1.4) << "frame " << i;
        }
      }
    }
  }
}

TEST_F(FrameBandsTest, ADragGetsCheaper)
{
  double cost = 0.0;
  Made made;
  for (int i = 1; i <= 60; ++i)
  {
    made = this->Show({ this->At(0.2 + 0.005 * i) });
    cost += made.Cost / 60.0;
    EXPECT_TRUE(i > 1 || made.CountOf(GroupWork::Build) > 0) << "the first one builds";
  }
  EXPECT_LE(cost, 0.6);
  // The small picture of a build with a sanitizer has less memory, which old bands fill by the end
  // of the drag. Groups whose bands are larger than their share of the rest are traced then.
  const std::ptrdiff_t few =
    IsMemorySanitized ? static_cast<std::ptrdiff_t>(made.Work.size()) / 8 : 0;
  EXPECT_LE(made.CountOf(GroupWork::Trace), few);
  // Back on the same way, most is known still.
  made = this->Show({ this->At(0.49) });
  EXPECT_LE(made.CountOf(GroupWork::Trace), few);
}

TEST_F(FrameBandsTest, BandsDoNotAllEndAtTheSameIsovalue)
{
  std::ptrdiff_t most = 0;
  for (int i = 1; i <= 80; ++i)
  {
    const Made made = this->Show({ this->At(0.1 + 0.005 * i) });
    most = i > 30 ? std::max(most, made.CountOf(GroupWork::Build)) : 0;
  }
  EXPECT_LT(most, static_cast<std::ptrdiff_t>(this->Builder.Built().Size()) / 2);
}

TEST_F(FrameBandsTest, WhatNeverPaysIsHardlyTried)
{
  for (const Prices& price : { Prices{ 1000, 300, 30000 }, Prices{ 1000, 1000, 1500 } })
  {
    this->Price = price;
    this->Builder = IsomapBuilder();
    this->Key.EditIsosurfaces().Isovalues = { this->At(0.1) };
    double cost = 0.0;
    for (int i = 1; i <= 60; ++i)
    {
      cost += this->Show({ this->At(0.1 + 0.01 * i) }).Cost / 60.0;
    }
    EXPECT_LT(cost, 1.08);
    // When it pays again, that is noticed.
    this->Price = { 1000, 300, 1500 };
    Made made;
    for (int i = 1; i <= 120; ++i)
    {
      made = this->Show({ this->At(0.7 - 0.005 * i) });
    }
    EXPECT_GT(made.CountOf(GroupWork::LookUp), 0);
  }
}

TEST_F(FrameBandsTest, NothingIsBuiltForAJump)
{
  const Made made = this->Show({ this->At(0.8) });
  EXPECT_EQ(made.CountOf(GroupWork::Trace), static_cast<std::ptrdiff_t>(made.Work.size()));
}

TEST_F(FrameBandsTest, OfSeveralIsovaluesOneMoves)
{
  this->Key.EditIsosurfaces().Isovalues = { this->At(0.2), this->At(0.7) };
  Made made;
  for (int i = 1; i <= 40; ++i)
  {
    made = this->Show({ this->At(0.2 + 0.003 * i), this->At(0.7) });
  }
  EXPECT_EQ(made.CountOf(GroupWork::Trace), 0);
}

TEST_F(FrameBandsTest, MemoryStaysWithinItsLimits)
{
  constexpr std::size_t pixels = std::size_t(Size.x) * Size.y;
  this->Price.Build = 1100; // so that short bands pay, too
  for (const std::size_t limit : { std::size_t(1) << 30, std::size_t(1) << 20, 40 * pixels })
  {
    this->Builder = IsomapBuilder();
    this->Options.MemoryLimit = limit;
    this->Key.EditIsosurfaces().Isovalues = { this->At(0.1) };
    std::size_t most = 0;
    for (int i = 1; i <= 150; ++i)
    {
      this->Show({ this->At(0.5 + 0.4 * std::sin(0.1 * i)) });
      most = std::max(most, this->Builder.Built().MemoryInBytes());
    }
    const std::size_t fixed = Isomap::FixedMemory(this->Key);
    EXPECT_LE(most, std::min(limit, 32 * pixels + fixed));
    EXPECT_GT(most, std::min(limit, 32 * pixels) / 2) << "what there is is used";
    EXPECT_EQ(this->Builder.HasDropped(), limit < 32 * pixels) << "only the user's limit is news";
  }
}

/// Bounds of tiles that are kept for the next bands count as memory, and go with the isomap.
TEST_F(FrameBandsTest, BoundsAreCountedAndReleased)
{
  const auto drag = [&](std::size_t isovalues)
  {
    for (int i = 1; i <= 5; ++i)
    {
      const double moved = this->At(0.2 + 0.003 * i);
      this->Show(isovalues == 1 ? std::vector<double>{ moved } : std::vector{ moved, moved + 9.0 });
    }
    const Isomap& map = this->Builder.Built();
    const std::size_t all = map.MemoryOf([](const GroupBand&) { return true; });
    EXPECT_GT(map.MemoryOfBounds(), 0u);
    EXPECT_LE(map.MemoryOfBounds(), isovalues * TileBounds::MemoryFor(this->Key.View.Size))
      << "no scratch is kept";
    EXPECT_EQ(map.MemoryInBytes(), Isomap::FixedMemory(this->Key) + all + map.MemoryOfBounds());
  };
  drag(2);
  drag(1);

  // They go before any band does.
  const Isomap& map = this->Builder.Built();
  const std::size_t bands = map.NumberOfBands();
  this->Builder.Trim(map.MemoryInBytes() - 1);
  EXPECT_EQ(map.MemoryOfBounds(), 0u);
  EXPECT_EQ(map.NumberOfBands(), bands);
  EXPECT_FALSE(this->Builder.HasDropped());

  // Nothing stays where the isomap is switched off, or the data changes.
  drag(1);
  this->Builder.Trim(0);
  EXPECT_EQ(map.MemoryOfBounds(), 0u);
  EXPECT_EQ(map.MemoryInBytes(), 0u);
  drag(1);
  this->Builder.Release();
  EXPECT_EQ(map.MemoryOfBounds(), 0u);
}

/// A range that was asked for takes no memory from a drag when nobody asks for it any more.
TEST_F(FrameBandsTest, WhatIsNoLongerAskedForMakesRoom)
{
  const ValueBand nothing{ 1.0, 0.0 };
  for (const bool isAhead : { false, true })
  {
    SCOPED_TRACE(isAhead ? "asked for by BuildAhead" : "asked for by a range");
    this->Builder = IsomapBuilder();
    this->Options = Isomap::Options();
    this->Options.Range = { this->At(0.6), this->At(0.9) };
    this->Key.EditIsosurfaces().Isovalues = { this->At(0.7) };
    const auto prepare = [&]
    {
      return isAhead ? this->Builder.BuildAhead(this->Source(), this->Options, {})
                     : this->Builder.Prepare(this->Source(), this->Options, {});
    };
    ASSERT_EQ(prepare(), Isomap::Outcome::Built);
    ASSERT_TRUE(this->Builder.Built().Holds(this->Options.Range));
    this->Options.MemoryLimit = this->Builder.Built().MemoryInBytes();

    // As long as it is asked for, it stays.
    this->Key.EditIsosurfaces().Isovalues = { this->At(0.1) };
    for (int i = 1; i <= 10; ++i)
    {
      this->Show({ this->At(0.1 + 0.005 * i) });
    }
    EXPECT_TRUE(this->Builder.Built().Holds(this->Options.Range));

    // A part of it is asked for still, then nothing.
    const ValueBand part{ this->At(0.65), this->At(0.7) };
    for (const ValueBand& range : { part, nothing })
    {
      this->Options.Range = range;
      Made made;
      for (int i = 1; i <= 40; ++i)
      {
        made = this->Show({ this->At(0.15 + 0.005 * i) });
      }
      EXPECT_EQ(this->Builder.Built().Holds(part), range.Low == part.Low);
      EXPECT_EQ(made.CountOf(GroupWork::LookUp) > 0, range.Low != part.Low);
    }
  }
}

/// A drag builds the same bands again, whatever the threads do.
TEST_F(FrameBandsTest, TheChoiceDoesNotDependOnThreads)
{
  for (const double tolerance : { 0.0, 0.2 })
  {
    this->Options.Tolerance = tolerance;
    std::vector<std::vector<GroupWork>> works[2];
    for (std::vector<std::vector<GroupWork>>& ofTurn : works)
    {
      this->Builder = IsomapBuilder();
      this->Key.EditIsosurfaces().Isovalues = { this->At(0.2) };
      for (int i = 1; i <= 30; ++i)
      {
        ofTurn.push_back(this->Show({ this->At(0.2 + 0.003 * i) }).Work);
      }
    }
    EXPECT_EQ(works[0], works[1]);
    const std::vector<GroupWork>& last = works[0].back();
    EXPECT_EQ(std::count(last.begin(), last.end(), GroupWork::Trace), 0);
    for (const std::vector<GroupWork>& work : works[0])
    {
      EXPECT_LE(std::count(work.begin(), work.end(), GroupWork::Build),
        static_cast<std::ptrdiff_t>(work.size()) / 11);
    }
  }
}

TEST_F(FrameBandsTest, AStoppedFrameLeavesNothing)
{
  this->IsStopped = true;
  this->Show({ this->At(0.21) });
  EXPECT_EQ(this->Builder.Built().MemoryInBytes(), 0u);
  this->IsStopped = false;
  this->Show({ this->At(0.21) });
  const std::size_t bytes = this->Builder.Built().MemoryInBytes();
  EXPECT_GT(bytes, 0u);
  this->IsStopped = true;
  this->Show({ this->At(0.22) });
  EXPECT_EQ(this->Builder.Built().MemoryInBytes(), bytes);
}

}
