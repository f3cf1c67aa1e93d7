// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Knots of pixels are the same after they were packed into chunks of rows and unpacked: any knots,
// and those of views. What is no chunk is refused.

#include "ViewFile/ZlibBytes.h"
#include "ViewTesting.h"

namespace
{

using namespace TemporalCoherence;

/// The knots of some rows alone.
PixelKnots RowsOf(const PixelKnots& knots, int width, const RowRange& rows)
{
  const std::size_t first = static_cast<std::size_t>(rows.First) * static_cast<std::size_t>(width);
  const std::size_t end = first + static_cast<std::size_t>(rows.Count * width);
  PixelKnots part;
  for (std::size_t pixel = first; pixel <= end; ++pixel)
  {
    part.Begin.push_back(knots.Begin[pixel] - knots.Begin[first]);
  }
  const auto copy = [&](const auto& all, auto& some)
  { some.assign(all.begin() + knots.Begin[first], all.begin() + knots.Begin[end]); };
  copy(knots.Progress, part.Progress);
  copy(knots.Distance, part.Distance);
  copy(knots.Normals, part.Normals);
  copy(knots.Middles, part.Middles);
  return part;
}

void ExpectRoundTrip(const PixelKnots& knots, int width, const RowRange& rows, int largest)
{
  const PixelKnots part = RowsOf(knots, width, rows);
  PixelKnots read;
  EXPECT_EQ(DecodeKnots(EncodeKnots(knots, width, rows), width, rows.Count, part.Progress.size(),
              static_cast<std::uint16_t>(largest), read),
    "");
  ExpectSame(part, read);
}

TEST(KnotChunk, AnyKnotsComeBack)
{
  unsigned seed = 1;
  for (const glm::ivec2& size : { glm::ivec2(1, 1), glm::ivec2(9, 1), glm::ivec2(1, 9),
         glm::ivec2(2, 2), glm::ivec2(24, 16), glm::ivec2(33, 70) })
  {
    for (const int largest : { 1, 7, 4095, 65535 })
    {
      for (const std::uint32_t farthest : { 100u, 100000u, 2147483647u })
      {
        SCOPED_TRACE(testing::Message() << size.x << " x " << size.y << ", progress " << largest
                                        << ", distance " << farthest << ", seed " << seed);
        const PixelKnots knots =
          RandomKnots(seed++, static_cast<std::uint16_t>(largest), farthest).Make(size);
        ExpectRoundTrip(knots, size.x, { 0, size.y }, largest);
        ExpectRoundTrip(knots, size.x, { size.y / 2, (size.y + 1) / 2 }, largest);
        ExpectRoundTrip(knots, size.x, { size.y - 1, 1 }, largest);
      }
    }
  }
}

TEST(KnotChunk, KnotsOfViewsComeBackAndAreSmall)
{
  for (const bool isInside : { false, true })
  {
    MadeViewSettings settings;
    settings.Size = { 120, 90 };
    settings.IsInside = isInside;
    const MadeView view = MakeView(settings);
    const PixelKnots& knots = view.Knots.Knots[isInside ? 1 : 0];
    ASSERT_GT(knots.Progress.size(), 10000u);
    ExpectRoundTrip(knots, 120, { 0, 90 }, view.Knots.Grid.LargestProgress);
    ExpectRoundTrip(knots, 120, { 7, 32 }, view.Knots.Grid.LargestProgress);
    // In memory a knot takes ten bytes.
    const auto packed = Deflate(EncodeKnots(knots, 120, { 0, 90 }));
    EXPECT_LT(packed.size(), 5 * knots.Progress.size());
  }
}

TEST(KnotChunk, WhatIsNoChunkIsRefused)
{
  const glm::ivec2 size(6, 5);
  const PixelKnots knots = RandomKnots(3, 500, 9000).Make(size);
  const std::size_t count = knots.Progress.size();
  const std::vector<std::uint8_t> good = EncodeKnots(knots, size.x, { 0, size.y });
  PixelKnots read;
  const auto errorOf = [&](const std::vector<std::uint8_t>& bytes, std::size_t knotsOf, int rows)
  { return DecodeKnots(bytes, size.x, rows, knotsOf, 500, read); };
  ASSERT_EQ(errorOf(good, count, size.y), "");
  for (std::size_t length = 0; length < good.size(); ++length)
  {
    EXPECT_NE(
      errorOf({ good.begin(), good.begin() + static_cast<std::ptrdiff_t>(length) }, count, size.y),
      "")
      << length;
  }
  std::vector<std::uint8_t> longer = good;
  longer.push_back(0);
  EXPECT_NE(errorOf(longer, count, size.y), "");
  EXPECT_NE(errorOf(good, count + 1, size.y), "");
  EXPECT_NE(errorOf(good, count - 1, size.y), "");
  EXPECT_NE(errorOf(good, count, size.y - 1), "");
  EXPECT_NE(errorOf(good, count, size.y + 1), "");
  const std::uint16_t highest = *std::max_element(knots.Progress.begin(), knots.Progress.end());
  ASSERT_GT(highest, 0);
  EXPECT_EQ(DecodeKnots(good, size.x, size.y, count, highest, read), "");
  EXPECT_NE(
    DecodeKnots(good, size.x, size.y, count, static_cast<std::uint16_t>(highest - 1), read), "");
}

/// Bytes of a chunk of one pixel.
std::vector<std::uint8_t> OnePixel(const std::vector<std::uint8_t>& counts,
  const std::vector<std::uint8_t>& tokens, const std::vector<std::uint8_t>& progress,
  const std::vector<std::uint8_t>& distances)
{
  const std::vector<std::uint8_t> normals(4 * tokens.size());
  std::vector<std::uint8_t> bytes;
  for (const auto* stream : { &counts, &tokens, &progress, &distances, &normals })
  {
    bytes.insert(bytes.end(), { static_cast<std::uint8_t>(stream->size()), 0, 0, 0 });
  }
  for (const auto* stream : { &counts, &tokens, &progress, &distances, &normals })
  {
    bytes.insert(bytes.end(), stream->begin(), stream->end());
  }
  return bytes;
}

TEST(KnotChunk, ImpossibleKnotsAreRefused)
{
  PixelKnots read;
  const auto isRefused = [&](const std::vector<std::uint8_t>& bytes, std::size_t count)
  { return !DecodeKnots(bytes, 1, 1, count, 100, read).empty(); };
  // Zigzag: 2 is 1, 1 is -1.
  EXPECT_FALSE(isRefused(OnePixel({ 4 }, { 3, 3 }, { 2, 2 }, { 2, 2 }), 2));
  EXPECT_FALSE(isRefused(OnePixel({ 4 }, { 3, 2 }, { 2 }, { 2, 2 }), 2));
  EXPECT_TRUE(isRefused(OnePixel({ 6 }, { 3, 2, 2 }, { 2 }, { 2, 2, 2 }), 3)) << "a second jump";
  EXPECT_TRUE(isRefused(OnePixel({ 4 }, { 3, 3 }, { 2, 0 }, { 2, 2 }), 2)) << "no progress";
  EXPECT_TRUE(isRefused(OnePixel({ 4 }, { 3, 3 }, { 4, 1 }, { 2, 2 }), 2)) << "back";
  EXPECT_TRUE(isRefused(OnePixel({ 2 }, { 2 }, {}, { 2 }), 1)) << "a jump without a knot before";
  EXPECT_TRUE(isRefused(OnePixel({ 2 }, { 0 }, {}, { 2 }), 1)) << "as left of nothing";
  EXPECT_TRUE(isRefused(OnePixel({ 2 }, { 1 }, {}, { 2 }), 1)) << "as below of nothing";
  EXPECT_TRUE(isRefused(OnePixel({ 2 }, { 4 }, { 2 }, { 2 }), 1)) << "no such token";
  EXPECT_TRUE(isRefused(OnePixel({ 2 }, { 3 }, { 1 }, { 2 }), 1)) << "negative progress";
  EXPECT_TRUE(isRefused(OnePixel({ 2 }, { 3 }, { 2 }, { 1 }), 1)) << "negative distance";
  EXPECT_TRUE(isRefused(OnePixel({ 2 }, { 3 }, { 2 }, { 0x82 }), 1)) << "half a number";
  EXPECT_TRUE(
    isRefused(OnePixel({ 2 }, { 3 }, { 2 }, { 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 1 }), 1))
    << "too long a number";
  EXPECT_TRUE(isRefused(OnePixel({ 2 }, { 3 }, { 2 }, { 0xfe, 0xff, 0xff, 0xff, 0x7f }), 1))
    << "too far";
  EXPECT_TRUE(isRefused(OnePixel({ 1 }, {}, {}, {}), 0)) << "fewer than no knots";
  EXPECT_TRUE(isRefused(OnePixel({ 0, 0 }, {}, {}, {}), 0)) << "more pixels";
  EXPECT_TRUE(isRefused(OnePixel({ 2 }, { 3 }, { 2, 2 }, { 2 }), 1)) << "more progress";
  EXPECT_TRUE(isRefused(OnePixel({ 2 }, { 3 }, { 2 }, { 2, 2 }), 1)) << "more distances";
}

}
