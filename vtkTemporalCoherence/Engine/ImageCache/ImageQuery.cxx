// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageCache/ImageQuery.h"

#include "Scene/Disparity.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace TemporalCoherence
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// t at a point of a path.
double DistanceAt(const PathBatch& paths, std::size_t ray, double at, bool isParallel)
{
  const double t0 = paths.T0[ray], t1 = paths.T1[ray];
  if (isParallel)
  {
    return t0 + at * (t1 - t0);
  }
  // In the picture, t times disparity is affine.
  const double q0 = paths.Q0[ray], q1 = paths.Q1[ray];
  return ((1.0 - at) * t0 * q0 + at * t1 * q1) / (q0 + at * (q1 - q0));
}

/// Call visit(pixel, parameter on entry, disparity on entry, disparity on exit) for each pixel
/// along a ray until it returns true.
/// \return false if it never did
template <typename Visit>
bool WalkPixels(const PathBatch& paths, std::size_t ray, const glm::ivec2& size, const Visit& visit)
{
  const double u = paths.U[ray], v = paths.V[ray];
  const double perU = paths.PerU[ray], perV = paths.PerV[ray];
  const double q0 = paths.Q0[ray], perQ = paths.Q1[ray] - paths.Q0[ray];
  const double end = paths.End[ray];
  int x = static_cast<int>(u);
  int y = static_cast<int>(v);
  const int stepX = perU > 0.0 ? 1 : -1;
  const int stepY = perV > 0.0 ? 1 : -1;
  const double acrossX = perU != 0.0 ? 1.0 / std::abs(perU) : Infinity;
  const double acrossY = perV != 0.0 ? 1.0 / std::abs(perV) : Infinity;
  double nextX = perU != 0.0 ? (x + (perU > 0.0) - u) / perU : Infinity;
  double nextY = perV != 0.0 ? (y + (perV > 0.0) - v) / perV : Infinity;
  double at = 0.0;
  double q = q0;
  while (true)
  {
    const double next = std::min(std::min(nextX, nextY), end);
    const double qNext = q0 + next * perQ;
    if (visit(y * size.x + x, at, q, qNext))
    {
      return true;
    }
    if (next >= end)
    {
      return false;
    }
    at = next;
    q = qNext;
    const bool isAcross = nextX < nextY;
    x += isAcross ? stepX : 0;
    y += isAcross ? 0 : stepY;
    nextX += isAcross ? acrossX : 0.0;
    nextY += isAcross ? 0.0 : acrossY;
    if (static_cast<unsigned>(x) >= static_cast<unsigned>(size.x) ||
      static_cast<unsigned>(y) >= static_cast<unsigned>(size.y))
    {
      return false;
    }
  }
}

}

bool ImageQuery::CanAsk(const FrameKey& cached)
{
  const View& view = cached.View;
  const glm::dvec3 w(RowOf(view.ClipFromWorld, 3));
  const double along = glm::dot(w, view.Forward);
  return view.Parallel ||
    (along > 0.0 && glm::length(w - along * view.Forward) <= 1e-9 * std::abs(along));
}

ImageQuery::ImageQuery(const CachedImage& image, const FrameKey& next)
  : Image(image)
{
  const View& view = image.Key.View;
  const glm::dmat4 clip = view.ClipFromWorld * next.Transform.WorldFromIndex;
  const glm::dvec4 forward(view.Forward, -glm::dot(view.Forward, view.Position));
  const glm::dvec4 w = RowOf(clip, 3);
  // Divide by depth instead of w: for a perspective they differ by a constant factor.
  const double perW = view.Parallel
    ? 1.0 / w.w
    : 1.0 / glm::dot(glm::dvec3(RowOf(view.ClipFromWorld, 3)), view.Forward);
  this->Projection.IsParallel = view.Parallel;
  this->Projection.Near = view.Near;
  this->Projection.Far = view.Far;
  this->Projection.Size = glm::dvec2(view.Size);
  this->Projection.RowU = 0.5 * view.Size.x * perW * (RowOf(clip, 0) + w);
  this->Projection.RowV = 0.5 * view.Size.y * perW * (RowOf(clip, 1) + w);
  this->Projection.RowZ = glm::transpose(next.Transform.WorldFromIndex) * forward;

  this->Voxel = next.Samples.Shape->VoxelSizeIn(next.Transform).Longest;
}

void ImageQuery::Ask(const RayBatch& rays, KnownRays& known) const
{
  PathBatch paths;
  ProjectWalks(this->Projection, rays, paths);
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
  {
    const bool isWalking = rays.WalkBegin[i] < rays.WalkEnd[i];
    known.Answers[i] = isWalking ? Answer::PossibleHit : Answer::DefiniteMiss;
    known.Free[i] = rays.WalkBegin[i];
    known.Pixel[i] = -1;
    if (isWalking && paths.Kind[i] != PathKind::Unknown)
    {
      this->FindHit(paths, i, known);
    }
  }
}

void ImageQuery::FindHit(const PathBatch& paths, std::size_t ray, KnownRays& known) const
{
  const bool isParallel = this->Projection.IsParallel;
  const float* const surface = this->Image.Picture.Disparities.data();
  double stop = paths.End[ray];
  double hit = -1.0;
  double last = 0.0; // surface of the predecessor
  bool isFirst = true;
  const bool isStopped = WalkPixels(paths, ray, this->Image.Picture.Size,
    [&](std::int32_t pixel, double at, double q, double qNext)
    {
      const double here = static_cast<double>(surface[pixel]);
      if (std::min(q, qNext) > here)
      {
        last = here;
        isFirst = false;
        return false;
      }
      const bool isInFront = q > here;
      bool isConnected = isInFront; // in its first pixel, to the beginning of the ray
      if (!isFirst)
      {
        isConnected = last > DisparityOfMiss(isParallel) &&
          std::abs(DepthOf(last, isParallel) - DepthOf(here, isParallel)) <= this->Voxel;
      }
      if (isConnected)
      {
        hit = isInFront ? (here - paths.Q0[ray]) / (paths.Q1[ray] - paths.Q0[ray]) : at;
      }
      stop = at;
      known.Pixel[ray] = pixel;
      return true;
    });
  if (!isStopped && paths.Kind[ray] == PathKind::Whole)
  {
    known.Answers[ray] = Answer::DefiniteMiss;
    return;
  }
  const double t = DistanceAt(paths, ray, stop, isParallel);
  known.Free[ray] = std::max(known.Free[ray], t);
  if (hit >= 0.0)
  {
    known.Answers[ray] = Answer::DefiniteHit;
    known.Hit[ray] = DistanceAt(paths, ray, hit, isParallel);
    known.Column[ray] = paths.U[ray] + hit * paths.PerU[ray];
    known.Row[ray] = paths.V[ray] + hit * paths.PerV[ray];
  }
}

void ImageQuery::Interpolate(
  const KnownRays& known, std::size_t ray, std::size_t pixel, Frame& frame) const
{
  const Frame& image = this->Image.Picture;
  const auto stopped = static_cast<std::size_t>(known.Pixel[ray]);
  frame.Depth[pixel] = known.Hit[ray];
  frame.Isovalues[pixel] = image.Isovalues[stopped];
  frame.Kinds[pixel] = image.Kinds[stopped];
  if (!frame.Cells.empty())
  {
    frame.Cells[pixel] = NoCell;
  }
  frame.Answers[pixel] = Answer::DefiniteHit;

  // Interpolate between the centres of those of four pixels that show the same surface.
  const glm::dvec2 at = glm::dvec2(known.Column[ray], known.Row[ray]) - 0.5;
  const glm::dvec2 low = glm::floor(at);
  glm::dvec4 color(0.0);
  glm::dvec3 normal(0.0);
  for (int i = 0; i < 4; ++i)
  {
    const glm::dvec2 corner = low + glm::dvec2(i & 1, i >> 1);
    const glm::dvec2 share = 1.0 - glm::abs(at - corner);
    const glm::ivec2 p = glm::clamp(glm::ivec2(corner), glm::ivec2(0), image.Size - 1);
    const auto neighbour = static_cast<std::size_t>(p.y * image.Size.x + p.x);
    if (image.Isovalues[neighbour] == image.Isovalues[stopped])
    {
      const std::array<std::uint8_t, 4>& c = image.Colors[neighbour];
      color += share.x * share.y * glm::dvec4(c[0], c[1], c[2], 255.0);
      normal += share.x * share.y * glm::dvec3(image.Normals[neighbour]);
    }
  }
  if (!(color.a > 0.0) || !(glm::length(normal) > 0.0))
  {
    frame.Colors[pixel] = image.Colors[stopped];
    frame.Normals[pixel] = image.Normals[stopped];
    return;
  }
  color = color * (255.0 / color.a) + 0.5;
  frame.Colors[pixel] = { static_cast<std::uint8_t>(color.r), static_cast<std::uint8_t>(color.g),
    static_cast<std::uint8_t>(color.b), 255 };
  frame.Normals[pixel] = glm::vec3(glm::normalize(normal));
}

bool ImageQuery::IsSeenFromInside(std::int32_t pixel) const
{
  if (pixel < 0)
  {
    return false; // the ray left the image
  }
  const Frame& frame = this->Image.Picture;
  const int column = pixel % frame.Size.x;
  const int row = pixel / frame.Size.x;
  for (int y = std::max(row - 1, 0); y <= std::min(row + 1, frame.Size.y - 1); ++y)
  {
    for (int x = std::max(column - 1, 0); x <= std::min(column + 1, frame.Size.x - 1); ++x)
    {
      if (frame.Kinds[static_cast<std::size_t>(y * frame.Size.x + x)] == HitKind::Exit)
      {
        return true;
      }
    }
  }
  return false;
}

}
