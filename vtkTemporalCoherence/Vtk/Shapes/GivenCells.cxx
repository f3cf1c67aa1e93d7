// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes/GivenCells.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkIdTypeArray.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVersionMacros.h>

#include <algorithm>
#include <utility>

namespace TemporalCoherence
{
namespace
{

/// Read one of many lists of ids. Fails if the list begins or ends outside of the array.
bool ReadList(vtkCellArray* lists, vtkIdType list, vtkIdList* ids)
{
  vtkDataArray* const offsets = lists->GetOffsetsArray();
  if (list < 0 || list >= offsets->GetNumberOfTuples() - 1)
  {
    return false;
  }
  // Compare offsets as doubles: wrong ones may exceed the range of ids.
  const double begin = offsets->GetComponent(list, 0), end = offsets->GetComponent(list + 1, 0);
  const auto size = static_cast<double>(lists->GetConnectivityArray()->GetNumberOfTuples());
  if (!(begin >= 0.0 && begin <= end && end <= size))
  {
    return false;
  }
  lists->GetCellAtId(list, ids);
  return true;
}

/// The outcome of a search for a polyhedron's faces.
enum class FacesFound
{
  All,
  None,
  Outside ///< they begin or end outside of their arrays
};

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)

FacesFound FindFaces(
  vtkUnstructuredGrid* grid, vtkIdType cell, std::vector<GivenCells::Face>& faces)
{
  vtkCellArray* const points = grid->GetPolyhedronFaces();
  vtkCellArray* const facesOf = grid->GetPolyhedronFaceLocations();
  if (!points || !facesOf)
  {
    return FacesFound::None;
  }
  vtkNew<vtkIdList> numbers, ids;
  if (!ReadList(facesOf, cell, numbers))
  {
    return FacesFound::Outside;
  }
  for (const vtkIdType number : *numbers)
  {
    if (!ReadList(points, number, ids))
    {
      return FacesFound::Outside;
    }
    faces.emplace_back(ids->begin(), ids->end());
  }
  return faces.empty() ? FacesFound::None : FacesFound::All;
}

#else

/// Read VTK's face stream: the face count, then for each face its point count and point ids.
FacesFound FindFaces(
  vtkUnstructuredGrid* grid, vtkIdType cell, std::vector<GivenCells::Face>& faces)
{
  vtkIdTypeArray* const stream = grid->GetFaces();
  vtkIdTypeArray* const locations = grid->GetFaceLocations();
  if (!stream || !locations)
  {
    return FacesFound::None;
  }
  const vtkIdType length = stream->GetNumberOfValues();
  vtkIdType at = cell < locations->GetNumberOfValues() ? locations->GetValue(cell) : length;
  if (at == -1) // VTK's mark for a cell without faces
  {
    return FacesFound::None;
  }
  if (at < 0 || at >= length)
  {
    return FacesFound::Outside;
  }
  const vtkIdType count = stream->GetValue(at++);
  for (vtkIdType f = 0; f < count; ++f)
  {
    const vtkIdType points = at < length ? stream->GetValue(at++) : -1;
    if (points < 0 || points > length - at)
    {
      return FacesFound::Outside;
    }
    const vtkIdType* const first = stream->GetPointer(at);
    faces.emplace_back(first, first + points);
    at += points;
  }
  return count < 0 ? FacesFound::Outside : count == 0 ? FacesFound::None : FacesFound::All;
}

#endif

}

std::vector<std::pair<vtkDataArray*, vtkMTimeType>> FaceArraysOf(vtkUnstructuredGrid* grid)
{
  std::vector<std::pair<vtkDataArray*, vtkMTimeType>> arrays;
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0)
  for (vtkCellArray* lists : { grid->GetPolyhedronFaces(), grid->GetPolyhedronFaceLocations() })
  {
    if (lists)
    {
      arrays.emplace_back(lists->GetOffsetsArray(), lists->GetMTime());
      arrays.emplace_back(lists->GetConnectivityArray(), lists->GetMTime());
    }
  }
#else
  for (vtkIdTypeArray* numbers : { grid->GetFaces(), grid->GetFaceLocations() })
  {
    arrays.emplace_back(numbers, 0);
  }
#endif
  return arrays;
}

GivenCells::GivenCells(vtkUnstructuredGrid* grid, std::string name)
  : Grid(grid)
  , Name(std::move(name))
{
}

std::string GivenCells::NameOf(vtkIdType cell) const
{
  return "Cell " + std::to_string(cell) + " of " + this->Name;
}

bool GivenCells::HasPoint(vtkIdType point) const
{
  return point >= 0 && point < this->Grid->GetNumberOfPoints();
}

bool GivenCells::ReadPoints(vtkIdType cell, vtkIdList* points, std::string& error) const
{
  vtkCellArray* const cells = this->Grid->GetCells();
  if (!ReadList(cells, cell, points))
  {
    error = this->NameOf(cell) + " has points that begin or end outside of the " +
      std::to_string(cells->GetConnectivityArray()->GetNumberOfTuples()) +
      " point ids of its vtkCellArray; give SetData offsets that ascend up to their number.";
    return false;
  }
  const auto wrong = std::find_if(
    points->begin(), points->end(), [this](vtkIdType point) { return !this->HasPoint(point); });
  if (wrong == points->end())
  {
    return true;
  }
  error = this->NameOf(cell) + " has the point " + std::to_string(*wrong) + ", but there are " +
    std::to_string(this->Grid->GetNumberOfPoints()) +
    " points; correct it or leave it out with vtkExtractCells.";
  return false;
}

bool GivenCells::ReadFaces(vtkIdType cell, std::vector<Face>& faces, std::string& error) const
{
  faces.clear();
  const std::string polyhedron = this->NameOf(cell) + " is a VTK_POLYHEDRON ";
  const FacesFound found = FindFaces(this->Grid, cell, faces);
  if (found == FacesFound::None)
  {
    error = polyhedron +
      "without faces; give them to InsertNextCell or SetCells, or leave it out with "
      "vtkExtractCells.";
    return false;
  }
  const bool areThere = found == FacesFound::All &&
    std::all_of(faces.begin(), faces.end(),
      [this](const Face& face)
      {
        return std::all_of(
          face.begin(), face.end(), [this](vtkIdType point) { return this->HasPoint(point); });
      });
  if (!areThere)
  {
    error = polyhedron + "with faces that " +
      (found == FacesFound::All ? "name points which are not there"
                                : "begin or end outside of the array of all faces") +
      "; correct its faces or leave it out with vtkExtractCells.";
    return false;
  }
  const auto isLess = [](const Face& face) { return face.size() < 3; };
  faces.erase(std::remove_if(faces.begin(), faces.end(), isLess), faces.end());
  return true;
}

}
