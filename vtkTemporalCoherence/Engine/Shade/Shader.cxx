// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shade/Shader.h"

#include "Shade/CapNormal.h"
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

glm::dvec3 At(const std::array<Array<double>, 3>& vectors, std::size_t i)
{
  return { vectors[0][i], vectors[1][i], vectors[2][i] };
}

/// On caps, replace the gradient by the normal of the plane that clips the solid.
void TakeFacesAtCaps(
  const NormalSource& source, const HitList& hits, std::array<Array<double>, 3>& gradients)
{
  for (std::size_t i = 0; i < hits.Rays.Count; ++i)
  {
    if (hits.Kind[i] == HitKind::Cap)
    {
      const glm::dvec3 point(
        source.Transform.IndexFromWorld * glm::dvec4(At(hits.Rays.Point, i), 1.0));
      const glm::dvec3 direction(
        source.Transform.IndexFromWorld * glm::dvec4(At(hits.Rays.Direction, i), 0.0));
      Set(gradients, i, CapNormal(point, direction, source.Samples, source.CapPlanes));
    }
  }
}

/// Repeat the last element up to the end of the last vector, so that no lane is uninitialised.
template <typename T>
void FillLastVector(std::size_t count, Array<T>& array)
{
  std::fill(array.begin() + static_cast<std::ptrdiff_t>(count),
    array.begin() + static_cast<std::ptrdiff_t>(WholeVectors(count)), array[count - 1]);
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
void AddLight(const Appearance& appearance, const Light& light, const HitList& hits,
  ShadingKernels::PhongSums& sums)
{
  sums.IsPositional = light.Positional;
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
    const double share = ShareAt(light, At(hits.Rays.Point, i), toLight);
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
void BeginSums(const Appearance& appearance, const HitList& hits, ShadingKernels::PhongSums& sums)
{
  const auto ambient = static_cast<float>(appearance.Shade ? appearance.Ambient : 1.0);
  sums.Count = hits.Rays.Count;
  std::copy_n(hits.Normal.begin(), sums.Count, sums.Normal.begin());
  if (!appearance.TwoSided)
  {
    TurnOutside(hits, sums);
  }
  FillLastVector(sums.Count, sums.Normal);
  for (std::size_t a = 0; a < 3; ++a)
  {
    const auto axis = static_cast<int>(a);
    if (appearance.Colors.size() == 1)
    {
      std::fill_n(sums.Color[a].begin(), WholeVectors(sums.Count),
        static_cast<float>(appearance.Colors[0][axis]));
    }
    else
    {
      for (std::size_t i = 0; i < sums.Count; ++i)
      {
        const glm::dvec3& color = appearance.Colors[static_cast<std::size_t>(hits.Surface[i])];
        sums.Color[a][i] = static_cast<float>(color[axis]);
      }
      FillLastVector(sums.Count, sums.Color[a]);
    }
    for (std::size_t i = 0; i < WholeVectors(sums.Count); ++i)
    {
      sums.Sum[a][i] = ambient * sums.Color[a][i];
    }
  }
}

/// True if one light from afar shines on one colour, as a headlight does.
bool IsLitSimply(const Appearance& appearance)
{
  return appearance.Shade && appearance.TwoSided && appearance.Colors.size() == 1 &&
    appearance.Lights.size() == 1 && !appearance.Lights[0].Positional &&
    appearance.ColorScale == 1.0 && appearance.ColorShift == 0.0;
}

/// The numbers that BeginSums and AddLight would work with.
ShadingKernels::SimpleLight LightOf(const Appearance& appearance)
{
  const Light& light = appearance.Lights[0];
  const auto ambient = static_cast<float>(appearance.Ambient);
  ShadingKernels::SimpleLight simple;
  for (std::size_t c = 0; c < 3; ++c)
  {
    const auto component = static_cast<int>(c);
    simple.Color[c] = static_cast<float>(appearance.Colors[0][component]);
    simple.Ambient[c] = ambient * simple.Color[c];
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

/// Normalised device coordinates of the columns and rows of a part of the picture.
struct PixelCentres
{
  PixelCentres(const View& view, const PixelRect& part)
  {
    for (int column = 0; column < part.Size.x; ++column)
    {
      this->X[static_cast<std::size_t>(column)] = view.PixelCentre(part.First.x + column, 0).x;
    }
    for (int row = 0; row < part.Size.y; ++row)
    {
      this->Y[static_cast<std::size_t>(row)] = view.PixelCentre(0, part.First.y + row).y;
    }
  }

  Array<double> X, Y;
};

/// Sorts the pixels of a part of the picture into hits and misses, row by row.
class PixelSorter
{
public:
  PixelSorter(bool withDefiniteHits, Frame& frame, HitList& hits)
    : WithDefiniteHits(withDefiniteHits)
    , Planes(frame)
    , Hits(hits)
  {
    hits.Rays.Count = 0;
  }

  /// Sort the pixels [first, first + count) of a row.
  void Sort(std::size_t first, std::size_t count, const double* x, double y)
  {
    const std::int16_t* const surfaces = &this->Planes.Isovalues[first];
    if (count == TileSize && this->WithDefiniteHits)
    {
      // Most rows are full or empty.
      int hitCount = 0;
      for (std::size_t i = 0; i < TileSize; ++i)
      {
        hitCount += surfaces[i] != Frame::NoSurface ? 1 : 0;
      }
      if (hitCount == TileSize)
      {
        this->TakeRow(first, x, y);
        return;
      }
      if (hitCount == 0)
      {
        std::fill_n(&this->Planes.Normals[first], TileSize, glm::vec3(0.0f));
        std::fill_n(&this->Planes.Colors[first], TileSize, NoColor);
        return;
      }
    }
    this->SortRow(first, count, x, y);
  }

private:
  static constexpr std::array<std::uint8_t, 4> NoColor = { 0, 0, 0, 0 };

  /// Take a row of hits.
  void TakeRow(std::size_t first, const double* x, double y)
  {
    const std::size_t at = this->Hits.Rays.Count;
    // Field by field: the compiler does not know that none of them lies in another.
    for (std::size_t i = 0; i < TileSize; ++i)
    {
      this->Hits.Pixel[at + i] = static_cast<std::int32_t>(first + i);
    }
    std::copy_n(&this->Planes.Isovalues[first], TileSize, &this->Hits.Surface[at]);
    std::copy_n(&this->Planes.Kinds[first], TileSize, &this->Hits.Kind[at]);
    std::copy_n(x, TileSize, &this->Hits.Rays.X[at]);
    std::fill_n(&this->Hits.Rays.Y[at], TileSize, y);
    std::copy_n(&this->Planes.Depth[first], TileSize, &this->Hits.Rays.T[at]);
    this->Hits.Rays.Count = at + TileSize;
  }

  /// Sort a row of hits and misses.
  void SortRow(std::size_t first, std::size_t count, const double* x, double y)
  {
    Array<std::size_t> misses;
    std::size_t hitCount = this->Hits.Rays.Count, missCount = 0;
    for (std::size_t i = 0; i < count; ++i)
    {
      // Without branches, which would be mispredicted at silhouettes: every pixel is written to the
      // end of both lists, and at most one of them grows.
      const std::size_t pixel = first + i;
      const bool isMiss = this->Planes.Isovalues[pixel] == Frame::NoSurface;
      const bool isKnown =
        !this->WithDefiniteHits && this->Planes.Answers[pixel] == Answer::DefiniteHit;
      this->Hits.Pixel[hitCount] = static_cast<std::int32_t>(pixel);
      this->Hits.Surface[hitCount] = this->Planes.Isovalues[pixel];
      this->Hits.Kind[hitCount] = this->Planes.Kinds[pixel];
      this->Hits.Rays.X[hitCount] = x[i];
      this->Hits.Rays.Y[hitCount] = y;
      this->Hits.Rays.T[hitCount] = this->Planes.Depth[pixel];
      misses[missCount] = pixel;
      hitCount += isMiss || isKnown ? 0 : 1;
      missCount += isMiss ? 1 : 0;
    }
    this->Hits.Rays.Count = hitCount;
    for (std::size_t i = 0; i < missCount; ++i)
    {
      this->Planes.Normals[misses[i]] = glm::vec3(0.0f);
      this->Planes.Colors[misses[i]] = NoColor;
    }
  }

  bool WithDefiniteHits;
  Frame& Planes;
  HitList& Hits;
};

}

void GatherHits(
  const View& view, const PixelRect& part, bool withDefiniteHits, Frame& frame, HitList& hits)
{
  const PixelCentres centres(view, part);
  PixelSorter sorter(withDefiniteHits, frame, hits);
  for (int row = 0; row < part.Size.y; ++row)
  {
    const int first = (part.First.y + row) * frame.Size.x + part.First.x;
    sorter.Sort(static_cast<std::size_t>(first), static_cast<std::size_t>(part.Size.x),
      centres.X.data(), centres.Y[static_cast<std::size_t>(row)]);
  }
  FindHitPoints(view, hits);
}

void TakeHits(const View& view, const TileHits& found, Frame& frame, HitList& hits)
{
  const auto rays = static_cast<std::size_t>(found.Rays.Count);
  Array<std::uint8_t> places;
  std::size_t count = 0;
  for (std::size_t ray = 0; ray < rays; ++ray)
  {
    places[count] = static_cast<std::uint8_t>(ray);
    count += found.Hits.Surface[ray] != Frame::NoSurface;
  }
  hits.Rays.Count = count;
  if (count == rays)
  {
    std::copy_n(found.Rays.Pixel.begin(), count, hits.Pixel.begin());
    std::copy_n(found.Hits.Surface.begin(), count, hits.Surface.begin());
    std::copy_n(found.Hits.Kind.begin(), count, hits.Kind.begin());
    ShadingKernels::FindPointsFrom(view.Origin, found.World, found.Hits.Depth, hits.Rays);
    return;
  }
  WorldDirections directions;
  const auto take = [&](const auto& from, auto& to)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      to[i] = from[places[i]];
    }
  };
  take(found.Rays.Pixel, hits.Pixel);
  take(found.Hits.Surface, hits.Surface);
  take(found.Hits.Kind, hits.Kind);
  take(found.Hits.Depth, hits.Rays.T);
  for (std::size_t a = 0; a < 3; ++a)
  {
    take(found.World[a], directions[a]);
  }
  for (std::size_t ray = 0; ray < rays; ++ray)
  {
    if (found.Hits.Surface[ray] == Frame::NoSurface)
    {
      const auto pixel = static_cast<std::size_t>(found.Rays.Pixel[ray]);
      frame.Normals[pixel] = glm::vec3(0.0f);
      frame.Colors[pixel] = {};
    }
  }
  if (count > 0)
  {
    FillLastVector(count, hits.Rays.T);
    for (Array<double>& component : directions)
    {
      FillLastVector(count, component);
    }
    ShadingKernels::FindPointsFrom(view.Origin, directions, hits.Rays.T, hits.Rays);
  }
}

void FindHitPoints(const View& view, HitList& hits)
{
  ShadingKernels::RayPoints& rays = hits.Rays;
  if (rays.Count > 0)
  {
    FillLastVector(rays.Count, rays.X);
    FillLastVector(rays.Count, rays.Y);
    FillLastVector(rays.Count, rays.T);
    rays.LinearDirection = { view.Direction, view.DirectionX, view.DirectionY };
    rays.LinearOrigin = { view.Origin, view.OriginX, view.OriginY };
    ShadingKernels::FindRayPoints(rays);
  }
}

void ComputeNormals(
  const NormalSource& source, HitList& hits, std::array<Array<double>, 3>* gradientsFound)
{
  if (hits.Rays.Count == 0)
  {
    return;
  }
  const auto count = hits.Rays.Count;
  std::array<Array<double>, 3> gradients;
  IndexGradients(
    { source.Samples, source.Transform.IndexFromWorld, source.FiniteRange, &source.Isovalues },
    { count, hits.Rays.Point, hits.Rays.Direction, hits.Surface, gradients });
  if (gradientsFound)
  {
    *gradientsFound = gradients;
  }
  TakeFacesAtCaps(source, hits, gradients);
  const glm::dmat3 worldFromGradient = glm::transpose(glm::dmat3(source.Transform.IndexFromWorld));
  ShadingKernels::FindFacingNormals(
    count, worldFromGradient, gradients, hits.Rays.Direction, hits.Normal);
  FillLastVector(count, hits.Normal);
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

void SumLight(const Appearance& appearance, const HitList& hits, ShadingKernels::PhongSums& sums)
{
  BeginSums(appearance, hits, sums);
  if (appearance.Shade)
  {
    for (const Light& light : appearance.Lights)
    {
      AddLight(appearance, light, hits, sums);
    }
  }
  if (appearance.ColorScale != 1.0 || appearance.ColorShift != 0.0)
  {
    ScaleSums(appearance, sums);
  }
}

void ShadeHits(const Appearance& appearance, const HitList& hits, Frame& frame)
{
  if (hits.Rays.Count == 0)
  {
    return;
  }
  Array<std::array<std::uint8_t, 4>> colors;
  if (IsLitSimply(appearance))
  {
    ShadingKernels::FindColors(hits.Rays, hits.Normal, LightOf(appearance), colors);
  }
  else
  {
    ShadingKernels::PhongSums sums;
    SumLight(appearance, hits, sums);
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
