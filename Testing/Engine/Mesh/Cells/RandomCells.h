// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_RandomCells_h
#define Testing_RandomCells_h

#include "Mesh/Cells/KernelsCells.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <random>

/// How the rays of a tile go: all from one point, or all the same way.
struct TileAim
{
  bool AreParallel = false;
  glm::dvec3 Eye{ 0.0 }, Along{ 0.0 };

  /// \param nextTarget `nextTarget()` is a point that the next ray goes through
  template <typename NextTarget>
  void At(const NextTarget& nextTarget, TemporalCoherence::MeshKernels::MeshRays& rays) const
  {
    rays.Count = rays.Capacity;
    for (std::size_t ray = 0; ray < rays.Count; ++ray)
    {
      const glm::dvec3 target = nextTarget();
      const glm::dvec3 direction = this->AreParallel ? this->Along : target - this->Eye;
      const glm::dvec3 origin = this->AreParallel ? target - 32.0 * this->Along : this->Eye;
      for (int a = 0; a < 3; ++a)
      {
        rays.Origin[static_cast<std::size_t>(a)][ray] = origin[a];
        rays.Direction[static_cast<std::size_t>(a)][ray] = direction[a];
      }
      rays.Begin[ray] = -1e30;
      rays.End[ray] = 1e30;
    }
    rays.Prepare();
  }
};

/// Cells of all kinds, good and bad, and rays that meet them.
class RandomCells
{
public:
  explicit RandomCells(unsigned int seed)
    : Engine(seed)
  {
  }

  double Around() { return std::uniform_real_distribution<double>(-1.0, 1.0)(this->Engine); }
  int Below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(this->Engine); }
  glm::dvec3 Point() { return { this->Around(), this->Around(), this->Around() }; }

  /// A cell that is about 2 Scale long.
  TemporalCoherence::MeshCell Hexahedron()
  {
    TemporalCoherence::MeshCell cell;
    cell.Shape = TemporalCoherence::MeshCellShape::Hexahedron;
    const double warps[] = { 0.0, 0.05, 0.3, 0.9 }, bends[] = { 0.0, 0.1, 0.5, 2.0 };
    const double warp = warps[this->Below(4)], bend = bends[this->Below(4)];
    const glm::dvec3 gradient = this->Point(), x = this->Point(), y = this->Point(),
                     z = this->Point();
    const bool isTurned = this->Below(2) == 0;
    const double offset = 0.5 * this->Around();
    for (std::size_t c = 0; c < 8; ++c)
    {
      const glm::dvec3 unit(c & 1 ? 1.0 : -1.0, c & 2 ? 1.0 : -1.0, c & 4 ? 1.0 : -1.0);
      const glm::dvec3 at = isTurned ? unit.x * x + unit.y * y + unit.z * z : unit;
      cell.Points[c] = at + warp * this->Point();
      cell.Values[c] = glm::dot(gradient, cell.Points[c]) + offset + bend * this->Around();
    }
    this->Spoil(cell);
    this->Move(cell);
    return cell;
  }

  TemporalCoherence::MeshCell Tetrahedron()
  {
    TemporalCoherence::MeshCell cell;
    cell.Shape = TemporalCoherence::MeshCellShape::Tetrahedron;
    for (std::size_t c = 0; c < 8; ++c)
    {
      cell.Points[c] = this->Point();
      cell.Values[c] = this->Below(8) == 0 ? 0.0 : this->Around();
    }
    if (this->Below(16) == 0)
    {
      cell.Points[3] = 0.5 * (cell.Points[0] + cell.Points[1]); // flat
    }
    if (this->Below(16) == 0)
    {
      cell.Points[2] = cell.Points[1];
    }
    this->Move(cell);
    return cell;
  }

  /// From a point at most so far away along each axis, or along an axis.
  TileAim Aim(double distance)
  {
    TileAim aim;
    aim.AreParallel = this->Below(2) == 0;
    aim.Eye = distance * this->Point();
    aim.Along[this->Below(3)] = 1.0;
    return aim;
  }

  /// A ray that goes to somewhere in a cell, or exactly through a vertex or the middle of an edge.
  void Aim(const TemporalCoherence::MeshCell& cell, glm::dvec3& origin, glm::dvec3& direction)
  {
    const int corners = cell.NumberOfPoints();
    glm::dvec3 target(0.0);
    double sum = 0.0;
    for (int c = 0; c < corners; ++c)
    {
      const double weight = 1.0 + this->Around();
      target += weight * (cell.Points[static_cast<std::size_t>(c)] - this->Middle);
      sum += weight;
    }
    target = this->Middle + target / sum;
    const int special = this->Below(8);
    const glm::dvec3 vertex = cell.Points[static_cast<std::size_t>(this->Below(corners))];
    target = special == 0 ? vertex : special == 1 ? 0.5 * (vertex + cell.Points[0]) : target;
    direction = this->Point();
    if (this->Below(8) == 0)
    {
      const int axis = this->Below(3);
      direction = glm::dvec3(0.0);
      direction[axis] = this->Below(2) == 0 ? 1.0 : -1.0;
    }
    direction = glm::normalize(direction);
    const double distances[] = { 3.0, 30.0, 1000.0 };
    const double distance = distances[this->Below(3)] * this->Scale;
    origin = target - distance * direction;
  }

  double Scale = 1.0;       ///< of the last cell
  glm::dvec3 Middle{ 0.0 }; ///< of the last cell
  bool HasScales = true;    ///< cells may be huge or tiny
private:
  /// Make some cells degenerate.
  void Spoil(TemporalCoherence::MeshCell& cell)
  {
    auto& p = cell.Points;
    auto& v = cell.Values;
    const auto join = [&](std::size_t from, std::size_t to)
    {
      p[to] = p[from];
      v[to] = v[from];
    };
    switch (this->Below(16))
    {
      case 0: // wedge
        join(2, 3);
        join(6, 7);
        break;
      case 1: // pyramid
        join(4, 5);
        join(4, 6);
        join(4, 7);
        break;
      case 2: // tetrahedron
        join(2, 3);
        join(4, 5);
        join(4, 6);
        join(4, 7);
        break;
      case 3: // folded
        std::swap(p[0], p[this->Below(2) == 0 ? 1 : 7]);
        break;
      case 4: // inverted
        for (std::size_t c = 0; c < 4; ++c)
        {
          std::swap(p[c], p[c + 4]);
        }
        break;
      case 5: // flat
        for (glm::dvec3& point : p)
        {
          point.z = 0.25 * point.x;
        }
        break;
      case 6: // two points that do not belong together coincide
        p[static_cast<std::size_t>(this->Below(8))] = p[static_cast<std::size_t>(this->Below(8))];
        break;
      case 7: // values at the isovalue
        for (int i = 0; i < 3; ++i)
        {
          v[static_cast<std::size_t>(this->Below(8))] = 0.0;
        }
        break;
      default:
        break;
    }
  }

  void Move(TemporalCoherence::MeshCell& cell)
  {
    const double scales[] = { 1.0, 1e-30, 1e25, 1e-3 };
    this->Scale = this->HasScales ? scales[std::max(this->Below(8) - 4, 0)] : 1.0;
    this->Middle = this->Below(4) == 0 ? 20.0 * this->Scale * this->Point() : glm::dvec3(0.0);
    for (glm::dvec3& point : cell.Points)
    {
      point = this->Middle + this->Scale * point;
    }
  }

  std::mt19937 Engine;
};

/// 64 cells, and a ray for each.
struct CellPairs
{
  using Crossings = TemporalCoherence::MeshKernels::Crossings;
  using CellSpans = TemporalCoherence::MeshKernels::CellSpans;

  std::array<TemporalCoherence::MeshCell, 64> Cells;
  std::array<double, 64> Scales;
  std::array<std::array<double, 8>, 64> Differences;
  TemporalCoherence::MeshKernels::MeshRays Rays;

  CellPairs(RandomCells& random, bool areTetrahedra)
  {
    this->Rays.Count = 64;
    for (std::size_t i = 0; i < 64; ++i)
    {
      this->Cells[i] = areTetrahedra ? random.Tetrahedron() : random.Hexahedron();
      this->Differences[i] = this->Cells[i].Values;
      this->Scales[i] = random.Scale;
      glm::dvec3 origin, direction;
      random.Aim(this->Cells[i], origin, direction);
      for (int a = 0; a < 3; ++a)
      {
        this->Rays.Origin[static_cast<std::size_t>(a)][i] = origin[a];
        this->Rays.Direction[static_cast<std::size_t>(a)][i] = direction[a];
      }
      this->Rays.Begin[i] = -1e40;
      this->Rays.End[i] = 1e40;
    }
    this->Rays.Prepare();
  }

  /// Find the crossings of each ray with its cell.
  void FindCrossings(Crossings& found) const
  {
    found.Count = 0;
    for (std::size_t i = 0; i < 64; ++i)
    {
      CellCrossings(this->Cells[i], this->Differences[i], this->Rays, std::uint64_t(1) << i, found);
    }
  }

  /// Find the parts of each ray in its cell.
  void FindSpans(CellSpans& spans) const
  {
    CellSpans ofRay;
    for (std::size_t i = 0; i < 64; ++i)
    {
      FindCellSpans(this->Cells[i], this->Differences[i], this->Rays, std::uint64_t(1) << i, ofRay);
      spans.Count[i] = ofRay.Count[i];
      std::copy_n(ofRay.Spans[i].begin(), ofRay.Count[i], spans.Spans[i].begin());
    }
  }
};

#endif
