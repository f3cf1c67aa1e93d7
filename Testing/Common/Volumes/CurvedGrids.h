// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_CurvedGrids_h
#define Testing_CurvedGrids_h

#include <vtkCellType.h>
#include <vtkDoubleArray.h>
#include <vtkGenericCell.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkUnstructuredGrid.h>

#include <glm/glm.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <random>
#include <vector>

/// Where the points of a cell with curved edges lie if these are straight, and maps that place such
/// cells so that they fill a cube.
struct CellPattern
{
  std::vector<glm::dvec3> Points;
  std::vector<std::function<glm::dvec3(const glm::dvec3&)>> Placements;
};

/// By the parameters that VTK gives the points of a cell.
inline std::vector<glm::dvec3> ParametersOf(int type)
{
  vtkNew<vtkGenericCell> cell;
  cell->SetCellType(type);
  const double* parameters = cell->GetParametricCoords();
  std::vector<glm::dvec3> points;
  for (vtkIdType p = 0; p < cell->GetNumberOfPoints(); ++p)
  {
    points.emplace_back(parameters[3 * p], parameters[3 * p + 1], parameters[3 * p + 2]);
  }
  return points;
}

inline CellPattern HexahedronPattern(int type)
{
  return { ParametersOf(type), { [](const glm::dvec3& at) { return at; } } };
}

inline CellPattern WedgePattern(int type)
{
  return { ParametersOf(type),
    { [](const glm::dvec3& at) { return at; },
      [](const glm::dvec3& at) { return glm::dvec3(1.0 - at.x, 1.0 - at.y, at.z); } } };
}

/// A pyramid over each face, with its apex in the middle of the cube.
inline CellPattern PyramidPattern(bool hasMiddles)
{
  CellPattern pattern;
  const glm::dvec3 a(0.0), b(1.0, 0.0, 0.0), c(1.0, 1.0, 0.0), d(0.0, 1.0, 0.0), e(0.5, 0.5, 1.0);
  pattern.Points = { a, b, c, d, e, 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + d), 0.5 * (d + a),
    0.5 * (a + e), 0.5 * (b + e), 0.5 * (c + e), 0.5 * (d + e) };
  if (hasMiddles)
  {
    pattern.Points.insert(pattern.Points.end(),
      { 0.25 * (a + b + c + d), (a + b + e) / 3.0, (b + c + e) / 3.0, (c + d + e) / 3.0,
        (d + a + e) / 3.0, 0.1875 * (a + b + c + d) + 0.25 * e });
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const bool isUpper : { false, true })
    {
      pattern.Placements.push_back(
        [axis, isUpper](const glm::dvec3& at)
        {
          const double height = 0.5 * at.z;
          glm::dvec3 placed;
          placed[axis] = isUpper ? 1.0 - height : height;
          placed[(axis + 1) % 3] = isUpper ? at.y : at.x;
          placed[(axis + 2) % 3] = isUpper ? at.x : at.y;
          return placed;
        });
    }
  }
  return pattern;
}

/// Cubes of such cells; cells share points.
inline vtkSmartPointer<vtkUnstructuredGrid> TileCubes(int type, const CellPattern& pattern, int n)
{
  const auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::map<std::array<long, 3>, vtkIdType> known;
  for (int cube = 0; cube < n * n * n; ++cube)
  {
    for (const auto& placement : pattern.Placements)
    {
      std::vector<vtkIdType> ids;
      for (const glm::dvec3& point : pattern.Points)
      {
        const glm::dvec3 at =
          (placement(point) + glm::dvec3(cube % n, cube / n % n, cube / n / n)) / double(n);
        const std::array<long, 3> key{ std::lround(at.x * 1e6), std::lround(at.y * 1e6),
          std::lround(at.z * 1e6) };
        const auto found = known.emplace(key, points->GetNumberOfPoints());
        if (found.second)
        {
          points->InsertNextPoint(at.x, at.y, at.z);
        }
        ids.push_back(found.first->second);
      }
      grid->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data());
    }
  }
  grid->SetPoints(points);
  return grid;
}

/// A random number from -1 to 1, the same for points at one place: VTK's source does not merge all.
inline double NoiseAt(const glm::dvec3& at)
{
  std::seed_seq seed{ std::lround(at.x * 1e4), std::lround(at.y * 1e4), std::lround(at.z * 1e4) };
  std::mt19937 engine(seed);
  return std::uniform_real_distribution<double>(-1.0, 1.0)(engine);
}

/// Bend a grid in the cube from 0 to size, whose surface stays where it is, and give its points
/// values: a smooth function, and noise.
inline void Bend(vtkUnstructuredGrid* grid, double size, double bend, double noise)
{
  constexpr double pi = 3.14159265358979323846;
  vtkNew<vtkPoints> bent;
  bent->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> values;
  values->SetName("values");
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    glm::dvec3 at;
    grid->GetPoint(p, &at.x);
    const glm::dvec3 unit = at / size;
    const double wave =
      bend * size * std::sin(pi * unit.x) * std::sin(pi * unit.y) * std::sin(pi * unit.z);
    bent->InsertNextPoint(at.x + wave, at.y - 0.7 * wave, at.z + 0.5 * wave * (unit.x - unit.y));
    values->InsertNextValue(
      3.0 * unit.x - unit.y + 2.0 * unit.x * unit.z * bend + noise * NoiseAt(unit));
  }
  grid->SetPoints(bent);
  grid->GetPointData()->SetScalars(values);
}

/// Give points the values of a function of their places.
template <typename Function>
void GiveValues(const Function& function, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkDoubleArray> values;
  for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
  {
    glm::dvec3 at;
    grid->GetPoint(p, &at.x);
    values->InsertNextValue(function(at));
  }
  grid->GetPointData()->SetScalars(values);
}

#endif
