// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ImageQuery.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Pixels of a cached image are believed where they are at most so many voxels (of the shortest
/// edge) apart: between pixels farther apart whole features of the surface can hide.
constexpr double FarthestApart = 1.0;

glm::dvec4 RowOf(const glm::dmat4& m, int r)
{
  return { m[0][r], m[1][r], m[2][r], m[3][r] };
}

/// Shortest and longest edge of a voxel in the world.
glm::dvec2 VoxelEdges(const Placement& where)
{
  const glm::dmat3 edges(where.WorldFromIndex);
  const glm::dvec3 lengths(glm::length(edges[0]), glm::length(edges[1]), glm::length(edges[2]));
  return { std::min(lengths.x, std::min(lengths.y, lengths.z)),
    std::max(lengths.x, std::max(lengths.y, lengths.z)) };
}

/// Depth up to which the pixels of a view are at most `apart` from each other.
double DepthOfSpacing(const View& view, double apart)
{
  const glm::dvec2 perPixel = 2.0 / glm::dvec2(view.Size);
  if (view.Parallel)
  {
    const double spacing =
      std::max(glm::length(view.OriginX) * perPixel.x, glm::length(view.OriginY) * perPixel.y);
    return spacing <= apart ? Infinity : -Infinity;
  }
  const double spacing =
    std::max(glm::length(view.DirectionX) * perPixel.x, glm::length(view.DirectionY) * perPixel.y);
  return apart / spacing;
}

}

/// A ray in the cached image. Column, row and disparity are affine in `lambda`, which runs from 0
/// to End.
struct ImageQuery::Path
{
  double TAt(double lambda) const
  {
    if (this->IsParallel)
    {
      return this->T0 + lambda * (this->T1 - this->T0);
    }
    return ((1.0 - lambda) * this->T0 * this->Q0 + lambda * this->T1 * this->Q1) /
      this->QAt(lambda);
  }
  double QAt(double lambda) const { return this->Q0 + lambda * (this->Q1 - this->Q0); }

  /// Call visit(pixel, lambda, disparity on entry, lambda, disparity on leaving) for each pixel on
  /// the way until it returns true.
  /// \return false if it never did
  template <typename Visit>
  bool Walk(const glm::ivec2& size, const Visit& visit) const
  {
    int x = std::min(static_cast<int>(this->U), size.x - 1);
    int y = std::min(static_cast<int>(this->V), size.y - 1);
    const int stepX = this->PerU > 0.0 ? 1 : -1;
    const int stepY = this->PerV > 0.0 ? 1 : -1;
    const double acrossX = this->PerU != 0.0 ? 1.0 / std::abs(this->PerU) : Infinity;
    const double acrossY = this->PerV != 0.0 ? 1.0 / std::abs(this->PerV) : Infinity;
    double nextX = this->PerU != 0.0 ? (x + (stepX + 1) / 2 - this->U) / this->PerU : Infinity;
    double nextY = this->PerV != 0.0 ? (y + (stepY + 1) / 2 - this->V) / this->PerV : Infinity;
    double lambda = 0.0;
    double q = this->Q0;
    while (true)
    {
      const double next = std::min(std::min(nextX, nextY), this->End);
      const double qNext = this->QAt(next);
      if (visit(y * size.x + x, lambda, q, next, qNext))
      {
        return true;
      }
      if (next >= this->End)
      {
        return false;
      }
      lambda = next;
      q = qNext;
      if (nextX < nextY)
      {
        x += stepX;
        nextX += acrossX;
      }
      else
      {
        y += stepY;
        nextY += acrossY;
      }
      if (static_cast<unsigned>(x) >= static_cast<unsigned>(size.x) ||
        static_cast<unsigned>(y) >= static_cast<unsigned>(size.y))
      {
        return false;
      }
    }
  }

  bool IsParallel;
  double T0, T1; ///< distances along the ray at 0 and 1
  double Q0, Q1; ///< disparities
  double U, V, PerU, PerV;
  double End;
};

bool ImageQuery::CanAsk(const View& view)
{
  const glm::dvec3 w(RowOf(view.ClipFromWorld, 3));
  const double along = glm::dot(w, view.Forward);
  return view.Parallel ||
    (along > 0.0 && glm::length(w - along * view.Forward) <= 1e-9 * std::abs(along));
}

ImageQuery::ImageQuery(CachedImage& image, const FrameKey& next, ReuseAccuracy accuracy)
  : Image(image)
  , Accuracy(accuracy)
  , IsParallel(image.Key.Seen.Parallel)
  , Near(image.Key.Seen.Near)
{
  const View& seen = image.Key.Seen;
  const glm::dmat4 clip = seen.ClipFromWorld * next.Where.WorldFromIndex;
  const glm::dvec4 forward(seen.Forward, -glm::dot(seen.Forward, seen.Position));
  const glm::dvec4 w = RowOf(clip, 3);
  // Divided by depth instead of w: the same for a perspective but for a factor.
  const double perW = this->IsParallel
    ? 1.0 / w.w
    : 1.0 / glm::dot(glm::dvec3(RowOf(seen.ClipFromWorld, 3)), seen.Forward);
  this->RowU = 0.5 * seen.Size.x * perW * (RowOf(clip, 0) + w);
  this->RowV = 0.5 * seen.Size.y * perW * (RowOf(clip, 1) + w);
  this->RowZ = glm::transpose(next.Where.WorldFromIndex) * forward;

  this->Far = seen.Far;

  const glm::dvec2 edges = VoxelEdges(next.Where);
  this->Voxel = edges.y;
  if (!image.Depths.HasSurface)
  {
    MakeSurfaceDepths(image.Picture, seen, image.Depths);
  }
  // Of a raised isovalue only what was outside the old one is known to be free.
  const bool isRaised =
    !(image.Key.Sought == next.Sought) && next.Sought.Mode == SurfaceMode::Crossing;
  if (accuracy == ReuseAccuracy::Bounded || isRaised)
  {
    const GuardOptions options{ edges.y, DepthOfSpacing(seen, FarthestApart * edges.x), isRaised };
    if (!image.Depths.HasGuard || !(image.Depths.Guarded == options))
    {
      MakeGuardDepths(image.Picture, seen, options, image.Depths);
    }
    this->Accuracy = ReuseAccuracy::Bounded;
  }
}

void ImageQuery::Ask(const RayBatch& rays, QueryBatch& known) const
{
  for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
  {
    known.Answers[i] = Answer::DefiniteMiss;
    known.Free[i] = rays.WalkBegin[i];
    known.Pixel[i] = -1;
    if (!(rays.WalkBegin[i] < rays.WalkEnd[i]))
    {
      continue;
    }
    known.Answers[i] = Answer::PossibleHit;
    Path path;
    const PathKind kind = this->Project(rays, i, path);
    if (kind == PathKind::Unknown)
    {
      continue;
    }
    if (this->Accuracy == ReuseAccuracy::Bounded)
    {
      this->FindFreeSpace(path, kind, i, known);
    }
    else
    {
      this->FindHit(path, kind, i, known);
    }
  }
}

/// Project the walk of a ray into the cached image.
/// \return Unknown if its beginning is not in what the image shows; Cut if only its end is not
ImageQuery::PathKind ImageQuery::Project(const RayBatch& rays, std::size_t ray, Path& path) const
{
  const auto along = [&](const glm::dvec4& row, double& begin, double& end)
  {
    const double origin = row.x * rays.Origin[0][ray] + row.y * rays.Origin[1][ray] +
      row.z * rays.Origin[2][ray] + row.w;
    const double per = row.x * rays.Direction[0][ray] + row.y * rays.Direction[1][ray] +
      row.z * rays.Direction[2][ray];
    begin = origin + rays.WalkBegin[ray] * per;
    end = origin + rays.WalkEnd[ray] * per;
  };
  double z0, z1, u0, u1, v0, v1;
  along(this->RowZ, z0, z1);
  if (!(z0 >= this->Near && z0 <= this->Far) || !(z0 > 0.0 || this->IsParallel))
  {
    return PathKind::Unknown;
  }
  along(this->RowU, u0, u1);
  along(this->RowV, v0, v1);
  PathKind kind = PathKind::Whole;
  path.T0 = rays.WalkBegin[ray];
  path.T1 = rays.WalkEnd[ray];
  if (z1 < this->Near || z1 > this->Far)
  {
    // Cut at the clipping plane.
    const double last = z1 < this->Near ? this->Near : this->Far;
    const double share = (last - z0) / (z1 - z0);
    path.T1 = path.T0 + share * (path.T1 - path.T0);
    z1 = last;
    u1 = u0 + share * (u1 - u0);
    v1 = v0 + share * (v1 - v0);
    kind = PathKind::Cut;
  }

  path.IsParallel = this->IsParallel;
  path.Q0 = DisparityOf(z0, this->IsParallel);
  path.Q1 = DisparityOf(z1, this->IsParallel);
  const double scale0 = this->IsParallel ? 1.0 : path.Q0;
  const double scale1 = this->IsParallel ? 1.0 : path.Q1;
  path.U = u0 * scale0;
  path.V = v0 * scale0;
  path.PerU = u1 * scale1 - path.U;
  path.PerV = v1 * scale1 - path.V;
  const glm::dvec2 size(this->Image.Picture.Size);
  if (!(path.U >= 0.0 && path.U < size.x && path.V >= 0.0 && path.V < size.y))
  {
    return PathKind::Unknown;
  }
  path.End = 1.0;
  const double leaveU = ((path.PerU > 0.0 ? size.x : 0.0) - path.U) / path.PerU;
  const double leaveV = ((path.PerV > 0.0 ? size.y : 0.0) - path.V) / path.PerV;
  const double leave =
    std::min(path.PerU != 0.0 ? leaveU : Infinity, path.PerV != 0.0 ? leaveV : Infinity);
  if (leave < 1.0)
  {
    path.End = leave;
    kind = PathKind::Cut;
  }
  return kind;
}

void ImageQuery::FindFreeSpace(
  const Path& path, PathKind kind, std::size_t ray, QueryBatch& known) const
{
  const float* const guard = this->Image.Depths.Guard.data();
  double stop = path.End;
  const bool isStopped = path.Walk(this->Image.Picture.Size,
    [&](std::int32_t pixel, double lambda, double q, double, double qNext)
    {
      const double guarded = static_cast<double>(guard[pixel]);
      if (std::min(q, qNext) > guarded)
      {
        return false;
      }
      stop = q > guarded ? (guarded - path.Q0) / (path.Q1 - path.Q0) : lambda;
      known.Pixel[ray] = pixel;
      return true;
    });
  if (isStopped || kind == PathKind::Cut)
  {
    known.Free[ray] = std::max(known.Free[ray], path.TAt(stop));
  }
  else
  {
    known.Answers[ray] = Answer::DefiniteMiss;
  }
}

void ImageQuery::FindHit(const Path& path, PathKind kind, std::size_t ray, QueryBatch& known) const
{
  const float* const surface = this->Image.Depths.Surface.data();
  double stop = path.End;
  double hit = -1.0;
  double last = std::numeric_limits<double>::quiet_NaN(); // disparity of the predecessor's surface
  const bool isStopped = path.Walk(this->Image.Picture.Size,
    [&](std::int32_t pixel, double lambda, double q, double, double qNext)
    {
      const double here = static_cast<double>(surface[pixel]);
      const bool isFirst = std::isnan(last);
      if (std::min(q, qNext) > here)
      {
        last = here;
        return false;
      }
      const bool isInFront = q > here;
      const double toLast =
        std::abs(DepthOf(last, this->IsParallel) - DepthOf(here, this->IsParallel));
      if (isFirst ? isInFront : toLast <= this->Voxel)
      {
        hit = isInFront ? (here - path.Q0) / (path.Q1 - path.Q0) : lambda;
      }
      stop = lambda;
      known.Pixel[ray] = pixel;
      return true;
    });
  if (hit >= 0.0)
  {
    known.Answers[ray] = Answer::DefiniteHit;
    known.Hit[ray] = path.TAt(hit);
    known.Column[ray] = path.U + hit * path.PerU;
    known.Row[ray] = path.V + hit * path.PerV;
  }
  else if (!isStopped && kind == PathKind::Whole)
  {
    known.Answers[ray] = Answer::DefiniteMiss;
    return;
  }
  known.Free[ray] = std::max(known.Free[ray], path.TAt(stop));
}

void ImageQuery::Interpolate(
  const QueryBatch& known, std::size_t ray, std::size_t pixel, Frame& frame) const
{
  const Frame& image = this->Image.Picture;
  const auto stopped = static_cast<std::size_t>(known.Pixel[ray]);
  frame.Depth[pixel] = known.Hit[ray];
  frame.Isovalues[pixel] = image.Isovalues[stopped];
  frame.Kinds[pixel] = image.Kinds[stopped];
  frame.Answers[pixel] = Answer::DefiniteHit;

  // Between the centres of four pixels, those that show the same surface.
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
  const Frame& frame = this->Image.Picture;
  const int column = pixel % frame.Size.x;
  const int row = pixel / frame.Size.x;
  for (int y = std::max(row - 1, 0); y <= std::min(row + 1, frame.Size.y - 1); ++y)
  {
    for (int x = std::max(column - 1, 0); x <= std::min(column + 1, frame.Size.x - 1); ++x)
    {
      if (frame.Kinds[static_cast<std::size_t>(y * frame.Size.x + x)] == HitKind::Leaves)
      {
        return true;
      }
    }
  }
  return false;
}

}
