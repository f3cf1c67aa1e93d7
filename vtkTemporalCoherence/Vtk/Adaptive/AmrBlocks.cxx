// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Adaptive/AmrBlocks.h"

#include "Input/GhostArray.h"
#include "Input/SamplesOfArray.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkMatrix3x3.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <sstream>

namespace TemporalCoherence
{
namespace
{

/// Largest offset of a lattice that still fits, in cells.
constexpr double LargestOffset = 1e-3;

/// Limit of the finest lattice along an axis: more cells could not be numbered.
constexpr double MostCellsAlong = 1e15;

std::string NumberText(double number)
{
  std::ostringstream text;
  text << number;
  return text.str();
}

glm::dvec3 SpacingOf(vtkImageData* grid)
{
  return { grid->GetSpacing()[0], grid->GetSpacing()[1], grid->GetSpacing()[2] };
}

/// The corner with the lowest coordinates, whatever the extent begins with.
glm::dvec3 CornerOf(vtkImageData* grid)
{
  const int* extent = grid->GetExtent();
  glm::dvec3 corner;
  for (int axis = 0; axis < 3; ++axis)
  {
    corner[axis] = grid->GetOrigin()[axis] + extent[2 * axis] * grid->GetSpacing()[axis];
  }
  return corner;
}

bool HasArray(AmrBlock& block, const ScalarChoice& choice, std::string& error)
{
  const ChosenScalars scalars = FindScalars(block.Grid, choice);
  block.Array = scalars.Array;
  if (block.Array && !scalars.OnCells)
  {
    error = block.Name +
      " has values at its points, but adaptive grids with several levels are "
      "drawn by values of cells; make some with vtkPointDataToCellData.";
    return false;
  }
  const ArrayPlaces cells{ block.Name, true, CountSamples(block.Grid, true) };
  return !block.Array ||
    (CheckTuples(block.Array, cells, error) &&
      FindFlags(block.Grid->GetCellData(), cells, block.Ghosts, error));
}

/// The blocks with the array, the finest ones first. Their cells are not known yet.
bool FindBlocks(AdaptiveGrid* amr, const ScalarChoice& choice, AmrBlocks& found, std::string& error)
{
  for (unsigned int level = amr->GetNumberOfLevels(); level-- > 0;)
  {
    const std::size_t before = found.Blocks.size();
    for (unsigned int index = 0; index < CountBlocks(amr, level); ++index)
    {
      AmrBlock block;
      block.Grid = GridOf(amr, level, index);
      block.Name = "Block " + std::to_string(index) + " of level " + std::to_string(level);
      if (!block.Grid)
      {
        continue;
      }
      const int* points = block.Grid->GetDimensions();
      if (*std::min_element(points, points + 3) < 2)
      {
        error = block.Name +
          " has no cells with a volume, but only adaptive grids in three "
          "dimensions can be drawn; draw another data set.";
        return false;
      }
      if (!HasArray(block, choice, error))
      {
        return false;
      }
      if (block.Array)
      {
        block.Level = found.Levels.size(); // from the finest one, for now
        found.Blocks.push_back(block);
      }
    }
    if (found.Blocks.size() > before)
    {
      found.Levels.push_back({ SpacingOf(found.Blocks.back().Grid), glm::i64vec3(1) });
    }
  }
  std::reverse(found.Levels.begin(), found.Levels.end());
  for (AmrBlock& block : found.Blocks)
  {
    block.Level = found.Levels.size() - 1 - block.Level;
  }
  if (found.Blocks.empty())
  {
    error = WhyThereAreNoScalars(choice);
  }
  return !found.Blocks.empty();
}

/// True if a number is whole within a tolerance.
bool IsWhole(double number, double tolerance)
{
  return std::abs(number - std::round(number)) <= tolerance && std::abs(number) < MostCellsAlong;
}

/// Set the ratios of levels. Each level's cells must divide into whole cells of the next one.
bool FitLevels(AmrBlocks& found, std::string& error)
{
  for (std::size_t l = found.Levels.size() - 1; l-- > 0;)
  {
    AmrLevel& level = found.Levels[l];
    const AmrLevel& finer = found.Levels[l + 1];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double ratio = level.Spacing[axis] / finer.Spacing[axis];
      if (!(ratio > 0.5) || !IsWhole(ratio, LargestOffset) ||
        !(ratio * static_cast<double>(finer.Ratio[axis]) < MostCellsAlong))
      {
        error = "A level has cells of size " + NumberText(level.Spacing[axis]) + " along axis " +
          std::to_string(axis) + ", but the next one has " + NumberText(finer.Spacing[axis]) +
          ", which does not divide them; resample the data with vtkAMRResampleFilter.";
        return false;
      }
      level.Ratio[axis] = static_cast<std::int64_t>(std::round(ratio)) * finer.Ratio[axis];
    }
  }
  return true;
}

/// The cells of a block without its outer layers that copy other blocks. Readers of distributed
/// data add such layers, which would hide the coarser cells around them, and may be out of date.
AmrBox WithoutCopies(const AmrBlock& block)
{
  if (!block.Ghosts)
  {
    return block.Stored;
  }
  AmrBox own{ block.Stored.End, block.Stored.First };
  const std::uint8_t* flags = block.Ghosts;
  for (std::int64_t z = block.Stored.First.z; z < block.Stored.End.z; ++z)
  {
    for (std::int64_t y = block.Stored.First.y; y < block.Stored.End.y; ++y)
    {
      for (std::int64_t x = block.Stored.First.x; x < block.Stored.End.x; ++x)
      {
        if (!(*flags++ & vtkDataSetAttributes::DUPLICATECELL))
        {
          own.First = glm::min(own.First, glm::i64vec3(x, y, z));
          own.End = glm::max(own.End, glm::i64vec3(x, y, z) + std::int64_t(1));
        }
      }
    }
  }
  return own;
}

/// For each block, the blocks whose boxes on the finest lattice touch or overlap its own,
/// ascending.
std::vector<std::vector<std::size_t>> NeighboursOf(const std::vector<AmrBlock>& blocks)
{
  // Sorted by their begins along x, blocks need no comparison with blocks that begin behind their
  // end.
  const std::size_t count = blocks.size();
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t(0));
  const auto begin = [&](std::size_t b) { return blocks[b].Finest.First.x; };
  std::sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b)
    { return begin(a) != begin(b) ? begin(a) < begin(b) : a < b; });
  std::vector<std::vector<std::size_t>> found(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const AmrBox& box = blocks[order[i]].Finest;
    const AmrBox around{ box.First - std::int64_t(1), box.End + std::int64_t(1) };
    for (std::size_t j = i + 1; j < count && begin(order[j]) <= box.End.x; ++j)
    {
      if (!IsEmpty(Common(around, blocks[order[j]].Finest)))
      {
        found[order[i]].push_back(order[j]);
        found[order[j]].push_back(order[i]);
      }
    }
  }
  for (std::vector<std::size_t>& neighbours : found)
  {
    std::sort(neighbours.begin(), neighbours.end());
  }
  return found;
}

bool FitBlock(const AmrBlocks& found, AmrBlock& block, std::string& error)
{
  const AmrLevel& level = found.Levels[block.Level];
  const glm::dvec3 spacing = SpacingOf(block.Grid), corner = CornerOf(block.Grid);
  const int* points = block.Grid->GetDimensions();
  for (int axis = 0; axis < 3; ++axis)
  {
    const double first = (corner[axis] - found.Origin[axis]) / level.Spacing[axis];
    const double off = std::abs(spacing[axis] / level.Spacing[axis] - 1.0) * points[axis];
    if (!(off <= LargestOffset) || !IsWhole(first, LargestOffset) ||
      !block.Grid->GetDirectionMatrix()->IsIdentity())
    {
      error = block.Name + " does not lie on the lattice of its level: it begins at " +
        NumberText(corner[axis]) + " and has cells of size " + NumberText(spacing[axis]) +
        " along axis " + std::to_string(axis) + "; resample the data with vtkAMRResampleFilter.";
      return false;
    }
    block.Stored.First[axis] = static_cast<std::int64_t>(std::round(first));
    block.Stored.End[axis] = block.Stored.First[axis] + points[axis] - 1;
  }
  block.Cells = WithoutCopies(block);
  block.Finest = { block.Cells.First * level.Ratio, block.Cells.End * level.Ratio };
  return true;
}

}

bool FindAmrBlocks(
  AdaptiveGrid* amr, const ScalarChoice& choice, AmrBlocks& found, std::string& error)
{
  if (!FindBlocks(amr, choice, found, error) || !FitLevels(found, error))
  {
    return false;
  }
  // A corner of the coarsest level, so that all blocks begin at whole numbers.
  found.Origin = CornerOf(found.Blocks.back().Grid);
  for (AmrBlock& block : found.Blocks)
  {
    if (!FitBlock(found, block, error))
    {
      return false;
    }
  }
  found.Blocks.erase(std::remove_if(found.Blocks.begin(), found.Blocks.end(),
                       [](const AmrBlock& block) { return IsEmpty(block.Cells); }),
    found.Blocks.end());
  found.Neighbours = NeighboursOf(found.Blocks);
  return true;
}

}
