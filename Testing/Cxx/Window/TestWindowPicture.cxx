// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A window gets a rectangle with all hits, which stays as large while hits move, and, where other
// things lie among its layers, the last layer before them, as loops over all pixels find them.

#include "Checks/Expect.h"
#include "Window/LayerDepthClip.h"
#include "Window/WindowPicture.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace
{

using namespace TemporalCoherence;

/// A whole number from 0 to n - 1.
int Below(std::mt19937& engine, int n)
{
  return static_cast<int>(engine() % static_cast<unsigned int>(n));
}

/// Looks from z = 1 down to z = -1.
View ViewOf(const glm::ivec2& size)
{
  View view;
  const bool isMade =
    MakeView(glm::lookAt(glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.0), glm::dvec3(0.0, 1.0, 0.0)),
      glm::ortho(-1.0, 1.0, -1.0, 1.0, 0.0, 2.0), { 0.0, 2.0 }, size, view);
  Expect(isMade, "a view");
  return view;
}

/// A frame without hits.
Frame EmptyFrame(const glm::ivec2& size)
{
  Frame frame;
  frame.Resize(size);
  std::fill(frame.Depth.begin(), frame.Depth.end(), std::numeric_limits<double>::infinity());
  std::fill(frame.Isovalues.begin(), frame.Isovalues.end(), Frame::NoSurface);
  std::fill(frame.Colors.begin(), frame.Colors.end(), PixelColor{});
  return frame;
}

std::size_t PlaceOf(const Frame& frame, const glm::ivec2& pixel)
{
  return static_cast<std::size_t>(pixel.y * frame.Size.x + pixel.x);
}

void SetHit(Frame& frame, const glm::ivec2& pixel, double t, const PixelColor& color)
{
  frame.Depth[PlaceOf(frame, pixel)] = t;
  frame.Isovalues[PlaceOf(frame, pixel)] = 0;
  frame.Colors[PlaceOf(frame, pixel)] = color;
}

LayerColor LayerColorOf(const PixelColor& color)
{
  LayerColor fine;
  for (std::size_t c = 0; c < color.size(); ++c)
  {
    fine.Values[c] = static_cast<std::uint16_t>(fine.Values[c] + 256 * color[c]);
  }
  return fine;
}

/// The picture of a frame is that of its hits.
void ExpectPicture(const Frame& frame, const std::string& what)
{
  const View view = ViewOf(frame.Size);
  WindowPicture picture;
  picture.Assign(frame, view, frame.Size);
  constexpr int grain = WindowPicture::HitsGrain;
  glm::ivec2 first = frame.Size, end(0);
  bool hasOpaque = false, hasTranslucent = false;
  for (int y = 0; y < frame.Size.y; ++y)
  {
    for (int x = 0; x < frame.Size.x; ++x)
    {
      const glm::ivec2 pixel(x, y);
      if (frame.Isovalues[PlaceOf(frame, pixel)] != Frame::NoSurface)
      {
        first = glm::min(first, pixel / grain * grain);
        end = glm::max(end, glm::min((pixel / grain + 1) * grain, frame.Size));
        const int alpha = frame.Colors[PlaceOf(frame, pixel)][3];
        hasOpaque |= alpha == 255;
        hasTranslucent |= alpha > 0 && alpha < 255;
      }
    }
  }
  if (end.x == 0)
  {
    Expect(picture.Rect.Size == glm::ivec2(0), what + ": nothing to show");
    return;
  }
  Expect(picture.Rect.First == first && picture.Rect.Size == end - first,
    what + ": the smallest rectangle of its grain with all hits");
  Expect(picture.HasOpaque == hasOpaque && picture.HasTranslucent == hasTranslucent,
    what + ": what its hits are like");
  std::size_t at = 0;
  for (int y = first.y; y < end.y; ++y)
  {
    for (int x = first.x; x < end.x; ++x, ++at)
    {
      const std::size_t from = PlaceOf(frame, { x, y });
      const bool isHit = frame.Isovalues[from] != Frame::NoSurface;
      const float depth = isHit ? WindowDepthOf(view, { x, y }, frame.Depth[from]) : 1.0f;
      if (picture.Colors[at] != frame.Colors[from] || picture.Depths[at] != depth)
      {
        Expect(false, what + ": pixel " + std::to_string(x) + ", " + std::to_string(y));
        return;
      }
    }
  }
}

/// From one hit to many, anywhere, at the borders of tiles and of the picture too.
void TestRectangles()
{
  std::mt19937 engine(31);
  for (int round = 0; round < 400; ++round)
  {
    const int most = round % 4 == 0 ? 300 : 45;
    const glm::ivec2 size(1 + Below(engine, most), 1 + Below(engine, most));
    Frame frame = EmptyFrame(size);
    const int kinds = Below(engine, 3);
    for (int hit = Below(engine, 5); hit > 0; --hit)
    {
      const bool isOpaque = kinds == 0 || (kinds == 1 && Below(engine, 2) == 0);
      const int alpha = isOpaque ? 255 : 1 + Below(engine, 254);
      SetHit(frame, { Below(engine, size.x), Below(engine, size.y) },
        0.1 + 0.001 * Below(engine, 1800), { 1, 2, 3, static_cast<std::uint8_t>(alpha) });
    }
    ExpectPicture(frame, "round " + std::to_string(round));
  }
  // Each pixel of a picture alone.
  const glm::ivec2 size(27, 18);
  for (int pixel = 0; pixel < size.x * size.y; ++pixel)
  {
    Frame frame = EmptyFrame(size);
    SetHit(frame, { pixel % size.x, pixel / size.x }, 0.5, { 9, 9, 9, 255 });
    ExpectPicture(frame, "pixel " + std::to_string(pixel));
  }
}

/// Pictures have the rectangle of the last one as long as it is at most twice as large.
void TestRoomOfTheLastPicture()
{
  constexpr int grain = WindowPicture::HitsGrain;
  const glm::ivec2 size(8 * grain, 4 * grain);
  const View view = ViewOf(size);
  WindowPicture picture;
  const auto expect = [&](const glm::ivec2& firstHit, const glm::ivec2& lastHit,
                        const glm::ivec2& first, const glm::ivec2& end, const std::string& what)
  {
    Frame frame = EmptyFrame(size);
    SetHit(frame, firstHit, 0.5, { 1, 2, 3, 255 });
    SetHit(frame, lastHit, 0.5, { 3, 2, 1, 255 });
    picture.Assign(frame, view, size);
    Expect(picture.Rect.First == grain * first && picture.Rect.Size == grain * (end - first), what);
    for (const glm::ivec2& hit : { firstHit, lastHit })
    {
      const glm::ivec2 at = hit - picture.Rect.First;
      const auto place = static_cast<std::size_t>(at.y * picture.Rect.Size.x + at.x);
      Expect(picture.Colors[place] == frame.Colors[PlaceOf(frame, hit)], what + ": a hit");
    }
  };
  const glm::ivec2 middle = grain * glm::ivec2(2, 2);
  expect(middle, middle + grain, { 2, 2 }, { 4, 4 }, "the first picture");
  expect(middle, middle + glm::ivec2(grain, 0), { 2, 2 }, { 4, 4 }, "half as large: as before");
  expect(middle, middle + glm::ivec2(2 * grain, 0), { 2, 2 }, { 5, 4 }, "it grows");
  expect(middle, middle, { 2, 2 }, { 3, 3 }, "much smaller");
  expect(grain * glm::ivec2(6, 0), grain * glm::ivec2(7, 0), { 6, 0 }, { 8, 1 }, "elsewhere");
  const Frame empty = EmptyFrame(size);
  picture.Assign(empty, view, size);
  Expect(picture.Rect.Size == glm::ivec2(0), "nothing to show");
  expect(middle, middle, { 2, 2 }, { 3, 3 }, "after nothing");
  Frame small = EmptyFrame({ grain, grain });
  SetHit(small, { 1, 1 }, 0.5, { 1, 2, 3, 255 });
  picture.Assign(small, ViewOf(small.Size), small.Size);
  Expect(picture.Rect.First == glm::ivec2(0) && picture.Rect.Size == small.Size, "fewer pixels");
}

/// Up to three layers in most pixels, round by round.
Frame FrameOfLayers(const glm::ivec2& size, std::mt19937& engine)
{
  Frame frame = EmptyFrame(size);
  frame.Layers.resize(static_cast<std::size_t>(NumberOfTiles(size)));
  for (std::int64_t tile = 0; tile < NumberOfTiles(size); ++tile)
  {
    const PixelRect part = PixelsOfTile(size, tile);
    std::vector<int> counts(static_cast<std::size_t>(part.Size.x * part.Size.y));
    std::generate(counts.begin(), counts.end(), [&] { return Below(engine, 4); });
    for (int layer = 0; layer < 3; ++layer)
    {
      for (std::size_t i = 0; i < counts.size(); ++i)
      {
        if (layer >= counts[i])
        {
          continue;
        }
        const glm::ivec2 pixel = part.First +
          glm::ivec2(static_cast<int>(i) % part.Size.x, static_cast<int>(i) / part.Size.x);
        const double t = 0.3 + 0.5 * layer + 0.001 * Below(engine, 400);
        const PixelColor color{ static_cast<std::uint8_t>(Below(engine, 50)),
          static_cast<std::uint8_t>(Below(engine, 50)), 7,
          static_cast<std::uint8_t>(60 + 60 * layer) };
        frame.Layers[static_cast<std::size_t>(tile)].push_back(
          { t, static_cast<std::int32_t>(PlaceOf(frame, pixel)), 0, HitKind::Entry,
            LayerColorOf(color) });
        if (layer == 0)
        {
          SetHit(frame, pixel, t, color);
        }
        frame.Colors[PlaceOf(frame, pixel)] = color;
      }
    }
  }
  return frame;
}

/// What a pixel of a picture shows before something in the window.
PixelColor ColorBefore(const Frame& frame, const View& view, const glm::ivec2& pixel, float depth)
{
  PixelColor color{};
  for (const std::vector<LayerHit>& layers : frame.Layers)
  {
    for (const LayerHit& layer : layers)
    {
      if (static_cast<std::size_t>(layer.Pixel) == PlaceOf(frame, pixel) &&
        WindowDepthOf(view, pixel, layer.Depth) <= depth)
      {
        color = layer.Color.Bytes();
      }
    }
  }
  return color[3] == 0 ? frame.Colors[PlaceOf(frame, pixel)] : color;
}

/// In windows with as many pixels as the picture, more, and numbers that are no multiples.
void TestClippedLayers()
{
  std::mt19937 engine(32);
  int clipped = 0, wholes = 0;
  for (int round = 0; round < 60; ++round)
  {
    const glm::ivec2 size(10 + Below(engine, 20), 10 + Below(engine, 20));
    const Frame frame = FrameOfLayers(size, engine);
    const View view = ViewOf(size);
    WindowPicture picture;
    picture.Assign(frame, view, frame.Size);
    Expect(picture.HasLayers, "layers behind one another");
    const glm::ivec2 scaled =
      picture.Rect.Size * (round % 3 == 2 ? 7 : 2) / (round % 3 == 2 ? 3 : 2);
    const glm::ivec2 window = round % 3 == 1 ? 2 * picture.Rect.Size : scaled;
    std::vector<float> depths(static_cast<std::size_t>(window.x * window.y), 1.0f);
    if (round % 5)
    {
      for (float& depth : depths)
      {
        depth = Below(engine, 2) ? 1.0f : 0.001f * static_cast<float>(Below(engine, 1000));
      }
    }
    std::vector<PixelColor> colors;
    const bool isClipped = ClipLayersAt(depths, window, picture.Rect, frame, view, colors);
    bool isOther = false;
    long wrong = 0;
    for (int i = 0; i < window.x * window.y; ++i)
    {
      const glm::ivec2 place(i % window.x, i / window.x);
      const glm::ivec2 pixel =
        picture.Rect.First + (2 * place + 1) * picture.Rect.Size / (2 * window);
      const auto at = static_cast<std::size_t>(i);
      const PixelColor expected = ColorBefore(frame, view, pixel, depths[at]);
      wrong += colors[at] != expected;
      isOther |= expected != frame.Colors[PlaceOf(frame, pixel)];
    }
    const std::string what = "clipped " + std::to_string(round) + ": ";
    Expect(wrong == 0, what + std::to_string(wrong) + " pixels show another layer");
    Expect(isClipped == isOther, what + "told");
    (isOther ? clipped : wholes)++;
  }
  Expect(clipped > 20 && wholes > 5, "both kinds");
}

/// Layers are behind one another only where a pixel has two.
void TestHasLayers()
{
  Frame frame = EmptyFrame({ 20, 10 });
  frame.Layers.resize(static_cast<std::size_t>(NumberOfTiles(frame.Size)));
  WindowPicture picture;
  for (const int x : { 9, 10, 11 })
  {
    SetHit(frame, { x, 3 }, 0.5, { 1, 1, 1, 100 });
    frame.Layers[1].push_back({ 0.5, 60 + x, 0, HitKind::Entry, { 1, 1, 1, 100 } });
    picture.Assign(frame, ViewOf(frame.Size), frame.Size);
    Expect(!picture.HasLayers, "one layer");
  }
  frame.Layers[1].push_back({ 0.7, 60 + 11, 0, HitKind::Exit, { 1, 1, 1, 150 } });
  picture.Assign(frame, ViewOf(frame.Size), frame.Size);
  Expect(picture.HasLayers, "a second one in one pixel");
}

}

int TestWindowPicture(int, char*[])
{
  TestRectangles();
  TestRoomOfTheLastPicture();
  TestClippedLayers();
  TestHasLayers();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
