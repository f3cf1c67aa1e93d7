// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/AmrGrids.h"
#include "Volumes/VtkMeshes.h"
#include "World/Arrays.h"
#include "World/Inputs.h"

#include <vtkCellData.h>
#include <vtkCellTypeSource.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPointSet.h>

#include <cmath>
#include <random>

namespace Fuzz
{
namespace Inputs
{
namespace
{

/// The points and cells of a mesh before they are moved and divided.
vtkSmartPointer<vtkImageData> MakeLattice(World& world)
{
  Bytes& from = world.From;
  const auto image = vtkSmartPointer<vtkImageData>::New();
  int points[3];
  for (int& length : points)
  {
    length = 3 + from.Pick(4) - (from.OneIn(12) ? 1 : 0) + (world.IsLarge ? 2 : 0);
  }
  image->SetDimensions(points);
  Story::Tell("  a mesh of ", points[0], " x ", points[1], " x ", points[2], " points");
  return image;
}

/// Points are moved out of their rows; where they move far, cells overlap.
void Move(World& world, vtkPointSet* grid)
{
  Bytes& from = world.From;
  const double distances[] = { 0.0, 0.1, 0.25, 0.0, 0.5, 1.0 };
  const double distance = from.OneOf(distances);
  std::mt19937 engine(static_cast<unsigned>(from.Pick(1 << 16)));
  const auto random = [&] { return static_cast<double>(engine()) / 2147483648.0 - 1.0; };
  const bool isMerged = from.OneIn(8), isFloat = from.OneIn(2);
  vtkNew<vtkPoints> points;
  points->SetDataType(isFloat ? VTK_FLOAT : VTK_DOUBLE);
  points->SetNumberOfPoints(grid->GetNumberOfPoints());
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    double at[3];
    // Some points lie at the place of another one: cells lose edges and faces.
    grid->GetPoint(isMerged && i > 0 && engine() % 8 == 0 ? i - 1 : i, at);
    for (double& coordinate : at)
    {
      coordinate += distance * random();
    }
    points->SetPoint(i, at);
  }
  if (from.IsWild() && points->GetNumberOfPoints() > 0)
  {
    const vtkIdType which = from.Pick(static_cast<int>(points->GetNumberOfPoints()));
    const double value = from.Wild();
    points->SetPoint(which, isFloat ? std::nan("") : value, 1.0, 2.0);
    Story::Tell("  point ", which, " is at ", value);
    world.IsTame = false;
  }
  grid->SetPoints(points);
  Story::Tell("  points moved by ", distance, isFloat ? ", floats" : "",
    isMerged ? ", some of them merged" : "");
}

/// Values of points or cells, and ghosts.
void GiveValues(World& world, vtkDataSet* grid)
{
  Bytes& from = world.From;
  const bool onCells = from.OneIn(6);
  const auto array = Arrays::Make(world, Arrays::PlacesOf(grid, onCells));
  Arrays::Survey(world, array);
  (onCells ? static_cast<vtkDataSetAttributes*>(grid->GetCellData()) : grid->GetPointData())
    ->SetScalars(array);
  if (from.OneIn(10))
  {
    Arrays::AddGhosts(world, grid->GetPointData(), grid->GetNumberOfPoints());
  }
  if (from.OneIn(8))
  {
    Arrays::AddGhosts(world, grid->GetCellData(), grid->GetNumberOfCells());
  }
}

/// Each hexahedron as a polyhedron with six faces.
vtkSmartPointer<vtkUnstructuredGrid> PolyhedraOf(vtkImageData* image)
{
  const int faces[6][4] = { { 0, 3, 2, 1 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 },
    { 2, 3, 7, 6 }, { 3, 0, 4, 7 } };
  const auto hexahedra = VtkMeshes::Unstructured(image, VTK_HEXAHEDRON);
  const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(hexahedra->GetPoints());
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < hexahedra->GetNumberOfCells(); ++c)
  {
    hexahedra->GetCellPoints(c, ids);
    std::vector<vtkIdType> stream;
    for (const auto& face : faces)
    {
      stream.push_back(4);
      for (const int corner : face)
      {
        stream.push_back(ids->GetId(corner));
      }
    }
    grid->InsertNextCell(VTK_POLYHEDRON, 8, ids->GetPointer(0), 6, stream.data());
  }
  return grid;
}

/// Cells of several types beside each other, whose faces do not always match.
vtkSmartPointer<vtkUnstructuredGrid> MixtureOf(World& world, vtkImageData* image)
{
  const int types[] = { VTK_HEXAHEDRON, VTK_WEDGE, VTK_TETRA, VTK_VOXEL };
  std::mt19937 engine(static_cast<unsigned>(world.From.Pick(1 << 16)));
  const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(VtkMeshes::PointsOf(image));
  vtkNew<vtkIdList> ids;
  for (const int type : types)
  {
    const auto all = VtkMeshes::Unstructured(image, type);
    const vtkIdType parts =
      all->GetNumberOfCells() / std::max<vtkIdType>(1, image->GetNumberOfCells());
    std::mt19937 chosen(engine());
    for (vtkIdType c = 0; c < all->GetNumberOfCells(); ++c)
    {
      // The cells of a cube have its type, most of the time.
      const auto cube = static_cast<unsigned>(c / std::max<vtkIdType>(1, parts));
      const bool isChosen = types[(cube * 2654435761U >> 16) % 4] == type;
      if (isChosen != (chosen() % 16 == 0))
      {
        all->GetCellPoints(c, ids);
        grid->InsertNextCell(type, ids);
      }
    }
  }
  return grid;
}

/// Cells that the engine does not know as they are.
vtkSmartPointer<vtkUnstructuredGrid> MakeOddCells(World& world, bool areCurved)
{
  const int curved[] = { VTK_QUADRATIC_TETRA, VTK_QUADRATIC_HEXAHEDRON, VTK_QUADRATIC_WEDGE,
    VTK_QUADRATIC_PYRAMID, VTK_LAGRANGE_HEXAHEDRON, VTK_LAGRANGE_TETRAHEDRON, VTK_LAGRANGE_WEDGE,
    VTK_BEZIER_HEXAHEDRON, VTK_BEZIER_TETRAHEDRON };
  const int prisms[] = { VTK_PENTAGONAL_PRISM, VTK_HEXAGONAL_PRISM };
  const int type = areCurved ? world.From.OneOf(curved) : world.From.OneOf(prisms);
  vtkNew<vtkCellTypeSource> source;
  source->SetCellType(type);
  source->SetCellOrder(2);
  source->SetBlocksDimensions(1 + world.From.Pick(2), 1 + world.From.Pick(2), 1);
  source->Update();
  const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(source->GetOutput()->GetPoints());
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < source->GetOutput()->GetNumberOfCells(); ++c)
  {
    source->GetOutput()->GetCellPoints(c, ids);
    grid->InsertNextCell(source->GetOutput()->GetCellType(c), ids);
  }
  Story::Tell("  cells of type ", type, ": ", grid->GetNumberOfCells());
  return grid;
}

/// The points of each cube as a convex set.
vtkSmartPointer<vtkUnstructuredGrid> ConvexSetsOf(vtkImageData* image)
{
  const auto hexahedra = VtkMeshes::Unstructured(image, VTK_HEXAHEDRON);
  const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(hexahedra->GetPoints());
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < hexahedra->GetNumberOfCells(); ++c)
  {
    hexahedra->GetCellPoints(c, ids);
    grid->InsertNextCell(VTK_CONVEX_POINT_SET, ids);
  }
  return grid;
}

vtkSmartPointer<vtkPointSet> MakeCells(World& world)
{
  Bytes& from = world.From;
  const int kind = from.Pick(14);
  Story::Tell("  cells of kind ", kind);
  if (kind >= 12)
  {
    return MakeOddCells(world, true);
  }
  if (kind == 11)
  {
    return MakeOddCells(world, false);
  }
  const auto image = MakeLattice(world);
  switch (kind)
  {
    case 0:
    case 1:
      return VtkMeshes::Unstructured(image, VTK_HEXAHEDRON);
    case 2:
    case 3:
      return VtkMeshes::Unstructured(image, VTK_TETRA);
    case 4:
      return VtkMeshes::Unstructured(image, VTK_VOXEL);
    case 5:
      return VtkMeshes::Unstructured(image, VTK_WEDGE);
    case 6:
      return VtkMeshes::Unstructured(image, VTK_PYRAMID);
    case 7:
      return MixtureOf(world, image);
    case 8:
      return from.OneIn(4) ? ConvexSetsOf(image) : PolyhedraOf(image);
    case 9:
      return VtkMeshes::Explicit(image);
    default:
      return VtkMeshes::Curvilinear(image);
  }
}

/// Some cells are there twice, or away.
void Repeat(World& world, vtkUnstructuredGrid* grid)
{
  std::mt19937 engine(static_cast<unsigned>(world.From.Pick(1 << 16)));
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = grid->GetNumberOfCells() - 1; c >= 0; --c)
  {
    if (engine() % 6 == 0 && grid->GetCellType(c) != VTK_POLYHEDRON)
    {
      grid->GetCellPoints(c, ids);
      grid->InsertNextCell(grid->GetCellType(c), ids);
    }
  }
  Story::Tell("  with cells that are there twice");
}

vtkSmartPointer<vtkPointSet> MakePointSet(World& world)
{
  const auto grid = MakeCells(world);
  Move(world, grid);
  auto* cells = vtkUnstructuredGrid::SafeDownCast(grid);
  if (cells && world.From.OneIn(12))
  {
    Repeat(world, cells);
  }
  GiveValues(world, grid);
  return grid;
}

/// Several levels, or one.
vtkSmartPointer<vtkDataObject> MakeLevels(World& world)
{
  Bytes& from = world.From;
  AmrTestLevels levels = RandomAmr(static_cast<unsigned>(from.Pick(1 << 16)));
  const double scale = from.Between(5.0, 30.0), phase = from.Between(0.0, 6.0);
  const bool isBall = from.OneIn(2);
  vtkNew<vtkDoubleArray> values;
  const auto amr = MakeAmr(levels,
    [&](const glm::dvec3& at)
    {
      const glm::dvec3 from0 = at - levels.Origin;
      const double value = isBall
        ? scale * glm::length(from0 - glm::dvec3(2.5, 2.0, 5.0))
        : scale * (std::sin(from0.x + phase) + std::cos(0.7 * from0.y) * from0.z);
      values->InsertNextValue(value);
      return value;
    });
  Arrays::Survey(world, values);
  Story::Tell("  an adaptive grid of ", levels.Boxes.size(), " levels");
  return amr;
}

/// The same values in different cells, beside each other.
vtkSmartPointer<vtkDataObject> MakeMeshBlocks(World& world)
{
  Bytes& from = world.From;
  const auto image = MakeLattice(world);
  GiveValues(world, image);
  const auto all = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  const int types[] = { VTK_HEXAHEDRON, VTK_TETRA, VTK_WEDGE, VTK_VOXEL };
  const int count = 1 + from.Pick(3);
  for (int i = 0; i < count; ++i)
  {
    const vtkSmartPointer<vtkPointSet> block = from.OneIn(4)
      ? vtkSmartPointer<vtkPointSet>(VtkMeshes::Curvilinear(image))
      : vtkSmartPointer<vtkPointSet>(VtkMeshes::Unstructured(image, from.OneOf(types)));
    const double shift = i * (image->GetDimensions()[0] - 1.0 + (from.OneIn(4) ? 0.5 : 0.0));
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (vtkIdType p = 0; p < block->GetNumberOfPoints(); ++p)
    {
      const double* at = block->GetPoint(p);
      points->InsertNextPoint(at[0] + shift, at[1], at[2]);
    }
    block->SetPoints(points);
    all->SetBlock(static_cast<unsigned>(i), block);
  }
  Story::Tell("  in ", count, " blocks");
  return all;
}

}

vtkSmartPointer<vtkDataObject> MakeMesh(World& world)
{
  const int kind = world.From.Pick(16);
  if (kind == 15)
  {
    return MakeAny(world);
  }
  return kind == 14 ? MakeMeshBlocks(world)
    : kind == 13    ? MakeLevels(world)
                    : vtkSmartPointer<vtkDataObject>(MakePointSet(world));
}

}
}
