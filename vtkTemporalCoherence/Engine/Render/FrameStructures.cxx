// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Render/FrameStructures.h"

namespace TemporalCoherence
{
namespace
{

bool HasSurfaces(const FrameKey& key)
{
  return key.Samples.HasCells() && !key.Isosurfaces.Isovalues.empty();
}

}

bool FrameStructures::NeedsRanges(const FrameKey& key) const
{
  return HasSurfaces(key) && !(this->OfData->Samples == key.Samples);
}

void FrameStructures::PrepareRanges(const FrameKey& key)
{
  if (this->NeedsRanges(key))
  {
    this->BoundSurfaces = nullptr;
    this->OfSurfaces = std::make_shared<const SurfaceCells>();
    this->Shared->Provide(key.Samples, this->OfData);
  }
}

void FrameStructures::PrepareActiveCells(const FrameKey& key)
{
  if (!HasSurfaces(key))
  {
    return;
  }
  if (!(this->OfSurfaces->Samples == key.Samples) ||
    !AreMetAlike(this->OfSurfaces->Isosurfaces, key.Isosurfaces))
  {
    this->BoundSurfaces = nullptr;
    this->Shared->Provide(*this->OfData, key.Isosurfaces, this->OfSurfaces);
  }
  const bool areBound = this->BoundSurfaces == this->OfSurfaces.get() &&
    this->BoundView == key.View && this->BoundTransform == key.Transform;
  if (!areBound)
  {
    this->BoundSurfaces = nullptr;
    this->Bounds.Build(key.View, key.Transform, *this->OfSurfaces->Active, *key.Samples.Kind);
    this->BoundView = key.View;
    this->BoundTransform = key.Transform;
    this->BoundSurfaces = this->OfSurfaces.get();
  }
}

std::shared_ptr<const FieldRanges> FrameStructures::RangesOf(const FrameKey& key) const
{
  std::shared_ptr<const FieldRanges> ranges = this->OfData;
  if (HasSurfaces(key) && !(ranges->Samples == key.Samples))
  {
    this->Shared->Provide(key.Samples, ranges);
  }
  return ranges;
}

void FrameStructures::MoveTo(const Field& now, const Field& before)
{
  if (this->OfData->Samples == before)
  {
    this->Shared->MoveTo(now, this->OfData);
  }
  if (this->OfSurfaces->Samples == before)
  {
    this->BoundSurfaces = nullptr;
    this->Shared->MoveTo(now, this->OfSurfaces);
  }
}

}
