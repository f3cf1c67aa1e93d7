// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/BlockCopy.h"

#include "Scene/Parallel.h"

#include <vtkDataSetAttributes.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <type_traits>

namespace TemporalCoherence
{
namespace
{

using Ghosts = vtkDataSetAttributes;

/// Rank of a block's sample. The sample with the highest rank is copied.
enum Rank : std::uint8_t
{
  None,
  Hidden,
  Duplicate,
  OwnHidden,
  Own
};

std::int64_t Place(const glm::ivec3& at, const glm::ivec3& size)
{
  return at.x + size.x * (at.y + static_cast<std::int64_t>(size.y) * at.z);
}

bool HasHiddenPoint(const BlockSource& block, const glm::ivec3& cell)
{
  for (int corner = 0; corner < 8 && block.PointGhosts; ++corner)
  {
    const glm::ivec3 point = cell + glm::ivec3(corner & 1, corner >> 1 & 1, corner >> 2);
    if (block.PointGhosts[Place(point, block.Points)] & Ghosts::HIDDENPOINT)
    {
      return true;
    }
  }
  return false;
}

Rank RankOfCell(const BlockSource& block, const glm::ivec3& cell)
{
  const int flag = block.CellGhosts ? block.CellGhosts[Place(cell, block.Points - 1)] : 0;
  const bool isHidden =
    (flag & (Ghosts::HIDDENCELL | Ghosts::REFINEDCELL)) || HasHiddenPoint(block, cell);
  const bool isOwn = !(flag & Ghosts::DUPLICATECELL);
  return isHidden ? (isOwn ? OwnHidden : Hidden) : (isOwn ? Own : Duplicate);
}

Rank RankOfPoint(const BlockSource& block, const glm::ivec3& point)
{
  const int flag = block.PointGhosts ? block.PointGhosts[Place(point, block.Points)] : 0;
  return flag & Ghosts::HIDDENPOINT ? Hidden : flag & Ghosts::DUPLICATEPOINT ? Duplicate : Own;
}

/// Raise the ranks of a row, and report each run of positions whose rank rose.
template <typename RankAt, typename Take>
void RaiseRow(std::uint8_t* ranks, int count, const RankAt& rankAt, const Take& take)
{
  int end = 0;
  while (end < count)
  {
    int begin = end;
    while (end < count && rankAt(end) > ranks[end])
    {
      ranks[end] = rankAt(end);
      ++end;
    }
    if (end > begin)
    {
      take(begin, end);
    }
    else
    {
      ++end;
    }
  }
}

/// Copies samples of type T into the whole.
template <typename T>
class Copier
{
public:
  Copier(const std::vector<BlockSource>& blocks, const BlockTarget& target)
    : Blocks(blocks)
    , Target(target)
    , Size(target.OnCells ? target.Points - 1 : target.Points)
    , Components(static_cast<std::int64_t>(blocks.front().Components.size()))
    , Ranks(static_cast<std::size_t>(Place({ 0, 0, Size.z }, Size)), None)
  {
  }

  /// \return false if some samples are in no block
  bool CopySlices()
  {
    std::atomic<bool> isFull(true);
    ParallelFor(this->Size.z, 1,
      [&](std::int64_t k)
      {
        if (!this->CopySlice(static_cast<int>(k)))
        {
          isFull = false;
        }
      });
    return isFull;
  }

  /// \pre the slices are copied
  void ContinueSamples()
  {
    ParallelFor(this->Size.z, 1,
      [&](std::int64_t k)
      {
        glm::ivec3 at(0, 0, static_cast<int>(k));
        for (at.y = 0; at.y < this->Size.y; ++at.y)
        {
          for (at.x = 0; at.x < this->Size.x; ++at.x)
          {
            if (this->RankAt(at) == None)
            {
              this->ContinueAt(at);
            }
          }
        }
      });
  }

  /// \pre the slices are copied
  /// \return true if a sample is hidden
  bool MarkHiddenSamples() const
  {
    std::atomic<bool> isAnyHidden(false);
    constexpr std::int64_t Grain = 1 << 16;
    ParallelForRanges(static_cast<std::int64_t>(this->Ranks.size()), Grain,
      [&](std::int64_t begin, std::int64_t end)
      {
        bool isHere = false;
        for (std::int64_t i = begin; i < end; ++i)
        {
          const bool isHidden = this->Ranks[static_cast<std::size_t>(i)] != Own;
          this->Target.CellGhosts[i] = isHidden ? Ghosts::HIDDENCELL : 0;
          isHere = isHere || isHidden;
        }
        if (isHere)
        {
          isAnyHidden = true;
        }
      });
    return isAnyHidden;
  }

private:
  std::uint8_t RankAt(const glm::ivec3& at) const
  {
    const bool isInside =
      glm::all(glm::greaterThanEqual(at, glm::ivec3(0))) && glm::all(glm::lessThan(at, this->Size));
    return isInside ? this->Ranks[static_cast<std::size_t>(Place(at, this->Size))]
                    : std::uint8_t(None);
  }

  bool CopySlice(int k)
  {
    for (const BlockSource& block : this->Blocks)
    {
      const glm::ivec3 size = this->Target.OnCells ? block.Points - 1 : block.Points;
      glm::ivec3 from(0, 0, k - block.First.z);
      for (; 0 <= from.z && from.z < size.z && from.y < size.y; ++from.y)
      {
        this->CopyRow(block, from, size);
      }
    }
    const auto begin = this->Ranks.begin() + Place({ 0, 0, k }, this->Size);
    const auto end = this->Ranks.begin() + Place({ 0, 0, k + 1 }, this->Size);
    return std::find(begin, end, std::uint8_t(None)) == end;
  }

  void CopyRow(const BlockSource& block, const glm::ivec3& from, const glm::ivec3& size)
  {
    const std::int64_t source = Place(from, size);
    const std::int64_t target = Place(from + block.First, this->Size);
    const auto rankAt = [&](int i)
    {
      const glm::ivec3 at(i, from.y, from.z);
      return this->Target.OnCells ? RankOfCell(block, at) : RankOfPoint(block, at);
    };
    RaiseRow(this->Ranks.data() + target, size.x, rankAt,
      [&](int begin, int end)
      {
        for (std::int64_t c = 0; c < this->Components; ++c)
        {
          const ArraySamples& samples = block.Components[static_cast<std::size_t>(c)];
          const T* first = static_cast<const T*>(samples.First) + source * samples.Step;
          T* to = static_cast<T*>(this->Target.Samples) + target * this->Components + c;
          for (std::int64_t i = begin; i < end; ++i)
          {
            to[i * this->Components] = first[i * samples.Step];
          }
        }
      });
  }

  T* SampleAt(const glm::ivec3& at) const
  {
    return static_cast<T*>(this->Target.Samples) + Place(at, this->Size) * this->Components;
  }

  void ContinueAt(const glm::ivec3& at)
  {
    for (std::int64_t c = 0; c < this->Components; ++c)
    {
      double sum = 0.0;
      int count = 0;
      for (int side = 0; side < 6; ++side)
      {
        glm::ivec3 step(0);
        step[side / 2] = side % 2 ? 1 : -1;
        if (this->RankAt(at + step) != None)
        {
          const auto beside = static_cast<double>(this->SampleAt(at + step)[c]);
          const bool isLine = this->RankAt(at + 2 * step) != None;
          sum +=
            isLine ? 2.0 * beside - static_cast<double>(this->SampleAt(at + 2 * step)[c]) : beside;
          ++count;
        }
      }
      // Farther away, any existing sample serves: it does not widen the range of values.
      this->SampleAt(at)[c] = count > 0
        ? Rounded(sum / count)
        : *static_cast<const T*>(
            this->Blocks.front().Components[static_cast<std::size_t>(c)].First);
    }
  }

  static T Rounded(double value)
  {
    if constexpr (std::is_floating_point_v<T>)
    {
      return static_cast<T>(value);
    }
    else
    {
      using Limits = std::numeric_limits<T>;
      return value <= static_cast<double>(Limits::lowest()) ? Limits::lowest()
        : value >= static_cast<double>(Limits::max())       ? Limits::max()
                                                            : static_cast<T>(std::round(value));
    }
  }

  const std::vector<BlockSource>& Blocks;
  const BlockTarget& Target;
  glm::ivec3 Size; ///< samples along each axis
  std::int64_t Components;
  std::vector<std::uint8_t> Ranks; ///< of the samples
};

/// Mark cells between points, unless some block owns and shows them.
bool MarkHiddenCells(const std::vector<BlockSource>& blocks, const BlockTarget& target)
{
  const glm::ivec3 cells = target.Points - 1;
  std::atomic<bool> isAnyHidden(false);
  ParallelFor(cells.z, 1,
    [&](std::int64_t k)
    {
      std::uint8_t* slice = target.CellGhosts + Place({ 0, 0, k }, cells);
      std::uint8_t* end = target.CellGhosts + Place({ 0, 0, k + 1 }, cells);
      std::fill(slice, end, std::uint8_t(Ghosts::HIDDENCELL));
      for (const BlockSource& block : blocks)
      {
        const glm::ivec3 size = block.Points - 1;
        glm::ivec3 from(0, 0, static_cast<int>(k) - block.First.z);
        for (; 0 <= from.z && from.z < size.z && from.y < size.y; ++from.y)
        {
          from.x = 0;
          std::uint8_t* row = target.CellGhosts + Place(from + block.First, cells);
          for (; from.x < size.x; ++from.x)
          {
            row[from.x] = RankOfCell(block, from) == Own ? 0 : row[from.x];
          }
        }
      }
      if (std::find(slice, end, std::uint8_t(Ghosts::HIDDENCELL)) != end)
      {
        isAnyHidden = true;
      }
    });
  return isAnyHidden;
}

}

bool CopyBlocks(const std::vector<BlockSource>& blocks, const BlockTarget& target)
{
  return DispatchScalarType(blocks.front().Components.front().Type,
    [&](auto sample)
    {
      Copier<decltype(sample)> copier(blocks, target);
      if (!copier.CopySlices())
      {
        copier.ContinueSamples();
      }
      return target.OnCells ? copier.MarkHiddenSamples() : MarkHiddenCells(blocks, target);
    });
}

}
