// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shader.h"

#include "KernelsShading.h"
#include "SurfaceNormal.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

template <typename T>
using Array = HitList::Array<T>;

constexpr double Pi = 3.14159265358979323846;

/// Share of a voxel by which a nearest-neighbour hit is moved on, from a face between two samples
/// into the box of the sample that the ray enters.
constexpr double IntoNextBox = 1e-2;

constexpr std::array<std::uint8_t, 4> Yellow = { 255, 255, 0, 255 };

void Set(std::array<Array<double>, 3>& vectors, std::size_t i, const glm::dvec3& vector)
{
  vectors[0][i] = vector.x;
  vectors[1][i] = vector.y;
  vectors[2][i] = vector.z;
}

glm::dvec3 At(const std::array<Array<double>, 3>& vectors, std::size_t i)
{
  return { vectors[0][i], vectors[1][i], vectors[2][i] };
}

/// Fill normals of the hits on one isovalue.
void ComputeNormalsOf(
  std::size_t surface, const NormalSource& source, const HitList& hits, Frame& frame)
{
  const glm::dmat4& toIndex = source.Where.IndexFromWorld;
  const glm::dmat3 toIndexDirection(toIndex);
  const bool isNearest = source.Samples.Between == Interpolation::Nearest;
  std::array<Array<double>, 3> points;
  std::array<Array<double>, 3> caps;
  std::array<std::size_t, RayBatch::Capacity> list;
  Array<std::uint8_t> isCap;
  ShadingKernels::FacingNormals normals;
  normals.WorldFromGradient = glm::transpose(toIndexDirection);
  for (std::size_t i = 0; i < static_cast<std::size_t>(hits.Count); ++i)
  {
    const auto pixel = static_cast<std::size_t>(hits.Pixel[i]);
    if (static_cast<std::size_t>(frame.Isovalues[pixel]) != surface)
    {
      continue;
    }
    const std::size_t at = normals.Count++;
    list[at] = pixel;
    glm::dvec3 point(toIndex * glm::dvec4(At(hits.Point, i), 1.0));
    isCap[at] = frame.Kinds[pixel] == HitKind::Cap;
    if (isCap[at])
    {
      Set(caps, at, BoxFaceNormal(point, source.Samples.Dimensions));
    }
    else if (isNearest)
    {
      point += IntoNextBox * glm::normalize(toIndexDirection * At(hits.Direction, i));
    }
    Set(points, at, point);
    Set(normals.Ray, at, At(hits.Direction, i));
  }
  if (normals.Count == 0)
  {
    return;
  }
  IndexGradients(source.Samples, source.FiniteRange, source.Isovalues[surface],
    static_cast<int>(normals.Count), points, normals.Gradient);
  for (std::size_t i = 0; i < normals.Count; ++i)
  {
    if (isCap[i])
    {
      Set(normals.Gradient, i, At(caps, i));
    }
  }
  ShadingKernels::FindFacingNormals(normals);
  for (std::size_t i = 0; i < normals.Count; ++i)
  {
    frame.Normals[list[i]] = { normals.Normal[0][i], normals.Normal[1][i], normals.Normal[2][i] };
  }
}

/// What arrives of a positional light at a point, and the direction it comes from.
double ShareAt(const Light& light, const glm::dvec3& point, glm::dvec3& toLight)
{
  const glm::dvec3 fromLight = point - light.Position;
  const double distance = glm::length(fromLight);
  if (!(distance > 0.0))
  {
    return 0.0;
  }
  toLight = fromLight / -distance;
  const double fading = light.Attenuation.x + light.Attenuation.y * distance +
    light.Attenuation.z * distance * distance;
  double share = fading > 0.0 ? 1.0 / fading : 1.0;
  if (light.ConeAngle <= 90.0)
  {
    const double cosine = glm::dot(fromLight, light.Direction) / distance;
    share *= cosine >= std::cos(light.ConeAngle * Pi / 180.0) && cosine > 0.0
      ? std::pow(cosine, light.Exponent)
      : 0.0;
  }
  return share;
}

/// Add the light that hits reflect.
void AddLight(const Appearance& appearance, const Light& light, const HitList& hits,
  ShadingKernels::PhongSums& sums)
{
  for (std::size_t i = 0; i < sums.Count; ++i)
  {
    glm::dvec3 toLight = -light.Direction;
    sums.Share[i] =
      light.Positional ? static_cast<float>(ShareAt(light, At(hits.Point, i), toLight)) : 1.0f;
    for (std::size_t a = 0; a < 3; ++a)
    {
      sums.ToLight[a][i] = static_cast<float>(toLight[static_cast<int>(a)]);
    }
  }
  for (std::size_t c = 0; c < 3; ++c)
  {
    const auto component = static_cast<int>(c);
    sums.Diffuse[c] = static_cast<float>(appearance.Diffuse * light.Diffuse[component]);
    sums.Specular[c] =
      static_cast<float>(std::max(appearance.Specular, 0.0) * light.Specular[component]);
  }
  sums.Power = appearance.SpecularPower;
  ShadingKernels::AddLight(sums);
}

/// What hits look like without light from anywhere.
void BeginSums(const Appearance& appearance, const HitList& hits, const Frame& frame,
  ShadingKernels::PhongSums& sums)
{
  const auto ambient = static_cast<float>(appearance.Shade ? appearance.Ambient : 1.0);
  sums.Count = static_cast<std::size_t>(hits.Count);
  for (std::size_t i = 0; i < sums.Count; ++i)
  {
    const auto pixel = static_cast<std::size_t>(hits.Pixel[i]);
    const glm::vec3 color(appearance.Colors[static_cast<std::size_t>(frame.Isovalues[pixel])]);
    for (std::size_t a = 0; a < 3; ++a)
    {
      const auto axis = static_cast<int>(a);
      sums.Normal[a][i] = frame.Normals[pixel][axis];
      sums.Ray[a][i] = static_cast<float>(hits.Direction[a][i]);
      sums.Color[a][i] = color[axis];
      sums.Sum[a][i] = ambient * color[axis];
    }
  }
}

}

void GatherHits(
  const View& view, const PixelRect& part, bool withDefiniteHits, Frame& frame, HitList& hits)
{
  ShadingKernels::RayPoints points;
  for (int row = part.First.y; row < part.First.y + part.Size.y; ++row)
  {
    for (int column = part.First.x; column < part.First.x + part.Size.x; ++column)
    {
      const int pixel = row * frame.Size.x + column;
      const auto p = static_cast<std::size_t>(pixel);
      if (frame.Isovalues[p] == Frame::NoSurface)
      {
        frame.Normals[p] = glm::vec3(0.0f);
        frame.Colors[p] = { 0, 0, 0, 0 };
      }
      else if (withDefiniteHits || frame.Answers[p] != Answer::DefiniteHit)
      {
        const glm::dvec2 centre = view.PixelCentre(column, row);
        points.X[points.Count] = centre.x;
        points.Y[points.Count] = centre.y;
        points.T[points.Count] = frame.Depth[p];
        hits.Pixel[points.Count++] = pixel;
      }
    }
  }
  hits.Count = static_cast<int>(points.Count);
  if (points.Count > 0)
  {
    points.LinearDirection = { view.Direction, view.DirectionX, view.DirectionY };
    points.LinearOrigin = { view.Origin, view.OriginX, view.OriginY };
    ShadingKernels::FindRayPoints(points);
    hits.Direction = points.Direction;
    hits.Point = points.Point;
  }
}

void ComputeNormals(const NormalSource& source, const HitList& hits, Frame& frame)
{
  for (std::size_t surface = 0; surface < source.Isovalues.size() && hits.Count > 0; ++surface)
  {
    ComputeNormalsOf(surface, source, hits, frame);
  }
}

void ShadeHits(const Appearance& appearance, const HitList& hits, Frame& frame)
{
  if (hits.Count == 0)
  {
    return;
  }
  ShadingKernels::PhongSums sums;
  BeginSums(appearance, hits, frame, sums);
  if (appearance.Shade)
  {
    for (const Light& light : appearance.Lights)
    {
      AddLight(appearance, light, hits, sums);
    }
  }
  std::array<Array<std::uint8_t>, 3> bytes;
  ShadingKernels::RoundColors(sums, bytes);
  const bool isByAnswer = appearance.ColorByAnswer && frame.IsFromCache;
  for (std::size_t i = 0; i < sums.Count; ++i)
  {
    const auto pixel = static_cast<std::size_t>(hits.Pixel[i]);
    frame.Colors[pixel] = { bytes[0][i], bytes[1][i], bytes[2][i], 255 };
    if (isByAnswer && frame.Answers[pixel] == Answer::PossibleHit)
    {
      frame.Colors[pixel] = Yellow;
    }
  }
}

}
