// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Polyhedra/ConeDivision.h"

#include <vtkIdList.h>
#include <vtkMeanValueCoordinatesInterpolator.h>
#include <vtkNew.h>
#include <vtkPoints.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>

namespace TemporalCoherence
{
namespace
{

constexpr double Rounding = 1e-9;

/// Smallest height of a cone.
constexpr double LeastHeight = 1e-5;

/// The convex hull of a part, or of a cone over a part.
struct Hull
{
  std::array<glm::dvec3, 5> Points;
  std::size_t Size = 0;

  void Add(const glm::dvec3& point) { this->Points[this->Size++] = point; }
};

/// True if a plane with this normal separates two hulls. Both may touch it.
bool IsBetween(const glm::dvec3& normal, const Hull& a, const Hull& b)
{
  const double length = glm::length(normal);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  double leastA = infinity, mostA = -infinity, leastB = infinity, mostB = -infinity;
  for (std::size_t p = 0; p < a.Size; ++p)
  {
    const double at = glm::dot(normal, a.Points[p]);
    leastA = std::min(leastA, at);
    mostA = std::max(mostA, at);
  }
  for (std::size_t p = 0; p < b.Size; ++p)
  {
    const double at = glm::dot(normal, b.Points[p]);
    leastB = std::min(leastB, at);
    mostB = std::max(mostB, at);
  }
  constexpr double shortest = 1e-12;
  return length > shortest && std::min(mostA - leastB, mostB - leastA) <= Rounding * length;
}

/// True if a plane through three points of the first hull lies between the hulls.
bool HasPlaneBetween(const Hull& a, const Hull& b)
{
  for (std::size_t i = 2; i < a.Size; ++i)
  {
    for (std::size_t j = 1; j < i; ++j)
    {
      for (std::size_t k = 0; k < j; ++k)
      {
        if (IsBetween(glm::cross(a.Points[j] - a.Points[i], a.Points[k] - a.Points[i]), a, b))
        {
          return true;
        }
      }
    }
  }
  return false;
}

/// True if the insides of two convex hulls have no point in common. If so, some separating plane is
/// parallel to a hull's face, or to an edge of each hull.
bool AreApart(const Hull& a, const Hull& b)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    glm::dvec3 normal(0.0);
    normal[axis] = 1.0;
    if (IsBetween(normal, a, b))
    {
      return true;
    }
  }
  if (HasPlaneBetween(a, b) || HasPlaneBetween(b, a))
  {
    return true;
  }
  for (std::size_t i = 1; i < a.Size; ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      for (std::size_t k = 1; k < b.Size; ++k)
      {
        for (std::size_t l = 0; l < k; ++l)
        {
          const glm::dvec3 normal =
            glm::cross(a.Points[j] - a.Points[i], b.Points[l] - b.Points[k]);
          if (IsBetween(normal, a, b))
          {
            return true;
          }
        }
      }
    }
  }
  return false;
}

/// Weights of points by VTK's mean value coordinates.
class SurfaceWeights
{
public:
  SurfaceWeights(const std::vector<glm::dvec3>& points, const std::vector<SurfacePart>& surface)
  {
    this->Points->SetDataTypeToDouble();
    for (const glm::dvec3& point : points)
    {
      this->Points->InsertNextPoint(&point.x);
    }
    for (const SurfacePart& part : surface)
    {
      for (std::size_t c = 1; c + 1 < part.Size; ++c)
      {
        this->Triangles->InsertNextId(part.At(0));
        this->Triangles->InsertNextId(part.At(c));
        this->Triangles->InsertNextId(part.At(c + 1));
      }
    }
  }

  std::vector<double> At(const glm::dvec3& place) const
  {
    std::vector<double> weights(static_cast<std::size_t>(this->Points->GetNumberOfPoints()), 0.0);
    vtkMeanValueCoordinatesInterpolator::ComputeInterpolationWeights(
      &place.x, this->Points, this->Triangles, weights.data());
    return weights;
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkIdList> Triangles;
};

/// Makes one attempt to divide a cell.
class Divider
{
public:
  /// \param attempt number of the attempt. Attempts try different places. Even ones take the place
  ///                that leaves the fewest parts, odd ones the place that sees most
  Divider(const std::vector<glm::dvec3>& points, const std::vector<SurfacePart>& surface,
    const SurfaceWeights& weights, int attempt)
    : Points(points)
    , Rest(surface)
    , Given(points.size())
    , Weights(weights)
    , Attempt(attempt)
  {
  }

  /// \param work remaining budget of compared pairs
  bool Divide(std::int64_t& work)
  {
    const std::size_t mostPoints = this->Rest.size() / 2 + 4;
    while (this->Made.Inside.size() < mostPoints && work > 0)
    {
      glm::dvec3 kernel;
      if (this->FindKernel(kernel))
      {
        return this->CutOff(kernel, std::vector<char>(this->Rest.size(), 1));
      }
      glm::dvec3 best;
      std::vector<char> seen;
      if (!this->FindBest(best, seen, work) || !this->CutOff(best, seen))
      {
        return false;
      }
    }
    return false;
  }

  ConeDivision Made;

private:
  Hull HullOf(const SurfacePart& part) const
  {
    Hull hull;
    for (std::size_t c = 0; c < part.Size; ++c)
    {
      hull.Add(this->Points[static_cast<std::size_t>(part.At(c))]);
    }
    return hull;
  }

  bool FindKernel(glm::dvec3& kernel) const;
  bool FindBest(glm::dvec3& best, std::vector<char>& seen, std::int64_t& work) const;
  bool FindPlaceBehind(std::size_t part, glm::dvec3& place) const;
  std::vector<char> SeenFrom(const glm::dvec3& from) const;
  std::vector<std::pair<std::int32_t, std::int32_t>> RimOf(const std::vector<char>& parts) const;
  bool CutOff(const glm::dvec3& from, const std::vector<char>& parts);

  std::vector<glm::dvec3> Points;
  std::vector<SurfacePart> Rest; ///< the surface of the undivided rest
  std::size_t Given;
  const SurfaceWeights& Weights;
  int Attempt;
};

/// Find a point behind all parts of the rest, about as far inside as possible: step behind the
/// plane that the point misses most, until it misses none.
bool Divider::FindKernel(glm::dvec3& kernel) const
{
  struct Plane
  {
    glm::dvec3 Inwards;
    double At;
  };
  std::vector<Plane> planes;
  glm::dvec3 place(0.0);
  for (const SurfacePart& part : this->Rest)
  {
    for (std::size_t c = 0; c < (part.Size == 3 ? 1 : part.Size); ++c)
    {
      const glm::dvec3 normal = -NormalAt(this->Points, part, c);
      const glm::dvec3& on = this->Points[static_cast<std::size_t>(part.At(c))];
      constexpr double flat = 1e-12;
      if (glm::length(normal) > flat)
      {
        planes.push_back({ glm::normalize(normal), glm::dot(glm::normalize(normal), on) });
        place += on;
      }
    }
  }
  place /= static_cast<double>(std::max<std::size_t>(planes.size(), 1));
  constexpr int mostSteps = 200;
  constexpr double over = 1.2, most = 0.25, less = 0.4;
  double best = LeastHeight;
  for (double margin = most; best < margin && margin > LeastHeight; margin *= less)
  {
    glm::dvec3 at = place;
    for (int step = 0; step < mostSteps; ++step)
    {
      double least = std::numeric_limits<double>::infinity();
      const Plane* missed = nullptr;
      for (const Plane& plane : planes)
      {
        const double height = glm::dot(plane.Inwards, at) - plane.At;
        missed = height < least ? &plane : missed;
        least = std::min(least, height);
      }
      if (least > best)
      {
        best = least;
        kernel = at;
      }
      if (!missed || least >= margin)
      {
        break;
      }
      at += over * (margin - least) * missed->Inwards;
    }
  }
  return best > LeastHeight;
}

/// Find a place about half way between a part and the next part behind it. Exact middles of
/// symmetric cells would lie in the planes of other parts.
bool Divider::FindPlaceBehind(std::size_t part, glm::dvec3& place) const
{
  constexpr double golden = 0.618033988749895, half = 0.43, spread = 0.02;
  const SurfacePart& front = this->Rest[part];
  glm::dvec3 from(0.0);
  double sum = 0.0;
  for (std::size_t c = 0; c < front.Size; ++c)
  {
    const double weight = 1.0 +
      0.5 * std::fmod(golden * (front.At(c) + 1.0) + golden * golden * (1.0 + this->Attempt), 1.0);
    from += weight * this->Points[static_cast<std::size_t>(front.At(c))];
    sum += weight;
  }
  from /= sum;
  const glm::dvec3 normal = NormalOf(this->Points, front);
  if (!(glm::length(normal) > Rounding * Rounding))
  {
    return false;
  }
  const glm::dvec3 inwards = -glm::normalize(normal);
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t other = 0; other < this->Rest.size(); ++other)
  {
    const Hull hull = this->HullOf(this->Rest[other]);
    for (std::size_t c = 1; other != part && c + 1 < hull.Size; ++c)
    {
      const glm::dvec3 along = hull.Points[c] - hull.Points[0];
      const glm::dvec3 across = hull.Points[c + 1] - hull.Points[0];
      const glm::dvec3 to = from - hull.Points[0];
      const double volume = glm::dot(along, glm::cross(inwards, across));
      const double u = glm::dot(to, glm::cross(inwards, across)) / volume;
      const double v = glm::dot(inwards, glm::cross(to, along)) / volume;
      const double distance = glm::dot(across, glm::cross(to, along)) / volume;
      const bool isHit = u >= -Rounding && v >= -Rounding && u + v <= 1.0 + Rounding;
      if (isHit && distance > Rounding)
      {
        nearest = std::min(nearest, distance);
      }
    }
  }
  place = from + (half + spread * this->Attempt) * nearest * inwards;
  return std::isfinite(nearest);
}

/// The parts whose cones from a point stay inside of the rest.
std::vector<char> Divider::SeenFrom(const glm::dvec3& from) const
{
  std::vector<char> seen(this->Rest.size(), 0);
  for (std::size_t part = 0; part < this->Rest.size(); ++part)
  {
    if (!(HeightBehind(this->Points, this->Rest[part], from) > LeastHeight))
    {
      continue;
    }
    Hull cone = this->HullOf(this->Rest[part]);
    cone.Add(from);
    std::size_t other = 0;
    while (other < this->Rest.size() &&
      (other == part || AreApart(cone, this->HullOf(this->Rest[other]))))
    {
      ++other;
    }
    seen[part] = other == this->Rest.size();
  }
  return seen;
}

/// The boundary edges of some parts, in the direction of the parts.
std::vector<std::pair<std::int32_t, std::int32_t>> Divider::RimOf(
  const std::vector<char>& parts) const
{
  std::map<std::pair<std::int32_t, std::int32_t>, int> counts;
  for (std::size_t part = 0; part < this->Rest.size(); ++part)
  {
    for (std::size_t c = 0; parts[part] && c < this->Rest[part].Size; ++c)
    {
      const std::int32_t a = this->Rest[part].At(c), b = this->Rest[part].At(c + 1);
      ++counts[{ a, b }];
      --counts[{ b, a }];
    }
  }
  std::vector<std::pair<std::int32_t, std::int32_t>> rim;
  for (const auto& [edge, count] : counts)
  {
    rim.insert(rim.end(), static_cast<std::size_t>(std::max(count, 0)), edge);
  }
  return rim;
}

/// Find the place whose cones leave the fewest parts or, in odd attempts, remove most parts.
bool Divider::FindBest(glm::dvec3& best, std::vector<char>& seen, std::int64_t& work) const
{
  constexpr std::size_t mostPlaces = 64;
  const std::size_t step = (this->Rest.size() + mostPlaces - 1) / mostPlaces;
  auto fewest = std::numeric_limits<std::ptrdiff_t>::max();
  for (std::size_t part = 0; part < this->Rest.size() && work > 0; part += step)
  {
    glm::dvec3 place;
    if (!this->FindPlaceBehind(part, place))
    {
      continue;
    }
    work -= static_cast<std::int64_t>(this->Rest.size() * this->Rest.size());
    const std::vector<char> parts = this->SeenFrom(place);
    const std::ptrdiff_t gone = std::count(parts.begin(), parts.end(), 1);
    const std::ptrdiff_t more =
      this->Attempt % 2 == 0 ? static_cast<std::ptrdiff_t>(this->RimOf(parts).size()) : 0;
    if (gone > 0 && more - gone < fewest)
    {
      fewest = more - gone;
      best = place;
      seen = parts;
    }
  }
  return !seen.empty();
}

/// Make cones from a point over some parts. In the surface of the rest, triangles between the point
/// and the rim of these parts replace the parts.
/// \return false if a cone is inverted
bool Divider::CutOff(const glm::dvec3& from, const std::vector<char>& parts)
{
  // Mean value coordinates are exact to half of the digits. So the place is computed from them.
  constexpr double accuracy = 1e-7;
  const std::vector<double> weights = this->Weights.At(from);
  glm::dvec3 place(0.0);
  for (std::size_t p = 0; p < this->Given; ++p)
  {
    place += weights[p] * this->Points[p];
  }
  if (!(glm::distance(place, from) < accuracy))
  {
    return false;
  }
  const auto apex = static_cast<std::int32_t>(this->Points.size());
  std::vector<SurfacePart> rest;
  for (const auto& [a, b] : this->RimOf(parts))
  {
    rest.push_back({ { a, b, apex, -1 }, 3 });
  }
  for (std::size_t part = 0; part < this->Rest.size(); ++part)
  {
    if (!parts[part])
    {
      rest.push_back(this->Rest[part]);
      continue;
    }
    this->Made.Cones.push_back({ this->Rest[part], apex });
    if (!(HeightBehind(this->Points, this->Rest[part], place) > 0.0))
    {
      return false;
    }
  }
  this->Points.push_back(place);
  this->Made.Inside.push_back(weights);
  this->Rest = std::move(rest);
  return true;
}

}

bool DivideIntoCones(const std::vector<glm::dvec3>& points, const std::vector<SurfacePart>& surface,
  DivisionWork& work, ConeDivision& division)
{
  constexpr int mostAttempts = 6;
  const std::int64_t most = work.OfFailed > 0 ? work.OfOne : work.Afterwards;
  std::int64_t left = most;
  const SurfaceWeights weights(points, surface);
  for (int attempt = 0; attempt < mostAttempts && left > 0; ++attempt)
  {
    Divider divider(points, surface, weights, attempt);
    if (divider.Divide(left))
    {
      division = std::move(divider.Made);
      return true;
    }
  }
  work.OfFailed -= most - left;
  return false;
}

}
