// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Surfaces of rectilinear grids lie where their samples put them, by brute force and against
// spheres.

#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Truth/Agreement.h"
#include "Volumes/Grids.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkMath.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPointDataToCellData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iostream>
#include <limits>
#include <random>

namespace
{

using Grid = vtkSmartPointer<vtkRectilinearGrid>;
using Arrange = std::function<void(Scene&)>;

double BlobAt(double x, double y, double z)
{
  return 60.0 * (1.5 - x * x - 2.0 * y * y - 0.5 * z * z + 0.3 * x * y + 0.2 * z);
}

Grids::Coordinates RandomCoordinates(double ratio)
{
  return { Grids::Random(31, ratio, 1), Grids::Random(22, ratio, 2), Grids::Random(27, ratio, 3) };
}

/// The coordinates of an axis as the scene of VTK's TestGPURayCastMapperRectilinearGrid changes
/// them, sorted: there is no order in the original, and so no cells.
std::vector<double> Shuffled(int n)
{
  std::vector<double> along = Grids::Random(n, 25.0, 203542u);
  std::sort(along.begin(), along.end());
  return along;
}

/// Expect that a picture is that of brute force, in every mode.
void ExpectTruth(const std::string& name, vtkRectilinearGrid* grid,
  const std::vector<double>& isovalues, const Arrange& arrange)
{
  Scene scene(grid, isovalues);
  arrange(scene);
  for (const bool threshold : { false, true })
  {
    for (const bool nearest : { false, true })
    {
      scene.Mapper->SetSurfaceMode(threshold);
      scene.Volume->GetProperty()->SetInterpolationType(
        nearest ? VTK_NEAREST_INTERPOLATION : VTK_LINEAR_INTERPOLATION);
      BruteForceTracer truth(grid, scene.Volume);
      truth.Isovalues = isovalues;
      truth.IsThreshold = threshold;
      const std::string what =
        name + (threshold ? ", THRESHOLD" : ", CROSSING") + (nearest ? ", nearest" : "");
      ExpectColdTruth(what, scene, truth, 160, 120, 2);
    }
  }
}

/// VTK's scene: a grid, the same with other coordinates along one axis, and with other types of
/// samples.
void TestVtkScene()
{
  const auto value = [](double x, double y, double z)
  { return 5.2 + 5.0 * std::sin(2.5 * x) * std::cos(3.0 * y + z) + 0.3 * z; };
  const Grids::Coordinates plain = { Grids::FineInside(29, 0.7), Grids::Even(33),
    Grids::FineInside(25, 0.4) };
  const Arrange look = [](Scene& scene)
  {
    scene.LookFrom(0.0, 0.0, 1.0);
    scene.Renderer->GetActiveCamera()->Pitch(30.0);
    scene.Renderer->ResetCamera();
  };
  const std::vector<double> isovalues = { 3.53, 6.97 };
  ExpectTruth("VTK's scene", Grids::FromFormula(plain, VTK_FLOAT, value), isovalues, look);
  for (int axis = 0; axis < 3; ++axis)
  {
    // The samples stay, their places change.
    Grid grid = Grids::FromFormula(plain, VTK_FLOAT, value);
    const auto a = static_cast<std::size_t>(axis);
    Grids::SetCoordinates(grid, axis, Shuffled(static_cast<int>(plain[a].size())));
    ExpectTruth(
      "VTK's scene, other coordinates of axis " + std::to_string(axis), grid, isovalues, look);
  }
  for (const int type : { VTK_LONG_LONG, VTK_DOUBLE })
  {
    Grid grid = Grids::FromFormula(plain, type, value);
    ExpectTruth("VTK's scene, type " + std::to_string(type), grid, { 4.0, 7.0 }, look);
  }
}

void TestTransforms()
{
  const Grid grid = Grids::FromFormula(RandomCoordinates(8.0), VTK_FLOAT, BlobAt);
  const std::vector<double> isovalues = { 70.0 };
  ExpectTruth("rotated and moved", grid, isovalues,
    [](Scene& scene)
    {
      scene.Volume->RotateX(31.0);
      scene.Volume->RotateZ(-72.0);
      scene.Volume->SetPosition(3.0, -4.0, 5.0);
      scene.LookFrom(1.0, 0.5, 0.2);
    });
  ExpectTruth("scaled and mirrored", grid, isovalues,
    [](Scene& scene)
    {
      scene.Volume->SetScale(0.5, -2.0, 7.0);
      scene.Volume->RotateY(12.0);
      scene.LookFrom(1.0, 0.5, 0.2);
    });
  ExpectTruth("sheared", grid, isovalues,
    [](Scene& scene)
    {
      vtkNew<vtkMatrix4x4> shear;
      shear->SetElement(0, 1, 0.4);
      shear->SetElement(2, 0, -0.7);
      scene.Volume->SetUserMatrix(shear);
      scene.LookFrom(-1.0, 0.5, 0.2);
    });
  ExpectTruth("parallel along an axis", grid, isovalues,
    [](Scene& scene)
    {
      scene.LookFrom(1.0, 0.0, 0.0);
      scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    });
  ExpectTruth("parallel, oblique", grid, isovalues,
    [](Scene& scene)
    {
      scene.LookFrom(1.0, 2.0, -0.4);
      scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
    });
  ExpectTruth("inside", grid, { 70.0, 40.0 },
    [](Scene& scene)
    {
      vtkCamera* camera = scene.Renderer->GetActiveCamera();
      camera->SetPosition(0.9, -0.8, 0.85);
      camera->SetFocalPoint(-0.2, 0.1, 0.0);
      camera->SetViewAngle(80.0);
      camera->SetClippingRange(0.01, 10.0);
    });
  ExpectTruth("cut by the near and the far plane", grid, isovalues,
    [](Scene& scene)
    {
      scene.LookFrom(1.0, 2.0, 0.4);
      const double distance = scene.Renderer->GetActiveCamera()->GetDistance();
      scene.Renderer->GetActiveCamera()->SetClippingRange(distance - 0.4, distance + 0.3);
    });
  const Grid far = Grids::FromFormula(RandomCoordinates(8.0), VTK_FLOAT, BlobAt);
  for (int axis = 0; axis < 3; ++axis)
  {
    std::vector<double> along = RandomCoordinates(8.0)[static_cast<std::size_t>(axis)];
    for (double& at : along)
    {
      at = 1.0 + 1e-6 * at;
    }
    Grids::SetCoordinates(far, axis, along);
  }
  ExpectTruth("far from the origin and tiny", far, isovalues,
    [](Scene& scene) { scene.LookFrom(1.0, -0.5, 0.4); });
}

void TestFields()
{
  const Arrange look = [](Scene& scene) { scene.LookFrom(1.0, 2.0, 3.0); };
  for (const int type : { VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT,
         VTK_INT, VTK_UNSIGNED_LONG_LONG, VTK_FLOAT, VTK_DOUBLE })
  {
    Grid grid = Grids::FromFormula(RandomCoordinates(4.0), type,
      [](double x, double y, double z) { return std::max(BlobAt(x, y, z), 0.0); });
    ExpectTruth("type " + std::to_string(type), grid, { 70.0, 20.0, 85.0 }, look);
  }
  // Whole faces of cells equal the isovalue, and nothing is smooth.
  Grid whole = Grids::FromFormula(RandomCoordinates(20.0), VTK_INT,
    [](double x, double y, double z) { return std::floor(2.9 * (x + y * z) + 3.0 * z); });
  ExpectTruth("whole numbers", whole, { 1.0, 2.0 }, look);
  Grid noise = Grids::FromFormula(RandomCoordinates(20.0), VTK_UNSIGNED_CHAR,
    [](double x, double y, double z)
    { return 2.0 + std::floor(2.0 * std::sin(91.0 * x * y + 40.0 * z)); });
  ExpectTruth("noise", noise, { 2.0 }, look);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Grid holes = Grids::FromFormula(RandomCoordinates(4.0), VTK_DOUBLE,
    [nan](double x, double y, double z)
    { return std::sin(91.0 * x * y + 40.0 * z) > 0.97 ? nan : BlobAt(x, y, z); });
  ExpectTruth("holes", holes, { 70.0 }, look);
  ExpectTruth(
    "very uneven", Grids::FromFormula(RandomCoordinates(1e4), VTK_FLOAT, BlobAt), { 70.0 }, look);
  Grid thin = Grids::FromFormula(
    { Grids::Random(31, 5.0, 1), Grids::Random(22, 5.0, 2), { -0.3, 0.4 } }, VTK_FLOAT, BlobAt);
  ExpectTruth("two samples along an axis", thin, { 70.0 }, look);
}

/// Normals are those of central differences with the real distances, facing the viewer.
void TestNormals()
{
  Grid grid = Grids::FromFormula(RandomCoordinates(6.0), VTK_FLOAT, BlobAt);
  for (const int interpolation : { VTK_LINEAR_INTERPOLATION, VTK_NEAREST_INTERPOLATION })
  {
    Scene scene(grid, { 60.0 });
    scene.Volume->GetProperty()->SetInterpolationType(interpolation);
    scene.Volume->SetScale(0.5, -2.0, 1.5);
    scene.Volume->RotateX(20.0);
    scene.LookFrom(1.0, 0.5, 0.7);
    Expect(scene.Render(120, 90), "normals: rendered");
    const BruteForceTracer truth(grid, scene.Volume);
    const bool isLinear = interpolation == VTK_LINEAR_INTERPOLATION;
    double eye[3];
    scene.Renderer->GetActiveCamera()->GetPosition(eye);
    long hits = 0, wrong = 0;
    for (int y = 0; y < 90; ++y)
    {
      for (int x = 0; x < 120; ++x)
      {
        double position[3], normal[3], toEye[3];
        if (!scene.Mapper->PickPixel(x, y, position, normal, nullptr))
        {
          continue;
        }
        vtkMath::Subtract(eye, position, toEye);
        const double away = vtkMath::Normalize(toEye);
        // Half way between samples the value is that of the sample beyond the face.
        const double into = isLinear ? 0.0 : 1e-4 * away;
        const std::array<double, 3> at = { position[0] - into * toEye[0],
          position[1] - into * toEye[1], position[2] - into * toEye[2] };
        const std::array<double, 3> expected = truth.Field.WorldNormalAt(at);
        const double cosine = std::abs(vtkMath::Dot(normal, expected.data()));
        ++hits;
        wrong += (isLinear && cosine < 0.99999) || vtkMath::Dot(normal, toEye) < -1e-6;
      }
    }
    Expect(hits > 500 && wrong == 0,
      "normals: " + std::to_string(wrong) + " of " + std::to_string(hits) + " are wrong");
  }
}

/// Positions converge with the square of the cells' size and normals with their size, on cells that
/// are not alike.
void TestConvergence()
{
  constexpr double Radius = 0.6;
  const std::array<double, 3> centre = { 0.03, -0.05, 0.02 };
  std::vector<std::array<double, 2>> errors;
  for (const int n : { 33, 65, 129 })
  {
    Grid grid = Grids::FromFormula(
      { Grids::FineInside(n, 0.6), Grids::FineInside(n, -0.5), Grids::FineInside(n, 0.3) },
      VTK_DOUBLE,
      [&centre](double x, double y, double z)
      { return -std::hypot(x - centre[0], y - centre[1], z - centre[2]); });
    Scene scene(grid, { -Radius });
    scene.LookFrom(2.0, -3.0, 1.5);
    Expect(scene.Render(128, 128), "sphere: rendered");
    std::array<double, 2> worst = { 0.0, 0.0 };
    for (int pixel = 0; pixel < 128 * 128; ++pixel)
    {
      double position[3], normal[3];
      if (scene.Mapper->PickPixel(pixel % 128, pixel / 128, position, normal, nullptr))
      {
        vtkMath::Subtract(position, centre.data(), position);
        worst[0] = std::max(worst[0], std::abs(vtkMath::Norm(position) - Radius));
        vtkMath::Normalize(position);
        const double cosine = std::min(1.0, std::abs(vtkMath::Dot(position, normal)));
        worst[1] = std::max(worst[1], std::acos(cosine));
      }
    }
    errors.push_back(worst);
    std::cout << "sphere, " << n << " samples: " << worst[0] << ", " << worst[1] << " radian\n";
  }
  for (std::size_t i = 0; i < 2; ++i)
  {
    const double position = errors[i][0] / errors[i + 1][0];
    Expect(position > 3.4 && position < 4.6, "sphere: positions converge with the square");
    Expect(errors[i][1] / errors[i + 1][1] > 1.8, "sphere: normals converge");
  }
  Expect(errors[2][0] < 2e-3 && errors[2][1] < 3e-2, "sphere: small errors");
}

/// Scalars of cells lie at the centres of cells, which are no more alike than these.
void TestCells()
{
  const Grids::Coordinates along = RandomCoordinates(6.0);
  for (const bool descends : { false, true })
  {
    Grid grid = Grids::FromFormula(along, VTK_FLOAT, BlobAt);
    if (descends)
    {
      grid = Grids::Reversed(grid, { true, false, true });
    }
    vtkNew<vtkPointDataToCellData> toCells;
    toCells->SetInputData(grid);
    toCells->Update();
    vtkDataArray* cells = toCells->GetOutput()->GetCellData()->GetScalars();
    grid->GetCellData()->SetScalars(cells);
    grid->GetPointData()->Initialize();
    for (const bool nearest : { false, true })
    {
      Scene scene(grid, { 70.0 });
      scene.LookFrom(1.0, 0.5, 0.7);
      scene.Mapper->SetSurfaceModeToThreshold();
      scene.Volume->GetProperty()->SetInterpolationType(
        nearest ? VTK_NEAREST_INTERPOLATION : VTK_LINEAR_INTERPOLATION);
      BruteForceTracer truth(grid, scene.Volume, 0, cells);
      truth.Isovalues = { 70.0 };
      truth.IsThreshold = true;
      ExpectColdTruth("scalars of cells", scene, truth, 160, 120);
    }
  }
}

/// Cells with a flag hold no surface, and what they cut open of a solid is capped.
void TestHiddenCells()
{
  for (const bool ofPoints : { false, true })
  {
    Grid grid = Grids::FromFormula(RandomCoordinates(6.0), VTK_FLOAT, BlobAt);
    vtkNew<vtkUnsignedCharArray> flags;
    flags->SetName(vtkDataSetAttributes::GhostArrayName());
    std::mt19937 engine(7);
    const vtkIdType count = ofPoints ? grid->GetNumberOfPoints() : grid->GetNumberOfCells();
    for (vtkIdType i = 0; i < count; ++i)
    {
      const bool isHidden = engine() % 100u < (ofPoints ? 4u : 30u);
      const int flag = ofPoints ? static_cast<int>(vtkDataSetAttributes::HIDDENPOINT)
                                : static_cast<int>(vtkDataSetAttributes::HIDDENCELL);
      flags->InsertNextValue(static_cast<unsigned char>(isHidden ? flag : 0));
    }
    vtkDataSetAttributes* attributes = grid->GetCellData();
    (ofPoints ? grid->GetPointData() : attributes)->AddArray(flags);
    const std::string name = ofPoints ? "hidden points" : "hidden cells";
    for (const std::vector<double>& isovalues : { std::vector{ 60.0 }, { 30.0, 75.0 } })
    {
      ExpectTruth(name, grid, isovalues, [](Scene& scene) { scene.LookFrom(1.0, 0.5, 0.7); });
      ExpectTruth(name + ", plain walks", grid, isovalues,
        [](Scene& scene)
        {
          scene.Mapper->SpaceLeapingOff();
          scene.LookFrom(-0.3, -0.5, 0.7);
        });
    }
  }
}

/// Cropping planes are meant in the coordinates of the grid.
void TestCropping()
{
  Grid grid = Grids::Reversed(
    Grids::FromFormula(RandomCoordinates(6.0), VTK_FLOAT, BlobAt), { true, false, false });
  const double box[6] = { -0.55, 0.31, -0.7, 0.12, -0.8, 0.43 };
  for (const bool threshold : { false, true })
  {
    Scene scene(grid, { 40.0, 75.0 });
    scene.Mapper->CroppingOn();
    scene.Mapper->SetCroppingRegionPlanes(box);
    scene.Mapper->SetSurfaceMode(threshold);
    scene.LookFrom(1.0, 0.5, 0.7);
    Expect(scene.Render(120, 90), "cropped: rendered");
    BruteForceTracer truth(grid, scene.Volume);
    truth.Isovalues = { 40.0, 75.0 };
    truth.IsThreshold = threshold;
    long hits = 0, different = 0;
    for (int pixel = 0; pixel < 120 * 90; ++pixel)
    {
      const int x = pixel % 120, y = pixel / 120;
      BruteForceTracer::Line line = BruteForceTracer::LineThrough(scene.Renderer, x, y, 120, 90);
      for (std::size_t i = 0; i < 6; ++i)
      {
        const double t = (box[i] - line.Origin[i / 2]) / line.Direction[i / 2];
        const bool isEntry = (i % 2 == 0) == (line.Direction[i / 2] > 0.0);
        (isEntry ? line.Begin : line.End) =
          isEntry ? std::max(line.Begin, t) : std::min(line.End, t);
      }
      const BruteForceTracer::Hit hit = truth.Trace(line);
      double position[3];
      int isovalue = -1;
      scene.Mapper->PickPixel(x, y, position, nullptr, &isovalue);
      const bool isSame = isovalue == hit.Isovalue &&
        (isovalue < 0 || vtkMath::Distance2BetweenPoints(position, hit.Position.data()) < 1e-12);
      hits += isovalue >= 0;
      different += !isSame;
    }
    Expect(hits > 500 && different <= 1,
      "cropped: " + std::to_string(different) + " of " + std::to_string(hits) + " differ");
  }
}

/// Coordinates may descend.
void TestDescending()
{
  Grid grid = Grids::FromFormula(RandomCoordinates(6.0), VTK_FLOAT, BlobAt);
  Scene scene(grid, { 70.0, 30.0 });
  scene.Mapper->SetSurfaceModeToThreshold();
  scene.LookFrom(1.0, 0.5, 0.7);
  Expect(scene.Render(120, 90), "ascending: rendered");
  for (int which = 1; which < 8; ++which)
  {
    const std::array<bool, 3> axes = { (which & 1) != 0, (which & 2) != 0, (which & 4) != 0 };
    Grid other = Grids::Reversed(grid, axes);
    const std::string name = "descending " + std::to_string(which);
    Scene reversed(other, { 70.0, 30.0 });
    reversed.Mapper->SetSurfaceModeToThreshold();
    reversed.LookFrom(1.0, 0.5, 0.7);
    Expect(reversed.Render(120, 90), name + ": rendered");
    int different = 0;
    for (int pixel = 0; pixel < 120 * 90; ++pixel)
    {
      const int x = pixel % 120, y = pixel / 120;
      const float here = scene.DepthAt(x, y), there = reversed.DepthAt(x, y);
      const bool isSame = std::isinf(here) ? std::isinf(there) : std::abs(here - there) < 1e-5f;
      const int light = std::abs(scene.ColorAt(x, y)[0] - reversed.ColorAt(x, y)[0]);
      different += !isSame || light > 1;
    }
    Expect(different <= 2, name + ": " + std::to_string(different) + " pixels differ");
    Expect(std::equal(scene.Volume->GetBounds(), scene.Volume->GetBounds() + 6,
             reversed.Volume->GetBounds()),
      name + ": other bounds");
    ExpectTruth(name, other, { 70.0 }, [](Scene& s) { s.LookFrom(-0.5, 1.0, 0.7); });
  }
}

}

int TestRectilinearGrid(int, char*[])
{
  // The Debug driver traps operations on what is not a number, which is what is tested here.
  vtkFloatingPointExceptions::Disable();
  TestVtkScene();
  TestTransforms();
  TestFields();
  TestCells();
  TestHiddenCells();
  TestCropping();
  TestDescending();
  TestNormals();
  TestConvergence();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
