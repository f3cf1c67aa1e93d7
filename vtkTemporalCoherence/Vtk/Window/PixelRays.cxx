// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/PixelRays.h"

#include "Window/PixelHit.h"

#include <algorithm>

namespace TemporalCoherence
{
namespace
{

using Long2 = glm::i64vec2;

/// a / b, rounded up.
Long2 DividedUp(const Long2& a, const Long2& b)
{
  return (a + b - std::int64_t(1)) / b;
}

}

// Along an axis, let a pixel be as long as the number of rays, and a ray as long as the number of
// pixels. Then all ends and overlaps are integers.

glm::ivec2 PixelRays::AtCentre(const glm::ivec2& pixel) const
{
  const Long2 centre = (std::int64_t(2) * Long2(pixel) + std::int64_t(1)) * Long2(this->Rays);
  return glm::ivec2(centre / (std::int64_t(2) * Long2(this->Pixels)));
}

PixelRect PixelRays::In(const glm::ivec2& pixel) const
{
  const Long2 rays(this->Rays), pixels(this->Pixels);
  const glm::ivec2 first(Long2(pixel) * rays / pixels);
  const glm::ivec2 end(DividedUp((Long2(pixel) + std::int64_t(1)) * rays, pixels));
  return { first, end - first };
}

PixelRect PixelRays::PixelsOf(const PixelRect& part) const
{
  const Long2 rays(this->Rays), pixels(this->Pixels);
  const glm::ivec2 first(Long2(part.First) * pixels / rays);
  const glm::ivec2 end(DividedUp(Long2(part.First + part.Size) * pixels, rays));
  return { first, end - first };
}

std::optional<glm::ivec2> PixelRays::Shown(const Frame& frame, const glm::ivec2& pixel) const
{
  const auto hits = [&](const glm::ivec2& ray)
  { return frame.Isovalues[IndexOfPixel(frame, ray.x, ray.y)] != Frame::NoSurface; };
  const glm::ivec2 centre = this->AtCentre(pixel);
  if (hits(centre))
  {
    return centre;
  }
  std::optional<glm::ivec2> nearest;
  if (this->AreMore())
  {
    const auto depth = [&](const glm::ivec2& ray)
    { return frame.Depth[IndexOfPixel(frame, ray.x, ray.y)]; };
    const PixelRect part = this->In(pixel);
    for (int i = 0; i < part.Size.x * part.Size.y; ++i)
    {
      const glm::ivec2 ray = part.First + glm::ivec2(i % part.Size.x, i / part.Size.x);
      if (hits(ray) && (!nearest || depth(ray) < depth(*nearest)))
      {
        nearest = ray;
      }
    }
  }
  return nearest;
}

PixelColor PixelRays::MeanColor(
  const PixelColor* colors, const PixelRect& part, const glm::ivec2& pixel) const
{
  const PixelRect all = this->In(pixel);
  const glm::ivec2 first = glm::max(all.First, part.First);
  const glm::ivec2 end = glm::min(all.First + all.Size, part.First + part.Size);
  // The overlap of a ray and the pixel along an axis.
  const auto share = [&](int axis, int ray)
  {
    const std::int64_t rays = this->Rays[axis], pixels = this->Pixels[axis], at = pixel[axis];
    return std::min((ray + 1) * pixels, (at + 1) * rays) - std::max(ray * pixels, at * rays);
  };
  std::array<std::int64_t, 4> sum{};
  for (int y = first.y; y < end.y; ++y)
  {
    const PixelColor* const row =
      colors + static_cast<std::ptrdiff_t>(y - part.First.y) * part.Size.x;
    std::array<std::int64_t, 4> inRow{};
    for (int x = first.x; x < end.x; ++x)
    {
      const std::int64_t weight = share(0, x);
      for (std::size_t c = 0; c < 4; ++c)
      {
        inRow[c] += weight * row[x - part.First.x][c];
      }
    }
    const std::int64_t weight = share(1, y);
    for (std::size_t c = 0; c < 4; ++c)
    {
      sum[c] += weight * inRow[c];
    }
  }
  const std::int64_t whole = static_cast<std::int64_t>(this->Rays.x) * this->Rays.y;
  PixelColor mean;
  for (std::size_t c = 0; c < 4; ++c)
  {
    mean[c] = static_cast<std::uint8_t>((2 * sum[c] + whole) / (2 * whole));
  }
  mean[3] = std::max<std::uint8_t>(mean[3], sum[3] > 0);
  return mean;
}

}
