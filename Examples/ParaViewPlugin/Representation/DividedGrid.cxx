// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DividedGrid.h"

#include "AdaptiveGrid.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <string>
#include <tuple>
#include <vector>

namespace
{

/// A block as all processes know it. Only numbers, all of them double, as that is how it is sent.
struct Block
{
  double Process; ///< the first that has it
  double Level;
  double Index;
  std::array<double, 3> Corner;
  std::array<double, 3> Spacing;
  std::array<double, 3> Cells; ///< their number along each axis

  static constexpr std::size_t Size = 12; ///< in numbers

  double End(std::size_t axis) const
  {
    return this->Corner[axis] + this->Cells[axis] * this->Spacing[axis];
  }

  /// Which block it is, whoever has it.
  auto Identity() const
  {
    return std::tie(this->Level, this->Index, this->Corner, this->Spacing, this->Cells);
  }
};

static_assert(sizeof(Block) == Block::Size * sizeof(double), "a block is sent as its numbers");

/// A block and what this process has of it.
struct Held
{
  Block Description;
  vtkSmartPointer<vtkImageData> Grid;
};

/// The cells of a grid that are not copies of another one's; false if there are none.
/// \param box first and last point along each axis
bool FindOwnCells(vtkImageData* grid, std::array<int, 6>& box)
{
  const int* extent = grid->GetExtent();
  std::copy_n(extent, 6, box.begin());
  auto* ghosts = vtkUnsignedCharArray::SafeDownCast(
    grid->GetCellData()->GetArray(vtkDataSetAttributes::GhostArrayName()));
  if (!ghosts || ghosts->GetNumberOfTuples() < grid->GetNumberOfCells())
  {
    return grid->GetNumberOfCells() > 0;
  }
  box = { { extent[1], extent[0], extent[3], extent[2], extent[5], extent[4] } };
  vtkIdType cell = 0;
  for (int k = extent[4]; k < extent[5]; ++k)
  {
    for (int j = extent[2]; j < extent[3]; ++j)
    {
      for (int i = extent[0]; i < extent[1]; ++i, ++cell)
      {
        if (!(ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL))
        {
          const std::array<int, 3> at{ { i, j, k } };
          for (std::size_t axis = 0; axis < 3; ++axis)
          {
            box[2 * axis] = std::min(box[2 * axis], at[axis]);
            box[2 * axis + 1] = std::max(box[2 * axis + 1], at[axis] + 1);
          }
        }
      }
    }
  }
  return box[0] < box[1];
}

/// The blocks of this process by level and index, without copies of others' cells around them.
std::vector<Held> BlocksHere(vtkOverlappingAMR* amr, int process)
{
  std::vector<Held> blocks;
  for (unsigned int level = 0; level < amr->GetNumberOfLevels(); ++level)
  {
    for (unsigned int index = 0; index < CountBlocks(amr, level); ++index)
    {
      vtkImageData* const grid = GridOf(amr, level, index);
      std::array<int, 6> box;
      if (!grid || !FindOwnCells(grid, box))
      {
        continue;
      }
      const auto cut = vtkSmartPointer<vtkUniformGrid>::New();
      cut->ShallowCopy(grid);
      cut->Crop(box.data());
      Block block{ static_cast<double>(process), static_cast<double>(level),
        static_cast<double>(index), {}, {}, {} };
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        block.Spacing[axis] = grid->GetSpacing()[axis];
        block.Corner[axis] = grid->GetOrigin()[axis] + box[2 * axis] * block.Spacing[axis];
        block.Cells[axis] = box[2 * axis + 1] - box[2 * axis];
      }
      blocks.push_back({ block, cut });
    }
  }
  return blocks;
}

/// The blocks of all processes, each with all that have it, the first one first.
std::vector<Block> BlocksOfAll(const std::vector<Held>& here, vtkMultiProcessController* controller)
{
  const auto processes = static_cast<std::size_t>(controller->GetNumberOfProcesses());
  std::vector<Block> mine(here.size());
  std::transform(
    here.begin(), here.end(), mine.begin(), [](const Held& held) { return held.Description; });
  const auto length = static_cast<vtkIdType>(Block::Size * mine.size());
  std::vector<vtkIdType> lengths(processes), offsets(processes);
  controller->AllGather(&length, lengths.data(), 1);
  vtkIdType total = 0;
  for (std::size_t p = 0; p < processes; ++p)
  {
    offsets[p] = total;
    total += lengths[p];
  }
  std::vector<Block> all(static_cast<std::size_t>(total) / Block::Size);
  controller->AllGatherV(reinterpret_cast<const double*>(mine.data()),
    reinterpret_cast<double*>(all.data()), length, lengths.data(), offsets.data());
  std::sort(all.begin(), all.end(),
    [](const Block& a, const Block& b)
    {
      return std::tuple_cat(a.Identity(), std::tie(a.Process)) <
        std::tuple_cat(b.Identity(), std::tie(b.Process));
    });
  return all;
}

vtkBoundingBox BoundsOf(const Block& block)
{
  return { block.Corner[0], block.End(0), block.Corner[1], block.End(1), block.Corner[2],
    block.End(2) };
}

/// The part of a block's cells that lies in a box.
double CellsIn(const Block& block, const vtkBoundingBox& box)
{
  double cells = 1.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<std::size_t>(axis);
    const double first = std::max(block.Corner[a], box.GetBound(2 * axis));
    const double end = std::min(block.End(a), box.GetBound(2 * axis + 1));
    cells *= std::max(0.0, end - first) / block.Spacing[a];
  }
  return cells;
}

double CellsIn(const std::vector<Block>& blocks, const vtkBoundingBox& box)
{
  double cells = 0.0;
  for (const Block& block : blocks)
  {
    cells += CellsIn(block, box);
  }
  return cells;
}

/// Where to cut a box across an axis so that a share of its cells lies before the cut.
double FindCut(const std::vector<Block>& blocks, const vtkBoundingBox& box, int axis, double share)
{
  const double wanted = share * CellsIn(blocks, box);
  double least = box.GetBound(2 * axis), largest = box.GetBound(2 * axis + 1);
  for (int i = 0; i < 20; ++i) // to a millionth of the box
  {
    const double middle = 0.5 * (least + largest);
    double bounds[6];
    box.GetBounds(bounds);
    bounds[2 * axis + 1] = middle;
    (CellsIn(blocks, vtkBoundingBox(bounds)) < wanted ? least : largest) = middle;
  }
  return 0.5 * (least + largest);
}

/// What a process draws: all is halved until there is a box for each.
vtkBoundingBox BoxOf(const std::vector<Block>& blocks, int process, int processes)
{
  vtkBoundingBox box;
  for (const Block& block : blocks)
  {
    box.AddBox(BoundsOf(block));
  }
  int first = 0;
  while (processes > 1 && box.IsValid())
  {
    const int before = processes / 2;
    double bounds[6], lengths[3];
    box.GetBounds(bounds);
    box.GetLengths(lengths);
    const auto axis = static_cast<int>(std::max_element(lengths, lengths + 3) - lengths);
    const double cut = FindCut(blocks, box, axis, static_cast<double>(before) / processes);
    const bool isBefore = process < first + before;
    bounds[isBefore ? 2 * axis + 1 : 2 * axis] = cut;
    first += isBefore ? 0 : before;
    processes = isBefore ? before : processes - before;
    box.SetBounds(bounds);
  }
  return box;
}

/// What has to be known of a box's surroundings. Between the centres of cells that touch each other
/// the field is interpolated, so that it depends on cells up to 1.5 sizes of the largest cell away.
vtkBoundingBox Surroundings(const std::vector<Block>& blocks, vtkBoundingBox box)
{
  std::array<double, 3> largest{};
  for (const Block& block : blocks)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      largest[axis] = std::max(largest[axis], block.Spacing[axis]);
    }
  }
  box.Inflate(2.0 * largest[0], 2.0 * largest[1], 2.0 * largest[2]);
  return box;
}

/// A grid that came from another process, where it is as the sender knows it: what VTK sends are
/// texts of few digits.
vtkSmartPointer<vtkImageData> Receive(
  const Block& block, int from, int tag, vtkMultiProcessController* controller)
{
  vtkNew<vtkImageData> received;
  controller->Receive(received, from, tag);
  const auto grid = vtkSmartPointer<vtkUniformGrid>::New();
  grid->ShallowCopy(received);
  grid->SetExtent(0, static_cast<int>(block.Cells[0]), 0, static_cast<int>(block.Cells[1]), 0,
    static_cast<int>(block.Cells[2]));
  grid->SetOrigin(block.Corner[0], block.Corner[1], block.Corner[2]);
  grid->SetSpacing(block.Spacing[0], block.Spacing[1], block.Spacing[2]);
  return grid;
}

/// Of arrays, VTK sends the active scalars first. So the first array becomes active if there are
/// none: then it is still the one that is drawn where no other is chosen.
void Send(vtkImageData* grid, int to, int tag, vtkMultiProcessController* controller)
{
  vtkNew<vtkImageData> plain;
  plain->ShallowCopy(grid);
  for (const int association : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkDataSetAttributes* attributes = plain->GetAttributes(association);
    for (int i = 0; i < attributes->GetNumberOfArrays() && !attributes->GetScalars(); ++i)
    {
      vtkDataArray* array = attributes->GetArray(i);
      const char* name = array ? array->GetName() : nullptr;
      if (name && std::string(name) != vtkDataSetAttributes::GhostArrayName())
      {
        attributes->SetActiveScalars(name);
      }
    }
  }
  controller->Send(plain, to, tag);
}

/// The blocks that this process needs. All processes go through all messages in one order, so that
/// none waits for one that waits for it.
std::vector<Held> Exchange(const std::vector<Held>& here, const std::vector<Block>& all,
  const std::vector<vtkBoundingBox>& needed, vtkMultiProcessController* controller)
{
  constexpr int tag = 5711;
  const int me = controller->GetLocalProcessId();
  const auto gridOf = [&](const Block& block)
  {
    return std::lower_bound(here.begin(), here.end(), block,
      [](const Held& held, const Block& wanted)
      { return held.Description.Identity() < wanted.Identity(); })
      ->Grid;
  };
  std::vector<Held> blocks;
  for (auto block = all.begin(); block != all.end();)
  {
    const auto end = std::find_if(
      block, all.end(), [&](const Block& other) { return other.Identity() != block->Identity(); });
    const auto owner = static_cast<int>(block->Process);
    for (std::size_t p = 0; p < needed.size(); ++p)
    {
      const auto process = static_cast<int>(p);
      if (!needed[p].Intersects(BoundsOf(*block)))
      {
        continue;
      }
      const bool hasIt = std::any_of(
        block, end, [&](const Block& same) { return same.Process == static_cast<double>(p); });
      if (hasIt && process == me)
      {
        blocks.push_back({ *block, gridOf(*block) });
      }
      else if (!hasIt && process == me)
      {
        blocks.push_back({ *block, Receive(*block, owner, tag, controller) });
      }
      else if (!hasIt && owner == me)
      {
        Send(gridOf(*block), process, tag, controller);
      }
    }
    block = end;
  }
  return blocks;
}

vtkSmartPointer<vtkOverlappingAMR> GridOf(const std::vector<Held>& blocks)
{
  std::vector<unsigned int> counts, indices;
  for (const Held& held : blocks)
  {
    const auto level = static_cast<std::size_t>(held.Description.Level);
    counts.resize(std::max(counts.size(), level + 1), 0);
    indices.push_back(counts[level]++);
  }
  const auto grid = vtkSmartPointer<vtkOverlappingAMR>::New();
  if (!counts.empty())
  {
    SetBlockCounts(grid, counts);
  }
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    const auto level = static_cast<unsigned int>(blocks[b].Description.Level);
    grid->SetDataSet(level, indices[b], vtkUniformGrid::SafeDownCast(blocks[b].Grid));
  }
  return grid;
}

}

DividedGrid Divide(vtkOverlappingAMR* blocks, vtkMultiProcessController* controller)
{
  const int processes = controller->GetNumberOfProcesses();
  const std::vector<Held> here = BlocksHere(blocks, controller->GetLocalProcessId());
  const std::vector<Block> all = BlocksOfAll(here, controller);
  std::vector<Block> once;
  std::unique_copy(all.begin(), all.end(), std::back_inserter(once),
    [](const Block& a, const Block& b) { return a.Identity() == b.Identity(); });
  std::vector<vtkBoundingBox> boxes, needed;
  for (int p = 0; p < processes; ++p)
  {
    boxes.push_back(BoxOf(once, p, processes));
    needed.push_back(Surroundings(once, boxes.back()));
  }
  return { GridOf(Exchange(here, all, needed, controller)),
    boxes[static_cast<std::size_t>(controller->GetLocalProcessId())] };
}
