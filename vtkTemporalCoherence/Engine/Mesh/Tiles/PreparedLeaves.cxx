// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Tiles/PreparedLeaves.h"

#include <limits>

namespace TemporalCoherence
{

PreparedLeaves::PreparedLeaves(const MeshTree& tree, const std::vector<double>& isovalues,
  const glm::dvec2& finiteRange, CellPurpose purpose, double width)
  : Tree(tree)
  , NumberOfSlots(isovalues.size() * static_cast<std::size_t>(tree.NumberOfLeaves()))
  , Isovalues(isovalues)
  , Purpose(purpose)
  , Width(width)
  , Bytes(static_cast<std::int64_t>(this->NumberOfSlots * sizeof(Slot)))
{
  for (const double isovalue : isovalues)
  {
    this->FromIsovalues.emplace_back(isovalue, finiteRange);
  }
}

PreparedLeaves::~PreparedLeaves()
{
  if (this->Kept)
  {
    for (std::size_t slot = 0; slot < this->NumberOfSlots; ++slot)
    {
      delete this->Kept[slot].load(std::memory_order_relaxed);
    }
  }
}

PreparedLeaves::Slot& PreparedLeaves::SlotOf(std::int64_t leaf, std::size_t isovalue) const
{
  const auto leaves = static_cast<std::size_t>(this->Tree.NumberOfLeaves());
  std::call_once(this->IsAsked, [&] { this->Kept.reset(new Slot[this->NumberOfSlots]()); });
  return this->Kept[isovalue * leaves + static_cast<std::size_t>(leaf)];
}

void PreparedLeaves::Prepare(
  std::int64_t leaf, std::size_t isovalue, std::uint64_t active, PreparedCells& cells) const
{
  if (this->Isovalues.size() > 1)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double low = this->Isovalues[isovalue];
    active &=
      this->Tree.CellsIn(leaf, { { low, this->Purpose == CellPurpose::Solids ? infinity : low } });
  }
  PrepareCells(
    this->Tree, leaf, active, this->FromIsovalues[isovalue], this->Width, this->Purpose, cells);
}

const PreparedCells* PreparedLeaves::Known(std::int64_t leaf, std::size_t isovalue) const
{
  return this->IsRoomForSlots() ? this->SlotOf(leaf, isovalue).load(std::memory_order_acquire)
                                : nullptr;
}

const PreparedCells& PreparedLeaves::Of(
  std::int64_t leaf, std::size_t isovalue, std::uint64_t active, PreparedCells& spare) const
{
  if (!this->IsRoomForSlots())
  {
    this->Prepare(leaf, isovalue, active, spare);
    return spare;
  }
  Slot& slot = this->SlotOf(leaf, isovalue);
  if (const PreparedCells* const known = slot.load(std::memory_order_acquire))
  {
    return *known;
  }
  if (this->Bytes.load(std::memory_order_relaxed) > static_cast<std::int64_t>(MostBytes))
  {
    this->Prepare(leaf, isovalue, active, spare);
    return spare;
  }
  auto made = std::make_unique<PreparedCells>();
  this->Prepare(leaf, isovalue, active, *made);
  const auto bytes = static_cast<std::int64_t>(made->SizeInBytes());
  const PreparedCells* known = nullptr;
  if (slot.compare_exchange_strong(known, made.get(), std::memory_order_acq_rel))
  {
    this->Bytes += bytes;
    return *made.release();
  }
  return *known; // another thread was faster
}

}
