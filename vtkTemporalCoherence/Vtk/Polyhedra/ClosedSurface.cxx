// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Polyhedra/ClosedSurface.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace TemporalCoherence
{
namespace
{

using Points = std::vector<glm::dvec3>;
using Surface = std::vector<SurfacePart>;

const glm::dvec3& PointAt(const Points& points, const SurfacePart& part, std::size_t corner)
{
  return points[static_cast<std::size_t>(part.At(corner))];
}

/// An edge of a part.
struct Edge
{
  std::pair<std::int32_t, std::int32_t> Ends; ///< ascending
  std::size_t Part;
  int Way; ///< 1: the part has it in this direction, -1: in the other one
};

/// All edges of a surface, sorted by their end points.
std::vector<Edge> EdgesOf(const Surface& surface)
{
  std::vector<Edge> edges;
  for (std::size_t part = 0; part < surface.size(); ++part)
  {
    for (std::size_t c = 0; c < surface[part].Size; ++c)
    {
      const std::int32_t a = surface[part].At(c), b = surface[part].At(c + 1);
      if (a != b)
      {
        edges.push_back({ std::minmax(a, b), part, a < b ? 1 : -1 });
      }
    }
  }
  std::stable_sort(
    edges.begin(), edges.end(), [](const Edge& a, const Edge& b) { return a.Ends < b.Ends; });
  return edges;
}

/// Call function(first, end) for each run of edges with equal end points.
template <typename Function>
void ForEachEdge(const std::vector<Edge>& edges, const Function& function)
{
  for (std::size_t first = 0, next = 0; first < edges.size(); first = next)
  {
    for (next = first; next < edges.size() && edges[next].Ends == edges[first].Ends; ++next)
    {
    }
    function(first, next);
  }
}

/// True if every edge occurs equally often in both directions.
bool IsClosed(const std::vector<Edge>& edges, const std::vector<int>& turns)
{
  bool isClosed = true;
  ForEachEdge(edges,
    [&](std::size_t first, std::size_t next)
    {
      int sum = 0;
      for (std::size_t e = first; e < next; ++e)
      {
        sum += edges[e].Way * turns[edges[e].Part];
      }
      isClosed = isClosed && sum == 0;
    });
  return isClosed;
}

/// True if a part is so thin that its normal consists of rounding errors.
bool IsFlat(const Points& points, const SurfacePart& part, const glm::dvec3& normal)
{
  double longest = 0.0;
  for (std::size_t c = 0; c < part.Size; ++c)
  {
    const glm::dvec3 edge = PointAt(points, part, c + 1) - PointAt(points, part, c);
    longest = std::max(longest, glm::dot(edge, edge));
  }
  constexpr double rounding = 1e-14;
  return !(glm::length(normal) > rounding * longest);
}

/// Six times the volume between a part and a point.
double VolumeBefore(const Points& points, const SurfacePart& part, const glm::dvec3& from)
{
  double volume = 0.0;
  for (std::size_t c = 1; c + 1 < part.Size; ++c)
  {
    volume += glm::dot(PointAt(points, part, 0) - from,
      glm::cross(PointAt(points, part, c) - from, PointAt(points, part, c + 1) - from));
  }
  return volume;
}

/// Find the parts to turn so that parts with a common edge agree. Number the connected pieces.
void FitTogether(const Surface& surface, const std::vector<Edge>& edges, std::vector<int>& turns,
  std::vector<std::size_t>& pieces)
{
  std::vector<std::vector<std::pair<std::size_t, int>>> beside(surface.size());
  ForEachEdge(edges,
    [&](std::size_t first, std::size_t next)
    {
      if (next - first == 2)
      {
        const Edge &a = edges[first], &b = edges[first + 1];
        beside[a.Part].emplace_back(b.Part, -a.Way * b.Way);
        beside[b.Part].emplace_back(a.Part, -a.Way * b.Way);
      }
    });
  turns.assign(surface.size(), 0);
  pieces.assign(surface.size(), 0);
  for (std::size_t start = 0; start < surface.size(); ++start)
  {
    std::vector<std::size_t> open;
    if (turns[start] == 0)
    {
      turns[start] = 1;
      open.push_back(start);
    }
    while (!open.empty())
    {
      const std::size_t part = open.back();
      open.pop_back();
      pieces[part] = start;
      for (const auto& [other, fits] : beside[part])
      {
        if (turns[other] == 0)
        {
          turns[other] = turns[part] * fits;
          open.push_back(other);
        }
      }
    }
  }
}

}

glm::dvec3 NormalAt(const Points& points, const SurfacePart& part, std::size_t corner)
{
  const glm::dvec3& at = PointAt(points, part, corner);
  return glm::cross(
    PointAt(points, part, corner + 1) - at, PointAt(points, part, corner + part.Size - 1) - at);
}

glm::dvec3 NormalOf(const Points& points, const SurfacePart& part)
{
  return part.Size == 3 ? NormalAt(points, part, 0)
                        : glm::cross(PointAt(points, part, 2) - PointAt(points, part, 0),
                            PointAt(points, part, 3) - PointAt(points, part, 1));
}

namespace
{

/// Height of a cone over a part, times twice the area of the part.
/// \param way 1: a cone behind the part; -1: in front of it. The result is not positive if the cone
///            is inverted somewhere.
double VolumeBehind(const Points& points, const SurfacePart& part, const glm::dvec3& normal,
  const glm::dvec3& from, double way)
{
  if (part.Size == 3)
  {
    return way * glm::dot(normal, PointAt(points, part, 0) - from);
  }
  // A cone over a bilinear part is inverted at a corner if it is inverted anywhere.
  constexpr double rounding = 1e-9;
  double sum = 0.0, least = 0.0;
  for (std::size_t c = 0; c < part.Size; ++c)
  {
    const double volume =
      way * glm::dot(NormalAt(points, part, c), PointAt(points, part, c) - from);
    least = std::min(least, volume);
    sum += 0.5 * volume;
  }
  return least < -rounding * std::max(sum, 0.0) ? least : sum;
}

}

double HeightBehind(
  const Points& points, const SurfacePart& part, const glm::dvec3& from, double way)
{
  const glm::dvec3 normal = NormalOf(points, part);
  return IsFlat(points, part, normal)
    ? std::numeric_limits<double>::infinity()
    : VolumeBehind(points, part, normal, from, way) / glm::length(normal);
}

bool IsSeenFromMean(const Points& points, std::size_t corners, const Surface& surface, double share)
{
  const auto count = static_cast<double>(corners);
  glm::dvec3 mean(0.0), least(points.front()), most(points.front());
  for (std::size_t p = 0; p < corners; ++p)
  {
    mean += (points[p] - points[0]) / count;
    least = glm::min(least, points[p]);
    most = glm::max(most, points[p]);
  }
  mean += points[0];
  const double size = glm::distance(least, most);
  share /= count;
  double way = 0.0;
  for (const SurfacePart& part : surface)
  {
    const glm::dvec3 normal = NormalOf(points, part);
    const glm::dvec3& on = PointAt(points, part, 0);
    way = way != 0.0 || IsFlat(points, part, normal) ? way
      : glm::dot(normal, on - mean) < 0.0            ? -1.0
                                                     : 1.0;
    const double ofMean = VolumeBehind(points, part, normal, mean, way);
    // No point is farther away than the size.
    if (ofMean > share * size * glm::length(normal) || IsFlat(points, part, normal))
    {
      continue;
    }
    double largest = 0.0;
    for (std::size_t p = 0; p < corners; ++p)
    {
      largest = std::max(largest, way * glm::dot(normal, on - points[p]));
    }
    if (!(ofMean >= share * largest))
    {
      return false;
    }
  }
  return true;
}

bool TurnOutwards(const Points& points, Surface& surface)
{
  const std::vector<Edge> edges = EdgesOf(surface);
  std::vector<int> turns(surface.size(), 1);
  std::vector<std::size_t> pieces(surface.size(), 0);
  if (!IsClosed(edges, turns))
  {
    FitTogether(surface, edges, turns, pieces);
    if (!IsClosed(edges, turns))
    {
      return false;
    }
  }
  std::vector<double> volumes(surface.size(), 0.0);
  for (std::size_t part = 0; part < surface.size(); ++part)
  {
    volumes[pieces[part]] += turns[part] * VolumeBefore(points, surface[part], points[0]);
  }
  for (std::size_t part = 0; part < surface.size(); ++part)
  {
    if ((volumes[pieces[part]] < 0.0) != (turns[part] < 0))
    {
      const auto first = surface[part].Points.begin();
      std::reverse(first, first + static_cast<std::ptrdiff_t>(surface[part].Size));
    }
  }
  return true;
}

}
