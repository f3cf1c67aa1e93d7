// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Every change of samples, of one or of many at once, changes a fingerprint. Where the samples lie
// in memory does not.

#include "Acceleration/FieldFingerprint.h"
#include "Grid.h"
#include "Scene/FrameKey.h"

#include <gtest/gtest.h>

#include <set>

namespace
{

using namespace TemporalCoherence;

/// Not whole nodes along any axis, and one cell in the last one along y.
const glm::ivec3 Dimensions(35, 18, 40);

/// Places along an axis: at both ends, and around the first samples of nodes.
std::set<int> PlacesAlong(int samples)
{
  std::set<int> places;
  for (const int place : { 0, 1, 14, 15, 16, 17, 31, 32, 33, samples - 2, samples - 1 })
  {
    if (place < samples)
    {
      places.insert(place);
    }
  }
  return places;
}

bool Holds(const CellBox& box, const glm::ivec3& low, const glm::ivec3& high)
{
  return glm::all(glm::lessThanEqual(box.First, low)) &&
    glm::all(glm::greaterThanEqual(box.First + box.Size, high));
}

/// Flip a bit of every sample at the places, one after the other: each is seen in one
/// node, whose box holds all cells in which its value or gradient counts.
template <typename T>
void ExpectEverySampleCounts(int components, int component)
{
  Grid<T> grid(Dimensions, components, component);
  std::mt19937 engine(3);
  for (T& sample : grid.Samples)
  {
    sample = static_cast<T>(engine() % 200 / 2);
  }
  const FieldFingerprint before = FingerprintOf(grid.Field);
  for (const int k : PlacesAlong(Dimensions.z))
  {
    for (const int j : PlacesAlong(Dimensions.y))
    {
      for (const int i : PlacesAlong(Dimensions.x))
      {
        auto* const bytes = reinterpret_cast<unsigned char*>(&grid.At(i, j, k));
        const auto byte = static_cast<std::size_t>(engine() % sizeof(T));
        const auto bit = static_cast<unsigned char>(1u << engine() % 8);
        bytes[byte] = static_cast<unsigned char>(bytes[byte] ^ bit);
        const std::vector<CellBox> boxes = ChangedCells(before, FingerprintOf(grid.Field));
        bytes[byte] = static_cast<unsigned char>(bytes[byte] ^ bit);
        const glm::ivec3 place(i, j, k);
        ASSERT_EQ(boxes.size(), 1u);
        const glm::ivec3 low = glm::max(place - 2, 0);
        const glm::ivec3 high = glm::min(place + 2, Dimensions - 1);
        for (const CellBox& box : boxes)
        {
          ASSERT_TRUE(Holds(box, low, high)) << i << ' ' << j << ' ' << k;
          ASSERT_TRUE(Holds({ glm::ivec3(0), Dimensions - 1 }, box.First, box.First + box.Size));
        }
      }
    }
  }
  EXPECT_TRUE(ChangedCells(before, FingerprintOf(grid.Field)).empty());
}

template <typename T>
class FieldFingerprintOf : public ::testing::Test
{
};
using Types = ::testing::Types<std::int8_t, std::uint8_t, std::int16_t, std::uint16_t, std::int32_t,
  std::uint32_t, std::int64_t, std::uint64_t, float, double>;
TYPED_TEST_SUITE(FieldFingerprintOf, Types);

TYPED_TEST(FieldFingerprintOf, EverySampleCounts)
{
  ExpectEverySampleCounts<TypeParam>(1, 0);
}

TYPED_TEST(FieldFingerprintOf, EverySampleOfAComponentCounts)
{
  ExpectEverySampleCounts<TypeParam>(3, 1);
}

TEST(FieldFingerprint, IsThatOfTheSamplesWhereverTheyLie)
{
  Grid<float> packed(Dimensions), interleaved(Dimensions, 2, 1);
  packed.FillRandomly(-1.0, 1.0, 4);
  interleaved.Fill([&](int i, int j, int k) { return packed.At(i, j, k); });
  EXPECT_TRUE(ChangedCells(FingerprintOf(packed.Field), FingerprintOf(interleaved.Field)).empty());
  for (std::size_t i = 0; i < interleaved.Samples.size(); i += 2)
  {
    interleaved.Samples[i] = 5.0f;
  }
  EXPECT_TRUE(ChangedCells(FingerprintOf(packed.Field), FingerprintOf(interleaved.Field)).empty())
    << "another component";
}

/// Changes of many samples at the same time, of the kind that weak hashes lose.
TEST(FieldFingerprint, ChangesDoNotCancelOut)
{
  Grid<float> grid(glm::ivec3(17));
  grid.Fill([](int i, int j, int k) { return (i + j + k) % 2 ? 1.0 : -1.0; });
  std::vector<float>& samples = grid.Samples;
  std::set<std::uint64_t> hashes = { FingerprintOf(grid.Field).Nodes.at(0) };
  // The signs of two to five of six neighbours, everywhere; and two samples swapped.
  std::size_t made = 1;
  for (std::size_t at = 0; at + 6 <= samples.size(); at += 7)
  {
    const std::vector<float> kept = samples;
    for (unsigned which = 1; which < 64; ++which)
    {
      for (std::size_t i = 0; i < 6; ++i)
      {
        samples[at + i] = which >> i & 1u ? -kept[at + i] : kept[at + i];
      }
      hashes.insert(FingerprintOf(grid.Field).Nodes.at(0));
      ++made;
    }
    samples = kept;
    if (at >= 700)
    {
      break;
    }
  }
  EXPECT_EQ(hashes.size(), made);
  for (float& sample : samples)
  {
    sample = -sample;
  }
  EXPECT_EQ(hashes.count(FingerprintOf(grid.Field).Nodes.at(0)), 0u) << "all signs";
}

TEST(FieldFingerprint, OnlyFieldsThatAreAlikeAreCompared)
{
  Grid<float> grid(Dimensions);
  Field other = grid.Field;
  other.Stamp = 7;
  other.Strides *= 2;
  EXPECT_TRUE(AreAlike(grid.Field, other));
  other = grid.Field;
  other.Between = Interpolation::Nearest;
  EXPECT_FALSE(AreAlike(grid.Field, other));
  other = grid.Field;
  other.Dimensions.x -= 1;
  EXPECT_FALSE(AreAlike(grid.Field, other));
  other = grid.Field;
  other.Type = ScalarType::Int32;
  EXPECT_FALSE(AreAlike(grid.Field, other));
  other = grid.Field;
  other.Dimensions.z = 1;
  EXPECT_FALSE(AreAlike(other, other)) << "no cells";
}

}
