// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/Shader.h"

#include "Lattice/RegionClipper.h"
#include "Shade/CapNormal.h"
#include "Shade/HitColors.h"
#include "Shade/SurfaceNormal.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace TemporalCoherence
{
namespace
{

template <typename T>
using Array = HitList::Array<T>;

constexpr double Pi = 3.14159265358979323846;

constexpr std::array<std::uint8_t, 4> Yellow = { 255, 255, 0, 255 };

void Set(std::array<Array<double>, 3>& vectors, std::size_t i, const glm::dvec3& vector)
{
  vectors[0][i] = vector.x;
  vectors[1][i] = vector.y;
  vectors[2][i] = vector.z;
}

/// On caps, replace the gradient by the normal of the plane that clips the solid.
void TakeFacesAtCaps(
  const NormalSource& source, const HitList& hits, std::array<Array<double>, 3>& gradients)
{
  const auto end = hits.Kind.begin() + static_cast<std::ptrdiff_t>(hits.Rays.Count);
  if (std::find(hits.Kind.begin(), end, HitKind::Cap) == end)
  {
    return;
  }
  for (std::size_t i = 0; i < hits.Rays.Count; ++i)
  {
    if (hits.Kind[i] == HitKind::Cap)
    {
      const glm::dmat4& toIndex = source.Transform.IndexFromWorld;
      const CapPoint cap{ glm::dvec3(toIndex * glm::dvec4(hits.Rays.PointAt(i), 1.0)),
        glm::dvec3(toIndex * glm::dvec4(hits.Rays.DirectionAt(i), 0.0)), hits.Cell[i] };
      Set(gradients, i, CapNormal(cap, source.Samples, source.Normals, source.Planes));
    }
  }
}

/// The share of a positional light that arrives at a point, and the direction it comes from.
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
  if (light.ConeAngle < 90.0)
  {
    const double cosine = glm::dot(fromLight, light.Direction) / distance;
    share *= cosine >= std::cos(light.ConeAngle * Pi / 180.0) && cosine > 0.0
      ? std::pow(cosine, light.Exponent)
      : 0.0;
  }
  return share;
}

/// The largest share of a light. It keeps the sums far within the range of floats, however near the
/// light is to a surface.
double LargestShare(const ShadingKernels::PhongSums& sums)
{
  constexpr double LargestTerm = 1e30;
  float brightest = 1.0f;
  for (std::size_t c = 0; c < 3; ++c)
  {
    brightest = std::max({ brightest, std::abs(sums.Diffuse[c]), std::abs(sums.Specular[c]) });
  }
  return LargestTerm / static_cast<double>(brightest);
}

/// Add the light that hits reflect.
/// \param arriving the share that other surfaces let through; null: all of it
void AddLight(const Appearance& appearance, const Light& light, const HitList& hits,
  const Array<float>* arriving, ShadingKernels::PhongSums& sums)
{
  sums.IsPositional = light.Positional;
  sums.HasShares = light.Positional || arriving;
  for (std::size_t c = 0; c < 3; ++c)
  {
    const auto component = static_cast<int>(c);
    sums.Toward[c] = static_cast<float>(-light.Direction[component]);
    sums.Diffuse[c] = static_cast<float>(appearance.Diffuse * light.Diffuse[component]);
    sums.Specular[c] =
      static_cast<float>(std::max(appearance.Specular, 0.0) * light.Specular[component]);
  }
  const double most = LargestShare(sums);
  for (std::size_t i = 0; i < sums.Count && light.Positional; ++i)
  {
    glm::dvec3 toLight = -light.Direction;
    const double share = ShareAt(light, hits.Rays.PointAt(i), toLight);
    sums.Share[i] = static_cast<float>(std::min(share, most));
    for (std::size_t a = 0; a < 3; ++a)
    {
      sums.ToLight[a][i] = static_cast<float>(toLight[static_cast<int>(a)]);
    }
  }
  if (light.Positional)
  {
    FillLastVector(sums.Count, sums.Share);
    for (std::size_t a = 0; a < 3; ++a)
    {
      FillLastVector(sums.Count, sums.ToLight[a]);
    }
  }
  for (std::size_t i = 0; arriving && i < WholeVectors(sums.Count); ++i)
  {
    sums.Share[i] = (light.Positional ? sums.Share[i] : 1.0f) * (*arriving)[i];
  }
  sums.Power = appearance.SpecularPower;
  ShadingKernels::AddLight(hits.Rays, sums);
}

/// Turn the normals of surfaces seen from inside to the outside.
void TurnOutside(const HitList& hits, ShadingKernels::PhongSums& sums)
{
  for (std::size_t i = 0; i < sums.Count; ++i)
  {
    if (hits.Kind[i] == HitKind::Exit)
    {
      for (float& component : sums.Normal[i])
      {
        component = -component;
      }
    }
  }
}

/// Colours of hits without any light.
void BeginSums(const Appearance& appearance, const HitList& hits, const Array<float>* arriving,
  ShadingKernels::PhongSums& sums)
{
  const auto ambient = static_cast<float>(appearance.Shade ? appearance.Ambient : 1.0);
  sums.Count = hits.Rays.Count;
  std::copy_n(hits.Normal.begin(), sums.Count, sums.Normal.begin());
  if (!appearance.TwoSided)
  {
    TurnOutside(hits, sums);
  }
  FillLastVector(sums.Count, sums.Normal);
  FindHitColors(appearance, hits, sums.Color);
  for (std::size_t a = 0; a < 3; ++a)
  {
    for (std::size_t i = 0; arriving && i < WholeVectors(sums.Count); ++i)
    {
      sums.Color[a][i] *= (*arriving)[i];
    }
    for (std::size_t i = 0; i < WholeVectors(sums.Count); ++i)
    {
      sums.Sum[a][i] = ambient * sums.Color[a][i];
    }
  }
}

/// True if one light from afar shines, as a headlight does.
bool IsLitSimply(const Appearance& appearance)
{
  return appearance.Shade && appearance.TwoSided && appearance.Lights.size() == 1 &&
    !appearance.Lights[0].Positional && appearance.ColorScale == 1.0 &&
    appearance.ColorShift == 0.0;
}

/// The light, with the numbers of BeginSums and AddLight.
ShadingKernels::SimpleLight LightOf(const Appearance& appearance)
{
  const Light& light = appearance.Lights[0];
  ShadingKernels::SimpleLight simple;
  simple.Ambient = static_cast<float>(appearance.Ambient);
  for (std::size_t c = 0; c < 3; ++c)
  {
    const auto component = static_cast<int>(c);
    simple.Toward[c] = static_cast<float>(-light.Direction[component]);
    simple.Diffuse[c] = static_cast<float>(appearance.Diffuse * light.Diffuse[component]);
    simple.Specular[c] =
      static_cast<float>(std::max(appearance.Specular, 0.0) * light.Specular[component]);
  }
  simple.Power = appearance.SpecularPower;
  return simple;
}

/// Store a value of each hit in a plane.
template <typename From, typename To>
void StoreToPlane(const HitList& hits, const Array<From>& values, Plane<To>& plane)
{
  static_assert(sizeof(From) == sizeof(To));
  for (std::size_t i = 0; i < hits.Rays.Count;)
  {
    // Most rows are full. Pixels ascend.
    const auto pixel = static_cast<std::size_t>(hits.Pixel[i]);
    const bool isRow = i + TileSize <= hits.Rays.Count &&
      hits.Pixel[i + TileSize - 1] == hits.Pixel[i] + TileSize - 1;
    if (isRow)
    {
      std::memcpy(&plane[pixel], &values[i], TileSize * sizeof(To));
      i += TileSize;
    }
    else
    {
      std::memcpy(&plane[pixel], &values[i], sizeof(To));
      ++i;
    }
  }
}

/// Apply scale and shift to colours.
void ScaleSums(const Appearance& appearance, ShadingKernels::PhongSums& sums)
{
  const auto scale = static_cast<float>(appearance.ColorScale);
  const auto shift = static_cast<float>(appearance.ColorShift);
  for (Array<float>& channel : sums.Sum)
  {
    std::transform(channel.begin(),
      channel.begin() + static_cast<std::ptrdiff_t>(WholeVectors(sums.Count)), channel.begin(),
      [=](float sum) { return scale * sum + shift; });
  }
}

}

NormalSource NormalSourceOf(
  const FrameKey& key, const FieldNormals& normals, const glm::dvec2& finiteRange)
{
  const RegionClipper clipper(key.Region, key.Transform);
  return { key.Samples, normals, key.Transform,
    CapPlanes(clipper.Planes(), key.Transform, key.View), key.Isosurfaces().Isovalues,
    finiteRange };
}

void ComputeNormals(
  const NormalSource& source, HitList& hits, std::array<Array<double>, 3>* gradientsFound)
{
  if (hits.Rays.Count == 0)
  {
    return;
  }
  std::array<Array<double>, 3> gradients;
  source.Normals.FindGradients(
    { source.Samples, source.Transform.IndexFromWorld, source.FiniteRange, &source.Isovalues },
    { hits.Rays, hits.Surface, gradients, &hits.Cell, hits.Gradients, &hits.Kind });
  if (gradientsFound)
  {
    *gradientsFound = gradients;
  }
  TakeFacesAtCaps(source, hits, gradients);
  const glm::dmat3 worldFromGradient = glm::transpose(glm::dmat3(source.Transform.IndexFromWorld));
  ShadingKernels::FindFacingNormals(hits.Rays, worldFromGradient, gradients, hits.Normal);
  FillLastVector(hits.Rays.Count, hits.Normal);
}

void StoreNormals(const HitList& hits, Frame& frame)
{
  StoreToPlane(hits, hits.Normal, frame.Normals);
}

void LoadNormals(const Frame& frame, HitList& hits)
{
  for (std::size_t i = 0; i < hits.Rays.Count; ++i)
  {
    const glm::vec3& normal = frame.Normals[static_cast<std::size_t>(hits.Pixel[i])];
    hits.Normal[i] = { normal.x, normal.y, normal.z };
  }
  if (hits.Rays.Count > 0)
  {
    FillLastVector(hits.Rays.Count, hits.Normal);
  }
}

void SumLight(const Appearance& appearance, const HitList& hits, const ArrivingLight* arriving,
  ShadingKernels::PhongSums& sums)
{
  BeginSums(appearance, hits, arriving ? &arriving->FromAllSides : nullptr, sums);
  for (std::size_t i = 0; appearance.Shade && i < appearance.Lights.size(); ++i)
  {
    const bool isShadowed = arriving && !arriving->OfLights.empty();
    AddLight(
      appearance, appearance.Lights[i], hits, isShadowed ? &arriving->OfLights[i] : nullptr, sums);
  }
  if (appearance.ColorScale != 1.0 || appearance.ColorShift != 0.0)
  {
    ScaleSums(appearance, sums);
  }
}

void ShadeHits(
  const Appearance& appearance, const HitList& hits, const ArrivingLight* arriving, Frame& frame)
{
  if (hits.Rays.Count == 0)
  {
    return;
  }
  Array<std::array<std::uint8_t, 4>> colors;
  if (!arriving && IsLitSimply(appearance))
  {
    std::array<Array<float>, 3> own;
    FindHitColors(appearance, hits, own);
    ShadingKernels::FindColors(hits.Rays, hits.Normal, own, LightOf(appearance), colors);
  }
  else
  {
    ShadingKernels::PhongSums sums;
    SumLight(appearance, hits, arriving, sums);
    ShadingKernels::RoundColors(sums, colors);
  }
  StoreToPlane(hits, colors, frame.Colors);
  PaintAnswers(appearance, hits, frame);
}

void PaintAnswers(const Appearance& appearance, const HitList& hits, Frame& frame)
{
  if (!appearance.ColorByAnswer || !frame.IsFromCache)
  {
    return;
  }
  for (std::size_t i = 0; i < hits.Rays.Count; ++i)
  {
    const auto pixel = static_cast<std::size_t>(hits.Pixel[i]);
    // If all layers are too faint to be visible, there is nothing to paint.
    if (frame.Answers[pixel] == Answer::PossibleHit && frame.Isovalues[pixel] != Frame::NoSurface)
    {
      frame.Colors[pixel] = Yellow;
    }
  }
}

}
