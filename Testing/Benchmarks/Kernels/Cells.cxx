// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Rays of a tile and cells of a mesh. Each cell is about as large as the tile.

#include "KernelBenchmarks.h"
#include "Mesh/Cells/KernelsCells.h"

#include <memory>
#include <random>
#include <vector>

namespace
{

using namespace TemporalCoherence;
using namespace TemporalCoherence::MeshKernels;

/// A cell, and a tile of rays that goes through it.
struct CellTile
{
  MeshCell Cell;
  std::shared_ptr<MeshRays> Rays;
};

constexpr std::size_t NumberOfTiles = 64;

/// \param warp how far points are moved, by half of an edge
std::vector<CellTile> MakeTiles(MeshCellShape shape, double warp)
{
  std::mt19937 engine(3);
  std::uniform_real_distribution<double> around(-1.0, 1.0);
  const auto vector = [&] { return glm::dvec3(around(engine), around(engine), around(engine)); };
  std::vector<CellTile> tiles(NumberOfTiles);
  for (CellTile& tile : tiles)
  {
    tile.Cell.Shape = shape;
    const glm::dvec3 gradient = vector();
    for (std::size_t c = 0; c < 8; ++c)
    {
      const glm::dvec3 unit(c & 1 ? 1.0 : -1.0, c & 2 ? 1.0 : -1.0, c & 4 ? 1.0 : -1.0);
      tile.Cell.Points[c] = unit + warp * vector();
      tile.Cell.Values[c] = glm::dot(gradient, tile.Cell.Points[c]) + 0.1 * around(engine);
    }
    if (shape == MeshCellShape::Tetrahedron)
    {
      std::swap(tile.Cell.Points[3], tile.Cell.Points[4]);
      std::swap(tile.Cell.Values[3], tile.Cell.Values[4]);
    }
    tile.Rays = std::make_shared<MeshRays>();
    MeshRays& rays = *tile.Rays;
    rays.Count = MeshRays::Capacity;
    const glm::dvec3 eye = 20.0 * glm::normalize(vector());
    const glm::dvec3 across = glm::normalize(glm::cross(eye, vector()));
    const glm::dvec3 up = glm::normalize(glm::cross(eye, across));
    for (std::size_t ray = 0; ray < rays.Count; ++ray)
    {
      const double x = static_cast<double>(ray % 8) / 3.5 - 1.0;
      const double y = static_cast<double>(ray / 8) / 3.5 - 1.0;
      const glm::dvec3 direction = glm::normalize(x * across + y * up - eye);
      for (int a = 0; a < 3; ++a)
      {
        rays.Origin[static_cast<std::size_t>(a)][ray] = eye[a];
        rays.Direction[static_cast<std::size_t>(a)][ray] = direction[a];
      }
      rays.Begin[ray] = 0.0;
      rays.End[ray] = 100.0;
    }
    rays.Prepare();
  }
  return tiles;
}

using FindCrossings = void (*)(
  const MeshCell&, const CellDifferences&, const MeshRays&, std::uint64_t, Crossings&);
using FindSpans = void (*)(
  const MeshCell&, const CellDifferences&, const MeshRays&, std::uint64_t, CellSpans&);

void RegisterFor(const std::string& name, MeshCellShape shape, double warp,
  FindCrossings findCrossings, FindSpans findSpans)
{
  KernelBenchmarks::ForEachTarget("CellCrossings/" + name,
    [=](benchmark::State& state)
    {
      const auto tiles = MakeTiles(shape, warp);
      const auto found = std::make_unique<Crossings>();
      KernelBenchmarks::RunOnTiles(state, tiles,
        [&](const CellTile& tile)
        {
          found->Count = 0;
          findCrossings(tile.Cell, tile.Cell.Values, *tile.Rays, ~std::uint64_t(0), *found);
        });
    });
  KernelBenchmarks::ForEachTarget("CellSpans/" + name,
    [=](benchmark::State& state)
    {
      const auto tiles = MakeTiles(shape, warp);
      const auto spans = std::make_unique<CellSpans>();
      KernelBenchmarks::RunOnTiles(state, tiles,
        [&](const CellTile& tile)
        { findSpans(tile.Cell, tile.Cell.Values, *tile.Rays, ~std::uint64_t(0), *spans); });
    });
}

}

void KernelBenchmarks::RegisterCells()
{
  RegisterFor(
    "tetrahedra", MeshCellShape::Tetrahedron, 0.2, TetrahedronCrossings, TetrahedronSpans);
  RegisterFor("boxes", MeshCellShape::Hexahedron, 0.0, HexahedronCrossings, HexahedronSpans);
  RegisterFor("hexahedra", MeshCellShape::Hexahedron, 0.2, HexahedronCrossings, HexahedronSpans);
}
