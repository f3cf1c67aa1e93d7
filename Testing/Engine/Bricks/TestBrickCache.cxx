// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Pictures of samples in bricks are those of samples in memory, to the last bit, by every route and
// with any room for bricks; what a thread uses is not dropped meanwhile.

#include "Acceleration/RangeScan.h"
#include "Bricks/BrickCache.h"
#include "Bricks/ImpatientWork.h"
#include "Grid.h"
#include "Lattice/Waves.h"
#include "Render/FrameRenderer.h"
#include "SameFrames.h"
#include "Scene/CellBlocks.h"
#include "Scene/Parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace
{

using namespace TemporalCoherence;

/// Reads bricks from a grid in memory.
template <typename T>
class GridReader : public BrickReader
{
public:
  explicit GridReader(const Field& field)
    : Samples(field)
  {
  }

  void Read(const glm::ivec3& first, const glm::ivec3& size, void* samples,
    const glm::i64vec2& strides) const override
  {
    for (int z = 0; z < size.z; ++z)
    {
      for (int y = 0; y < size.y; ++y)
      {
        std::memcpy(static_cast<T*>(samples) + y * strides.x + z * strides.y,
          this->Samples.At(first + glm::ivec3(0, y, z)),
          static_cast<std::size_t>(size.x) * sizeof(T));
      }
    }
  }

private:
  TypedField<T> Samples;
};

/// A field in bricks with the samples of a field in memory.
/// \param rooms for bricks
template <typename T>
Field InBricks(const Field& field, std::size_t rooms)
{
  const auto bricks = std::make_shared<const BrickCache>(
    field.Dimensions, sizeof(T), std::make_shared<const GridReader<T>>(field));
  bricks->SetLimit(rooms * sizeof(T) * BrickCache::Edge * BrickCache::Edge * BrickCache::Edge);
  const std::shared_ptr<std::byte> room(
    new std::byte[RangeScan::BytesFor(field.Type, field.Dimensions)],
    std::default_delete<std::byte[]>());
  RangeScan scan(field.Type, field.Dimensions, room);
  const glm::ivec3 nodes = CellBlocks::NodesFor(field.Dimensions);
  scan.Scan(field, { 0, 0 }, { nodes.y, nodes.z });
  Field made = field;
  made.Bricks = bricks;
  made.Samples = bricks.get();
  made.Strides = BrickCache::Strides();
  made.Known = std::make_shared<const KnownRanges>(scan.Finish());
  return made;
}

// Waves reach 1.3; their values fit into a byte.
constexpr double Scale = 80.0;

template <typename T>
double SampleAt(int i, int j, int k)
{
  const double value = Scale * Wave(i, j, k) + (std::is_unsigned_v<T> ? 128.0 : 0.0);
  return std::is_floating_point_v<T> && (i + 3 * j + 5 * k) % 211 == 0
    ? std::numeric_limits<double>::quiet_NaN()
    : value;
}

/// A viewer who changes something from frame to frame.
class Visitor
{
public:
  explicit Visitor(unsigned int seed)
    : Engine(seed)
  {
  }

  void Change(const glm::ivec3& dimensions, double middle, FrameKey& key)
  {
    Surfaces& surfaces = key.EditIsosurfaces();
    switch (this->Pick(7))
    {
      case 0:
      case 1:
        this->Turn += 0.05 * this->Pick(3);
        key.View = LookAt(dimensions, { std::cos(this->Turn), std::sin(this->Turn), 0.4 },
          { 90, 64 }, this->Pick(2) == 0);
        break;
      case 2:
      case 3:
        for (double& isovalue : surfaces.Isovalues)
        {
          isovalue += this->Pick(9) - 4;
        }
        break;
      case 4:
        surfaces.Opacities.assign(
          surfaces.Isovalues.size(), this->Pick(2) == 0 ? 1.0 : 0.3 + 0.1 * this->Pick(5));
        break;
      case 5:
        surfaces.Mode = this->Pick(2) == 0 ? SurfaceMode::Crossing : SurfaceMode::Threshold;
        key.Region.Clips.clear();
        if (this->Pick(2) == 0)
        {
          key.Region.Clips.push_back({ 1.0, 0.3, -0.2, -0.4 * dimensions.x });
        }
        break;
      default:
        surfaces.Isovalues = { middle + this->Pick(80) - 40.0 };
        if (this->Pick(3) == 0)
        {
          surfaces.Isovalues.push_back(middle + this->Pick(80) - 40.0);
        }
        surfaces.Opacities.clear();
        break;
    }
    key.Appearance.Colors.assign(
      surfaces.Isovalues.size(), { 1.0, 0.5 + 0.05 * this->Pick(10), 0.2 });
  }

  int Pick(unsigned int count) { return static_cast<int>(this->Engine() % count); }

private:
  std::mt19937 Engine;
  double Turn = 0.3;
};

template <typename T>
class BricksOf : public ::testing::Test
{
};

using Types = ::testing::Types<std::uint8_t, std::int16_t, std::int32_t, float, double>;

struct NamesOfTypes
{
  template <typename T>
  static std::string GetName(int)
  {
    return std::string(std::is_floating_point_v<T> ? "Float"
               : std::is_unsigned_v<T>             ? "UInt"
                                                   : "Int") +
      std::to_string(8 * sizeof(T));
  }
};

TYPED_TEST_SUITE(BricksOf, Types, NamesOfTypes);

TYPED_TEST(BricksOf, ShowTheSameByEveryRoute)
{
  using T = TypeParam;
  const glm::ivec3 dimensions(97, 70, 66);
  Grid<T> samples(dimensions);
  samples.Fill(SampleAt<T>);
  std::map<Route, int> routes;
  for (const std::size_t rooms : { std::size_t(1), std::size_t(7), std::size_t(1000) })
  {
    for (unsigned int walk = 0; walk < 2; ++walk)
    {
      FrameKey key;
      key.Samples = samples.Field;
      key.View = LookAt(dimensions, { 1.0, 2.0, 0.7 }, { 90, 64 });
      key.Appearance.Shade = true;
      key.Appearance.Lights = { Light() };
      const double middle = std::is_unsigned_v<T> ? 128.0 : 0.0;
      key.EditIsosurfaces().Isovalues = { middle + 20.0 };
      key.Appearance.Colors = { { 1.0, 0.5, 0.2 } };
      const Field inBricks = InBricks<T>(samples.Field, rooms);
      FrameRenderer::Options options;
      options.Map.Range = walk == 1 ? ValueBand{ middle - 60.0, middle + 60.0 } : options.Map.Range;
      FrameRenderer ofMemory, ofBricks;
      Visitor visitor(17 * walk + static_cast<unsigned int>(rooms));
      for (int frame = 0; frame < 40; ++frame)
      {
        ofMemory.Render(key, options);
        FrameKey other = key;
        other.Samples = inBricks;
        ofBricks.Render(other, options);
        const std::string step = "frame " + std::to_string(frame) + ", rooms " +
          std::to_string(rooms) + ", by " + NameOf(ofBricks.Statistics().Made);
        ASSERT_EQ(ofBricks.Statistics().Made, ofMemory.Statistics().Made) << step;
        ASSERT_TRUE(ShowTheSame(ofBricks.LastFrame(), ofMemory.LastFrame())) << step;
        ASSERT_TRUE(HaveTheSameLayers(ofBricks.LastFrame(), ofMemory.LastFrame())) << step;
        ++routes[ofBricks.Statistics().Made];
        visitor.Change(dimensions, middle, key);
      }
      EXPECT_GT(inBricks.Bricks->NumberOfReads(), 0);
    }
  }
  for (const Route route : { Route::Cold, Route::IsomapLookup, Route::IsomapBuild, Route::Reshade })
  {
    EXPECT_GT(routes[route], 0) << NameOf(route);
  }
}

TYPED_TEST(BricksOf, ShowTheSameVolume)
{
  using T = TypeParam;
  const glm::ivec3 dimensions(70, 66, 40);
  Grid<T> samples(dimensions);
  samples.Fill(SampleAt<T>);
  const double middle = std::is_unsigned_v<T> ? 128.0 : 0.0;
  FrameKey key;
  key.View = LookAt(dimensions, { 1.0, 2.0, 0.7 }, { 60, 44 });
  for (const BlendMode mode :
    { BlendMode::Maximum, BlendMode::Minimum, BlendMode::Average, BlendMode::Composite })
  {
    Blending blending;
    blending.Mode = mode;
    blending.AverageRange = { middle - 50.0, middle + 50.0 };
    blending.Looks.resize(1);
    blending.Looks[0].Transfer.Range = { middle - 60.0, middle + 60.0 };
    blending.Looks[0].Transfer.Nodes = { glm::dvec4(0.0), glm::dvec4(1.0, 0.5, 0.2, 0.8) };
    blending.ScalarRanges = { { middle - 140.0, middle + 140.0 } };
    key.Shown = blending;
    key.Samples = samples.Field;
    FrameRenderer ofMemory, ofBricks;
    ofMemory.Render(key, {});
    key.Samples = InBricks<T>(samples.Field, 5);
    ofBricks.Render(key, {});
    ASSERT_TRUE(ShowTheSame(ofBricks.LastFrame(), ofMemory.LastFrame())) << static_cast<int>(mode);
  }
}

TEST(BrickCacheTest, KeepsWhatThreadsUse)
{
  // Threads hold addresses while others read bricks and drop them: no sample changes meanwhile.
  const glm::ivec3 dimensions(300, 200, 100);
  Grid<std::uint32_t> samples(dimensions);
  samples.Fill([&](int i, int j, int k) { return i + dimensions.x * (j + dimensions.y * k); });
  const Field field = InBricks<std::uint32_t>(samples.Field, 4);
  std::atomic<int> wrong{ 0 };
  std::vector<std::thread> threads;
  for (unsigned int number = 0; number < 4; ++number)
  {
    threads.emplace_back(
      [&, number]()
      {
        std::mt19937 engine(number);
        const TypedField<std::uint32_t> typed(field);
        for (int use = 0; use < 3000; ++use)
        {
          const SampleUse here;
          std::vector<std::pair<const std::uint32_t*, std::uint32_t>> held;
          for (int i = 0; i < 5; ++i)
          {
            const glm::ivec3 at(engine() % 300u, engine() % 200u, engine() % 100u);
            held.emplace_back(typed.At(at),
              static_cast<std::uint32_t>(at.x + dimensions.x * (at.y + dimensions.y * at.z)));
          }
          for (const auto& each : held)
          {
            wrong += *each.first != each.second;
          }
        }
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
  EXPECT_EQ(wrong, 0);
  // Each of the four threads may hold five bricks.
  EXPECT_LE(field.Bricks->MemoryInBytes(), 24u * sizeof(std::uint32_t) * 35 * 35 * 35 + 10000u);
}

TEST(BrickCacheTest, KeepsWhatWasUsedLast)
{
  Grid<std::uint8_t> samples({ 320, 32, 32 });
  samples.FillRandomly(0.0, 255.0, 1);
  const Field field = InBricks<std::uint8_t>(samples.Field, 5);
  const TypedField<std::uint8_t> typed(field);
  const auto look = [&](int brick)
  {
    const SampleUse use;
    return *typed.At(32 * brick, 0, 0);
  };
  for (int i = 0; i < 5; ++i)
  {
    look(i);
  }
  look(0);
  look(5); // takes the place of brick 1
  EXPECT_EQ(field.Bricks->NumberOfReads(), 6);
  look(0);
  EXPECT_EQ(field.Bricks->NumberOfReads(), 6);
  look(1);
  EXPECT_EQ(field.Bricks->NumberOfReads(), 7);
}

TEST(BrickCacheTest, GivesUpAtATime)
{
  Grid<std::uint8_t> samples({ 100, 32, 32 });
  samples.Fill([](int, int, int) { return 7; });
  const Field field = InBricks<std::uint8_t>(samples.Field, 5);
  const TypedField<std::uint8_t> typed(field);
  const SampleUse use;
  EXPECT_EQ(*typed.At(0, 0, 0), 7);
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  field.Bricks->GiveUpAt(std::chrono::duration_cast<std::chrono::nanoseconds>(now).count());
  EXPECT_EQ(*typed.At(0, 0, 0), 7) << "what is there is given";
  EXPECT_FALSE(SampleUse::HasMissed());
  {
    const ImpatientWork here;
    EXPECT_EQ(*typed.At(64, 0, 0), 0);
  }
  EXPECT_TRUE(SampleUse::HasMissed());
  EXPECT_EQ(*typed.At(32, 0, 0), 7) << "other work waits";
  SampleUse::Renew();
  EXPECT_FALSE(SampleUse::HasMissed());
  field.Bricks->GiveUpAt(BrickCache::Patient);
  EXPECT_EQ(*typed.At(64, 0, 0), 7);
}

TEST(BrickCacheTest, ReadsAheadWithoutDroppingTheLastFrame)
{
  Grid<std::uint8_t> samples({ 320, 32, 32 });
  samples.FillRandomly(0.0, 255.0, 1);
  const Field field = InBricks<std::uint8_t>(samples.Field, 3);
  const TypedField<std::uint8_t> typed(field);
  field.Bricks->BeginFrame();
  for (int brick = 0; brick < 2; ++brick)
  {
    const SampleUse use;
    typed.At(32 * brick, 0, 0);
  }
  EXPECT_EQ(field.Bricks->TakeAwaited(), (std::vector<std::int64_t>{ 0, 1 }));
  EXPECT_TRUE(field.Bricks->ReadAhead(2));
  EXPECT_TRUE(field.Bricks->Has(2));
  EXPECT_TRUE(field.Bricks->ReadAhead(3)) << "what was only read ahead may go";
  EXPECT_FALSE(field.Bricks->Has(2));
  {
    const SampleUse use;
    typed.At(96, 0, 0);
  }
  EXPECT_FALSE(field.Bricks->ReadAhead(4)) << "all bricks are of the last frame";
  EXPECT_TRUE(field.Bricks->TakeAwaited().empty());
  EXPECT_EQ(field.Bricks->Around(1), (std::vector<std::int64_t>{ 0, 1, 2 }));
}

}
