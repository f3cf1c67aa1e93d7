// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Linear cells made of concave polyhedra fill the polyhedron once and do not leave it. Neighbours
// share all points of their faces, however these are given. Cells that cannot be divided so are
// reported.

#include "Checks/EventCounter.h"
#include "Checks/Expect.h"
#include "LinearCells.h"
#include "PolyhedronGrid.h"
#include "Scenes/Scene.h"
#include "Shapes/SubdividedCells.h"
#include "Truth/SameSurface.h"

#include <vtkCommand.h>

#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>

namespace
{

using namespace TemporalCoherence;
using Polygon = std::vector<glm::dvec2>;

const Polygon UShape = { { 0, 0 }, { 3, 0 }, { 3, 3 }, { 2, 3 }, { 2, 1 }, { 1, 1 }, { 1, 3 },
  { 0, 3 } };
const Polygon LShape = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } };
const Polygon Dart = { { 0, 0 }, { 3, 1 }, { 0, 2 }, { 1, 1 } };
const Polygon Zigzag = { { 0, 0 }, { 1, 2 }, { 2, 0 }, { 3, 2 }, { 4, 0 }, { 4, 0.3 }, { 3, 2.6 },
  { 2, 0.8 }, { 1, 2.6 }, { 0, 0.3 } };

double Linear(const glm::dvec3& at)
{
  return 2.0 * at.x - 3.0 * at.y + 0.5 * at.z + 1.0;
}

MeshPart PartOf(PolyhedronGrid& grid, const std::string& what, std::int64_t overlapping = 0)
{
  grid.Give(Linear);
  std::vector<MeshPart> parts;
  std::string error;
  Subdivision told;
  Expect(AppendSubdividedCells(grid.Made.Get(), grid.Made->GetPointData()->GetScalars(), 0, nullptr,
           0, parts, error, &told) &&
      parts.size() == 1,
    what + ": cells are made " + error);
  Expect(told.Error.Overlapping == overlapping,
    what + ": " + std::to_string(told.Error.Overlapping) + " cells overlap others");
  Expect(told.Error.Overlaps == (overlapping > 0 ? "Cell 0 of the input" : ""),
    what + ": " + told.Error.Overlaps + " is told");
  return parts.empty() ? MeshPart() : parts.front();
}

/// The faces of a linear cell, turned outwards.
CellFaces FacesOfPart(const MeshPart& part, std::int64_t cell)
{
  std::vector<glm::dvec3> points;
  for (std::int64_t p = part.Offsets.IdAt(cell); p < part.Offsets.IdAt(cell + 1); ++p)
  {
    const std::int64_t id = part.Connectivity.IdAt(p);
    points.emplace_back(
      part.Coordinates[0].At(id), part.Coordinates[1].At(id), part.Coordinates[2].At(id));
  }
  const glm::dvec3 apex = points.back();
  points.pop_back();
  const glm::dvec3 normal = points.size() == 3
    ? glm::cross(points[1] - points[0], points[2] - points[0])
    : glm::cross(points[2] - points[0], points[3] - points[1]);
  if (glm::dot(normal, apex - points[0]) > 0.0)
  {
    std::reverse(points.begin(), points.end());
  }
  CellFaces faces = { points };
  for (std::size_t p = 0; p < points.size(); ++p)
  {
    faces.push_back({ points[(p + 1) % points.size()], points[p], apex });
  }
  return faces;
}

/// As many parts lie around random places as the cell does.
void ExpectFilledOnce(const MeshPart& part, const CellFaces& faces, const std::string& what)
{
  std::vector<CellFaces> parts;
  double volume = 0.0;
  for (std::int64_t c = 0; c < part.NumberOfCells; ++c)
  {
    parts.push_back(FacesOfPart(part, c));
    volume += VolumeIn(parts.back());
  }
  const double expected = VolumeIn(faces);
  Expect(std::abs(volume - expected) < 1e-12 * std::abs(expected),
    what + ": volume " + std::to_string(volume) + ", not " + std::to_string(expected));
  glm::dvec3 least(1e300), most(-1e300);
  for (const auto& face : faces)
  {
    for (const glm::dvec3& point : face)
    {
      least = glm::min(least, point);
      most = glm::max(most, point);
    }
  }
  std::mt19937 random(1);
  std::uniform_real_distribution<double> share(-0.05, 1.05);
  int inside = 0, wrong = 0;
  for (int k = 0; k < 1000; ++k)
  {
    const glm::dvec3 at =
      least + (most - least) * glm::dvec3(share(random), share(random), share(random));
    double winding = 0.0;
    for (const CellFaces& one : parts)
    {
      winding += WindingAround(one, at);
    }
    const double truth = WindingAround(faces, at);
    inside += truth > 0.5;
    wrong += std::abs(winding - truth) > 1e-6;
  }
  Expect(inside > 20 && wrong == 0, what + ": " + std::to_string(wrong) + " places are wrong");
}

/// A triangle and the same one turned above it, whose sides bend inwards: no tetrahedra between its
/// points fill it.
CellFaces Twisted(double turn)
{
  std::vector<glm::dvec3> low, high;
  for (int corner = 0; corner < 3; ++corner)
  {
    const double angle = 2.0 * 3.14159265358979323846 * corner / 3.0;
    low.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    high.emplace_back(std::cos(angle + turn), std::sin(angle + turn), 1.0);
  }
  CellFaces faces = { { low[2], low[1], low[0] }, high };
  for (std::size_t p = 0; p < 3; ++p)
  {
    const std::size_t next = (p + 1) % 3;
    faces.push_back({ low[p], low[next], high[p] });
    faces.push_back({ low[next], high[next], high[p] });
  }
  return faces;
}

/// A cube whose upper face goes down to a point.
CellFaces Dented(double depth)
{
  CellFaces faces = FacesOfCubes({ { 0, 0, 0 } });
  const auto top = std::find_if(faces.begin(), faces.end(),
    [](const auto& face)
    {
      return std::all_of(
        face.begin(), face.end(), [](const glm::dvec3& point) { return point.z == 1.0; });
    });
  const std::vector<glm::dvec3> rim = *top;
  faces.erase(top);
  for (std::size_t p = 0; p < 4; ++p)
  {
    faces.push_back({ rim[p], rim[(p + 1) % 4], { 0.4, 0.5, 1.0 - depth } });
  }
  return faces;
}

std::vector<std::pair<std::string, CellFaces>> ConcaveCells()
{
  std::set<std::array<int, 3>> ring, shell;
  for (int cube = 0; cube < 27; ++cube)
  {
    const std::array<int, 3> at{ cube % 3, cube / 3 % 3, cube / 9 };
    if (at != std::array<int, 3>{ 1, 1, 1 })
    {
      shell.insert(at);
    }
    if (at[2] == 0 && (at[0] != 1 || at[1] != 1))
    {
      ring.insert(at);
    }
  }
  return { { "U", PrismOver(UShape, 0.0, 1.0) }, { "thin U", PrismOver(UShape, 0.0, 1e-4) },
    { "far U", PrismOver(UShape, 1e4, 1e4 + 1.0) }, { "L", PrismOver(LShape, 0.0, 2.0) },
    { "dart", PrismOver(Dart, 0.0, 0.5) }, { "zigzag", PrismOver(Zigzag, 0.0, 1.0) },
    { "dented", Dented(0.3) }, { "deeply dented", Dented(0.95) }, { "twisted", Twisted(0.5) },
    { "cross",
      FacesOfCubes({ { 0, 0, 0 }, { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 },
        { 0, 0, -1 } }) },
    { "screw",
      FacesOfCubes({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 1, 1, 1 }, { 0, 1, 1 }, { 0, 1, 2 },
        { 0, 0, 2 } }) },
    { "ring", FacesOfCubes(ring) }, { "shell", FacesOfCubes(shell) } };
}

void TestCells()
{
  for (const auto& [name, faces] : ConcaveCells())
  {
    for (unsigned int seed = 0; seed < 4; ++seed)
    {
      // Which side of a surface in another one is outside, faces without directions do not tell.
      if (name == "shell" && seed != 0)
      {
        continue;
      }
      const std::string what = name + " " + std::to_string(seed);
      PolyhedronGrid grid({ faces }, seed);
      const MeshPart part = PartOf(grid, what);
      Expect(HasValuesOf(Linear, part, name == "far U" ? 1e-8 : 1e-12),
        what + ": a linear field stays linear");
      ExpectFilledOnce(part, faces, what);
    }
  }
}

/// Cells in two layers fill a box: concave ones and what lies in their bays.
void TestNeighbours()
{
  const Polygon bay = { { 1, 1 }, { 2, 1 }, { 2, 3 }, { 1, 3 } };
  const Polygon beside = { { 3, 0 }, { 5, 0 }, { 5, 3 }, { 4, 1 }, { 3, 3 } }; // seen from its mean
  const Polygon wedge = { { 3, 3 }, { 4, 1 }, { 5, 3 } };
  for (unsigned int seed = 0; seed < 8; ++seed)
  {
    const std::string what = "neighbours " + std::to_string(seed);
    std::vector<CellFaces> cells;
    for (const Polygon& polygon : { UShape, bay, beside, wedge })
    {
      cells.push_back(PrismOver(polygon, 0.0, 1.0));
      cells.push_back(PrismOver(polygon, 1.0, 1.5));
    }
    PolyhedronGrid grid(cells, seed);
    const MeshPart part = PartOf(grid, what);
    double volume = 0.0;
    for (std::int64_t c = 0; c < part.NumberOfCells; ++c)
    {
      volume += VolumeIn(FacesOfPart(part, c));
    }
    Expect(std::abs(volume - 5.0 * 3.0 * 1.5) < 1e-12, what + ": volume " + std::to_string(volume));
    const glm::dvec3 low(0.0), high(5.0, 3.0, 1.5);
    for (const auto& [face, count] : CountFaces(part))
    {
      bool isOutside = false;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        for (const glm::dvec3& bound : { low, high })
        {
          isOutside |= std::all_of(face.begin(), face.end(),
            [&, at = &part.Coordinates[axis], value = bound[static_cast<int>(axis)]](
              std::int64_t point) { return at->At(point) == value; });
        }
      }
      Expect(
        count == (isOutside ? 1 : 2), what + ": a face has " + std::to_string(count) + " cells");
    }
  }
}

/// A cell with a point that has no value is left out as a whole, and not only the parts there.
void TestWithoutValue()
{
  PolyhedronGrid grid({ PrismOver(UShape, 0.0, 1.0),
                        PrismOver({ { 1, 1 }, { 2, 1 }, { 2, 3 }, { 1, 3 } }, 0.0, 1.0) },
    1);
  grid.Give([](const glm::dvec3& at) { return at == glm::dvec3(0.0) ? std::nan("") : Linear(at); });
  std::vector<MeshPart> parts;
  std::string error;
  Expect(AppendSubdividedCells(
           grid.Made.Get(), grid.Made->GetPointData()->GetScalars(), 0, nullptr, 0, parts, error),
    "a point without a value: " + error);
  double volume = 0.0;
  for (std::int64_t c = 0; c < parts.at(0).NumberOfCells; ++c)
  {
    volume += VolumeIn(FacesOfPart(parts[0], c));
  }
  Expect(
    std::abs(volume - 2.0) < 1e-12, "a point without a value: volume " + std::to_string(volume));
}

/// The sides of a hexagonal prism may bend inwards.
void TestPrism()
{
  const CellFaces faces = PrismOver(LShape, 0.0, 1.0);
  PolyhedronGrid points({ faces }, 1), grid({}, 0);
  std::vector<vtkIdType> ids;
  for (const double height : { 0.0, 1.0 })
  {
    for (const glm::dvec2& corner : LShape)
    {
      ids.push_back(grid.PointAt(glm::dvec3(corner, height)));
    }
  }
  grid.Made->InsertNextCell(VTK_HEXAGONAL_PRISM, 12, ids.data());
  ExpectFilledOnce(PartOf(grid, "prism"), faces, "prism");
}

/// An edge of a tetrahedron may have a point of a neighbour. And cones over parts of convex cells
/// meet in the mean of the points.
void TestConvex()
{
  const glm::dvec3 a(0.0), b(1.0, 0.0, 0.0), c(0.0, 1.0, 0.0), d(0.0, 0.0, 1.0);
  const glm::dvec3 middle = 0.5 * (a + b);
  const CellFaces faces = { { a, c, b, middle }, { a, middle, b, d }, { a, d, c }, { b, c, d } };
  PolyhedronGrid grid({ faces }, 3);
  const MeshPart part = PartOf(grid, "tetrahedron with five points");
  ExpectFilledOnce(part, faces, "tetrahedron with five points");
  const glm::dvec3 mean = (a + b + c + d + middle) / 5.0;
  Expect(part.NumberOfCells == 4, "a convex cell is one cone for each face");
  for (std::int64_t cell = 0; cell < part.NumberOfCells; ++cell)
  {
    const glm::dvec3 apex = FacesOfPart(part, cell)[1][2];
    Expect(glm::distance(apex, mean) < 1e-15, "a convex cell is seen from its mean");
  }
}

/// Cells that are not closed or cross themselves are drawn as cones from their mean, and told.
void TestUndivided()
{
  CellFaces open = PrismOver(UShape, 0.0, 1.0);
  open.erase(open.begin() + 4);
  PolyhedronGrid withOpen({ open }, 0);
  PartOf(withOpen, "open", 1);
  const Polygon eight = { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 0, -1 } };
  PolyhedronGrid crossing({ PrismOver(eight, 0.0, 1.0) }, 0);
  const MeshPart part = PartOf(crossing, "crossing", 1);
  Expect(part.NumberOfCells > 0 && HasValuesOf(Linear, part, 1e-12), "crossing: it is drawn");

  crossing.Give(Linear);
  Scene scene(crossing.Made, { 1.5 });
  scene.LookFrom(1.0, 2.0, 3.0);
  const EventCounter warnings(scene.Mapper, vtkCommand::WarningEvent);
  Expect(scene.Render(40, 40) && warnings.Count == 1, "crossing: one warning");
  scene.Renderer->GetActiveCamera()->Azimuth(5.0);
  Expect(scene.Render(40, 40) && warnings.Count == 1, "crossing: no second warning");
}

/// A plane in a U is that in the three hexahedra that it consists of.
void TestDrawn()
{
  const std::vector<Polygon> boxes = { { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } },
    { { 1, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 } }, { { 2, 0 }, { 3, 0 }, { 3, 1 }, { 2, 1 } },
    { { 0, 1 }, { 1, 1 }, { 1, 3 }, { 0, 3 } }, { { 2, 1 }, { 3, 1 }, { 3, 3 }, { 2, 3 } } };
  std::vector<CellFaces> convex;
  for (const Polygon& box : boxes)
  {
    convex.push_back(PrismOver(box, 0.0, 1.0));
  }
  PolyhedronGrid whole({ PrismOver(UShape, 0.0, 1.0) }, 5), divided(convex, 5);
  const auto across = [](const glm::dvec3& at) { return at.z + 0.1 * at.x - 0.05 * at.y; };
  whole.Give(across);
  divided.Give(across);
  Scene scene(whole.Made, { 0.5 }), truth(divided.Made, { 0.5 });
  for (const glm::dvec3& from : { glm::dvec3(0.3, 0.2, 1.0), glm::dvec3(-1.0, 2.0, 1.3) })
  {
    for (Scene* one : { &scene, &truth })
    {
      one->LookFrom(from.x, from.y, from.z);
    }
    ExpectSameSurface("U", scene, truth);
    int differing = 0;
    for (int pixel = 0; pixel < 90 * 90; ++pixel)
    {
      differing += std::isfinite(scene.DepthAt(pixel % 90, pixel / 90)) !=
        std::isfinite(truth.DepthAt(pixel % 90, pixel / 90));
    }
    Expect(differing == 0, "U: " + std::to_string(differing) + " pixels outside or missing");
  }
}

}

int TestConcaveCells(int, char*[])
{
  TestCells();
  TestNeighbours();
  TestWithoutValue();
  TestPrism();
  TestConvex();
  TestUndivided();
  TestDrawn();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
