// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Acceleration/SampleComparer.h"

#include "Acceleration/TileBounds.h"
#include "Scene/FrameKey.h"
#include "Scene/LabelSets.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{

SampleComparer::Result SampleComparer::Compare(
  const Field& last, const Field& next, FieldStructures& shared)
{
  this->Changed.clear();
  this->TilesToTrace.clear();
  if (next == last || !AreAlike(last, next))
  {
    return Result::Unknown;
  }
  shared.Provide(next, this->Next);
  if (last.Labels && !last.Labels->Hashes().empty())
  {
    shared.Provide(last, this->Last); // reads no samples
  }
  if (!this->Last || !(this->Last->Samples == last))
  {
    return Result::Unknown;
  }
  this->Changed = ChangedCells(*this->Last, *this->Next,
    next.Labels ? ChangesBetween(next.Labels->Changes(), last.Stamp, next.Stamp) : std::nullopt);
  return this->Changed.empty() ? Result::Equal : Result::Different;
}

void SampleComparer::FindTilesToTrace(
  const View& view, const IndexTransform& transform, const FieldRanges& ranges)
{
  if (AreReadAlike(this->LimitsOfLast, LimitsOf(ranges)))
  {
    this->TilesToTrace = FindTiles(view, transform, this->Changed, *ranges.Samples.Shape);
  }
}

double SampleComparer::ShareToTrace() const
{
  const std::vector<std::uint8_t>& tiles = this->TilesToTrace;
  return tiles.empty() ? 1.0
                       : static_cast<double>(std::count(tiles.begin(), tiles.end(), 1)) /
      static_cast<double>(tiles.size());
}

void SampleComparer::Take(const Field& shown, const FieldRanges& ranges)
{
  if (!(ranges.Samples == shown))
  {
    return;
  }
  this->LimitsOfLast = LimitsOf(ranges);
  if (this->Next && this->Next->Samples == shown)
  {
    this->Last = this->Next;
  }
}

SampleComparer::Limits SampleComparer::LimitsOf(const FieldRanges& ranges)
{
  // Samples that are not numbers are not read.
  const glm::dvec2& all = ranges.Pyramid->WholeRange();
  return { ranges.Pyramid->FiniteRange(), std::isfinite(all.x) && std::isfinite(all.y) };
}

/// True if equal samples have equal differences from an isovalue. For infinite samples the
/// difference depends on the range of the finite ones.
bool SampleComparer::AreReadAlike(const Limits& a, const Limits& b)
{
  return a.FiniteRange == b.FiniteRange || (a.AreFinite && b.AreFinite);
}

}
