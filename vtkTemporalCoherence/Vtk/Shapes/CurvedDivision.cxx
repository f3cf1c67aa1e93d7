// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes/CurvedDivision.h"

#include <vtkIdList.h>
#include <vtkNew.h>

#include <cstdint>
#include <numeric>

namespace TemporalCoherence
{
namespace
{

constexpr std::size_t CellsBetweenReports = 256;

/// Appends the linear cells of a curved one, with point numbers inside of the curved cell.
struct AppendingSink : public DivisionSink
{
  MadeCells& Made;
  vtkIdType Original = 0;

  explicit AppendingSink(MadeCells& made)
    : Made(made)
  {
  }

  void Add(const DivisionCell& cell) override
  {
    this->Ids.assign(cell.Points.begin(), cell.Points.begin() + cell.NumberOfPoints);
    this->Made.AddCell(cell.Type, this->Ids, this->Original);
  }

private:
  std::vector<std::int32_t> Ids;
};

/// Numbers the points of divided cells, one cell after the other.
class PointNumbers
{
public:
  PointNumbers(SharedPoints& shared, MadeCells& made, CurvedPoints& points)
    : Shared(shared)
    , Points(points)
    , Sink(made)
    , Next(static_cast<std::int32_t>(made.Points.size()))
  {
  }

  void Divide(CurvedShape shape, const CellParts& parts, vtkIdList* ids, vtkIdType original)
  {
    std::vector<std::int32_t>& connectivity = this->Sink.Made.Connectivity;
    const std::size_t begin = connectivity.size();
    this->Sink.Original = original;
    this->Divider.Divide(shape, parts, this->Sink);
    this->Number(shape, ids);
    for (std::size_t i = begin; i < connectivity.size(); ++i)
    {
      connectivity[i] = this->Numbers[static_cast<std::size_t>(connectivity[i])];
    }
    this->Points.Begins.push_back(this->Points.Places.size());
  }

private:
  /// Number the points of a cell. New points get consecutive numbers from Next on.
  void Number(CurvedShape shape, vtkIdList* ids)
  {
    const std::vector<DivisionPlace>& places = this->Divider.Places();
    this->Keys.resize(places.size());
    this->AreInside.resize(places.size());
    this->Numbers.resize(places.size());
    for (std::size_t p = 0; p < places.size(); ++p) // first, to hide the latency of memory
    {
      this->AreInside[p] = !this->SetName(shape, places[p], ids);
      if (!this->AreInside[p])
      {
        this->Keys[p] = SharedPoints::KeyOf(this->Name);
        this->Shared.Prefetch(this->Keys[p]);
      }
    }
    for (std::size_t p = 0; p < places.size(); ++p)
    {
      this->Numbers[p] =
        this->AreInside[p] ? this->Next : this->Shared.Find(this->Keys[p], this->Next);
      if (this->Numbers[p] == this->Next)
      {
        this->Points.Places.push_back(places[p]);
        ++this->Next;
      }
    }
  }

  /// Set the name of a point on a face: the corners of the face with integer weights, without
  /// common divisor. Cells that share the face make equal names, however they number their corners.
  /// \return false for points inside of a cell, which no other cell shares
  bool SetName(CurvedShape shape, const DivisionPlace& place, vtkIdList* ids)
  {
    const CornerWeights weights = WeightsOf(shape, place);
    std::int64_t divisor = 0;
    this->Name.clear();
    for (int corner = 0; corner < weights.Count; ++corner)
    {
      const std::int64_t weight = weights.Of[static_cast<std::size_t>(corner)];
      if (weight != 0)
      {
        divisor = std::gcd(divisor, weight);
        this->Name.emplace_back(ids->GetId(corner), weight);
      }
    }
    if (this->Name.size() == static_cast<std::size_t>(weights.Count))
    {
      return false;
    }
    for (auto& [point, weight] : this->Name)
    {
      weight /= divisor;
    }
    return true;
  }

  SharedPoints& Shared;
  CurvedPoints& Points;
  AppendingSink Sink;
  CellDivider Divider;
  std::int32_t Next;
  SharedPoints::Name Name;
  // One entry for each point of a cell:
  std::vector<SharedPoints::Key> Keys;
  std::vector<bool> AreInside;
  std::vector<std::int32_t> Numbers;
};

}

bool DivideCurvedCells(const CurvedSource& source, const CurvedPlan& plan, MakingBudget& budget,
  SharedPoints& shared, MadeCells& made, CurvedPoints& points)
{
  PointNumbers numbers(shared, made, points);
  vtkNew<vtkIdList> ids;
  const std::size_t count = source.NumberOfCells();
  for (std::size_t c = 0; c < count; ++c)
  {
    if (plan.Parts()[c] > 0)
    {
      const CellParts parts = plan.PartsOf(c, ids);
      source.ReadIds(c, ids);
      numbers.Divide(source.KindOf(c).Shape, parts, ids, source.Curved.Cells[c]);
    }
    else
    {
      points.Begins.push_back(points.Places.size());
    }
    if (c % CellsBetweenReports == 0 &&
      (!budget.Allows(made.MemoryInBytes() + shared.MemoryInBytes() + points.MemoryInBytes() +
           points.Places.size() * sizeof(PointValue),
         made.NumberOfCells()) ||
        !budget.GoesOn(static_cast<double>(c) / static_cast<double>(count))))
    {
      return false;
    }
  }
  points.Places.shrink_to_fit();
  return budget.Allows(
    made.MemoryInBytes() + points.MemoryInBytes() + points.Places.size() * sizeof(PointValue),
    made.NumberOfCells());
}

bool PlaceCurvedPoints(const CurvedSource& source, const CurvedPoints& points,
  const ReportProgress& progress, PointValue* at)
{
  return ForEachWithReader(source.NumberOfCells(), progress,
    [&](CurvedCellReader& cell, std::size_t number)
    {
      const std::size_t begin = points.Begins[number], end = points.Begins[number + 1];
      if (begin < end)
      {
        cell.Read(source, number);
      }
      for (std::size_t p = begin; p < end; ++p)
      {
        at[p] = cell.At(points.Places[p]);
      }
    });
}

}
