// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shader.h"

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

glm::dvec3 At(const std::array<Array<double>, 3>& vectors, std::size_t i)
{
  return { vectors[0][i], vectors[1][i], vectors[2][i] };
}

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

/// Fill normals of the hits on one isovalue.
void ComputeNormalsOf(
  std::size_t surface, const NormalSource& source, const HitList& hits, Frame& frame)
{
  const glm::dmat4& toIndex = source.Where.IndexFromWorld;
  const glm::dmat3 toIndexDirection(toIndex);
  const glm::dmat3 worldFromGradient = glm::transpose(toIndexDirection);
  std::array<glm::dvec3, RayBatch::Capacity> points{}, gradients{};
  std::array<std::size_t, RayBatch::Capacity> list;
  std::size_t count = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(hits.Count); ++i)
  {
    const auto pixel = static_cast<std::size_t>(hits.Pixel[i]);
    if (static_cast<std::size_t>(frame.Isovalues[pixel]) != surface)
    {
      continue;
    }
    glm::dvec3 point(toIndex * glm::dvec4(At(hits.Point, i), 1.0));
    if (frame.Kinds[pixel] == HitKind::Cap)
    {
      const glm::dvec3 normal = BoxFaceNormal(point, source.Samples.Dimensions);
      frame.Normals[pixel] = FacingNormal(worldFromGradient, normal, At(hits.Direction, i));
      continue;
    }
    if (source.Samples.Between == Interpolation::Nearest)
    {
      point += IntoNextBox * glm::normalize(toIndexDirection * At(hits.Direction, i));
    }
    points[count] = point;
    list[count++] = i;
  }
  IndexGradients(source.Samples, source.FiniteRange, source.Isovalues[surface],
    static_cast<int>(count), points.data(), gradients.data());
  for (std::size_t j = 0; j < count; ++j)
  {
    const auto pixel = static_cast<std::size_t>(hits.Pixel[list[j]]);
    frame.Normals[pixel] =
      FacingNormal(worldFromGradient, gradients[j], At(hits.Direction, list[j]));
  }
}

/// Light as it arrives at the hits: directions to the light, and the share that arrives.
struct IncidentLight
{
  IncidentLight(const Light& light, const HitList& hits)
  {
    for (std::size_t i = 0; i < static_cast<std::size_t>(hits.Count); ++i)
    {
      glm::dvec3 toLight = -light.Direction;
      this->Share[i] =
        light.Positional ? static_cast<float>(ShareAt(light, At(hits.Point, i), toLight)) : 1.0f;
      for (int axis = 0; axis < 3; ++axis)
      {
        this->ToLight[static_cast<std::size_t>(axis)][i] = static_cast<float>(toLight[axis]);
      }
    }
  }

  /// What arrives of a positional light at a point, and the direction it comes from.
  static double ShareAt(const Light& light, const glm::dvec3& point, glm::dvec3& toLight)
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

  std::array<Array<float>, 3> ToLight;
  Array<float> Share;
};

/// Raise numbers in [0, 1] to a power.
void Raise(double power, std::size_t count, Array<float>& values)
{
  constexpr double LargestWhole = 1024.0;
  if (power != std::floor(power) || power < 1.0 || power > LargestWhole)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      values[i] = std::pow(values[i], static_cast<float>(power));
    }
    return;
  }
  Array<float> result;
  std::fill_n(result.begin(), count, 1.0f);
  for (int whole = static_cast<int>(power); whole > 0; whole >>= 1)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      result[i] *= whole & 1 ? values[i] : 1.0f;
      values[i] *= values[i];
    }
  }
  values = result;
}

/// Sums of light over the hits of a tile.
class PhongSum
{
public:
  PhongSum(const Appearance& appearance, const HitList& hits, const Frame& frame)
    : Look(appearance)
    , Count(static_cast<std::size_t>(hits.Count))
  {
    const auto ambient = static_cast<float>(appearance.Ambient);
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      const auto pixel = static_cast<std::size_t>(hits.Pixel[i]);
      const glm::vec3 color(appearance.Colors[static_cast<std::size_t>(frame.Isovalues[pixel])]);
      for (std::size_t c = 0; c < 3; ++c)
      {
        const auto component = static_cast<int>(c);
        this->Normal[c][i] = frame.Normals[pixel][component];
        this->Ray[c][i] = static_cast<float>(hits.Direction[c][i]);
        this->Color[c][i] = color[component];
        this->Sum[c][i] = appearance.Shade ? ambient * color[component] : color[component];
      }
    }
  }

  void Add(const Light& light, const IncidentLight& incident)
  {
    const auto& n = this->Normal;
    const auto& l = incident.ToLight;
    Array<float> cosine, mirrored;
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      const float c = n[0][i] * l[0][i] + n[1][i] * l[1][i] + n[2][i] * l[2][i];
      cosine[i] = c > 0.0f ? c : 0.0f;
      float m = 0.0f;
      for (std::size_t a = 0; a < 3; ++a)
      {
        m -= (2.0f * c * n[a][i] - l[a][i]) * this->Ray[a][i];
      }
      mirrored[i] = c > 0.0f && m > 0.0f ? std::min(m, 1.0f) : 0.0f;
    }
    const bool isSpecular = this->Look.Specular > 0.0;
    if (isSpecular)
    {
      // 0 to the power of 0 is 1, but what is not lit does not shine.
      const Array<float> lit = mirrored;
      Raise(this->Look.SpecularPower, this->Count, mirrored);
      for (std::size_t i = 0; i < this->Count; ++i)
      {
        mirrored[i] = lit[i] > 0.0f ? mirrored[i] : 0.0f;
      }
    }
    for (std::size_t c = 0; c < 3; ++c)
    {
      const auto component = static_cast<int>(c);
      const auto diffuse = static_cast<float>(this->Look.Diffuse * light.Diffuse[component]);
      const auto specular =
        isSpecular ? static_cast<float>(this->Look.Specular * light.Specular[component]) : 0.0f;
      for (std::size_t i = 0; i < this->Count; ++i)
      {
        this->Sum[c][i] +=
          incident.Share[i] * (diffuse * cosine[i] * this->Color[c][i] + specular * mirrored[i]);
      }
    }
  }

  /// The colour of a hit in bytes.
  std::array<std::uint8_t, 4> ColorAt(std::size_t i) const
  {
    const auto byte = [](float value)
    { return static_cast<std::uint8_t>(std::min(std::max(value, 0.0f), 1.0f) * 255.0f + 0.5f); };
    return { byte(this->Sum[0][i]), byte(this->Sum[1][i]), byte(this->Sum[2][i]), 255 };
  }

private:
  const Appearance& Look;
  std::size_t Count;
  std::array<Array<float>, 3> Normal, Ray, Color, Sum;
};

}

void GatherHits(
  const View& view, const PixelRect& part, bool withDefiniteHits, Frame& frame, HitList& hits)
{
  std::size_t count = 0;
  Array<double> x, y;
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
        x[count] = centre.x;
        y[count] = centre.y;
        hits.Pixel[count++] = pixel;
      }
    }
  }
  hits.Count = static_cast<int>(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const double t = frame.Depth[static_cast<std::size_t>(hits.Pixel[i])];
    double direction[3];
    double square = 0.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      direction[axis] =
        view.Direction[axis] + x[i] * view.DirectionX[axis] + y[i] * view.DirectionY[axis];
      square += direction[axis] * direction[axis];
    }
    const double perLength = 1.0 / std::sqrt(square);
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto a = static_cast<std::size_t>(axis);
      const double origin =
        view.Origin[axis] + x[i] * view.OriginX[axis] + y[i] * view.OriginY[axis];
      hits.Direction[a][i] = direction[axis] * perLength;
      hits.Point[a][i] = origin + t * hits.Direction[a][i];
    }
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
  PhongSum sum(appearance, hits, frame);
  if (appearance.Shade)
  {
    for (const Light& light : appearance.Lights)
    {
      sum.Add(light, IncidentLight(light, hits));
    }
  }
  const bool isByAnswer = appearance.ColorByAnswer && frame.IsFromCache;
  for (std::size_t i = 0; i < static_cast<std::size_t>(hits.Count); ++i)
  {
    const auto pixel = static_cast<std::size_t>(hits.Pixel[i]);
    frame.Colors[pixel] =
      isByAnswer && frame.Answers[pixel] == Answer::PossibleHit ? Yellow : sum.ColorAt(i);
  }
}

}
