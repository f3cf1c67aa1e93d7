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
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <sstream>

namespace TemporalCoherence
{
namespace
{

constexpr std::uint8_t NotToBeShown = vtkDataSetAttributes::HIDDENCELL |
  vtkDataSetAttributes::REFINEDCELL | vtkDataSetAttributes::DUPLICATECELL;

constexpr std::int64_t CellGrain = 1 << 14;

/// Find integers of 32 or 64 bits.
bool FindIds(
  const GridLeaf& leaf, vtkDataArray* array, const char* what, MeshArray& ids, std::string& error)
{
  ArraySamples samples;
  if (!FindSamples(array, 0, samples, error))
  {
    return false;
  }
  if (array->GetNumberOfComponents() != 1 ||
    (samples.Type != ScalarType::Int32 && samples.Type != ScalarType::Int64))
  {
    error = leaf.Name + " has cells with " + what + " in a " + array->GetClassName() +
      "; give vtkCellArray integers of 32 or 64 bits, for example with ConvertTo64BitStorage.";
    return false;
  }
  ids = { samples.First, samples.Type, samples.Step };
  return true;
}

bool SetConnectivity(const GridLeaf& leaf, vtkCellArray* cells, MeshPart& part, std::string& error)
{
  part.ConnectivitySize = cells->GetConnectivityArray()->GetNumberOfValues();
  if (cells->GetNumberOfCells() < part.NumberOfCells)
  {
    error = leaf.Name + " has " + std::to_string(part.NumberOfCells) + " cells, but points of " +
      std::to_string(cells->GetNumberOfCells()) + "; give it a vtkCellArray with all of them.";
    return false;
  }
  return FindIds(leaf, cells->GetOffsetsArray(), "offsets", part.Offsets, error) &&
    FindIds(leaf, cells->GetConnectivityArray(), "point ids", part.Connectivity, error);
}

/// That a data set has cells of a type, for a message.
std::string TextOfType(const GridLeaf& leaf, std::size_t type, std::int64_t count)
{
  return leaf.Name + " has " + std::to_string(count) + (count == 1 ? " cell" : " cells") +
    " of type " + std::to_string(type) + ", which ";
}

bool SetTypes(vtkUnstructuredGrid* grid, const GridLeaf& leaf, MeshPart& part, CellCensus& census,
  std::string& error)
{
  vtkUnsignedCharArray* types = grid->GetCellTypesArray();
  if (!types || types->GetNumberOfValues() < part.NumberOfCells)
  {
    error = leaf.Name + " has " + std::to_string(part.NumberOfCells) + " cells, but types of " +
      std::to_string(types ? types->GetNumberOfValues() : 0) +
      "; give SetCells one type for each cell.";
    return false;
  }
  part.Types = types->GetPointer(0);
  const TypeCounts counts = CountTypes(part.Types, part.NumberOfCells);
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

/// The flags of points or cells; null if there are none.
bool FindFlags(const GridLeaf& leaf, vtkDataSetAttributes* attributes, vtkIdType count,
  const char* places, const std::uint8_t*& flags, std::string& error)
{
  vtkUnsignedCharArray* ghosts = GhostsOf(attributes);
  flags = ghosts ? ghosts->GetPointer(0) : nullptr;
  if (!ghosts || HasOneForEach(ghosts, count))
  {
    return true;
  }
  std::ostringstream what;
  what << leaf.Name << " has a ghost array '" << vtkDataSetAttributes::GhostArrayName() << "' of "
       << ghosts->GetNumberOfTuples() << " tuples of " << ghosts->GetNumberOfComponents()
       << " component(s), but " << count << ' ' << places
       << "; give it one value for each, or remove it.";
  error = what.str();
  return false;
}

/// One byte for each cell, 1 if its own flag or that of a point hides it, or if it is missing.
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
  if (!FindFlags(leaf, leaf.Data->GetCellData(), part.NumberOfCells, "cells", ofCells, error) ||
    !FindFlags(leaf, leaf.Data->GetPointData(), part.NumberOfPoints, "points", ofPoints, error))
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
    // Whoever writes cells may call Modified() of an array or of all cells.
    from.Add(cells->GetOffsetsArray(), cells->GetMTime());
    from.Add(cells->GetConnectivityArray());
    from.Add(static_cast<double>(leaf.Data->GetNumberOfCells()));
  }
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(leaf.Data))
  {
    from.Add(grid->GetCellTypesArray());
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

bool SetCells(const GridLeaf& leaf, const std::vector<std::uint8_t>& missing, MeshPart& part,
  MadeFlags& made, CellCensus& census, std::string& error)
{
  census = CellCensus();
  part.NumberOfPoints = leaf.Data->GetNumberOfPoints();
  part.NumberOfCells = leaf.Data->GetNumberOfCells();
  vtkCellArray* cells = CellsOf(leaf.Data);
  if (cells && !SetConnectivity(leaf, cells, part, error))
  {
    return false;
  }
  if (auto* grid = vtkUnstructuredGrid::SafeDownCast(leaf.Data))
  {
    if (!SetTypes(grid, leaf, part, census, error))
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
