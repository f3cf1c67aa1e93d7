// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Shapes/PolyhedronCells.h"

#include "Polyhedra/UnitCube.h"

#include <vtkCellArray.h>
#include <vtkCellType.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace TemporalCoherence
{

namespace
{

glm::dvec3 PlaceOf(const PointValue& point)
{
  return { point[0], point[1], point[2] };
}

bool HasValue(const PointValue& point)
{
  return !std::isnan(point[3]);
}

/// Required share of IsSeenFromMean. Points on one side of a plane have a mean distance of at least
/// the largest distance / number (share 1). Less is required, because faces may be warped.
constexpr double SeenWell = 0.25;

PointValue MeanOf(const std::vector<PointValue>& points)
{
  const PointValue& first = points.front();
  PointValue mean{ 0.0, 0.0, 0.0, 0.0 };
  for (const PointValue& point : points)
  {
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

/// The sum of points with weights that add up to 1.
PointValue SumOf(const std::vector<PointValue>& points, const std::vector<double>& weights)
{
  const PointValue& first = points.front();
  PointValue sum = first;
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    for (std::size_t c = 0; c < sum.size(); ++c)
    {
      sum[c] += weights[p] * (points[p][c] - first[c]);
    }
  }
  return sum;
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
  const Surface& surface = this->SurfaceOf(std::move(faces));
  if (surface.Faces.size() == 4 && surface.Corners.size() == 4)
  {
    std::array<std::int32_t, 4> ids;
    std::transform(surface.Corners.begin(), surface.Corners.end(), ids.begin(),
      [this](vtkIdType point) { return this->NumberOf(point); });
    this->Made.AddCell(MeshCellType::Tetrahedron, ids, cell);
  }
  else if (surface.Faces.size() >= 4)
  {
    this->AddCones(surface, cell);
  }
  return true;
}

std::size_t PolyhedronCells::Surface::NumberOf(vtkIdType corner) const
{
  return static_cast<std::size_t>(
    std::lower_bound(this->Corners.begin(), this->Corners.end(), corner) - this->Corners.begin());
}

const PolyhedronCells::Surface& PolyhedronCells::SurfaceOf(std::vector<Face> faces)
{
  Surface& surface = this->Last;
  surface.Faces = std::move(faces);
  surface.Corners.clear();
  for (const Face& face : surface.Faces)
  {
    surface.Corners.insert(surface.Corners.end(), face.begin(), face.end());
  }
  std::sort(surface.Corners.begin(), surface.Corners.end());
  surface.Corners.erase(
    std::unique(surface.Corners.begin(), surface.Corners.end()), surface.Corners.end());
  surface.Middles.clear();
  surface.Parts.clear();
  surface.Points.clear();
  surface.Places.clear();
  for (const vtkIdType corner : surface.Corners)
  {
    surface.Points.push_back(this->Reader.Read(corner));
    surface.Places.push_back(PlaceOf(surface.Points.back()));
  }
  for (const Face& face : surface.Faces)
  {
    this->AddParts(face);
  }
  return surface;
}

void PolyhedronCells::AddParts(const Face& face)
{
  Surface& surface = this->Last;
  std::vector<std::int32_t>& numbers = this->FaceNumbers;
  numbers.clear();
  this->FacePoints.clear();
  this->FacePlaces.clear();
  for (const vtkIdType point : face)
  {
    const std::size_t number = surface.NumberOf(point);
    numbers.push_back(static_cast<std::int32_t>(number));
    this->FacePoints.push_back(surface.Points[number]);
    this->FacePlaces.push_back(surface.Places[number]);
  }
  surface.Middles.push_back(-1);
  const std::vector<FaceCutter::Triangle> triangles = this->Cutter.Cut(face, this->FacePlaces);
  for (const FaceCutter::Triangle& triangle : triangles)
  {
    surface.Parts.push_back(
      { { numbers[triangle[0]], numbers[triangle[1]], numbers[triangle[2]], -1 }, 3 });
  }
  if (!triangles.empty())
  {
    return;
  }
  if (face.size() <= 4)
  {
    numbers.resize(4, -1);
    surface.Parts.push_back({ { numbers[0], numbers[1], numbers[2], numbers[3] }, face.size() });
    return;
  }
  const auto middle = static_cast<std::int32_t>(surface.Points.size());
  surface.Middles.back() = middle;
  surface.Points.push_back(MeanOf(this->FacePoints));
  surface.Places.push_back(PlaceOf(surface.Points.back()));
  for (std::size_t p = 0; p < numbers.size(); ++p)
  {
    surface.Parts.push_back({ { numbers[p], numbers[(p + 1) % numbers.size()], middle, -1 }, 3 });
  }
}

bool PolyhedronCells::HasConcaveFace(const std::vector<Face>& faces)
{
  return std::any_of(faces.begin(), faces.end(),
    [this](const Face& face)
    {
      std::vector<glm::dvec3> places;
      for (const PointValue& point : this->Read(face))
      {
        places.push_back(PlaceOf(point));
      }
      return !this->Cutter.Cut(face, places).empty();
    });
}

/// Add cones from the mean of the points if it sees the surface well, else from other points.
void PolyhedronCells::AddCones(const Surface& surface, vtkIdType cell)
{
  // A cell without a value at a point is hidden as a whole.
  if (!std::all_of(surface.Points.begin(), surface.Points.end(), HasValue))
  {
    return;
  }
  ConeDivision division;
  if (!IsSeenFromMean(surface.Places, surface.Corners.size(), surface.Parts, SeenWell) &&
    !this->Divide(surface, division))
  {
    this->Overlapping.push_back(cell);
  }
  const bool isDivided = !division.Cones.empty();
  const auto corners = surface.Points.begin() + static_cast<std::ptrdiff_t>(surface.Corners.size());
  const std::int32_t mean =
    isDivided ? -1 : this->Made.AddPoint(MeanOf({ surface.Points.begin(), corners }));
  std::vector<std::int32_t> numbers = this->NumbersOf(surface);
  for (const std::vector<double>& weights : division.Inside)
  {
    numbers.push_back(this->Made.AddPoint(SumOf(surface.Points, weights)));
  }
  for (const Cone& cone : division.Cones)
  {
    this->AddCone(cone.Base, numbers[static_cast<std::size_t>(cone.Apex)], numbers, cell);
  }
  for (std::size_t part = 0; !isDivided && part < surface.Parts.size(); ++part)
  {
    this->AddCone(surface.Parts[part], mean, numbers, cell);
  }
}

/// \param division stays empty if cones from the mean of the points suffice
/// \return false if these cones leave the cell, but no division was found
bool PolyhedronCells::Divide(const Surface& surface, ConeDivision& division)
{
  const bool areFinite = std::all_of(surface.Places.begin(), surface.Places.end(),
    [](const glm::dvec3& place) { return std::isfinite(place.x + place.y + place.z); });
  std::vector<glm::dvec3> scaled;
  if (!areFinite || !ScaleToUnit(surface.Places, scaled))
  {
    return true; // an error, or flat
  }
  std::vector<SurfacePart> parts = surface.Parts;
  const bool isClosed = TurnOutwards(scaled, parts);
  const auto isSeen = [&](double share)
  { return isClosed && IsSeenFromMean(scaled, surface.Corners.size(), parts, share); };
  if (isSeen(SeenWell))
  {
    return true;
  }
  ++this->Searches;
  return (isClosed && DivideIntoCones(scaled, parts, this->Work, division)) || isSeen(0.0);
}

void PolyhedronCells::AddCone(const SurfacePart& base, std::int32_t apex,
  const std::vector<std::int32_t>& numbers, vtkIdType cell)
{
  const auto idOf = [&](std::size_t corner)
  { return numbers[static_cast<std::size_t>(base.At(corner))]; };
  if (base.Size == 3)
  {
    this->Made.AddCell(MeshCellType::Tetrahedron,
      std::array<std::int32_t, 4>{ idOf(0), idOf(1), idOf(2), apex }, cell);
  }
  else
  {
    this->Made.AddCell(MeshCellType::Pyramid,
      std::array<std::int32_t, 5>{ idOf(0), idOf(1), idOf(2), idOf(3), apex }, cell);
  }
}

/// The numbers of a surface's points among all made points.
std::vector<std::int32_t> PolyhedronCells::NumbersOf(const Surface& surface)
{
  std::vector<std::int32_t> numbers(surface.Points.size(), -1);
  for (std::size_t f = 0; f < surface.Faces.size(); ++f)
  {
    for (const vtkIdType point : surface.Faces[f])
    {
      std::int32_t& number = numbers[surface.NumberOf(point)];
      number = number >= 0 ? number : this->NumberOf(point);
    }
    if (surface.Middles[f] >= 0)
    {
      const auto middle = static_cast<std::size_t>(surface.Middles[f]);
      numbers[middle] = this->MiddleOf(surface.Faces[f], surface.Points[middle]);
    }
  }
  return numbers;
}

/// Add wedges around the axis.
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
  std::vector<Face> ends(2);
  for (vtkIdType p = 0; p < 2 * corners; ++p)
  {
    ends[p < corners ? 0 : 1].push_back(this->Ids->GetId(p));
  }
  std::vector<Face> faces = ends;
  for (std::size_t p = 0; p < ends[0].size(); ++p)
  {
    const std::size_t next = (p + 1) % ends[0].size();
    faces.push_back({ ends[0][p], ends[0][next], ends[1][next], ends[1][p] });
  }
  if (this->HasConcaveFace(faces))
  {
    this->AddCones(this->SurfaceOf(std::move(faces)), cell);
    return true;
  }
  std::array<std::int32_t, 2> middles;
  for (std::size_t end = 0; end < 2; ++end)
  {
    middles[end] = this->MiddleOf(ends[end], MeanOf(this->Read(ends[end])));
  }
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

/// Add the Delaunay tetrahedra. Among points on one sphere, lower numbers decide, so that
/// neighbours split a face alike. (vtkConvexPointSet depends on the order of points in the cell and
/// stretches each cell to a cube, so its neighbours disagree.)
void PolyhedronCells::AddConvexSet(vtkIdType cell)
{
  vtkNew<vtkIdList> points;
  this->Grid->GetCells()->GetCellAtId(cell, points);
  Face unique(points->begin(), points->end());
  std::sort(unique.begin(), unique.end());
  unique.erase(std::unique(unique.begin(), unique.end()), unique.end());
  std::vector<glm::dvec3> places;
  bool haveValues = true;
  const auto isNowhere = [&](vtkIdType point)
  {
    const PointValue read = this->Reader.Read(point);
    const glm::dvec3 at = PlaceOf(read);
    const bool isFinite = std::isfinite(at.x + at.y + at.z);
    if (isFinite)
    {
      places.push_back(at);
      haveValues &= HasValue(read);
    }
    return !isFinite;
  };
  // The remaining points are a convex set, too.
  unique.erase(std::remove_if(unique.begin(), unique.end(), isNowhere), unique.end());
  std::vector<glm::dvec3> scaled;
  if (unique.size() < 4 || !haveValues || !ScaleToUnit(places, scaled))
  {
    return;
  }
  // Tetrahedra outside of a large octahedron around these bounds are lost: thin ones at the hull.
  this->Triangulator->InitTriangulation(
    -5.0, 6.0, -5.0, 6.0, -5.0, 6.0, static_cast<int>(unique.size()));
  for (std::size_t p = 0; p < unique.size(); ++p)
  {
    this->Triangulator->InsertPoint(static_cast<vtkIdType>(p), &places[p].x, &scaled[p].x, 0);
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

std::int32_t PolyhedronCells::MiddleOf(const Face& face, const PointValue& middle)
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
    this->Made.AddPoint(middle);
  }
  return number;
}

std::vector<PointValue> PolyhedronCells::Read(const Face& points) const
{
  std::vector<PointValue> read(points.size());
  std::transform(points.begin(), points.end(), read.begin(),
    [this](vtkIdType point) { return this->Reader.Read(point); });
  return read;
}

}
