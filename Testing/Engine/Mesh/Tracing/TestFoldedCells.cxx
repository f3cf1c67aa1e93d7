// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// In folded hexahedra, where a point may have several places, normals of surfaces are those where
// the field has the isovalue, and normals of caps those of the face that is hit.

#include "Grid.h"
#include "Kinds/MeshKind.h"
#include "Mesh/Cells/CellPoints.h"
#include "Mesh/Cells/HexahedronRoots.h"
#include "Mesh/Tree/MeshTree.h"
#include "Render/FrameRenderer.h"
#include "Scene/Field.h"
#include "Volumes/Meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <random>

namespace
{

using namespace TemporalCoherence;

constexpr double Isovalue = 0.3;
constexpr int Size = 120;

/// Cubes of length 2 whose corners, those at the boundary, too, are moved at random.
std::shared_ptr<const MeshTree> MovedCubes(double by, unsigned int seed)
{
  constexpr int cubes = 5;
  Meshes::Block block;
  block.Cubes = glm::ivec3(cubes);
  block.Jitter = 0.0;
  Meshes::DoubleArrays arrays = Meshes::MakeBlock(Meshes::Cells::Hexahedra, block);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> move(-by, by);
  for (double& coordinate : arrays.Points)
  {
    coordinate = 2.0 * (cubes * coordinate + move(random));
  }
  MeshProblem problem;
  return MeshTree::Build(Meshes::MeshOf(arrays), {}, ~std::size_t(0), problem);
}

/// A cell from a ray: x and y across it, z along it.
struct SeenCell
{
  MeshCell Cell; ///< in index space
  Ray From;
  glm::dvec3 Across, Upwards;

  SeenCell(const MeshTree& tree, CellNumber number, const Ray& ray)
    : From(ray)
    , Across(glm::normalize(glm::cross(ray.Direction, glm::dvec3(0.3, 0.5, 0.9))))
    , Upwards(glm::cross(ray.Direction, this->Across))
  {
    tree.Reader().Read(number, this->Cell);
    for (glm::dvec3& point : this->Cell.Points)
    {
      point = tree.ToIndex(point);
    }
  }

  glm::dvec3 See(const glm::dvec3& point) const
  {
    const glm::dvec3 from = point - this->From.Origin;
    return { glm::dot(from, this->Across), glm::dot(from, this->Upwards),
      glm::dot(from, this->From.Direction) };
  }
};

/// Calls a function with the places of the ray in the cell where a function of the corners is 0,
/// and with the distances of these places.
template <typename Zero, typename Visit>
void ForEachPlace(const SeenCell& seen, const Zero& zero, const Visit& visit)
{
  MeshKernels::SeenHexahedron corners;
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3 at = seen.See(seen.Cell.Points[corner]);
    corners.X[corner] = at.x;
    corners.Y[corner] = at.y;
    corners.T[corner] = at.z;
    corners.Difference[corner] = zero(corner);
  }
  MeshKernels::HexahedronRoots roots;
  MeshKernels::FindRoots(corners, roots);
  for (std::size_t root = 0; root < roots.Count; ++root)
  {
    const std::array<double, 3>& at = roots.Roots[root].At;
    visit(0.5 + 0.5 * glm::dvec3(at[0], at[1], at[2]), roots.Roots[root].T);
  }
}

/// The normal of the nearest surface to a distance.
/// \param isFound false: there is none
glm::dvec3 NormalAt(const SeenCell& seen, double distance, bool isCap, bool& isFound)
{
  double nearest = 1e-6;
  glm::dvec3 normal(0.0);
  const auto consider = [&](double t, const std::function<glm::dvec3()>& normalOf)
  {
    if (std::abs(t - distance) < nearest)
    {
      nearest = std::abs(t - distance);
      normal = normalOf();
    }
  };
  if (!isCap)
  {
    ForEachPlace(
      seen, [&](std::size_t corner) { return seen.Cell.Values[corner] - Isovalue; },
      [&](const glm::dvec3& at, double t)
      { consider(t, [&] { return MeshKernels::GradientAt(seen.Cell, at); }); });
  }
  for (int face = 0; isCap && face < 6; ++face)
  {
    const int axis = face / 2;
    const double side = face % 2;
    ForEachPlace(
      seen,
      [&](std::size_t corner)
      { return static_cast<double>(corner >> static_cast<unsigned int>(axis) & 1u) - side; },
      [&](const glm::dvec3& at, double t)
      {
        const glm::dmat3 along = MeshKernels::JacobianAt(seen.Cell, at);
        consider(t, [&] { return glm::cross(along[(axis + 1) % 3], along[(axis + 2) % 3]); });
      });
  }
  isFound = normal != glm::dvec3(0.0);
  normal = isFound ? glm::normalize(normal) : normal;
  return glm::dot(normal, seen.From.Direction) > 0.0 ? -normal : normal;
}

class FoldedCells : public ::testing::TestWithParam<double>
{
};

TEST_P(FoldedCells, HaveTheNormalsOfWhatIsHit)
{
  for (const bool isCap : { false, true })
  {
    int hits = 0, wrong = 0, unknown = 0;
    for (unsigned int seed = 1; seed < 6; ++seed)
    {
      const std::shared_ptr<const MeshTree> tree = MovedCubes(this->GetParam(), seed);
      FrameKey key;
      key.Samples = MeshField(*tree, MeshKind(tree, false));
      key.Appearance.Colors.assign(1, { 1.0, 0.5, 0.2 });
      const glm::ivec3 box(2.0 * tree->ToIndex(glm::dvec3(5.0)));
      key.View = LookAt(box + 1, { 1.0, 2.0, 0.7 }, { Size, Size }, false);
      key.EditIsosurfaces().Isovalues = { isCap ? -4.0 : Isovalue };
      key.EditIsosurfaces().Mode = isCap ? SurfaceMode::Threshold : SurfaceMode::Crossing;
      FrameRenderer renderer;
      renderer.Render(key, {});
      const Frame& frame = renderer.LastFrame();
      for (std::size_t pixel = 0; pixel < frame.Kinds.size(); ++pixel)
      {
        if (frame.Cells[pixel] == NoCell)
        {
          continue;
        }
        const auto x = static_cast<int>(pixel % Size), y = static_cast<int>(pixel / Size);
        const SeenCell seen(*tree, frame.Cells[pixel], key.View.RayThrough(x, y));
        bool isFound = false;
        const glm::dvec3 normal = NormalAt(seen, frame.Depth[pixel], isCap, isFound);
        ++hits;
        unknown += !isFound;
        // Beside folds, normals turn fast.
        constexpr double near = 0.02;
        wrong += isFound && !(glm::distance(normal, glm::dvec3(frame.Normals[pixel])) < near);
      }
    }
    const char* const what = isCap ? "caps" : "surfaces";
    EXPECT_GT(hits, 3000) << what;
    EXPECT_LT(unknown, hits / 100) << what;
    EXPECT_EQ(wrong, 0) << what;
  }
}

INSTANTIATE_TEST_SUITE_P(Moves, FoldedCells, ::testing::Values(0.1, 0.3, 0.5, 0.8));

}
