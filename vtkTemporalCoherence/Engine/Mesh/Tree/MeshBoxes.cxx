// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Tree/MeshBoxes.h"

#include "Mesh/Tree/MeshLattice.h"
#include "Mesh/Tree/MeshLeaves.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

float Below(double x)
{
  const auto rounded = static_cast<float>(x);
  return static_cast<double>(rounded) <= x
    ? rounded
    : std::nextafter(rounded, -std::numeric_limits<float>::infinity());
}

glm::vec3 Below(const glm::dvec3& point)
{
  return { Below(point.x), Below(point.y), Below(point.z) };
}

}

bool MeshBoxes::Build(const MeshReader& reader, const CellNumbers& order,
  const ReportProgress& progress, MeshProblem& problem)
{
  const MeshLeaves leaves = ReadLeaves(reader, order, progress, problem);
  if (problem.Defect != MeshDefect::None)
  {
    return false;
  }
  this->Edges = leaves.Edges;
  this->HasVolume = leaves.HasVolume;
  if (!leaves.Boxes.empty())
  {
    this->Place(leaves.Whole, static_cast<std::int64_t>(leaves.Boxes.size()));
    this->BuildLevels(leaves.Boxes);
  }
  return true;
}

/// Lay index space around the mesh, half a unit away or more. The scale is a power of two and the
/// origin a multiple of it, so that points in single precision are converted without rounding.
void MeshBoxes::Place(const PointBox& whole, std::int64_t leaves)
{
  this->Dimensions = 4 * MeshLattice::SizeFor(leaves) + 1;
  double needed = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    needed = std::max(needed, (whole.High[axis] - whole.Low[axis]) / (this->Dimensions[axis] - 3));
  }
  // A mesh of size 0 needs a scale, too, and smaller scales have no finite inverse.
  constexpr int LeastExponent = -900;
  int exponent = 0;
  if (needed > 0.0)
  {
    std::frexp(needed, &exponent);
  }
  this->Scale = std::ldexp(1.0, std::max(exponent, LeastExponent));
  this->PerScale = 1.0 / this->Scale;
  this->Low = this->Scale * glm::floor(whole.Low / this->Scale - 0.5);
}

FloatBox MeshBoxes::InIndexSpace(const PointBox& box) const
{
  const glm::ivec3& size = this->Dimensions;
  const double margin = std::ldexp(std::max({ size.x, size.y, size.z }), -40);
  const glm::dvec3 low = this->ToIndex(box.Low) - margin;
  const glm::dvec3 high = this->ToIndex(box.High) + margin;
  return { Below(low), -Below(-high) };
}

void MeshBoxes::BuildLevels(const std::vector<PointBox>& leaves)
{
  this->Levels.assign(1, std::vector<FloatBox>(leaves.size()));
  std::transform(leaves.begin(), leaves.end(), this->Levels[0].begin(),
    [&](const PointBox& box) { return this->InIndexSpace(box); });
  constexpr std::size_t LeastLevels = 3;
  while (this->Levels.size() < LeastLevels || this->Levels.back().size() > 1)
  {
    const std::vector<FloatBox>& below = this->Levels.back();
    std::vector<FloatBox> boxes((below.size() + 63) / 64);
    for (std::size_t i = 0; i < below.size(); ++i)
    {
      boxes[i / 64].Widen(below[i]);
    }
    this->Levels.push_back(std::move(boxes));
  }
}

IndexBox MeshBoxes::BoxOf(const CellBox& cells) const
{
  FloatBox box;
  if (!this->Levels.empty())
  {
    // Convert cells to leaves.
    const glm::ivec3 last = cells.First + cells.Size - 1;
    const auto leafOf = [](const glm::ivec3& cell)
    { return glm::ivec3(cell.x >> 2, cell.y >> 2, cell.z >> 2); };
    this->WidenBy(this->Levels.size() - 1, glm::ivec3(0), leafOf(cells.First), leafOf(last), box);
  }
  if (box.Low.x > box.High.x)
  {
    return { glm::dvec3(0.0), glm::dvec3(0.0) };
  }
  return { glm::dvec3(box.Low), glm::dvec3(box.High) };
}

/// Widen a box by the boxes of a block's leaves within first .. last.
void MeshBoxes::WidenBy(std::size_t level, const glm::ivec3& block, const glm::ivec3& first,
  const glm::ivec3& last, FloatBox& box) const
{
  const int bits = 2 * static_cast<int>(level);
  const glm::ivec3 begin(block.x << bits, block.y << bits, block.z << bits);
  const glm::ivec3 end = begin + (1 << bits) - 1;
  const auto number = static_cast<std::size_t>(MeshLattice::NumberOf(block));
  if (number >= this->Levels[level].size() || glm::any(glm::lessThan(last, begin)) ||
    glm::any(glm::greaterThan(first, end)))
  {
    return;
  }
  if (glm::all(glm::lessThanEqual(first, begin)) && glm::all(glm::greaterThanEqual(last, end)))
  {
    box.Widen(this->Levels[level][number]);
    return;
  }
  // Visit only children within first .. last.
  const int below = bits - 2;
  const auto childOf = [&](const glm::ivec3& leaf)
  { return glm::ivec3(leaf.x >> below, leaf.y >> below, leaf.z >> below); };
  const glm::ivec3 from = childOf(glm::max(first, begin)), to = childOf(glm::min(last, end));
  for (int z = from.z; z <= to.z; ++z)
  {
    for (int y = from.y; y <= to.y; ++y)
    {
      for (int x = from.x; x <= to.x; ++x)
      {
        this->WidenBy(level - 1, { x, y, z }, first, last, box);
      }
    }
  }
}

std::size_t MeshBoxes::MemoryInBytes() const
{
  std::size_t boxes = 0;
  for (const std::vector<FloatBox>& level : this->Levels)
  {
    boxes += level.capacity();
  }
  return boxes * sizeof(FloatBox);
}

}
