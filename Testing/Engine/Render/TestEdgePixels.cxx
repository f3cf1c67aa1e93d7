// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Pixels at edges are those that differ from a neighbour, in whatever tile it lies. The places of a
// pixel's rays have its centre as their mean, and tell which share of it an edge covers.

#include "Render/EdgePixels.h"
#include "Render/EdgeRays.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace
{

using namespace TemporalCoherence;

const glm::ivec2 Size(29, 21);

std::size_t PlaceOf(const glm::ivec2& pixel)
{
  return static_cast<std::size_t>(pixel.y * Size.x + pixel.x);
}

/// A picture of one grey surface, whose normals look to the viewer.
Frame Plain()
{
  Frame frame;
  frame.Resize(Size);
  frame.Depth.assign(frame.Depth.size(), 1.0);
  frame.Normals.assign(frame.Depth.size(), glm::vec3(0.0f, 0.0f, 1.0f));
  frame.Isovalues.assign(frame.Depth.size(), SurfaceIndex(0));
  frame.Colors.assign(frame.Depth.size(), { 100, 100, 100, 255 });
  return frame;
}

/// The pixels at edges of a whole picture.
std::set<std::pair<int, int>> EdgesOf(const Frame& frame, EdgeSign sign)
{
  std::set<std::pair<int, int>> edges;
  for (std::int64_t tile = 0; tile < NumberOfTiles(Size); ++tile)
  {
    const PixelRect part = PixelsOfTile(Size, tile);
    const std::uint64_t found = FindEdges(frame, part, sign);
    for (int place = 0; place < 64; ++place)
    {
      if (found >> place & 1u)
      {
        EXPECT_LT(place, part.Size.x * part.Size.y);
        edges.insert({ part.First.x + place % part.Size.x, part.First.y + place / part.Size.x });
      }
    }
  }
  return edges;
}

/// The pixels that differ from one of their neighbours, found one by one.
std::set<std::pair<int, int>> Expected(
  const std::function<bool(const glm::ivec2&, const glm::ivec2&)>& differ)
{
  std::set<std::pair<int, int>> edges;
  for (int pixel = 0; pixel < Size.x * Size.y; ++pixel)
  {
    const glm::ivec2 at(pixel % Size.x, pixel / Size.x);
    for (int step = 0; step < 9; ++step)
    {
      const glm::ivec2 next = at + glm::ivec2(step % 3, step / 3) - 1;
      if (glm::all(glm::greaterThanEqual(next, glm::ivec2(0))) &&
        glm::all(glm::lessThan(next, Size)) && differ(at, next))
      {
        edges.insert({ at.x, at.y });
      }
    }
  }
  return edges;
}

TEST(EdgePixels, APlainPictureHasNone)
{
  EXPECT_TRUE(EdgesOf(Plain(), EdgeSign::Colors).empty());
  EXPECT_TRUE(EdgesOf(Plain(), EdgeSign::Normals).empty());
}

TEST(EdgePixels, BothSidesOfAStepAreEdges)
{
  for (const int column : { 3, 8, 16, 28 })
  {
    Frame frame = Plain();
    for (int pixel = 0; pixel < Size.x * Size.y; ++pixel)
    {
      if (pixel % Size.x >= column)
      {
        frame.Colors[static_cast<std::size_t>(pixel)] = { 100, 117, 100, 255 };
      }
    }
    std::set<std::pair<int, int>> expected;
    for (int y = 0; y < Size.y; ++y)
    {
      expected.insert({ column - 1, y });
      expected.insert({ column, y });
    }
    EXPECT_EQ(EdgesOf(frame, EdgeSign::Colors), expected) << column;
    EXPECT_TRUE(EdgesOf(frame, EdgeSign::Normals).empty()) << column;
  }
}

TEST(EdgePixels, ASmallStepIsNone)
{
  Frame frame = Plain();
  frame.Colors[PlaceOf({ 8, 8 })] = { 116, 84, 100, 239 };
  EXPECT_TRUE(EdgesOf(frame, EdgeSign::Colors).empty());
  frame.Colors[PlaceOf({ 8, 8 })] = { 116, 84, 100, 238 };
  EXPECT_EQ(EdgesOf(frame, EdgeSign::Colors).size(), 9u) << "by its alpha";
}

TEST(EdgePixels, AreThoseThatDifferFromANeighbour)
{
  std::mt19937 random(1);
  std::uniform_int_distribution<int> any(0, 99);
  for (const int percent : { 1, 5, 30 })
  {
    Frame frame = Plain();
    for (std::size_t pixel = 0; pixel < frame.Colors.size(); ++pixel)
    {
      if (any(random) < percent)
      {
        frame.Colors[pixel] = { 200, 100, 100, 255 };
        frame.Isovalues[pixel] = 1;
      }
      if (any(random) < percent)
      {
        frame.Normals[pixel] = glm::vec3(0.0f, 0.6f, 0.8f);
      }
      if (any(random) < percent)
      {
        frame.Colors[pixel] = {};
        frame.Isovalues[pixel] = Frame::NoSurface;
        frame.Normals[pixel] = glm::vec3(0.0f);
      }
    }
    EXPECT_EQ(EdgesOf(frame, EdgeSign::Colors),
      Expected([&](const glm::ivec2& a, const glm::ivec2& b)
        { return frame.Colors[PlaceOf(a)] != frame.Colors[PlaceOf(b)]; }))
      << percent;
    EXPECT_EQ(EdgesOf(frame, EdgeSign::Normals),
      Expected(
        [&](const glm::ivec2& a, const glm::ivec2& b)
        {
          return frame.Isovalues[PlaceOf(a)] != frame.Isovalues[PlaceOf(b)] ||
            frame.Normals[PlaceOf(a)] != frame.Normals[PlaceOf(b)];
        }))
      << percent;
  }
}

TEST(EdgeRays, HaveThePixelsCentreAsMean)
{
  std::set<std::pair<double, double>> places;
  glm::dvec2 sum(0.0);
  for (std::size_t ray = 0; ray < EdgeRays::Rounds.back().Rays; ++ray)
  {
    const glm::dvec2 place = EdgeRays::PlaceOf(ray);
    EXPECT_LT(std::max(std::abs(place.x), std::abs(place.y)), 0.5);
    places.insert({ place.x, place.y });
    sum += place;
    if (ray % 4 == 3)
    {
      EXPECT_EQ(sum, glm::dvec2(0.0)) << ray;
    }
  }
  EXPECT_EQ(places.size(), EdgeRays::Rounds.back().Rays);
}

/// The mean error of the share of a pixel that lies on one side of a line.
double ErrorOfShares(std::size_t rays)
{
  constexpr int Lines = 4000, Grid = 64;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> angles(0.0, 6.283185307179586), offsets(-0.6, 0.6);
  double error = 0.0;
  for (int line = 0; line < Lines; ++line)
  {
    const double angle = angles(random), offset = offsets(random);
    const glm::dvec2 normal(std::cos(angle), std::sin(angle));
    int inside = 0;
    for (int i = 0; i < Grid * Grid; ++i)
    {
      const glm::dvec2 place((i % Grid + 0.5) / Grid - 0.5, (i / Grid + 0.5) / Grid - 0.5);
      inside += glm::dot(normal, place) < offset;
    }
    int found = 0;
    for (std::size_t ray = 0; ray < rays; ++ray)
    {
      found += glm::dot(normal, EdgeRays::PlaceOf(ray)) < offset;
    }
    error += std::abs(static_cast<double>(found) / static_cast<double>(rays) -
      static_cast<double>(inside) / (Grid * Grid));
  }
  return error / Lines;
}

TEST(EdgeRays, TellTheShareOfAPixelThatAnEdgeCovers)
{
  EXPECT_LT(ErrorOfShares(4), 0.08);
  EXPECT_LT(ErrorOfShares(8), 0.05);
  EXPECT_LT(ErrorOfShares(16), 0.03);
}

TEST(EdgeRays, TheMeanOfColoursIsRounded)
{
  EdgeRays::RaySum sum;
  EXPECT_EQ(sum.Contrast(), 0);
  sum.Add({ 10, 0, 255, 255 });
  EXPECT_EQ(sum.Contrast(), 0);
  sum.Add({ 11, 0, 255, 0 });
  sum.Add({ 11, 1, 255, 0 });
  sum.Add({ 10, 0, 255, 0 });
  EXPECT_EQ(sum.Contrast(), 255);
  EXPECT_EQ(sum.Mean(), (std::array<std::uint8_t, 4>{ 11, 0, 255, 64 }));
}

}
