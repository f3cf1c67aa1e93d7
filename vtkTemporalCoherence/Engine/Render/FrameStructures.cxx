// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/FrameStructures.h"

#include <optional>
#include <vector>

namespace TemporalCoherence
{

bool MayShowAnything(const FrameKey& key)
{
  return key.Samples.HasCells() && (key.IsBlended() || !key.Isosurfaces().Isovalues.empty());
}

bool FrameStructures::NeedsRanges(const FrameKey& key) const
{
  return MayShowAnything(key) && !(this->OfData->Samples == key.Samples);
}

void FrameStructures::PrepareRanges(const FrameKey& key)
{
  if (this->NeedsRanges(key))
  {
    this->BoundCells = nullptr;
    this->OfSurfaces = std::make_shared<const SurfaceCells>();
    this->OfVolume = std::make_shared<const VisibleCells>();
    this->OfOthers.clear();
    this->Shared->Provide(key.Samples, this->OfData);
  }
}

void FrameStructures::PrepareActiveCells(const FrameKey& key)
{
  if (!MayShowAnything(key))
  {
    return;
  }
  if (!(this->OfSurfaces->Samples == key.Samples) ||
    !AreMetAlike(this->OfSurfaces->Isosurfaces, key.Isosurfaces()))
  {
    this->BoundCells = nullptr;
    this->Shared->Provide(*this->OfData, key.Isosurfaces(), this->OfSurfaces);
  }
  this->PrepareBounds(key, *this->OfSurfaces->Active);
}

bool FrameStructures::PrepareVisibleCells(const FrameKey& key)
{
  const std::optional<std::vector<SeenBands>> bands = VisibleComponents(key.Blended());
  if (!MayShowAnything(key) || !bands)
  {
    return false;
  }
  const std::vector<VisibleValues> values = this->VisibleValuesOf(key, *bands);
  if (!(this->OfVolume->Values == values))
  {
    this->BoundCells = nullptr;
    this->Shared->Provide(values, this->OfVolume);
  }
  this->PrepareBounds(key, *this->OfVolume->Active);
  return true;
}

/// The visible values of a key's components, with the ranges of their fields.
std::vector<VisibleValues> FrameStructures::VisibleValuesOf(
  const FrameKey& key, const std::vector<SeenBands>& bands)
{
  const Blending& volume = key.Blended();
  this->OfOthers.resize(volume.Others.size(), std::make_shared<const FieldRanges>());
  std::vector<VisibleValues> values;
  for (const SeenBands& seen : bands)
  {
    std::shared_ptr<const FieldRanges> ranges = this->OfData;
    if (seen.Component > 0)
    {
      const Field& other = volume.Others[seen.Component - 1];
      std::shared_ptr<const FieldRanges>& held = this->OfOthers[seen.Component - 1];
      if (!(held->Samples == other))
      {
        this->Shared->Provide(other, held);
      }
      ranges = held;
    }
    values.push_back({ ranges, seen.Bands, seen.HasLabels ? volume.Labels->Samples.Labels : nullptr,
      seen.CountFor });
  }
  return values;
}

/// Build the tile bounds, unless they belong to these cells and this view already.
void FrameStructures::PrepareBounds(const FrameKey& key, const ActiveCells& cells)
{
  const bool areBound = this->BoundCells == &cells && this->BoundView == key.View &&
    this->BoundTransform == key.Transform;
  if (!areBound)
  {
    this->BoundCells = nullptr;
    this->Bounds.Build(key.View, key.Transform, cells, *key.Samples.Shape);
    this->BoundView = key.View;
    this->BoundTransform = key.Transform;
    this->BoundCells = &cells;
  }
}

std::shared_ptr<const FieldRanges> FrameStructures::RangesOf(const FrameKey& key) const
{
  std::shared_ptr<const FieldRanges> ranges = this->OfData;
  if (MayShowAnything(key) && !(ranges->Samples == key.Samples))
  {
    this->Shared->Provide(key.Samples, ranges);
  }
  return ranges;
}

FrameKey FrameStructures::WithHidden(const FrameKey& key, const FieldRanges& ranges)
{
  FrameKey whole = key;
  whole.Samples.Hidden =
    ranges.Samples == key.Samples ? ranges.Samples.Hidden : key.Samples.Flagged;
  return whole;
}

void FrameStructures::MoveTo(const Field& now, const Field& before)
{
  if (this->OfData->Samples == before)
  {
    this->Shared->MoveTo(now, this->OfData);
  }
  if (this->OfSurfaces->Samples == before)
  {
    this->BoundCells = nullptr;
    this->Shared->MoveTo(now, this->OfSurfaces);
  }
  if (!this->OfVolume->Values.empty() && this->OfVolume->Values.front().Ranges->Samples == before)
  {
    this->BoundCells = nullptr;
    this->OfVolume = std::make_shared<const VisibleCells>();
  }
}

}
