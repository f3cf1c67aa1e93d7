// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CurvedCellReader_h
#define TemporalCoherence_CurvedCellReader_h

#include "Scene/Progress.h"
#include "Shapes/BernsteinFunctions.h"
#include "Shapes/CellDivision.h"
#include "Shapes/CurvedCells.h"
#include "Shapes/PointReader.h"

#include <vtkGenericCell.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkSMPTools.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <new>
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkUnstructuredGrid;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// The values of VTK's interpolation functions of a cell: a row for each place.
/// \param places in the straight cell with edges of length 1
std::vector<double> WeightsAt(vtkCell* cell, const std::vector<glm::dvec3>& places);

/// The weighted sum of a cell's points. Exact if all points are equal, and at points.
PointValue Weigh(const double* weights, const std::vector<PointValue>& points);

/// Curved cells, with the data for dividing them.
///
/// Threads share the user's arrays, and read them by stateless functions only. VTK's cells have a
/// state, which vtkUnstructuredGrid::GetCell writes: it reads rational weights through a buffer
/// that all threads share. So each thread has its own cells, made of a private grid, and rational
/// weights are applied here.
class CurvedSource
{
public:
  /// \pre the arguments outlive this
  CurvedSource(vtkUnstructuredGrid* grid, const CurvedCells& curved, const PointReader& reader);

  /// Set up a VTK cell of a kind, without rational weights. May be called by any thread.
  void SetCell(std::size_t kind, vtkGenericCell* cell) const;

  /// Weights of the corners of the straight cell, for each point of a kind.
  const std::vector<std::array<double, 8>>& LinearWeights(std::size_t kind) const
  {
    return this->WeightsOfKinds[kind];
  }

  /// The points of a cell. May be called by any thread.
  void ReadIds(std::size_t number, vtkIdList* ids) const;

  std::size_t NumberOfCells() const { return this->Curved.Cells.size(); }
  const CurvedKind& KindOf(std::size_t number) const
  {
    return this->Curved.Kinds[this->Curved.KindOf[number]];
  }

  vtkUnstructuredGrid* const Grid;
  const CurvedCells& Curved;
  const PointReader Reader;

private:
  std::vector<vtkSmartPointer<vtkUnstructuredGrid>> Examples; ///< of each kind
  mutable std::mutex UsesExamples;
  std::vector<std::vector<std::array<double, 8>>> WeightsOfKinds;
};

/// The interpolation functions of one kind of cells, for one thread.
class KindFunctions
{
public:
  KindFunctions(const CurvedSource& source, std::size_t kind);

  /// The values at a place; valid until the next call.
  const double* At(const DivisionPlace& place);

private:
  CurvedShape Shape;
  vtkNew<vtkGenericCell> Cell;
  double Base;
  BernsteinFunctions Bernstein; ///< of Bezier cells
  std::size_t NumberOfPoints;
  std::vector<double> Scratch;
  std::vector<DivisionPlace> Places; ///< of the kept rows
  std::vector<double> Rows;
};

/// Reads curved cells for one thread.
class CurvedCellReader
{
public:
  /// The valid samples of a cell.
  enum class Samples
  {
    All,
    Corners,   ///< others were replaced
    Unbounded, ///< all, but a corner or the range of values is infinite
    None       ///< a corner is NaN: the cell is hidden
  };

  void Read(const CurvedSource& source, std::size_t number);

  /// \pre a cell was read
  PointValue At(const DivisionPlace& place);

  std::vector<PointValue> Points;
  Samples Given = Samples::All;

private:
  void Complete(const CurvedSource& source, std::size_t kind);

  vtkNew<vtkIdList> Ids;
  std::vector<std::unique_ptr<KindFunctions>> Functions; ///< by kind
  KindFunctions* Of = nullptr;                           ///< of the cell that was read last
  std::vector<double> Rational, Row;
};

/// Call `visit(reader, i)` for each i below a number, in parallel, with a reader that no other
/// thread uses.
/// \return false if progress stopped it
/// \throws std::bad_alloc
template <typename Visit>
bool ForEachWithReader(std::size_t count, const ReportProgress& progress, const Visit& visit)
{
  constexpr std::size_t numbersBetweenReports = 4096;
  std::mutex guard;
  std::vector<std::unique_ptr<CurvedCellReader>> idle;
  std::atomic<bool> hasMemory(true);
  const auto work = [&](vtkIdType begin, vtkIdType end)
  {
    try
    {
      std::unique_ptr<CurvedCellReader> reader;
      {
        const std::lock_guard<std::mutex> lock(guard);
        if (!idle.empty())
        {
          reader = std::move(idle.back());
          idle.pop_back();
        }
      }
      reader = reader ? std::move(reader) : std::make_unique<CurvedCellReader>();
      for (vtkIdType i = begin; i < end && hasMemory; ++i)
      {
        visit(*reader, static_cast<std::size_t>(i));
      }
      const std::lock_guard<std::mutex> lock(guard);
      idle.push_back(std::move(reader));
    }
    catch (const std::bad_alloc&)
    {
      hasMemory = false;
    }
  };
  for (std::size_t done = 0; done < count; done += numbersBetweenReports)
  {
    if (progress && !progress(static_cast<double>(done) / static_cast<double>(count)))
    {
      return false;
    }
    vtkSMPTools::For(static_cast<vtkIdType>(done),
      static_cast<vtkIdType>(std::min(done + numbersBetweenReports, count)), work);
    if (!hasMemory)
    {
      throw std::bad_alloc();
    }
  }
  return true;
}

}

#endif
