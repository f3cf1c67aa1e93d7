// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/KnotCollector.h"

#include "Shade/SurfaceNormal.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace TemporalCoherence
{
namespace
{

PackedNormal Pack(const glm::dvec3& normal)
{
  // Scale first: the squares of very small or large components would underflow or overflow.
  const double largest =
    std::max(std::abs(normal.x), std::max(std::abs(normal.y), std::abs(normal.z)));
  PackedNormal packed{};
  if (!(largest >= std::numeric_limits<double>::min() && std::isfinite(largest)))
  {
    return packed;
  }
  const glm::dvec3 unit = glm::normalize(normal / largest);
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double component = unit[static_cast<int>(a)] * static_cast<double>(LargestNormal);
    packed[a] = static_cast<std::int16_t>(std::lround(component));
  }
  return packed;
}

}

KnotCollector::KnotCollector(const RayBatch& rays, const KnotForm& form, const BandScale& scale)
  : Rays(rays)
  , Form(form)
  , Scale(scale)
  , Grid(scale.GridFor(form.Tolerance, form.LargestProgress))
  , Fits(form.Tolerance > 0.0 ? NumberOfDirections * RayBatch::Capacity : 0)
{
}

void KnotCollector::Follow(
  std::size_t direction, std::size_t ray, const Cubic<double>& progress, double enter, double leave)
{
  Cubic<double> steps;
  for (std::size_t c = 0; c < progress.size(); ++c)
  {
    steps[c] = this->Grid.StepsOf(progress[c]);
  }
  const double begin = this->Rays.Begin[ray], step = this->Grid.DistanceStep;
  this->Fits[direction * RayBatch::Capacity + ray].Follow(steps, (enter - begin) / step,
    (leave - begin) / step, this->Grid.LargestProgress,
    [&](const Knot& knot, const KnotPlaces& places)
    { this->AddKnot(direction, ray, knot, places); });
}

void KnotCollector::AddKnot(
  std::size_t direction, std::size_t ray, const Knot& knot, const KnotPlaces& places)
{
  this->Fitted[direction].push_back(
    { static_cast<std::uint8_t>(ray), { knot.Distance, knot.Progress } });
  if (this->Form.HasNormals)
  {
    for (const double place : { places.Knot, places.Middle })
    {
      this->AddPlace(direction, ray, static_cast<float>(place * this->Grid.DistanceStep));
    }
  }
}

void KnotCollector::HandOver(const KnotNormalSource& source, TileKnots& knots)
{
  for (std::size_t fit = 0; fit < this->Fits.size(); ++fit)
  {
    const std::size_t direction = fit / RayBatch::Capacity, ray = fit % RayBatch::Capacity;
    this->Fits[fit].Finish([&](const Knot& knot, const KnotPlaces& places)
      { this->AddKnot(direction, ray, knot, places); });
  }
  for (std::size_t direction = 0; direction < NumberOfDirections; ++direction)
  {
    knots.Cells[direction].Assign(this->Cells[direction]);
    knots.Fitted[direction].Assign(this->Fitted[direction]);

    std::vector<KnotNormals::Row> normals;
    for (std::size_t first = 0; first < this->Places[direction].size(); first += RayBatch::Capacity)
    {
      const std::size_t count =
        std::min<std::size_t>(RayBatch::Capacity, this->Places[direction].size() - first);
      this->FindNormals(&this->Places[direction][first], count, source, normals);
    }
    knots.Normals[direction].Assign(normals);
  }
  knots.Unresolved = this->Unresolved;
}

/// Append the normals of some knots.
void KnotCollector::FindNormals(const Place* places, std::size_t count,
  const KnotNormalSource& source, std::vector<KnotNormals::Row>& normals) const
{
  HitRays rays; // they begin at the knots' points, in index space
  rays.Count = count;
  rays.AreApart = true;
  rays.T.fill(0.0);
  HitRays::Vectors gradients;
  RayBatch::Array<SurfaceIndex> surfaces{};
  for (std::size_t i = 0; i < WholeVectors(count); ++i)
  {
    const auto [ray, distance] = places[std::min(i, count - 1)];
    const double t = this->Rays.Begin[ray] + static_cast<double>(distance);
    for (std::size_t a = 0; a < 3; ++a)
    {
      const double last = source.Samples.Dimensions[static_cast<int>(a)] - 1;
      const double at = this->Rays.Origin[a][ray] + t * this->Rays.Direction[a][ray];
      rays.Begin[a][i] = std::min(std::max(at, 0.0), last);
      rays.Own[a][i] = this->Rays.Direction[a][ray];
    }
  }
  const std::vector<double> reference = { this->Scale.Low };
  const GradientQuery inIndexSpace{ source.Samples, glm::dmat4(1.0), source.FiniteRange,
    &reference };
  source.Normals->FindGradients(inIndexSpace, { rays, surfaces, gradients });
  const glm::dmat3 toWorld = glm::transpose(glm::dmat3(source.Transform.IndexFromWorld));
  for (std::size_t i = 0; i < count; ++i)
  {
    const glm::dvec3 gradient(gradients[0][i], gradients[1][i], gradients[2][i]);
    normals.push_back({ places[i].Ray, { Pack(toWorld * gradient) } });
  }
}

}
