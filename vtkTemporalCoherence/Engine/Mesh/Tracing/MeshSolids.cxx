// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Tracing/MeshSolids.h"

#include "Scene/LayerBatch.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

/// Where a ray passes the isovalue.
struct Crossing
{
  double T;
  bool Rises;
};

/// Follows a ray through a cell.
class SolidFollower
{
public:
  SolidFollower(
    const RayBatch& rays, std::size_t ray, CellNumber cell, std::vector<SolidPart>& parts)
    : Begin(rays.Begin[ray])
    , End(rays.End[ray])
    , Ray(static_cast<std::uint8_t>(ray))
    , Cell(cell)
    , Parts(parts)
  {
  }

  /// \param crossings ascending
  void Follow(const MeshKernels::CellSpan& span, const Crossing* crossings, std::size_t count)
  {
    this->LastPlace = span.Out - TouchingPlaces * std::abs(span.Out);
    bool isInside = span.AtIn >= 0.0, isCrossed = false;
    double from = span.In;
    HitKind kind = HitKind::Cap;
    for (std::size_t i = 0; i < count; ++i)
    {
      const Crossing& crossing = crossings[i];
      if (crossing.T < span.In || crossing.T > span.Out || crossing.Rises == isInside)
      {
        continue;
      }
      if (isInside)
      {
        this->Append(from, crossing.T, kind);
      }
      isInside = !isInside;
      isCrossed = true;
      from = crossing.T;
      kind = HitKind::Entry;
    }
    // The search left out a crossing too close to a face: take the face whose value is nearer to
    // the isovalue.
    const bool isAtIn = !isCrossed && std::abs(span.AtIn) < std::abs(span.AtOut);
    const double missed = isAtIn ? span.In : span.Out;
    if (isInside)
    {
      this->Append(from, span.AtOut < 0.0 ? missed : span.Out, kind);
    }
    else if (span.AtOut >= 0.0)
    {
      this->Append(missed, span.Out, HitKind::Entry);
    }
  }

private:
  void Append(double from, double to, HitKind kind)
  {
    if (to < this->Begin || from > this->End)
    {
      return;
    }
    if (from < this->Begin)
    {
      from = this->Begin;
      kind = HitKind::Cap;
    }
    this->Parts.push_back(
      { from, std::min(to, this->End), kind, this->Ray, this->Cell, from >= this->LastPlace });
  }

  double Begin, End;
  double LastPlace = 0.0; ///< parts that begin here or later are at the cell's end
  std::uint8_t Ray;
  CellNumber Cell;
  std::vector<SolidPart>& Parts;
};

}

void AppendSolidParts(const MeshCell& cell, const MeshKernels::CellDifferences& differences,
  CellNumber number, const RayBatch& rays, const MeshKernels::MeshRays& inMesh, std::uint64_t which,
  std::vector<SolidPart>& parts)
{
  MeshKernels::CellSpans spans;
  MeshKernels::FindCellSpans(cell, differences, inMesh, which, spans);
  MeshKernels::Crossings crossings;
  MeshKernels::CellCrossings(cell, differences, inMesh, which, crossings);
  ForEachRay(which,
    [&](std::size_t ray)
    {
      std::array<Crossing, MeshKernels::Crossings::Capacity> ofRay;
      std::size_t count = 0;
      for (std::size_t i = 0; i < crossings.Count; ++i)
      {
        if (crossings.Ray[i] == ray)
        {
          ofRay[count++] = { crossings.T[i], crossings.Rises[i] };
        }
      }
      std::sort(ofRay.begin(), ofRay.begin() + static_cast<std::ptrdiff_t>(count),
        [](const Crossing& a, const Crossing& b) { return a.T < b.T; });
      SolidFollower follower(rays, ray, number, parts);
      for (std::size_t span = 0; span < spans.Count[ray]; ++span)
      {
        follower.Follow(spans.Spans[ray][span], ofRay.data(), count);
      }
    });
}

}
