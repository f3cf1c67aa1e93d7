// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grids/GridCells.h"

#include "Grids/CellTypes.h"
#include "Grids/GridShape.h"
#include "Grids/PartPoints.h"
#include "Input/GhostArray.h"
#include "Input/SamplesOfArray.h"
#include "Scene/Parallel.h"
#include "Shapes/GivenCells.h"
#include "Shapes/SubdividedCells.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVersionMacros.h>
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
#include <vtkAffineArray.h>
#include <vtkConstantArray.h>
#endif

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

constexpr std::uint8_t NotToBeShown = vtkDataSetAttributes::HIDDENCELL |
  vtkDataSetAttributes::REFINEDCELL | vtkDataSetAttributes::DUPLICATECELL;

constexpr std::int64_t CellGrain = 1 << 14;

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)

template <typename Id>
std::int64_t SlopeFromZero(vtkDataArray* offsets)
{
  auto* const affine = vtkAffineArray<Id>::FastDownCast(offsets);
  const auto line = affine ? affine->GetBackend() : nullptr;
  return line && line->Intercept == 0 && line->Slope > 0 ? line->Slope : 0;
}

/// The number of points of every cell of an array with fixed-size storage, otherwise 0.
std::int64_t PointsOfEachCell(vtkCellArray* cells)
{
  vtkDataArray* const offsets = cells->GetOffsetsArray();
  const std::int64_t points = SlopeFromZero<vtkTypeInt32>(offsets);
  return points != 0 ? points : SlopeFromZero<vtkTypeInt64>(offsets);
}

/// The type of all cells, if a constant array holds the types; otherwise null.
const std::uint8_t* ConstantType(vtkDataArray* types)
{
  auto* const constant = vtkConstantArray<unsigned char>::FastDownCast(types);
  const auto backend = constant ? constant->GetBackend() : nullptr;
  return backend ? &backend->Value : nullptr;
}

#else

std::int64_t PointsOfEachCell(vtkCellArray*)
{
  return 0;
}

const std::uint8_t* ConstantType(vtkDataArray*)
{
  return nullptr;
}

#endif

/// Find integers of 32 or 64 bits: in place, or in a copy if VTK computes them or their size
/// differs.
bool FindIds(const GridLeaf& leaf, vtkDataArray* array, const char* what, MeshArray& ids,
  ArrayCopies& copies, std::string& error)
{
  const int type = array->GetDataType();
  if (array->GetNumberOfComponents() != 1 || type == VTK_FLOAT || type == VTK_DOUBLE)
  {
    error = leaf.Name + " has cells with " + what + " in a " + array->GetClassName() +
      "; give vtkCellArray integers of 32 or 64 bits, for example with ConvertTo64BitStorage.";
    return false;
  }
  const auto isTaken = [](const ArraySamples& found)
  { return found.Type == ScalarType::Int32 || found.Type == ScalarType::Int64; };
  if (!AreInPlace(array) || !isTaken(SamplesOf(array, 0)))
  {
    copies.push_back(CopyInPlace(array, VTK_TYPE_INT64));
    array = copies.back();
  }
  const ArraySamples samples = SamplesOf(array, 0);
  ids = { samples.First, samples.Type, samples.Step };
  return true;
}

bool SetConnectivity(const GridLeaf& leaf, vtkCellArray* cells, MeshPart& part, ArrayCopies& copies,
  std::string& error)
{
  part.ConnectivitySize = cells->GetConnectivityArray()->GetNumberOfValues();
  if (cells->GetNumberOfCells() < part.NumberOfCells)
  {
    error = leaf.Name + " has " + std::to_string(part.NumberOfCells) + " cells, but points of " +
      std::to_string(cells->GetNumberOfCells()) + "; give it a vtkCellArray with all of them.";
    return false;
  }
  part.PointsOfEach = PointsOfEachCell(cells);
  return (part.PointsOfEach != 0 ||
           FindIds(leaf, cells->GetOffsetsArray(), "offsets", part.Offsets, copies, error)) &&
    FindIds(leaf, cells->GetConnectivityArray(), "point ids", part.Connectivity, copies, error);
}

/// Find the types of cells: in place, or in a copy if VTK computes them.
void FindTypes(vtkDataArray* types, MeshPart& part, ArrayCopies& copies)
{
  part.Types = ConstantType(types);
  part.TypeStep = part.Types ? 0 : 1;
  if (!part.Types)
  {
    auto* inMemory = vtkUnsignedCharArray::SafeDownCast(types);
    if (!inMemory)
    {
      copies.push_back(CopyInPlace(types, VTK_UNSIGNED_CHAR));
      inMemory = vtkUnsignedCharArray::SafeDownCast(copies.back());
    }
    part.Types = inMemory->GetPointer(0);
  }
}

/// The part of a message that says which cells a data set has.
std::string TextOfType(const GridLeaf& leaf, std::size_t type, std::int64_t count)
{
  return leaf.Name + " has " + std::to_string(count) + (count == 1 ? " cell" : " cells") +
    " of type " + std::to_string(type) + ", which ";
}

bool SetTypes(vtkUnstructuredGrid* grid, const GridLeaf& leaf, MeshPart& part, ArrayCopies& copies,
  CellCensus& census, std::string& error)
{
  vtkDataArray* types = TypesOf(grid);
  if (!types || types->GetNumberOfValues() < part.NumberOfCells)
  {
    error = leaf.Name + " has " + std::to_string(part.NumberOfCells) + " cells, but types of " +
      std::to_string(types ? types->GetNumberOfValues() : 0) +
      "; give SetCells one type for each cell.";
    return false;
  }
  FindTypes(types, part, copies);
  const TypeCounts counts = CountTypes(part);
  for (std::size_t type = 0; type < counts.size(); ++type)
  {
    if (counts[type] == 0)
    {
      continue;
    }
    const int dimension = DimensionOfType(static_cast<int>(type));
    if (dimension < 0)
    {
      error = TextOfType(leaf, type, counts[type]) + "VTK does not know; leave " +
        (counts[type] == 1 ? "it" : "them") + " out with vtkExtractCells.";
      return false;
    }
    const bool isOther = dimension == 3 && !IsLinear(static_cast<int>(type));
    if (isOther && !IsSubdivided(static_cast<int>(type)))
    {
      error = TextOfType(leaf, type, counts[type]) + "cannot be drawn; make others of " +
        (counts[type] == 1 ? "it" : "them") + ", for example with vtkDataSetTriangleFilter.";
      return false;
    }
    census.HasOthers = census.HasOthers || isOther;
  }
  return true;
}

/// One byte for each cell: 1 if its own flag or a point's flag hides it, or if it is missing.
/// \param ofCells, ofPoints, missing may be null
MadeFlags FlagsOfAll(const MeshPart& part, const std::uint8_t* ofCells,
  const std::uint8_t* ofPoints, const std::uint8_t* missing)
{
  const auto made =
    std::make_shared<std::vector<std::uint8_t>>(static_cast<std::size_t>(part.NumberOfCells));
  ParallelFor(part.NumberOfCells, CellGrain,
    [&](std::int64_t cell)
    {
      unsigned int flag = ofCells && (ofCells[cell] & NotToBeShown) ? 1u : 0u;
      flag |= missing ? missing[cell] : 0u;
      if (ofPoints)
      {
        ForEachPoint(part, cell,
          [&](std::int64_t point)
          { flag |= ofPoints[point] & vtkDataSetAttributes::HIDDENPOINT ? 1u : 0u; });
      }
      (*made)[static_cast<std::size_t>(cell)] = static_cast<std::uint8_t>(flag);
    });
  return made;
}

bool SetFlags(const GridLeaf& leaf, const std::vector<std::uint8_t>& missing, MeshPart& part,
  MadeFlags& made, std::string& error)
{
  const std::uint8_t* ofCells = nullptr;
  const std::uint8_t* ofPoints = nullptr;
  const ArrayPlaces cells{ leaf.Name, true, part.NumberOfCells };
  const ArrayPlaces points{ leaf.Name, false, part.NumberOfPoints };
  if (!FindFlags(leaf.Data->GetCellData(), cells, ofCells, error) ||
    !FindFlags(leaf.Data->GetPointData(), points, ofPoints, error))
  {
    return false;
  }
  const bool hidesPoints = ofPoints &&
    std::any_of(ofPoints, ofPoints + part.NumberOfPoints,
      [](std::uint8_t flag) { return (flag & vtkDataSetAttributes::HIDDENPOINT) != 0; });
  made = hidesPoints || !missing.empty()
    ? FlagsOfAll(
        part, ofCells, hidesPoints ? ofPoints : nullptr, missing.empty() ? nullptr : missing.data())
    : nullptr;
  part.Flags = made ? made->data() : ofCells;
  part.HidingFlags = made ? 1 : NotToBeShown;
  return true;
}

/// Mark the NaN values of a component.
template <typename T>
void MarkNaN(const ArraySamples& samples, std::int64_t count, std::vector<std::uint8_t>& missing)
{
  const T* const first = static_cast<const T*>(samples.First);
  for (std::int64_t i = 0; i < count; ++i)
  {
    if (std::isnan(first[i * samples.Step]))
    {
      missing.resize(static_cast<std::size_t>(count), 0);
      missing[static_cast<std::size_t>(i)] = 1;
    }
  }
}

}

void NoteCells(const GridLeaf& leaf, MadeFrom& from)
{
  const glm::ivec3 dimensions = DimensionsOf(leaf.Data);
  for (int axis = 0; axis < 3; ++axis)
  {
    from.Add(dimensions[axis]);
  }
  from.Add(static_cast<double>(leaf.Data->GetNumberOfPoints()));
  if (vtkCellArray* cells = CellsOf(leaf.Data))
  {
    // Writers of cells may call Modified() of an array or of all cells.
    from.Add(cells->GetOffsetsArray(), cells->GetMTime());
    from.Add(cells->GetConnectivityArray());
    from.Add(static_cast<double>(leaf.Data->GetNumberOfCells()));
  }
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(leaf.Data))
  {
    from.Add(TypesOf(grid));
    for (const auto& [array, time] : FaceArraysOf(grid))
    {
      from.Add(array, time);
    }
    from.Add(grid->GetPointData()->GetRationalWeights());
    from.Add(grid->GetCellData()->GetHigherOrderDegrees());
  }
  from.Add(GhostsOf(leaf.Data->GetCellData()));
  from.Add(GhostsOf(leaf.Data->GetPointData()));
}

void FindMissingCells(
  const GridLeaf& leaf, const DrawnComponent& component, std::vector<std::uint8_t>& missing)
{
  missing.clear();
  const vtkIdType count = leaf.Data->GetNumberOfCells();
  const int components = leaf.Array->GetNumberOfComponents();
  if (!leaf.OnCells || leaf.Array->GetNumberOfTuples() < count)
  {
    return;
  }
  const int first = component.IsMagnitude ? 0 : std::max(component.Number, 0);
  const int end = component.IsMagnitude ? components : component.Number + 1;
  for (int c = first; c < end && c < components; ++c)
  {
    const ArraySamples samples = SamplesOf(leaf.Array, c);
    if (samples.Type == ScalarType::Float32)
    {
      MarkNaN<float>(samples, count, missing);
    }
    else if (samples.Type == ScalarType::Float64)
    {
      MarkNaN<double>(samples, count, missing);
    }
  }
}

bool SetCells(const GridLeaf& leaf, const std::vector<std::uint8_t>& missing, MeshPart& part,
  MadeFlags& made, ArrayCopies& copies, CellCensus& census, std::string& error)
{
  census = CellCensus();
  copies.clear();
  part.NumberOfPoints = leaf.Data->GetNumberOfPoints();
  part.NumberOfCells = leaf.Data->GetNumberOfCells();
  vtkCellArray* cells = CellsOf(leaf.Data);
  if (cells && !SetConnectivity(leaf, cells, part, copies, error))
  {
    return false;
  }
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(leaf.Data))
  {
    if (!SetTypes(grid, leaf, part, copies, census, error))
    {
      return false;
    }
  }
  else if (!cells)
  {
    part.Dimensions = DimensionsOf(leaf.Data);
  }
  return SetFlags(leaf, missing, part, made, error);
}

}
