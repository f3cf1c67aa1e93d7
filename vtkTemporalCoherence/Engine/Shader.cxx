// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shader.h"

#include "SurfaceNormal.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

constexpr double Pi = 3.14159265358979323846;

/// Share of a voxel by which a nearest-neighbour hit is moved on, from a face between two samples
/// into the box of the sample that the ray enters.
constexpr double IntoNextBox = 1e-2;

/// Unit normal of a hit, facing the viewer. Where the field has no gradient the surface is taken to
/// face the viewer.
glm::vec3 FacingNormal(
  const glm::dmat3& worldFromGradient, const glm::dvec3& gradient, const glm::dvec3& ray)
{
  const double largest =
    std::max(std::abs(gradient.x), std::max(std::abs(gradient.y), std::abs(gradient.z)));
  if (!(largest > 0.0))
  {
    return glm::vec3(-ray);
  }
  // Scaled first: squares of very small or large components would leave the range of numbers.
  const glm::dvec3 normal = glm::normalize(worldFromGradient * (gradient / largest));
  return glm::vec3(glm::dot(normal, ray) > 0.0 ? -normal : normal);
}

glm::dvec3 Reflect(const glm::dvec3& toLight, const glm::dvec3& normal, double cosine)
{
  return 2.0 * cosine * normal - toLight;
}

/// Light that reaches a point: direction to the light, and the share that arrives.
glm::dvec3 DirectionToLight(const Light& light, const glm::dvec3& point, double& share)
{
  share = 1.0;
  if (!light.Positional)
  {
    return -light.Direction;
  }
  const glm::dvec3 fromLight = point - light.Position;
  const double distance = glm::length(fromLight);
  if (!(distance > 0.0))
  {
    share = 0.0;
    return -light.Direction;
  }
  const double fading = light.Attenuation.x + light.Attenuation.y * distance +
    light.Attenuation.z * distance * distance;
  share = fading > 0.0 ? 1.0 / fading : 1.0;
  if (light.ConeAngle <= 90.0)
  {
    const double cosine = glm::dot(fromLight, light.Direction) / distance;
    share *= cosine >= std::cos(light.ConeAngle * Pi / 180.0) && cosine > 0.0
      ? std::pow(cosine, light.Exponent)
      : 0.0;
  }
  return fromLight / -distance;
}

glm::dvec3 Phong(const Appearance& appearance, const glm::dvec3& color, const glm::dvec3& point,
  const glm::dvec3& normal, const glm::dvec3& ray)
{
  glm::dvec3 sum = appearance.Ambient * color;
  for (const Light& light : appearance.Lights)
  {
    double share;
    const glm::dvec3 toLight = DirectionToLight(light, point, share);
    const double cosine = glm::dot(normal, toLight);
    if (!(cosine > 0.0) || !(share > 0.0))
    {
      continue;
    }
    sum += appearance.Diffuse * share * cosine * light.Diffuse * color;
    const double mirrored = glm::dot(Reflect(toLight, normal, cosine), -ray);
    if (mirrored > 0.0 && appearance.Specular > 0.0)
    {
      sum +=
        appearance.Specular * share * std::pow(mirrored, appearance.SpecularPower) * light.Specular;
    }
  }
  return sum;
}

std::array<std::uint8_t, 4> OpaqueColor(const glm::dvec3& color)
{
  const glm::dvec3 scaled = glm::clamp(color, 0.0, 1.0) * 255.0 + 0.5;
  return { static_cast<std::uint8_t>(scaled.x), static_cast<std::uint8_t>(scaled.y),
    static_cast<std::uint8_t>(scaled.z), 255 };
}

std::size_t PixelAt(const Frame& frame, int x, int y)
{
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.Size.x) +
    static_cast<std::size_t>(x);
}

}

void ComputeNormals(
  const NormalSource& source, const View& view, const PixelRect& part, Frame& frame)
{
  const glm::dmat4& toIndex = source.Where.IndexFromWorld;
  const glm::dmat3 toIndexDirection(toIndex);
  const glm::dmat3 worldFromGradient = glm::transpose(toIndexDirection);
  for (int y = part.First.y; y < part.First.y + part.Size.y; ++y)
  {
    for (int x = part.First.x; x < part.First.x + part.Size.x; ++x)
    {
      const std::size_t pixel = PixelAt(frame, x, y);
      const std::int16_t surface = frame.Isovalues[pixel];
      if (surface == Frame::NoSurface)
      {
        frame.Normals[pixel] = glm::vec3(0.0f);
        continue;
      }
      const Ray ray = view.RayThrough(x, y);
      const glm::dvec3 world = ray.Origin + frame.Depth[pixel] * ray.Direction;
      glm::dvec3 point(toIndex * glm::dvec4(world, 1.0));
      glm::dvec3 gradient;
      if (frame.Caps[pixel])
      {
        gradient = BoxFaceNormal(point, source.Samples.Dimensions);
      }
      else
      {
        if (source.Samples.Between == Interpolation::Nearest)
        {
          point += IntoNextBox * glm::normalize(toIndexDirection * ray.Direction);
        }
        IndexGradients(source.Samples, source.FiniteRange,
          source.Isovalues[static_cast<std::size_t>(surface)], 1, &point, &gradient);
      }
      frame.Normals[pixel] = FacingNormal(worldFromGradient, gradient, ray.Direction);
    }
  }
}

void ShadePixels(
  const Appearance& appearance, const View& view, const PixelRect& part, Frame& frame)
{
  for (int y = part.First.y; y < part.First.y + part.Size.y; ++y)
  {
    for (int x = part.First.x; x < part.First.x + part.Size.x; ++x)
    {
      const std::size_t pixel = PixelAt(frame, x, y);
      const std::int16_t surface = frame.Isovalues[pixel];
      if (surface == Frame::NoSurface)
      {
        frame.Colors[pixel] = { 0, 0, 0, 0 };
        continue;
      }
      glm::dvec3 color = appearance.Colors[static_cast<std::size_t>(surface)];
      if (appearance.Shade)
      {
        const Ray ray = view.RayThrough(x, y);
        const glm::dvec3 point = ray.Origin + frame.Depth[pixel] * ray.Direction;
        color = Phong(appearance, color, point, glm::dvec3(frame.Normals[pixel]), ray.Direction);
      }
      frame.Colors[pixel] = OpaqueColor(color);
    }
  }
}

}
