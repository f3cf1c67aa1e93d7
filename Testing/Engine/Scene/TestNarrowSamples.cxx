// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Samples of 8 and 16 bits are gathered by offsets of 32 bits only where every offset fits,
// whatever the strides of a field are.

#include "Grid.h"
#include "Scene/Field.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

using namespace TemporalCoherence;

namespace
{

/// Only asked about: there are no samples.
Field FieldWith(const glm::ivec3& dimensions, const glm::i64vec3& strides)
{
  Field field;
  field.Dimensions = dimensions;
  field.Strides = strides;
  return field;
}

constexpr std::int64_t Limit = std::numeric_limits<std::int32_t>::max();

}

TEST(NarrowSamples, AreImagesAsTheyLieInMemory)
{
  EXPECT_TRUE(NarrowSamples<std::uint8_t>::Are(Grid<std::uint8_t>({ 7, 6, 5 }).Field));
  EXPECT_TRUE(NarrowSamples<std::int16_t>::Are(Grid<std::int16_t>({ 7, 6, 5 }).Field));
  EXPECT_FALSE(NarrowSamples<float>::Are(Grid<float>({ 7, 6, 5 }).Field));
  EXPECT_FALSE(NarrowSamples<std::uint8_t>::Are(Grid<std::uint8_t>({ 7, 6, 5 }, 3).Field));
}

TEST(NarrowSamples, AreNotFlipped)
{
  EXPECT_FALSE(NarrowSamples<std::uint8_t>::Are(FieldWith({ 7, 6, 5 }, { 1, -7, 42 })));
  EXPECT_FALSE(NarrowSamples<std::uint8_t>::Are(FieldWith({ 7, 6, 5 }, { 1, 7, -42 })));
  EXPECT_FALSE(NarrowSamples<std::uint8_t>::Are(FieldWith({ 7, 6, 5 }, { -1, 7, 42 })));
  const std::int64_t far = std::int64_t(1) << 40;
  EXPECT_FALSE(NarrowSamples<std::uint8_t>::Are(FieldWith({ 7, 6, 5 }, { 1, 7, -far })));
}

TEST(NarrowSamples, ReachAsFarAsOffsetsDo)
{
  // The last sample of a piece of a large array lies 4 rows, 4 slices and 8 samples behind the
  // first one: both strides count.
  const glm::ivec3 piece(9, 5, 5);
  for (const std::int64_t bytes : { 1, 2 })
  {
    const auto are = [bytes](const Field& field)
    {
      return bytes == 1 ? NarrowSamples<std::uint8_t>::Are(field)
                        : NarrowSamples<std::int16_t>::Are(field);
    };
    const std::int64_t most = Limit / bytes - piece.x;
    EXPECT_TRUE(are(FieldWith(piece, { 1, most / 8, most / 8 })));
    EXPECT_FALSE(are(FieldWith(piece, { 1, most / 8 + 1, most / 8 + 1 })));
    EXPECT_TRUE(are(FieldWith(piece, { 1, 9, most / 4 - 9 })));
    EXPECT_FALSE(are(FieldWith(piece, { 1, 9, most / 4 + 1 })));
    EXPECT_FALSE(are(FieldWith(piece, { 1, most / 4 + 1, 9 })));
  }
}

TEST(NarrowSamples, OfAnyStrideAreToldWithoutOverflow)
{
  constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max();
  const int many = std::numeric_limits<std::int32_t>::max();
  for (const std::int64_t stride : { largest, largest / 2 + 1, std::int64_t(1) << 32 })
  {
    // 2^32 times 2^32 is 0 in 64 bits.
    EXPECT_FALSE(NarrowSamples<std::uint8_t>::Are(FieldWith({ 9, 5, many }, { 1, 9, stride })));
    EXPECT_FALSE(NarrowSamples<std::uint8_t>::Are(FieldWith({ 9, many, 5 }, { 1, stride, 9 })));
    EXPECT_FALSE(NarrowSamples<std::uint8_t>::Are(FieldWith({ 9, 5, 4 }, { 1, 9, stride })));
    EXPECT_FALSE(NarrowSamples<std::uint8_t>::Are(FieldWith({ 9, 5, 4 }, { 1, stride, stride })));
  }
}
