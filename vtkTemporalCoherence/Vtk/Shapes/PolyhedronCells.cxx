// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes/PolyhedronCells.h"

#include <vtkBoundingBox.h>
#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkMath.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace TemporalCoherence
{

namespace
{

using Place = std::array<double, 3>;

/// Sets of points that are thinner than this, by their longest extent, are stretched.
constexpr double Thin = 0.25;

/// Scale points to the unit cube. Those of a thin set lie there along its principal axes, all
/// extents alike: the triangulation would lose most of it.
/// \return false if they lie in a plane
bool ScaleToUnit(const std::vector<Place>& points, std::vector<Place>& scaled)
{
  vtkBoundingBox box;
  for (const Place& point : points)
  {
    box.AddPoint(point[0], point[1], point[2]);
  }
  const double longest = box.IsValid() ? box.GetMaxLength() : 0.0;
  if (!(longest > 0.0))
  {
    return false;
  }
  scaled = points;
  Place mean{};
  for (Place& point : scaled)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      point[a] = (point[a] - box.GetBound(2 * static_cast<int>(a))) / longest;
      mean[a] += point[a] / static_cast<double>(points.size());
    }
  }
  double spread[3][3] = {}, sizes[3], axes[3][3];
  for (const Place& point : scaled)
  {
    for (std::size_t a = 0; a < 9; ++a)
    {
      spread[a / 3][a % 3] += (point[a / 3] - mean[a / 3]) * (point[a % 3] - mean[a % 3]);
    }
  }
  vtkMath::Diagonalize3x3(spread, sizes, axes);
  Place least{}, most{};
  std::vector<Place> turned(scaled.size(), Place{});
  for (std::size_t p = 0; p < scaled.size(); ++p)
  {
    for (std::size_t a = 0; a < 9; ++a)
    {
      turned[p][a % 3] += (scaled[p][a / 3] - mean[a / 3]) * axes[a / 3][a % 3];
    }
    for (std::size_t a = 0; a < 3; ++a)
    {
      least[a] = std::min(least[a], turned[p][a]);
      most[a] = std::max(most[a], turned[p][a]);
    }
  }
  const Place extents = { most[0] - least[0], most[1] - least[1], most[2] - least[2] };
  const auto [shortest, largest] = std::minmax_element(extents.begin(), extents.end());
  constexpr double flat = 1e-14;
  if (*shortest<Thin* * largest&& * shortest> flat)
  {
    for (std::size_t p = 0; p < scaled.size(); ++p)
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        scaled[p][a] = (turned[p][a] - least[a]) / extents[a];
      }
    }
  }
  return *shortest > flat;
}

}

bool IsPolyhedron(int type)
{
  return type == VTK_POLYHEDRON || type == VTK_PENTAGONAL_PRISM || type == VTK_HEXAGONAL_PRISM ||
    type == VTK_CONVEX_POINT_SET;
}

PolyhedronCells::PolyhedronCells(
  const GivenCells& given, const PointReader& reader, SharedPoints& shared, MadeCells& made)
  : Given(given)
  , Grid(given.Grid)
  , Reader(reader)
  , Shared(shared)
  , Made(made)
{
}

bool PolyhedronCells::Add(vtkIdType cell, std::string& error)
{
  switch (this->Grid->GetCellType(cell))
  {
    case VTK_POLYHEDRON:
      return this->AddPolyhedron(cell, error);
    case VTK_CONVEX_POINT_SET:
      this->AddConvexSet(cell);
      return true;
    default:
      return this->AddPrism(cell, error);
  }
}

bool PolyhedronCells::AddPolyhedron(vtkIdType cell, std::string& error)
{
  std::vector<Face> faces;
  if (!this->Given.ReadFaces(cell, faces, error))
  {
    return false;
  }
  Face corners;
  for (const Face& face : faces)
  {
    corners.insert(corners.end(), face.begin(), face.end());
  }
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  if (faces.size() == 4 && corners.size() == 4)
  {
    std::array<std::int32_t, 4> ids;
    std::transform(corners.begin(), corners.end(), ids.begin(),
      [this](vtkIdType point) { return this->NumberOf(point); });
    this->Made.AddCell(MeshCellType::Tetrahedron, ids, cell);
  }
  else if (faces.size() > 4)
  {
    const std::int32_t apex = this->Made.AddPoint(this->MeanOf(corners));
    for (const Face& face : faces)
    {
      this->AddConeOver(face, apex, cell);
    }
  }
  return true;
}

void PolyhedronCells::AddConeOver(const Face& face, std::int32_t apex, vtkIdType cell)
{
  std::vector<std::int32_t> ids(face.size());
  std::transform(face.begin(), face.end(), ids.begin(),
    [this](vtkIdType point) { return this->NumberOf(point); });
  if (face.size() <= 4)
  {
    ids.push_back(apex);
    this->Made.AddCell(
      face.size() == 3 ? MeshCellType::Tetrahedron : MeshCellType::Pyramid, ids, cell);
    return;
  }
  const std::int32_t middle = this->MiddleOf(face);
  for (std::size_t p = 0; p < ids.size(); ++p)
  {
    this->Made.AddCell(MeshCellType::Tetrahedron,
      std::array<std::int32_t, 4>{ ids[p], ids[(p + 1) % ids.size()], middle, apex }, cell);
  }
}

/// Wedges around the axis.
bool PolyhedronCells::AddPrism(vtkIdType cell, std::string& error)
{
  const bool hasFive = this->Grid->GetCellType(cell) == VTK_PENTAGONAL_PRISM;
  const vtkIdType corners = hasFive ? 5 : 6;
  this->Grid->GetCells()->GetCellAtId(cell, this->Ids);
  if (this->Ids->GetNumberOfIds() != 2 * corners)
  {
    error = this->Given.NameOf(cell) + " is a " +
      (hasFive ? "VTK_PENTAGONAL_PRISM" : "VTK_HEXAGONAL_PRISM") + " with " +
      std::to_string(this->Ids->GetNumberOfIds()) + " points, but needs " +
      std::to_string(2 * corners) + "; correct the cell or leave it out with vtkExtractCells.";
    return false;
  }
  std::array<Face, 2> ends;
  for (vtkIdType p = 0; p < 2 * corners; ++p)
  {
    ends[p < corners ? 0 : 1].push_back(this->Ids->GetId(p));
  }
  const std::array<std::int32_t, 2> middles{ this->MiddleOf(ends[0]), this->MiddleOf(ends[1]) };
  for (std::size_t p = 0; p < ends[0].size(); ++p)
  {
    std::array<std::int32_t, 6> ids;
    for (std::size_t end = 0; end < 2; ++end)
    {
      ids[3 * end] = middles[end];
      ids[3 * end + 1] = this->NumberOf(ends[end][p]);
      ids[3 * end + 2] = this->NumberOf(ends[end][(p + 1) % ends[end].size()]);
    }
    this->Made.AddCell(MeshCellType::Wedge, ids, cell);
  }
  return true;
}

/// The Delaunay tetrahedra. Of points on one sphere, those with lower numbers decide, so that
/// neighbours split a face alike. (vtkConvexPointSet goes by the order of points in the cell and
/// stretches each cell to a cube, which neighbours do not agree on.)
void PolyhedronCells::AddConvexSet(vtkIdType cell)
{
  vtkNew<vtkIdList> points;
  this->Grid->GetCells()->GetCellAtId(cell, points);
  Face unique(points->begin(), points->end());
  std::sort(unique.begin(), unique.end());
  unique.erase(std::unique(unique.begin(), unique.end()), unique.end());
  std::vector<Place> places;
  const auto isNowhere = [&](vtkIdType point)
  {
    Place at;
    this->Grid->GetPoint(point, at.data());
    const bool isFinite = std::isfinite(at[0] + at[1] + at[2]);
    if (isFinite)
    {
      places.push_back(at);
    }
    return !isFinite;
  };
  // The other points are a convex set, too.
  unique.erase(std::remove_if(unique.begin(), unique.end(), isNowhere), unique.end());
  std::vector<Place> scaled;
  if (unique.size() < 4 || !ScaleToUnit(places, scaled))
  {
    return;
  }
  // Tetrahedra outside of a large octahedron around these bounds are lost: thin ones at the hull.
  this->Triangulator->InitTriangulation(
    -5.0, 6.0, -5.0, 6.0, -5.0, 6.0, static_cast<int>(unique.size()));
  for (std::size_t p = 0; p < unique.size(); ++p)
  {
    this->Triangulator->InsertPoint(
      static_cast<vtkIdType>(p), places[p].data(), scaled[p].data(), 0);
  }
  this->Triangulator->Triangulate();
  this->Ids->Reset();
  this->Corners->Reset();
  this->Triangulator->AddTetras(0, this->Ids, this->Corners); // appends
  for (vtkIdType p = 0; p + 3 < this->Ids->GetNumberOfIds(); p += 4)
  {
    std::array<std::int32_t, 4> ids;
    for (vtkIdType corner = 0; corner < 4; ++corner)
    {
      ids[static_cast<std::size_t>(corner)] =
        this->NumberOf(unique[static_cast<std::size_t>(this->Ids->GetId(p + corner))]);
    }
    this->Made.AddCell(MeshCellType::Tetrahedron, ids, cell);
  }
}

std::int32_t PolyhedronCells::NumberOf(vtkIdType point)
{
  const auto next = static_cast<std::int32_t>(this->Made.Points.size());
  const std::int32_t number = this->Shared.Find(point, next);
  if (number == next)
  {
    this->Made.AddPoint(this->Reader.Read(point));
  }
  return number;
}

std::int32_t PolyhedronCells::MiddleOf(const Face& face)
{
  SharedPoints::Name name;
  for (const vtkIdType point : face)
  {
    name.emplace_back(point, 1);
  }
  const auto next = static_cast<std::int32_t>(this->Made.Points.size());
  const std::int32_t number = this->Shared.Find(name, next);
  if (number == next)
  {
    this->Made.AddPoint(this->MeanOf(face));
  }
  return number;
}

PointValue PolyhedronCells::MeanOf(const Face& points) const
{
  const PointValue first = this->Reader.Read(points.front());
  PointValue mean{ 0.0, 0.0, 0.0, 0.0 };
  for (const vtkIdType id : points)
  {
    const PointValue point = this->Reader.Read(id);
    for (std::size_t c = 0; c < mean.size(); ++c)
    {
      mean[c] += (point[c] - first[c]) / static_cast<double>(points.size());
    }
  }
  for (std::size_t c = 0; c < mean.size(); ++c)
  {
    mean[c] += first[c];
  }
  return mean;
}

}
