// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes/CurvedPlan.h"

#include "Scene/Parallel.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>

namespace TemporalCoherence
{
namespace
{

using Samples = CurvedCellReader::Samples;

/// Smallest range of values in a cell, as a share of the range in all cells.
constexpr double SmallestRange = 0.01;

/// Limit of measured parts. The waves of functions up to order 10 are coarser.
constexpr int MostMeasuredParts = 16;

/// Near the apex of a pyramid, functions are not smooth: the error shrinks with the number of
/// parts, not with its square. More parts than are measured do not pay.
constexpr int MostPartsOfPyramid = MostMeasuredParts;

/// Cones in a part reach no farther than the cones that are measured, but in other directions.
/// Along these, the second difference of a quadratic function may be larger by half.
constexpr double ConeFactor = 1.5;

/// The number of parts that an error demands.
int PartsFor(CurvedShape shape, double bend, double error)
{
  const double most = shape == CurvedShape::Pyramid ? MostPartsOfPyramid : MostParts;
  // An unknown bend demands no parts.
  const double parts = bend > error ? std::ceil(std::sqrt(bend / error) * (1.0 - 1e-6)) : 1.0;
  return static_cast<int>(std::clamp(parts, 1.0, most));
}

/// Limit of the rounds that divide cells further because their parts are cones.
constexpr int MostRounds = 16;

}

CurvedPlan::CurvedPlan(const CurvedSource& source)
  : Source(source)
{
  for (const CurvedKind& kind : source.Curved.Kinds)
  {
    constexpr int most = 8;
    this->FirstParts.push_back(std::clamp(2 * (kind.Order - 1), 2, most));
  }
}

bool CurvedPlan::Measure(const ReportProgress& progress)
{
  std::vector<std::size_t> all(this->Source.NumberOfCells());
  std::iota(all.begin(), all.end(), std::size_t(0));
  std::vector<CellError> errors;
  if (!MeasureErrors(
        this->Source, all, this->FirstParts, false, PartOf(progress, 0.0, 0.5), errors))
  {
    return false;
  }
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const CellError& error : errors)
  {
    if (error.Given != Samples::None && error.Given != Samples::Unbounded)
    {
      low = std::min(low, error.LowestValue);
      high = std::max(high, error.HighestValue);
    }
    this->AreValuesBounded = this->AreValuesBounded && error.Given != Samples::Unbounded &&
      error.Given != Samples::Corners;
  }
  this->RangeOfAll = std::max(high - low, 0.0);
  this->Chosen.assign(all.size(), 1);
  this->Bends.resize(all.size());
  for (std::size_t c = 0; c < all.size(); ++c)
  {
    this->Chosen[c] = errors[c].Given == Samples::None ? 0 : 1;
    this->Bends[c] = this->BendOf(errors[c], this->FirstParts[this->Source.Curved.KindOf[c]]);
  }
  std::vector<CellError>().swap(errors);
  return this->MeasureFurther(PartOf(progress, 0.5, 1.0));
}

/// Measure cells of higher order with more parts. Their errors shrink with the square of the number
/// of parts only if parts are finer than the waves of the cell's functions.
bool CurvedPlan::MeasureFurther(const ReportProgress& progress)
{
  std::vector<int> measured = this->FirstParts, next = measured;
  for (double begin = 0.0;;)
  {
    for (std::size_t k = 0; k < next.size(); ++k)
    {
      const bool isHigher = this->Source.Curved.Kinds[k].Order > 2;
      next[k] = isHigher ? std::min(2 * measured[k], MostMeasuredParts) : measured[k];
    }
    std::vector<std::size_t> cells;
    for (std::size_t c = 0; c < this->Bends.size(); ++c)
    {
      const std::uint32_t kind = this->Source.Curved.KindOf[c];
      if (next[kind] > measured[kind] &&
        this->PartsFor(c, this->Bends[c], SubdivisionGoal) > measured[kind])
      {
        cells.push_back(c);
      }
    }
    if (cells.empty())
    {
      return true;
    }
    const double end = 0.5 * (1.0 + begin); // the number of rounds is unknown
    std::vector<CellError> errors;
    if (!MeasureErrors(this->Source, cells, next, false, PartOf(progress, begin, end), errors))
    {
      return false;
    }
    begin = end;
    measured = next;
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      this->Bends[cells[i]] =
        this->BendOf(errors[i], measured[this->Source.Curved.KindOf[cells[i]]]);
    }
  }
}

CurvedPlan::Bend CurvedPlan::BendOf(const CellError& error, int parts) const
{
  const double squared = parts * parts;
  const double length =
    std::max(error.HighestValue - error.LowestValue, SmallestRange * this->RangeOfAll);
  const bool areBounded = error.Given != Samples::Unbounded && length > 0.0;
  return { static_cast<float>(squared * error.OfPoints),
    areBounded ? static_cast<float>(squared * (error.OfValues / length)) : 0.0f };
}

/// Choose the numbers of parts that make the fewest cells. Each number must be a multiple of all
/// smaller numbers.
void CurvedPlan::ChooseChain()
{
  constexpr auto size = static_cast<std::size_t>(MostParts) + 1;
  std::vector<double> count(size, 0.0); // of cells that demand this number of parts or fewer
  int most = 1;
  for (std::size_t c = 0; c < this->Bends.size(); ++c)
  {
    const int parts = this->PartsFor(c, this->Bends[c], this->ChosenFor);
    count[static_cast<std::size_t>(parts)] += this->Chosen[c] > 0 ? 1.0 : 0.0;
    most = std::max(most, parts);
  }
  std::partial_sum(count.begin(), count.end(), count.begin());
  std::vector<double> cost(size, 0.0); // of all cells that demand more parts
  std::vector<int> next(size, 0);      // in the best chain
  for (int n = most - 1; n >= 1; --n)
  {
    const auto from = static_cast<std::size_t>(n);
    cost[from] = std::numeric_limits<double>::infinity();
    for (int m = 2 * n; m < 2 * most + n && m <= MostParts; m += n)
    {
      const auto to = static_cast<std::size_t>(m);
      const double made = (count[to] - count[from]) * m * m * m + cost[to];
      if (made < cost[from])
      {
        cost[from] = made;
        next[from] = m;
      }
    }
  }
  this->Chain.assign(static_cast<std::size_t>(most) + 1, 1);
  for (int n = 1; n < most;)
  {
    const int m = std::max(next[static_cast<std::size_t>(n)], n + 1);
    for (int i = n + 1; i <= std::min(m, most); ++i)
    {
      this->Chain[static_cast<std::size_t>(i)] = m;
    }
    n = m;
  }
}

DivisionSize CurvedPlan::Choose(double error)
{
  this->ChosenFor = error;
  this->ChooseChain();
  this->Boundary = BoundaryParts();
  this->AreCones.assign(this->Chosen.size(), 0);
  for (std::size_t c = 0; c < this->Chosen.size(); ++c)
  {
    this->Chosen[c] =
      static_cast<std::uint16_t>(this->Chosen[c] > 0 ? this->ChainFor(c, this->Bends[c]) : 0);
  }
  return this->Size();
}

int CurvedPlan::PartsFor(std::size_t number, const Bend& bend, double error) const
{
  return TemporalCoherence::PartsFor(this->Source.KindOf(number).Shape, bend.Largest(), error);
}

int CurvedPlan::ChainFor(std::size_t number, const Bend& bend) const
{
  const auto parts = static_cast<std::size_t>(this->PartsFor(number, bend, this->ChosenFor));
  return this->Chain[std::min(parts, this->Chain.size() - 1)];
}

bool CurvedPlan::Join(const ReportProgress& progress, DivisionSize& size)
{
  if (this->AreAlike())
  {
    return true;
  }
  for (std::size_t c = 0; c < this->Chosen.size(); ++c)
  {
    this->AddToBoundary(c);
  }
  for (int round = 0;; ++round)
  {
    const std::vector<std::size_t> cones = this->FindCones();
    if (!this->MeasureCones(cones, progress))
    {
      return false;
    }
    bool isRaised = false;
    for (const std::size_t c : cones)
    {
      const int parts = this->ChainFor(c, this->ConeBends[c]);
      if (parts > this->Chosen[c] && round < MostRounds)
      {
        this->Chosen[c] = static_cast<std::uint16_t>(parts);
        this->AddToBoundary(c);
        isRaised = true;
      }
    }
    if (!isRaised)
    {
      size = this->Size();
      return true;
    }
  }
}

/// True if all cells, and so all faces and edges, have one number of parts.
bool CurvedPlan::AreAlike() const
{
  return std::all_of(this->Chosen.begin(), this->Chosen.end(),
    [this](std::uint16_t parts) { return parts == this->Chosen.front(); });
}

void CurvedPlan::AddToBoundary(std::size_t number)
{
  if (this->Chosen[number] > 1)
  {
    this->Source.ReadIds(number, this->Ids);
    this->Boundary.Add(FrameOf(this->Source.KindOf(number).Shape), this->Ids, this->Chosen[number]);
  }
}

template <typename Visit>
void CurvedPlan::ForEachCell(const Visit& visit) const
{
  constexpr std::int64_t grain = 256;
  ParallelForRanges(static_cast<std::int64_t>(this->Chosen.size()), grain,
    [&](std::int64_t begin, std::int64_t end)
    {
      vtkNew<vtkIdList> points;
      for (std::int64_t c = begin; c < end; ++c)
      {
        visit(static_cast<std::size_t>(c), points);
      }
    });
}

/// Find the cells with a face or edge that is divided further than the cell.
std::vector<std::size_t> CurvedPlan::FindCones()
{
  this->ForEachCell(
    [this](std::size_t c, vtkIdList* points)
    {
      this->AreCones[c] = this->Chosen[c] > 0 &&
        !this->BoundaryOf(c, points).AreEqual(FrameOf(this->Source.KindOf(c).Shape));
    });
  std::vector<std::size_t> cones;
  for (std::size_t c = 0; c < this->Chosen.size(); ++c)
  {
    if (this->AreCones[c])
    {
      cones.push_back(c);
    }
  }
  return cones;
}

bool CurvedPlan::MeasureCones(const std::vector<std::size_t>& cones, const ReportProgress& progress)
{
  constexpr Bend unknown{ -1.0f, -1.0f };
  this->ConeBends.resize(this->Bends.size(), unknown);
  std::vector<std::size_t> cells;
  std::copy_if(cones.begin(), cones.end(), std::back_inserter(cells),
    [this](std::size_t cell) { return this->ConeBends[cell].OfPoints < 0.0f; });
  std::vector<CellError> errors;
  if (!cells.empty() &&
    !MeasureErrors(this->Source, cells, this->FirstParts, true, progress, errors))
  {
    return false;
  }
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    errors[i].OfPoints *= ConeFactor;
    errors[i].OfValues *= ConeFactor;
    const Bend bend =
      this->BendOf(errors[i], this->FirstParts[this->Source.Curved.KindOf[cells[i]]]);
    const Bend& whole = this->Bends[cells[i]];
    this->ConeBends[cells[i]] = { std::max(bend.OfPoints, whole.OfPoints),
      std::max(bend.OfValues, whole.OfValues) };
  }
  return true;
}

CellParts CurvedPlan::BoundaryOf(std::size_t number, vtkIdList* points) const
{
  this->Source.ReadIds(number, points);
  return this->Boundary.Of(
    FrameOf(this->Source.KindOf(number).Shape), points, this->Chosen[number]);
}

CellParts CurvedPlan::PartsOf(std::size_t number, vtkIdList* points) const
{
  return this->AreCones[number] ? this->BoundaryOf(number, points)
                                : CellParts(this->Chosen[number]);
}

int CurvedPlan::LargestParts() const
{
  return this->Chosen.empty() ? 1 : *std::max_element(this->Chosen.begin(), this->Chosen.end());
}

DivisionSize CurvedPlan::Size() const
{
  std::atomic<std::int64_t> cells(0), ids(0);
  this->ForEachCell(
    [&](std::size_t c, vtkIdList* points)
    {
      if (this->Chosen[c] > 0)
      {
        const DivisionSize ofCell = SizeOf(this->Source.KindOf(c).Shape, this->PartsOf(c, points));
        cells += ofCell.Cells;
        ids += ofCell.Ids;
      }
    });
  return { cells, ids };
}

CurvedError CurvedPlan::Error() const
{
  CurvedError worst;
  for (std::size_t c = 0; c < this->Chosen.size(); ++c)
  {
    if (this->Chosen[c] > 0)
    {
      const Bend& bend = this->AreCones[c] ? this->ConeBends[c] : this->Bends[c];
      const bool isPyramid = this->Source.KindOf(c).Shape == CurvedShape::Pyramid;
      const int parts = this->Chosen[c];
      const double squared = parts * (isPyramid ? std::min(parts, MostPartsOfPyramid) : parts);
      worst.OfPoints = std::max(worst.OfPoints, bend.OfPoints / squared);
      worst.OfValues = std::max(worst.OfValues, bend.OfValues / squared);
    }
  }
  if (!this->AreValuesBounded)
  {
    worst.OfValues = std::numeric_limits<double>::quiet_NaN();
  }
  return worst;
}

}
