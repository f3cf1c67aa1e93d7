// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellOracle.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace CellOracle
{

namespace
{

using Matrix = std::array<Vector, 3>; ///< rows

constexpr Number IllConditioned = 1e5L;

Number Largest(const Vector& v)
{
  return std::max({ std::abs(v.x), std::abs(v.y), std::abs(v.z) });
}

/// Four values at the corners of a cube: offsets from the ray in two directions, the difference,
/// and the distance along the ray.
struct Corner
{
  Vector Value;
  Number T;
};

struct Cube
{
  std::array<Corner, 8> Corners;

  /// Means of two corners along an axis after the other.
  /// \param slope gets the derivatives of each value along the axes; [3]: those of T
  void Look(const Vector& u, Vector& value, Number& t, std::array<Vector, 4>& slope) const
  {
    using Row = glm::vec<4, Number>;
    std::array<Row, 8> v;
    for (std::size_t c = 0; c < 8; ++c)
    {
      v[c] = Row(this->Corners[c].Value, this->Corners[c].T);
    }
    const auto mix = [](const Row& a, const Row& b, Number s) { return a + s * (b - a); };
    const Row x00 = mix(v[0], v[1], u.x), x10 = mix(v[2], v[3], u.x), x01 = mix(v[4], v[5], u.x),
              x11 = mix(v[6], v[7], u.x);
    const Row y0 = mix(x00, x10, u.y), y1 = mix(x01, x11, u.y), all = mix(y0, y1, u.z);
    const Row alongX =
      mix(mix(v[1] - v[0], v[3] - v[2], u.y), mix(v[5] - v[4], v[7] - v[6], u.y), u.z);
    const Row alongY = mix(x10 - x00, x11 - x01, u.z), alongZ = y1 - y0;
    for (int i = 0; i < 4; ++i)
    {
      slope[static_cast<std::size_t>(i)] = { alongX[i], alongY[i], alongZ[i] };
    }
    value = Vector(all);
    t = all.w;
  }
};

class Search
{
public:
  Search(const Cube& cube, int depth)
    : Whole(cube)
    , Depth(depth)
  {
  }

  void Cut(const std::array<glm::dvec3, 8>& values, const Vector& low, Number size, int depth)
  {
    for (int i = 0; i < 3; ++i)
    {
      double least = values[0][i], most = least;
      for (const glm::dvec3& value : values)
      {
        least = std::min(least, value[i]);
        most = std::max(most, value[i]);
      }
      if (least > 1e-12 || most < -1e-12)
      {
        return;
      }
    }
    if (depth == this->Depth)
    {
      this->Try(low + size / 2);
      return;
    }
    const double half = 0.5;
    for (int part = 0; part < 8; ++part)
    {
      // Towards corner `part`.
      std::array<glm::dvec3, 8> corners = values;
      for (int axis = 1; axis < 8; axis *= 2)
      {
        for (int c = 0; c < 8; ++c)
        {
          if ((c & axis) == 0)
          {
            glm::dvec3& lower = corners[static_cast<std::size_t>(c)];
            glm::dvec3& higher = corners[static_cast<std::size_t>(c + axis)];
            ((part & axis) == 0 ? higher : lower) = half * (lower + higher);
          }
        }
      }
      this->Cut(
        corners, low + size / 2 * Vector(part & 1, part >> 1 & 1, part >> 2), size / 2, depth + 1);
    }
  }

  /// Begin at corners that are roots.
  void TryCorners()
  {
    for (int c = 0; c < 8; ++c)
    {
      if (Largest(this->Whole.Corners[static_cast<std::size_t>(c)].Value) < 1e-9L)
      {
        this->Try(Vector(c & 1, c >> 1 & 1, c >> 2));
      }
    }
  }

  Roots Found;

private:
  void Try(Vector u)
  {
    Matrix inverse;
    bool isThere = false;
    for (int step = 0; step < 30 && !isThere; ++step)
    {
      Vector value;
      Number t;
      std::array<Vector, 4> slopes;
      this->Whole.Look(u, value, t, slopes);
      if (step == 0)
      {
        // Here the ray does not pass, but lies in the cell.
        const Vector along = glm::cross(slopes[0], slopes[1]);
        this->Found.IsDoubtful = this->Found.IsDoubtful || Largest(along) < 1e-9L;
      }
      const Vector columns[3] = { glm::cross(slopes[1], slopes[2]),
        glm::cross(slopes[2], slopes[0]), glm::cross(slopes[0], slopes[1]) };
      const Number determinant = glm::dot(slopes[0], columns[0]);
      if (!(std::abs(determinant) > 1e-18L))
      {
        this->Found.IsDoubtful = true;
        return;
      }
      for (int i = 0; i < 3; ++i)
      {
        inverse[static_cast<std::size_t>(i)] =
          Vector(columns[0][i], columns[1][i], columns[2][i]) / determinant;
      }
      const Vector move(
        glm::dot(inverse[0], value), glm::dot(inverse[1], value), glm::dot(inverse[2], value));
      u -= move;
      if (!(Largest(u - Number(0.5)) < 3))
      {
        return;
      }
      isThere = Largest(move) < 1e-14L;
    }
    if (!isThere)
    {
      this->Found.IsDoubtful = true;
      return;
    }
    if (Largest(u - Number(0.5)) > Number(0.5) + Beyond)
    {
      return;
    }
    this->Add(u, inverse);
  }

  void Add(const Vector& u, const Matrix& inverse)
  {
    Root root;
    root.At = u;
    Vector value;
    std::array<Vector, 4> slopes;
    this->Whole.Look(u, value, root.T, slopes);
    root.Condition = 0;
    for (const Vector& row : inverse)
    {
      root.Condition =
        std::max(root.Condition, std::abs(row.x) + std::abs(row.y) + std::abs(row.z));
    }
    this->Found.IsDoubtful = this->Found.IsDoubtful || root.Condition > IllConditioned;
    for (const Root& other : this->Found.All)
    {
      if (Largest(other.At - u) < 1e-9L)
      {
        return;
      }
    }
    const Vector along = glm::cross(slopes[0], slopes[1]);
    const Number forward = glm::dot(along, slopes[3]);
    root.Rises = (glm::dot(along, slopes[2]) > 0) == (forward > 0);
    Number range = 0;
    for (const Corner& corner : this->Whole.Corners)
    {
      range = std::max(range, std::abs(corner.T - this->Whole.Corners[0].T));
    }
    root.Speed = range > 0 ? std::abs(forward) / (std::sqrt(glm::dot(along, along)) * range) : 0;
    this->Found.All.push_back(root);
  }

  const Cube& Whole;
  int Depth;
};

}

Roots FindInHexahedron(const TemporalCoherence::MeshCell& cell,
  const std::array<double, 8>& differences, const Ray& ray, int depth)
{
  // Two directions across the ray, by no rule that kernels have.
  const Vector direction = ray.Direction / std::sqrt(glm::dot(ray.Direction, ray.Direction));
  Vector any(0.3L, -0.5L, 0.81L);
  if (std::abs(glm::dot(any, direction)) > 0.9L)
  {
    any = Vector(0.7L, 0.6L, 0.2L);
  }
  Vector across = glm::cross(direction, any);
  across /= std::sqrt(glm::dot(across, across));
  const Vector up = glm::cross(direction, across);
  Cube cube;
  std::array<glm::dvec3, 8> values;
  Vector most(0);
  for (std::size_t c = 0; c < 8; ++c)
  {
    const Vector from = Vector(cell.Points[c]) - ray.Origin;
    cube.Corners[c].Value = { glm::dot(from, across), glm::dot(from, up), differences[c] };
    cube.Corners[c].T =
      glm::dot(from, direction) / std::sqrt(glm::dot(ray.Direction, ray.Direction));
    most = glm::max(most, glm::abs(cube.Corners[c].Value));
  }
  for (std::size_t c = 0; c < 8; ++c)
  {
    for (int i = 0; i < 3; ++i)
    {
      cube.Corners[c].Value[i] /= most[i] > 0 ? most[i] : 1;
    }
    values[c] = glm::dvec3(cube.Corners[c].Value);
  }
  Search search(cube, depth);
  search.Cut(values, Vector(0), 1, 0);
  search.TryCorners();
  int through = 0;
  for (const Corner& corner : cube.Corners)
  {
    through += std::max(std::abs(corner.Value.x), std::abs(corner.Value.y)) < 1e-12L;
  }
  // Through corners that coincide: the ray is at once in all points between them.
  search.Found.IsDoubtful = search.Found.IsDoubtful || through > 1;
  return search.Found;
}

Span FindInTetrahedron(
  const TemporalCoherence::MeshCell& cell, const std::array<double, 8>& differences, const Ray& ray)
{
  // Weights of vertices are linear along the ray.
  Span span;
  const Vector base = cell.Points[0];
  const Vector a = Vector(cell.Points[1]) - base, b = Vector(cell.Points[2]) - base,
               c = Vector(cell.Points[3]) - base;
  const Number volume = glm::dot(a, glm::cross(b, c));
  const Number edge = std::max({ Largest(a), Largest(b), Largest(c) });
  if (!(std::abs(volume) > 1e-6L * edge * edge * edge))
  {
    span.IsFlat = true;
    return span;
  }
  const Vector rows[3] = { glm::cross(b, c) / volume, glm::cross(c, a) / volume,
    glm::cross(a, b) / volume };
  std::array<Number, 4> at{ 1 }, slope{ 0 };
  const Vector from = ray.Origin - base;
  for (std::size_t i = 0; i < 3; ++i)
  {
    at[i + 1] = glm::dot(rows[i], from);
    slope[i + 1] = glm::dot(rows[i], ray.Direction);
    at[0] -= at[i + 1];
    slope[0] -= slope[i + 1];
  }
  span.In = -1e300L;
  span.Out = 1e300L;
  for (std::size_t i = 0; i < 4; ++i)
  {
    if (slope[i] == 0)
    {
      span.Out = at[i] < 0 ? -2e300L : span.Out;
      continue;
    }
    const Number t = -at[i] / slope[i];
    (slope[i] > 0 ? span.In : span.Out) =
      slope[i] > 0 ? std::max(span.In, t) : std::min(span.Out, t);
  }
  span.IsHit = span.In <= span.Out;
  span.AtIn = span.AtOut = 0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    span.AtIn += differences[i] * (at[i] + slope[i] * span.In);
    span.AtOut += differences[i] * (at[i] + slope[i] * span.Out);
  }
  return span;
}

}
