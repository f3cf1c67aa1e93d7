// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Acceleration/FieldStructures.h"

#include "Scene/LabelSets.h"

#include <algorithm>

namespace TemporalCoherence
{
namespace
{

/// The structure in the list that fits, or null. Structures no longer in use leave the list.
template <typename Structure, typename Fits>
std::shared_ptr<const Structure> FindHeld(
  std::vector<std::weak_ptr<const Structure>>& list, const Fits& fits)
{
  list.erase(std::remove_if(
               list.begin(), list.end(), [](const auto& structure) { return structure.expired(); }),
    list.end());
  for (const std::weak_ptr<const Structure>& weak : list)
  {
    const std::shared_ptr<const Structure> structure = weak.lock();
    if (structure && fits(*structure))
    {
      return structure;
    }
  }
  return nullptr;
}

}

void FieldStructures::Provide(const Field& field, std::shared_ptr<const FieldRanges>& held)
{
  // Release the old structure first, so that its memory can serve the new one.
  held = std::make_shared<const FieldRanges>();
  auto found =
    FindHeld(this->Ranges, [&](const FieldRanges& ranges) { return ranges.Samples == field; });
  if (!found)
  {
    const auto made = std::make_shared<FieldRanges>();
    const auto pyramid = std::make_shared<ValueRangePyramid>();
    pyramid->Build(field);
    made->Pyramid = pyramid;
    made->Samples = field;
    made->Samples.Hidden = HiddenCells::WithoutNaN(field, pyramid->LeavesWithNaN());
    found = made;
    this->Ranges.push_back(found);
  }
  held = found;
}

void FieldStructures::Provide(
  const FieldRanges& ranges, const Surfaces& surfaces, std::shared_ptr<const SurfaceCells>& held)
{
  const auto last = ranges.Samples.Labels && held->Samples == ranges.Samples ? held : nullptr;
  held = std::make_shared<const SurfaceCells>();
  auto found = FindHeld(this->Cells,
    [&](const SurfaceCells& cells)
    { return cells.Samples == ranges.Samples && AreMetAlike(cells.Isosurfaces, surfaces); });
  if (!found)
  {
    const auto made = std::make_shared<SurfaceCells>();
    const auto active = std::make_shared<ActiveCells>();
    active->Build(ranges.Samples, *ranges.Pyramid, surfaces, last ? last->Active.get() : nullptr);
    made->Active = active;
    made->Samples = ranges.Samples;
    made->Isosurfaces = surfaces;
    found = made;
    this->Cells.push_back(found);
  }
  held = found;
}

void FieldStructures::Provide(
  const std::vector<VisibleValues>& values, std::shared_ptr<const VisibleCells>& held)
{
  held = std::make_shared<const VisibleCells>();
  auto found =
    FindHeld(this->Visible, [&](const VisibleCells& cells) { return cells.Values == values; });
  if (!found)
  {
    std::vector<ActiveCells::SeenValues> fields;
    for (const VisibleValues& each : values)
    {
      fields.push_back({ each.Ranges->Samples, each.Ranges->Pyramid.get(), each.Bands, each.Labels,
        std::make_shared<const LabelIndex>(each.CountFor) });
    }
    const auto active = std::make_shared<ActiveCells>();
    active->BuildVisible(fields);
    found = std::make_shared<const VisibleCells>(VisibleCells{ values, active });
    this->Visible.push_back(found);
  }
  held = found;
}

void FieldStructures::Provide(const Field& field, std::shared_ptr<const FieldFingerprint>& held)
{
  auto found =
    FindHeld(this->Prints, [&](const FieldFingerprint& print) { return print.Samples == field; });
  if (!found)
  {
    const bool isKnown = field.Labels && !field.Labels->Hashes().empty();
    found = std::make_shared<const FieldFingerprint>(
      isKnown ? FieldFingerprint{ field, field.Labels->Hashes() } : FingerprintOf(field));
    this->Prints.push_back(found);
  }
  held = found;
}

void FieldStructures::MoveTo(const Field& field, std::shared_ptr<const FieldRanges>& held)
{
  auto found =
    FindHeld(this->Ranges, [&](const FieldRanges& ranges) { return ranges.Samples == field; });
  if (!found)
  {
    const auto moved = std::make_shared<FieldRanges>(FieldRanges{ field, held->Pyramid });
    moved->Samples.Hidden = held->Samples.Hidden;
    found = moved;
    this->Ranges.push_back(found);
  }
  held = found;
}

void FieldStructures::MoveTo(const Field& field, std::shared_ptr<const SurfaceCells>& held)
{
  auto found = FindHeld(this->Cells,
    [&](const SurfaceCells& cells)
    { return cells.Samples == field && AreMetAlike(cells.Isosurfaces, held->Isosurfaces); });
  if (!found)
  {
    const auto moved =
      std::make_shared<SurfaceCells>(SurfaceCells{ field, held->Isosurfaces, held->Active });
    moved->Samples.Hidden = held->Samples.Hidden;
    found = moved;
    this->Cells.push_back(found);
  }
  held = found;
}

}
