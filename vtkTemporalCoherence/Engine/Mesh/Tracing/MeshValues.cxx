// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Mesh/Tracing/MeshValues.h"

#include "Mesh/Cells/CellPoints.h"
#include "Mesh/Tracing/HitCells.h"
#include "Mesh/Tracing/KernelsHitPlaces.h"

#include <cmath>
#include <cstddef>
#include <limits>

namespace TemporalCoherence
{
namespace
{

class MeshValues final : public ArrayValues
{
public:
  explicit MeshValues(const MeshValuesSource& source)
    : Source(source)
  {
  }

  bool IsSame(const ArrayValues& other) const override
  {
    const auto* const same = dynamic_cast<const MeshValues*>(&other);
    return same && same->Source.Tree == this->Source.Tree &&
      same->Source.Stamp == this->Source.Stamp && same->Source.Transform == this->Source.Transform;
  }

  void Find(const HitRays& rays, const RayBatch::Array<CellNumber>& known,
    RayBatch::Array<double>& values) const override
  {
    const MeshTree& tree = *this->Source.Tree;
    MeshKernels::PointsInCells places;
    places.Count = rays.Count;
    FindHitPlaces(
      rays, this->Source.Transform.IndexFromWorld, tree.Low(), tree.Scale(), places.Point);
    const auto placeOf = [&](std::size_t i)
    { return glm::dvec3(places.Point[0][i], places.Point[1][i], places.Point[2][i]); };
    // Pictures that are interpolated from others do not know the cells of hits.
    RayBatch::Array<CellNumber> numbers;
    for (std::size_t i = 0; i < rays.Count; ++i)
    {
      numbers[i] = known[i] != NoCell ? known[i] : FindCellAt(tree, placeOf(i));
    }
    const HitCells cells(tree, rays.Count, &numbers, placeOf);
    places.Cell = cells.OfHit;
    MeshKernels::FindCellGradients(cells.Cells.data(), cells.Count, places);
    values.fill(std::numeric_limits<double>::quiet_NaN());
    cells.ForEachHit(tree, places,
      [&](std::size_t hit, std::size_t part, std::int64_t cell, const MeshCellPoints& ids,
        const std::array<double, 8>& weights)
      { values[hit] = this->ValueIn(part, cell, ids, weights); });
  }

private:
  double ValueIn(std::size_t part, std::int64_t cell, const MeshCellPoints& points,
    const std::array<double, 8>& weights) const
  {
    const PartValues& of = this->Source.Parts[part];
    const MeshArray& originals = this->Source.Tree->Reader().PartAt(part).Originals;
    const auto valueOf = [&](const MeshArray& values)
    {
      if (of.AreOfCells)
      {
        return values.At(originals.First ? originals.IdAt(cell) : cell);
      }
      double value = 0.0;
      for (std::size_t p = 0; p < static_cast<std::size_t>(NumberOfPointsIn(points.Shape)); ++p)
      {
        value += weights[p] * values.At(points.Ids[p]);
      }
      return value;
    };
    if (of.Components.size() == 1)
    {
      return valueOf(of.Components.front());
    }
    double square = 0.0;
    for (const MeshArray& component : of.Components)
    {
      const double along = valueOf(component);
      square += along * along;
    }
    return std::sqrt(square);
  }

  MeshValuesSource Source;
};

}

std::shared_ptr<const ArrayValues> MakeMeshValues(const MeshValuesSource& source)
{
  return std::make_shared<const MeshValues>(source);
}

}
