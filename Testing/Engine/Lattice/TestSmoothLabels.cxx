// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Smooth surfaces between labels are those of a march by small steps. Labels that touch have no gap
// between them, positions stay near the faces of voxels, and normals are those of simple shapes.

#include "Checks/Infinity.h"
#include "Grid.h"
#include "Kinds/LabelKind.h"
#include "Lattice/RaySource.h"
#include "Scene/LabelSets.h"
#include "Shade/FieldNormals.h"
#include "Tracing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

namespace
{

using namespace TemporalCoherence;

constexpr double SmoothRadius = 2.5;

/// Shares of labels by their definition, in double precision.
template <typename T>
class TrueLabels
{
public:
  explicit TrueLabels(Grid<T>& grid)
    : Samples(grid)
  {
    const double deviation = 0.3 * SmoothRadius;
    const int half = static_cast<int>(std::ceil(2.8 * deviation));
    double sum = 0.0;
    for (int i = -half; i <= half; ++i)
    {
      this->Weights[i] = std::exp(-0.5 * i * i / (deviation * deviation));
      sum += this->Weights[i];
    }
    // In whole parts of 256.
    double rest = 1.0;
    for (auto& [step, weight] : this->Weights)
    {
      weight = std::round(256.0 * weight / sum) / 256.0;
      rest -= weight;
    }
    this->Weights[0] += rest;
  }

  /// The label at a point, and how far its share is above that of the next one.
  T At(const glm::dvec3& point, double& lead)
  {
    const glm::ivec3& n = this->Samples.Field.Dimensions;
    const glm::ivec3 cell = glm::clamp(glm::ivec3(glm::floor(point)), glm::ivec3(0), n - 2);
    const glm::dvec3 in = point - glm::dvec3(cell);
    std::set<T> labels;
    std::vector<std::pair<glm::ivec3, double>> corners;
    for (int corner = 0; corner < 8; ++corner)
    {
      const glm::ivec3 step(corner & 1, corner >> 1 & 1, corner >> 2);
      const glm::dvec3 along = glm::mix(1.0 - in, in, glm::dvec3(step));
      const double weight = along.x * along.y * along.z;
      if (weight > 0.0)
      {
        corners.emplace_back(cell + step, weight);
        labels.insert(this->LabelOf(cell + step));
      }
    }
    T largest{};
    double most = -Infinity, second = -Infinity;
    for (const T label : labels)
    {
      double share = 0.0;
      for (const auto& [sample, weight] : corners)
      {
        share += weight * this->ShareOf(label, sample);
      }
      second = share > most ? most : std::max(second, share);
      largest = share > most ? label : largest;
      most = std::max(most, share);
    }
    lead = most - second;
    return largest;
  }

private:
  T LabelOf(const glm::ivec3& sample) { return this->Samples.At(sample.x, sample.y, sample.z); }

  double ShareOf(T label, const glm::ivec3& sample)
  {
    const auto key = std::tuple(label, sample.x, sample.y, sample.z);
    const auto known = this->Known.find(key);
    if (known != this->Known.end())
    {
      return known->second;
    }
    double share = 0.0;
    const glm::ivec3 last = this->Samples.Field.Dimensions - 1;
    for (const auto& [k, z] : this->Weights)
    {
      for (const auto& [j, y] : this->Weights)
      {
        for (const auto& [i, x] : this->Weights)
        {
          const glm::ivec3 at = glm::clamp(sample + glm::ivec3(i, j, k), glm::ivec3(0), last);
          share += this->LabelOf(at) == label ? x * y * z : 0.0;
        }
      }
    }
    constexpr double margin = 1.0 / 64.0, ofThin = 3.0 / 16.0;
    if (this->LabelOf(sample) == label)
    {
      share = share < 0.5 ? 0.5 + ofThin : std::max(share, 0.5 + margin);
    }
    else
    {
      share = share > 0.5 ? 0.5 - ofThin : std::min(share, 0.5 - margin);
    }
    this->Known[key] = share;
    return share;
  }

  Grid<T>& Samples;
  std::map<int, double> Weights;
  std::map<std::tuple<T, int, int, int>, double> Known;
};

/// A grid of labels with smooth surfaces between them.
template <typename T>
struct SmoothGrid : Grid<T>
{
  using Grid<T>::Grid;

  void Smooth()
  {
    this->Field.Shape = UniformShape();
    const auto smooth = std::make_shared<const SmoothLabels>(this->Field, SmoothRadius);
    this->Field.Shape = LabelKind(smooth);
    this->Field.Labels = LabelSets::Make(this->Field);
  }
};

/// Call visit(rays) for the tiles of some views.
template <typename Visit>
void ForEachTile(const glm::ivec3& dimensions, int pixels, const Visit& visit)
{
  for (const glm::dvec3& direction :
    { glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(-0.4, -0.5, 1.0), glm::dvec3(0.3, -0.7, 0.9) })
  {
    const View view = LookAt(dimensions, direction, { pixels, pixels });
    for (int tile = 0; tile < pixels * pixels / 64; ++tile)
    {
      RayBatch rays;
      const glm::ivec2 place(tile % (pixels / 8), tile / (pixels / 8));
      RaySource(view, IndexTransform(), dimensions).SetUp(8 * place, glm::ivec2(8), rays);
      visit(rays);
    }
  }
}

glm::dvec3 PointAt(const RayBatch& rays, std::size_t ray, double t)
{
  return { rays.Origin[0][ray] + t * rays.Direction[0][ray],
    rays.Origin[1][ray] + t * rays.Direction[1][ray],
    rays.Origin[2][ray] + t * rays.Direction[2][ray] };
}

template <typename T>
void ExpectMarch(SmoothGrid<T>& grid, const std::vector<double>& drawn)
{
  grid.Smooth();
  const Tracing<T> tracing(grid, drawn, SurfaceMode::Threshold);
  const auto tracer = MakeSurfaceTracer(tracing.Scene);
  TraceScene plain = tracing.Scene;
  plain.Active = nullptr;
  const auto withoutLeaps = MakeSurfaceTracer(plain);
  TrueLabels<T> truth(grid);
  const std::set<double> isDrawn(drawn.begin(), drawn.end());
  int met = 0, differing = 0;
  ForEachTile(grid.Field.Dimensions, 40,
    [&](const RayBatch& rays)
    {
      HitBatch hits, all;
      tracer->Trace(rays, hits);
      withoutLeaps->Trace(rays, all);
      for (std::size_t ray = 0; ray < 64; ++ray)
      {
        EXPECT_EQ(hits.Surface[ray], all.Surface[ray]);
        EXPECT_EQ(hits.Depth[ray], all.Depth[ray]);
        EXPECT_EQ(hits.Kind[ray], all.Kind[ray]);
        if (!(rays.Begin[ray] < rays.End[ray]))
        {
          continue;
        }
        // March to the first label that is drawn.
        constexpr double step = 0.01;
        double distance = Infinity, label = 0.0, lead = 0.0;
        for (double t = rays.Begin[ray] + 1e-7; t < rays.End[ray]; t += step)
        {
          label = static_cast<double>(truth.At(PointAt(rays, ray, t), lead));
          if (isDrawn.count(label))
          {
            distance = t;
            break;
          }
        }
        const bool isHit = hits.Surface[ray] != Frame::NoSurface;
        const bool isSame = isHit == std::isfinite(distance) &&
          (!isHit ||
            (drawn[static_cast<std::size_t>(hits.Surface[ray])] == label &&
              std::abs(hits.Depth[ray] - distance) < 2.0 * step));
        met += isHit;
        differing += !isSame;
      }
    });
  EXPECT_GT(met, 300);
  EXPECT_LE(differing, met / 200); // steps miss what is thinner
}

TEST(SmoothLabels, AreThoseOfAMarch)
{
  SmoothGrid<std::uint8_t> balls(glm::ivec3(19, 17, 18));
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::vector<glm::dvec4> places;
  for (int i = 0; i < 9; ++i)
  {
    places.emplace_back(
      18.0 * share(engine), 17.0 * share(engine), 17.0 * share(engine), 2.0 + 4.0 * share(engine));
  }
  balls.Fill(
    [&](int i, int j, int k)
    {
      int label = 0;
      for (std::size_t ball = 0; ball < places.size(); ++ball)
      {
        const bool isIn =
          glm::distance(glm::dvec3(i, j, k), glm::dvec3(places[ball])) < places[ball].w;
        label = isIn ? static_cast<int>(ball) + 1 : label;
      }
      return label;
    });
  ExpectMarch(balls, { 1, 2, 3, 4, 5, 6, 7, 8, 9 });
  ExpectMarch(balls, { 9, 2, 4 });
}

TEST(SmoothLabels, AreThoseOfAMarchInNoise)
{
  SmoothGrid<std::int32_t> noise(glm::ivec3(9, 8, 7));
  noise.FillRandomly(0.0, 6.99, 1);
  ExpectMarch(noise, { 1, 4, 6 });
}

/// What of labels on one shape is measured.
struct Errors
{
  std::vector<double> OfNormals, OfFaces; ///< degrees, and samples from the nearest face of a voxel

  static double Median(std::vector<double> values)
  {
    std::nth_element(values.begin(),
      values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
  }
};

/// Measure a shape of label 1.
/// \param normalAt its normal at a point
template <typename Normal>
Errors Measure(SmoothGrid<std::uint8_t>& grid, const Normal& normalAt)
{
  grid.Smooth();
  const std::vector<double> labels = { 1.0 };
  const Tracing<std::uint8_t> tracing(grid, labels, SurfaceMode::Threshold);
  const auto tracer = MakeSurfaceTracer(tracing.Scene);
  Errors errors;
  ForEachTile(grid.Field.Dimensions, 128,
    [&](const RayBatch& rays)
    {
      HitBatch hits;
      tracer->Trace(rays, hits);
      HitRays at;
      at.Count = 64;
      at.AreApart = true;
      GradientTile::Vectors gradients;
      RayBatch::Array<SurfaceIndex> surfaces{};
      for (std::size_t ray = 0; ray < 64; ++ray)
      {
        for (std::size_t a = 0; a < 3; ++a)
        {
          at.Begin[a][ray] = rays.Origin[a][ray];
          at.Own[a][ray] = rays.Direction[a][ray];
        }
        at.T[ray] = std::isfinite(hits.Depth[ray]) ? hits.Depth[ray] : 0.0;
      }
      KindOf(grid.Field)
        .FindGradients({ grid.Field, glm::dmat4(1.0), tracing.Scene.FiniteRange, &labels },
          { at, surfaces, gradients });
      for (std::size_t ray = 0; ray < 64; ++ray)
      {
        const glm::dvec3 point = PointAt(rays, ray, hits.Depth[ray]);
        const double margin = 8.0;
        const glm::dvec3 last(grid.Field.Dimensions - 1);
        if (hits.Kind[ray] != HitKind::Entry ||
          glm::any(glm::lessThan(point, glm::dvec3(margin))) ||
          glm::any(glm::greaterThan(point, last - margin)))
        {
          continue;
        }
        const glm::dvec3 into =
          glm::normalize(glm::dvec3(gradients[0][ray], gradients[1][ray], gradients[2][ray]));
        errors.OfNormals.push_back(
          glm::degrees(std::acos(glm::clamp(-glm::dot(into, normalAt(point)), -1.0, 1.0))));
        double nearest = Infinity;
        const glm::ivec3 around(glm::floor(point));
        for (int k = -1; k <= 2; ++k)
        {
          for (int j = -1; j <= 2; ++j)
          {
            for (int i = -1; i <= 2; ++i)
            {
              for (int axis = 0; axis < 3; ++axis)
              {
                const glm::ivec3 sample = around + glm::ivec3(i, j, k);
                glm::ivec3 next = sample;
                ++next[axis];
                if (grid.At(sample.x, sample.y, sample.z) != grid.At(next.x, next.y, next.z))
                {
                  // The face: half a sample along its own axes, and thin along the other.
                  glm::dvec3 half(0.5), middle(sample);
                  half[axis] = 0.0;
                  middle[axis] += 0.5;
                  const glm::dvec3 beyond =
                    glm::max(glm::abs(point - middle) - half, glm::dvec3(0.0));
                  nearest = std::min(nearest, glm::length(beyond));
                }
              }
            }
          }
        }
        errors.OfFaces.push_back(nearest);
      }
    });
  return errors;
}

TEST(SmoothLabels, HaveTheNormalsOfShapes)
{
  constexpr int n = 48;
  const glm::dvec3 middle(23.3, 23.8, 23.1);
  // Steps of a rod along an axis are longer than what is smoothed.
  const auto expect = [](const char* shape, const Errors& errors, double most)
  {
    ASSERT_GT(errors.OfNormals.size(), 100u) << shape;
    EXPECT_LT(Errors::Median(errors.OfNormals), most) << shape;
    EXPECT_LT(*std::max_element(errors.OfFaces.begin(), errors.OfFaces.end()), 0.75) << shape;
  };
  for (const double radius : { 4.0, 6.0, 14.0 })
  {
    SmoothGrid<std::uint8_t> ball(glm::ivec3(n, n, n));
    ball.Fill([&](int i, int j, int k)
      { return glm::distance(glm::dvec3(i, j, k), middle) < radius ? 1 : 0; });
    expect(
      "ball", Measure(ball, [&](const glm::dvec3& p) { return glm::normalize(p - middle); }), 0.8);
  }
  for (const glm::dvec3& along : { glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.6, 0.5, -0.3),
         glm::dvec3(1.0, 0.05, 0.2), glm::dvec3(-0.3, 0.2, 0.9) })
  {
    const glm::dvec3 axis = glm::normalize(along);
    SmoothGrid<std::uint8_t> half(glm::ivec3(n, n, n));
    half.Fill([&](int i, int j, int k)
      { return glm::dot(glm::dvec3(i, j, k) - middle, axis) < 0.2 ? 1 : 0; });
    expect("plane", Measure(half, [&](const glm::dvec3&) { return axis; }), 0.8);
    SmoothGrid<std::uint8_t> rod(glm::ivec3(n, n, n));
    const auto across = [&](const glm::dvec3& p)
    { return p - middle - glm::dot(p - middle, axis) * axis; };
    rod.Fill(
      [&](int i, int j, int k) { return glm::length(across(glm::dvec3(i, j, k))) < 9.0 ? 1 : 0; });
    expect("rod", Measure(rod, [&](const glm::dvec3& p) { return glm::normalize(across(p)); }),
      along.x == 1.0 && along.y == 0.0 ? 2.2 : 0.8);
  }
}

TEST(SmoothLabels, ThinPartsStay)
{
  // A line of voxels, of two labels in turn: seen from its side, it has no gap and is not thin.
  SmoothGrid<std::uint8_t> line(glm::ivec3(17, 17, 17));
  line.Fill(
    [](int i, int j, int k) { return j == 8 && k == 8 && i > 2 && i < 14 ? 1 + i % 2 : 0; });
  line.Smooth();
  const Tracing<std::uint8_t> tracing(line, { 1.0, 2.0 }, SurfaceMode::Threshold);
  const auto tracer = MakeSurfaceTracer(tracing.Scene);
  const View view = LookAt(line.Field.Dimensions, { 0.0, -1.0, 0.0 }, { 256, 256 }, true);
  const RaySource source(view, IndexTransform(), line.Field.Dimensions);
  std::map<int, double> thickness; // along z, by place along x in tenths
  for (int tile = 0; tile < 1024; ++tile)
  {
    RayBatch rays;
    source.SetUp(8 * glm::ivec2(tile % 32, tile / 32), glm::ivec2(8), rays);
    HitBatch hits;
    tracer->Trace(rays, hits);
    for (std::size_t ray = 0; ray < 64; ++ray)
    {
      const double x = rays.Origin[0][ray], pixel = 2.0 * glm::length(glm::dvec3(8.0)) / 256.0;
      if (x > 3.0 && x < 13.0)
      {
        thickness[static_cast<int>(10.0 * x)] +=
          hits.Surface[ray] != Frame::NoSurface ? pixel * pixel / 0.1 : 0.0;
      }
    }
  }
  ASSERT_GT(thickness.size(), 90u);
  for (const auto& [place, across] : thickness)
  {
    EXPECT_GT(across, 0.2) << 0.1 * place;
    EXPECT_LT(across, 1.2) << 0.1 * place;
  }
}

TEST(SmoothLabels, LeaveNoGapBetweenNeighbours)
{
  // Two labels fill a ball. From one of them a ray comes to the other or leaves the ball.
  constexpr int n = 24;
  SmoothGrid<std::uint16_t> ball(glm::ivec3(n, n, n));
  const glm::dvec3 middle(11.7, 11.4, 11.9), cut = glm::normalize(glm::dvec3(0.5, 0.7, -0.2));
  ball.Fill(
    [&](int i, int j, int k)
    {
      const glm::dvec3 p(i, j, k);
      const bool isIn = glm::distance(p, middle) < 9.0;
      return isIn ? (glm::dot(p - middle, cut) < 0.0 ? 1 : 2) : 0;
    });
  ball.Smooth();
  const Tracing<std::uint16_t> tracing(ball, { 0.0, 1.0, 2.0 }, SurfaceMode::Threshold);
  const auto tracer = MakeSurfaceTracer(tracing.Scene);
  int passed = 0, gaps = 0;
  ForEachTile(ball.Field.Dimensions, 256,
    [&](const RayBatch& rays)
    {
      HitBatch hits;
      tracer->Trace(rays, hits);
      std::array<std::vector<int>, 64> seen;
      std::array<std::vector<double>, 64> depths;
      for (int layer = 0; layer < 8; ++layer)
      {
        for (std::size_t ray = 0; ray < 64; ++ray)
        {
          // Behind the last one, the search begins again.
          const bool isBehind = depths[ray].empty() || hits.Depth[ray] > depths[ray].back();
          if (hits.Surface[ray] != Frame::NoSurface && isBehind)
          {
            seen[ray].push_back(hits.Surface[ray]);
            depths[ray].push_back(hits.Depth[ray]);
          }
        }
        tracer->FindNext(rays, hits);
      }
      for (std::size_t ray = 0; ray < 64; ++ray)
      {
        const std::vector<int>& labels = seen[ray];
        for (std::size_t i = 1; i + 1 < labels.size(); ++i)
        {
          const bool isOutside = labels[i] == 0;
          const glm::dvec3 place = PointAt(rays, ray, depths[ray][i]);
          // Deep in the ball there is nothing but the two.
          gaps += isOutside && glm::distance(place, middle) < 7.0;
        }
        passed += labels.size() >= 4;
      }
    });
  EXPECT_GT(passed, 5000);
  EXPECT_EQ(gaps, 0);
}

TEST(SmoothLabels, ForgetWhatDependsOnPaintedSamples)
{
  const glm::ivec3 dimensions(41, 30, 27);
  SmoothGrid<std::uint8_t> noise(dimensions);
  std::mt19937 engine(5);
  noise.Fill([&](int i, int, int) { return i / 9 + static_cast<int>(engine() % 12 == 0); });
  const SmoothLabels kept(noise.Field, SmoothRadius);
  const auto visitAll = [&](const SmoothLabels& smooth, const auto& visit)
  {
    for (int k = 0; k < dimensions.z - 1; k += CellBlocks::LeafSize)
    {
      for (int j = 0; j < dimensions.y - 1; j += CellBlocks::LeafSize)
      {
        for (int i = 0; i < dimensions.x - 1; i += CellBlocks::LeafSize)
        {
          for (const int label : { 0, 1, 3, 7 })
          {
            visit(glm::ivec3(i, j, k), label, smooth.Of({ i, j, k }, label));
          }
        }
      }
    }
  };
  visitAll(kept, [](const glm::ivec3&, int, const SmoothLabels::Block&) {});
  const std::size_t all = kept.Memory();
  const glm::ivec3 first(17, 11, 13), last(19, 14, 13); // of painted samples
  for (int k = first.z; k <= last.z; ++k)
  {
    for (int j = first.y; j <= last.y; ++j)
    {
      for (int i = first.x; i <= last.x; ++i)
      {
        noise.At(i, j, k) = 7;
      }
    }
  }
  kept.Forget({ first - 1, last - first + 2 });
  EXPECT_LT(kept.Memory(), all);
  EXPECT_GT(kept.Memory(), all / 4) << "blocks far away stay";
  const SmoothLabels made(noise.Field, SmoothRadius);
  visitAll(kept,
    [&](const glm::ivec3& cell, int label, const SmoothLabels::Block& block)
    {
      const SmoothLabels::Block& expected = made.Of(cell, label);
      EXPECT_TRUE(block.Share == expected.Share && block.Gradient == expected.Gradient)
        << label << " at " << cell.x << " " << cell.y << " " << cell.z;
    });
}

}
