// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Shading of hits in vectors has the bits of the formulas written out one by one.

#include "EachTarget.h"
#include "Grid.h"
#include "Kinds/FieldKind.h"
#include "Scene/Difference.h"
#include "Shade/KernelsGradients.h"
#include "Shade/KernelsShading.h"
#include "Shade/RandomDirection.h"
#include "Shade/RaysFromPoints.h"
#include "Shade/SurfaceNormal.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace
{

using namespace TemporalCoherence;
using namespace TemporalCoherence::ShadingKernels;

using Vectors = std::array<Array<double>, 3>;

/// The gradient at a point of index space.
template <typename T>
class GradientReference
{
  using Real = RealOf<T>;

public:
  GradientReference(const Field& field, const glm::dvec2& finiteRange, double isovalue)
    : Samples(field)
    , FromIsovalue(isovalue, finiteRange)
    , IsNearest(field.Between == Interpolation::Nearest)
  {
  }

  glm::dvec3 At(const glm::dvec3& point) const
  {
    Real at[3];
    glm::ivec3 cell;
    for (int a = 0; a < 3; ++a)
    {
      cell[a] = std::min(std::max(static_cast<int>(point[a]), 0), this->Samples.Dimensions[a] - 2);
      const double in = std::min(std::max(point[a] - cell[a], 0.0), 1.0);
      at[a] = static_cast<Real>(this->IsNearest ? std::floor(in + 0.5) : in);
    }
    glm::dvec3 gradient;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
      Real edges[4];
      for (int edge = 0; edge < 4; ++edge)
      {
        glm::ivec3 first = cell;
        first[u] += edge & 1;
        first[v] += edge >> 1;
        glm::ivec3 second = first;
        ++second[axis];
        edges[edge] = Mix(this->Difference(first, axis), this->Difference(second, axis), at[axis]);
      }
      gradient[axis] = static_cast<double>(
        Mix(Mix(edges[0], edges[1], at[u]), Mix(edges[2], edges[3], at[u]), at[v]));
    }
    return gradient;
  }

private:
  static Real Mix(Real a, Real b, Real weightOfB)
  {
    return (Real(1) - weightOfB) * a + weightOfB * b;
  }

  Real Value(const glm::ivec3& sample) const
  {
    const T value = *this->Samples.At(sample);
    if constexpr (std::is_floating_point_v<T>)
    {
      return this->FromIsovalue.Unscaled(this->FromIsovalue(value));
    }
    return static_cast<Real>(value);
  }

  /// Central at a sample, one-sided at the ends.
  Real Difference(const glm::ivec3& sample, int axis) const
  {
    glm::ivec3 before = sample, behind = sample;
    before[axis] = std::max(sample[axis] - 1, 0);
    behind[axis] = std::min(sample[axis] + 1, this->Samples.Dimensions[axis] - 1);
    const Real scale = behind[axis] - before[axis] == 2 ? Real(0.5) : Real(1);
    return scale * (this->Value(behind) - this->Value(before));
  }

  TypedField<T> Samples;
  TemporalCoherence::Difference<T> FromIsovalue;
  bool IsNearest;
};

/// Points in the field's box, on its faces and on samples among them.
void PlaceRandomly(const glm::ivec3& dimensions, std::mt19937& engine, Vectors& points)
{
  std::uniform_real_distribution<double> share(-0.02, 1.02);
  std::uniform_int_distribution<int> kind(0, 7);
  for (std::size_t i = 0; i < RayBatch::Capacity; ++i)
  {
    for (int a = 0; a < 3; ++a)
    {
      const double last = dimensions[a] - 1;
      const double at = std::min(std::max(share(engine), 0.0), 1.0) * last;
      points[static_cast<std::size_t>(a)][i] = kind(engine) == 0 ? std::floor(at) : at;
    }
  }
}

class KernelsGradients : public EachTarget
{
protected:
  template <typename T>
  void Compare(const glm::ivec3& dimensions, double low, double high, int components = 1)
  {
    Grid<T> grid(dimensions, components, components - 1);
    grid.FillRandomly(low, high, 5);
    this->CompareBetween<T>(grid.Field, low, high);
    if constexpr (std::is_floating_point_v<T>)
    {
      // With holes, too.
      for (std::size_t i = 0; i < grid.Samples.size(); i += 7)
      {
        const T infinity = std::numeric_limits<T>::infinity();
        grid.Samples[i] = i % 3 == 0 ? infinity : i % 3 == 1 ? -infinity : T(NAN);
      }
      this->CompareBetween<T>(grid.Field, low, high);
    }
  }

private:
  template <typename T>
  void CompareBetween(Field field, double low, double high)
  {
    for (const Interpolation between : { Interpolation::Linear, Interpolation::Nearest })
    {
      field.Between = between;
      for (const int count : { 1, 7, 16, 41, 64 })
      {
        this->CompareAt<T>(field, { low, high }, static_cast<std::size_t>(count));
      }
    }
  }

  template <typename T>
  void CompareAt(const Field& field, const glm::dvec2& range, std::size_t count)
  {
    std::mt19937 engine(static_cast<unsigned int>(count));
    RaysFromPoints rays;
    rays.Count = count;
    PlaceRandomly(field.Dimensions, engine, rays.Begin);
    rays.Own = Vectors{};
    rays.Own[0].fill(1.0);
    const std::vector<double> isovalues = { 0.5 * (range.x + range.y), range.y };
    RayBatch::Array<SurfaceIndex> surfaces;
    for (std::size_t i = 0; i < surfaces.size(); ++i)
    {
      surfaces[i] = static_cast<SurfaceIndex>(i / 3 % 2);
    }
    Vectors reference;
    for (std::size_t i = 0; i < count; ++i)
    {
      const double isovalue = isovalues[static_cast<std::size_t>(surfaces[i])];
      glm::dvec3 point = rays.PointAt(i);
      if (field.Between == Interpolation::Nearest)
      {
        point.x += 1e-2; // into the box that the ray enters
      }
      const glm::dvec3 gradient = GradientReference<T>(field, range, isovalue).At(point);
      for (std::size_t a = 0; a < 3; ++a)
      {
        reference[a][i] = gradient[static_cast<int>(a)];
      }
    }
    this->ForEachTarget(
      [&](const char* target)
      {
        Vectors found;
        KindOf(field).FindGradients(
          { field, glm::dmat4(1.0), range, &isovalues }, { rays, surfaces, found });
        for (std::size_t a = 0; a < 3; ++a)
        {
          EXPECT_TRUE(AreIdentical(found[a], reference[a], static_cast<int>(count)))
            << target << ", axis " << a << ", " << count << " points";
        }
      });
  }
};

TEST_F(KernelsGradients, NarrowIntegers)
{
  this->Compare<std::uint8_t>({ 9, 7, 8 }, 0.0, 255.0);
  this->Compare<std::int8_t>({ 9, 7, 8 }, -128.0, 127.0);
  this->Compare<std::uint16_t>({ 9, 7, 8 }, 0.0, 65535.0);
  this->Compare<std::int16_t>({ 9, 7, 8 }, -32768.0, 32767.0);
}

TEST_F(KernelsGradients, WideIntegersAndReals)
{
  this->Compare<std::int32_t>({ 9, 7, 8 }, -2e9, 2e9);
  this->Compare<std::uint64_t>({ 9, 7, 8 }, 0.0, 1e19);
  this->Compare<float>({ 9, 7, 8 }, -3.0, 5.0);
  this->Compare<double>({ 9, 7, 8 }, -1e200, 1e200);
  this->Compare<double>({ 9, 7, 8 }, -1e-3, 1.0);
  this->Compare<double>({ 9, 7, 8 }, -1e300, 1e300);
}

TEST_F(KernelsGradients, OneOfSeveralComponents)
{
  this->Compare<std::uint8_t>({ 6, 5, 5 }, 0.0, 255.0, 3);
  this->Compare<std::int16_t>({ 6, 5, 5 }, -32768.0, 32767.0, 2);
  this->Compare<float>({ 6, 5, 5 }, -3.0, 5.0, 4);
}

TEST_F(KernelsGradients, FieldsOfFewSamples)
{
  this->Compare<std::uint8_t>({ 2, 2, 2 }, 0.0, 255.0);
  this->Compare<std::uint16_t>({ 3, 2, 4 }, 0.0, 65535.0);
  this->Compare<double>({ 2, 3, 2 }, 0.0, 1.0);
}

class KernelsShading : public EachTarget
{
};

/// Rays of views, and the cells that points on them lie in.
TEST_F(KernelsShading, RaysAndCellsOfHits)
{
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> around(-1.0, 1.0);
  const glm::ivec3 dimensions(12, 9, 14);
  View view;
  for (auto* vector : { &view.Direction, &view.DirectionX, &view.DirectionY, &view.Origin })
  {
    *vector = RandomDirection(engine);
  }
  Array<double> x, y;
  HitRays rays;
  rays.Count = RayBatch::Capacity;
  for (std::size_t i = 0; i < rays.Count; ++i)
  {
    x[i] = around(engine);
    y[i] = around(engine);
    rays.T[i] = 10.0 * around(engine);
  }
  for (const bool isParallel : { false, true })
  {
    view.Parallel = isParallel;
    view.OriginX = isParallel ? glm::dvec3(0.4, 0.5, -0.2) : glm::dvec3(0.0);
    view.OriginY = isParallel ? glm::dvec3(0.1, -0.8, 0.3) : glm::dvec3(0.0);
    this->ForEachTarget(
      [&](const char* target)
      {
        FindRays(view, x, y, rays);
        GradientKernels::CellPoints<double> found;
        found.Count = rays.Count;
        GradientKernels::FindCells({ glm::dmat4(1.0), dimensions }, rays, found);
        for (std::size_t i = 0; i < rays.Count; ++i)
        {
          const glm::dvec3 along = view.Direction + x[i] * view.DirectionX + y[i] * view.DirectionY;
          const double square = along.x * along.x + along.y * along.y + along.z * along.z;
          const glm::dvec3 direction = along * (1.0 / std::sqrt(square));
          const glm::dvec3 begin = view.Origin + x[i] * view.OriginX + y[i] * view.OriginY;
          const glm::dvec3 point = begin + rays.T[i] * direction;
          EXPECT_EQ(rays.DirectionAt(i), direction) << target;
          EXPECT_EQ(rays.PointAt(i), point) << target;
          for (int axis = 0; axis < 3; ++axis)
          {
            const auto a = static_cast<std::size_t>(axis);
            const double inBox = std::min(std::max(point[axis], 0.0), dimensions[axis] - 1.0);
            const double cell = std::min(std::floor(inBox), dimensions[axis] - 2.0);
            EXPECT_EQ(found.Cell[a][i], cell) << target;
            EXPECT_EQ(found.At[a][i], inBox - cell) << target;
          }
        }
      });
  }
}

TEST_F(KernelsShading, NormalsFaceTheViewer)
{
  std::mt19937 engine(4);
  glm::dmat3 m;
  for (int column = 0; column < 3; ++column)
  {
    m[column] = RandomDirection(engine);
  }
  Vectors gradients;
  HitRays rays;
  rays.Count = RayBatch::Capacity;
  for (std::size_t i = 0; i < RayBatch::Capacity; ++i)
  {
    // From none at all to those whose squares are no numbers, some along an axis.
    const double length =
      i % 8 == 0 ? 0.0 : std::pow(10.0, 12.0 * static_cast<double>(i % 40) - 240.0);
    glm::dvec3 towards = RandomDirection(engine);
    if (i % 8 < 4)
    {
      towards = glm::dvec3(0.0);
      towards[static_cast<int>(i % 3)] = i % 2 ? 1.0 : -1.0;
    }
    const glm::dvec3 gradient = length * towards, ray = RandomDirection(engine);
    for (std::size_t a = 0; a < 3; ++a)
    {
      gradients[a][i] = gradient[static_cast<int>(a)];
      rays.Own[a][i] = ray[static_cast<int>(a)];
    }
  }
  this->ForEachTarget(
    [&](const char* target)
    {
      Array<std::array<float, 3>> normals;
      FindFacingNormals(rays, m, gradients, normals);
      for (std::size_t i = 0; i < RayBatch::Capacity; ++i)
      {
        const glm::dvec3 g(gradients[0][i], gradients[1][i], gradients[2][i]);
        const glm::dvec3 ray = rays.DirectionAt(i);
        const double largest = std::max({ std::abs(g.x), std::abs(g.y), std::abs(g.z) });
        const bool isFar = largest > 0.0 && (largest < 1e-100 || largest > 1e100);
        const glm::dvec3 scaled = g * (1.0 / (isFar ? largest : 1.0));
        const glm::dvec3 w =
          largest > 0.0 ? m[0] * scaled.x + m[1] * scaled.y + m[2] * scaled.z : ray;
        const double along = w.x * ray.x + w.y * ray.y + w.z * ray.z;
        const double perLength = 1.0 / std::sqrt(w.x * w.x + w.y * w.y + w.z * w.z);
        for (int a = 0; a < 3; ++a)
        {
          const double component = (along > 0.0 ? -perLength : perLength) * w[a];
          EXPECT_EQ(normals[i][static_cast<std::size_t>(a)], static_cast<float>(component))
            << target;
        }
      }
    });
}

/// Edges of cells may be so short or so long that squares of them are no numbers.
TEST_F(KernelsShading, NormalsHaveUnitLengthWhateverTheEdges)
{
  const std::array<glm::dvec3, 6> edges = { glm::dvec3(1e200), glm::dvec3(1e-200),
    glm::dvec3(1e307, 1e307, 1e307), glm::dvec3(1e200, 1.0, 1.0), glm::dvec3(1e-200, 1.0, 1e-150),
    glm::dvec3(1e300, 1e-300, 1.0) };
  this->ForEachTarget(
    [&](const char* target)
    {
      for (const glm::dvec3& edge : edges)
      {
        std::mt19937 engine(7);
        Vectors gradients;
        HitRays rays;
        rays.Count = RayBatch::Capacity;
        for (std::size_t i = 0; i < RayBatch::Capacity; ++i)
        {
          glm::dvec3 gradient = RandomDirection(engine);
          const glm::dvec3 ray = RandomDirection(engine);
          for (int a = 0; a < 3 && i % 4 < 3; ++a)
          {
            gradient[a] = a == static_cast<int>(i % 4) ? 1.0 : 0.0;
          }
          for (std::size_t a = 0; a < 3; ++a)
          {
            gradients[a][i] = gradient[static_cast<int>(a)];
            rays.Own[a][i] = ray[static_cast<int>(a)];
          }
        }
        glm::dmat3 m(0.0);
        m[0].x = edge.x;
        m[1].y = edge.y;
        m[2].z = edge.z;
        Array<std::array<float, 3>> normals;
        FindFacingNormals(rays, m, gradients, normals);
        for (std::size_t i = 0; i < RayBatch::Capacity; ++i)
        {
          const glm::dvec3 n(normals[i][0], normals[i][1], normals[i][2]);
          EXPECT_NEAR(glm::length(n), 1.0, 1e-6) << target << ", " << edge.x << ", hit " << i;
          EXPECT_LE(glm::dot(n, rays.DirectionAt(i)), 1e-6) << target;
        }
      }
    });
}

/// What AddLight and RoundColors make of one hit.
std::array<std::uint8_t, 4> ColorReference(
  const PhongSums& sums, const HitRays& rays, std::size_t i)
{
  const std::array<float, 3>& n = sums.Normal[i];
  std::array<float, 3> l, r;
  for (std::size_t a = 0; a < 3; ++a)
  {
    l[a] = sums.IsPositional ? sums.ToLight[a][i] : sums.Toward[a];
    r[a] = static_cast<float>(rays.Own[a][i]);
  }
  const float share = sums.HasShares ? sums.Share[i] : 1.0f;
  const float cosine = n[0] * l[0] + n[1] * l[1] + n[2] * l[2];
  const float mirrored = (l[0] - 2.0f * cosine * n[0]) * r[0] +
    (l[1] - 2.0f * cosine * n[1]) * r[1] + (l[2] - 2.0f * cosine * n[2]) * r[2];
  float base = cosine > 0.0f ? std::min(std::max(mirrored, 0.0f), 1.0f) : 0.0f;
  float shine = base > 0.0f ? std::pow(base, static_cast<float>(sums.Power)) : 0.0f;
  if (sums.Power == std::floor(sums.Power))
  {
    shine = 1.0f;
    for (int rest = static_cast<int>(sums.Power); rest > 0; rest >>= 1)
    {
      shine *= rest & 1 ? base : 1.0f;
      base *= base;
    }
  }
  std::array<std::uint8_t, 4> color = { 0, 0, 0, 255 };
  for (std::size_t a = 0; a < 3; ++a)
  {
    const float sum = sums.Sum[a][i] +
      share *
        (sums.Diffuse[a] * std::max(cosine, 0.0f) * sums.Color[a][i] + sums.Specular[a] * shine);
    const float clamped = std::min(std::max(sum, 0.0f), 1.0f);
    color[a] = static_cast<std::uint8_t>(static_cast<int>(clamped * 255.0f + 0.5f));
  }
  return color;
}

TEST_F(KernelsShading, ColorsOfALight)
{
  std::mt19937 engine(5);
  std::uniform_real_distribution<float> share(0.0f, 1.0f);
  HitRays rays;
  PhongSums sums;
  sums.Count = RayBatch::Capacity;
  sums.Toward = { 0.6f, 0.0f, 0.8f };
  sums.Diffuse = { 0.7f, 0.8f, 0.9f };
  for (std::size_t i = 0; i < sums.Count; ++i)
  {
    const glm::dvec3 normal = RandomDirection(engine), toLight = RandomDirection(engine);
    const glm::dvec3 ray = RandomDirection(engine);
    sums.Share[i] = share(engine);
    for (std::size_t a = 0; a < 3; ++a)
    {
      const int axis = static_cast<int>(a);
      sums.Normal[i][a] = static_cast<float>(normal[axis]);
      sums.ToLight[a][i] = static_cast<float>(toLight[axis]);
      rays.Own[a][i] = ray[axis];
      sums.Color[a][i] = share(engine);
      sums.Sum[a][i] = 0.1f * sums.Color[a][i];
    }
  }
  for (const double power : { 1.0, 2.0, 10.0, 33.0, 7.5 })
  {
    for (const bool isPositional : { false, true })
    {
      for (const float specular : { 0.0f, 0.4f })
      {
        sums.Power = power;
        sums.IsPositional = isPositional;
        sums.HasShares = isPositional;
        sums.Specular = { specular, 0.5f * specular, specular };
        this->ForEachTarget(
          [&](const char* target)
          {
            PhongSums lit = sums;
            AddLight(rays, lit);
            Array<std::array<std::uint8_t, 4>> colors;
            RoundColors(lit, colors);
            for (std::size_t i = 0; i < sums.Count; ++i)
            {
              EXPECT_EQ(colors[i], ColorReference(sums, rays, i)) << target << ", power " << power;
            }
          });
      }
    }
  }
}

}
