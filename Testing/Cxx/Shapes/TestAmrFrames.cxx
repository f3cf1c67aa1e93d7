// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Pictures of adaptive grids. With one level they are those of an image, byte for byte. With
// several levels, no ray through the faces between them finds a hole.

#include "Adaptive/AmrMesh.h"
#include "Checks/AreIdentical.h"
#include "Checks/Expect.h"
#include "Checks/Sanitized.h"
#include "LinearCells.h"
#include "Scenes/Scene.h"
#include "Volumes/AmrGrids.h"

#include <vtkAbstractMapper.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkUniformGrid.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <cstdlib>
#include <iostream>
#include <string>

namespace
{

using namespace TemporalCoherence;

double Waves(const glm::dvec3& at)
{
  return 50.0 * (1.0 + std::sin(1.3 * at.x + at.y) * std::cos(1.1 * at.y) + 0.3 * at.z);
}

void ChooseCells(Scene& scene)
{
  scene.Mapper->SetScalarModeToUseCellFieldData();
  scene.Mapper->SelectScalarArray("values");
}

void TestOneLevel()
{
  AmrTestLevels levels;
  levels.Origin = { -2.0, 1.0, 0.5 };
  levels.Spacing = { 0.5, 0.25, 0.75 };
  const AmrTestBox all{ glm::ivec3(0), glm::ivec3(19, 15, 11) };
  levels.Boxes = { { all } };
  const auto one = MakeAmr(levels, Waves);
  levels.Boxes = { CutBox(all, 7) };
  const auto blocks = MakeAmr(levels, Waves);
  Expect(HasOneLevel(one) && HasOneLevel(blocks), "there is one level");
  vtkNew<vtkImageData> image;
  image->ShallowCopy(GridAt(one, 0, 0));
  Scene ofImage(image, { 60.0 });
  for (const auto& amr : { one, blocks })
  {
    for (const bool isSolid : { false, true })
    {
      Scene ofAmr(nullptr, { 60.0 });
      ofAmr.Mapper->SetInputDataObject(amr);
      for (Scene* scene : { &ofImage, &ofAmr })
      {
        ChooseCells(*scene);
        isSolid ? scene->Mapper->SetSurfaceModeToThreshold()
                : scene->Mapper->SetSurfaceModeToCrossing();
      }
      ofImage.LookFrom(1.0, 2.0, 0.7);
      ofAmr.Renderer->GetActiveCamera()->DeepCopy(ofImage.Renderer->GetActiveCamera());
      Expect(ofImage.Render(200, 150) && ofAmr.Render(200, 150), "both are drawn");
      int hits = 0;
      for (int pixel = 0; pixel < 200 * 150; ++pixel)
      {
        hits += !std::isinf(ofImage.DepthAt(pixel % 200, pixel / 200));
      }
      Expect(hits > 1500, "the picture is not empty: " + std::to_string(hits));
      Expect(AreIdentical(ofImage.Color, ofAmr.Color) && AreIdentical(ofImage.Depth, ofAmr.Depth),
        std::string("one level is drawn as an image") + (isSolid ? ", solid" : ""));
    }
  }
}

/// A cube of 8^3 cells of size 1, of which a box is finer, and a part of that again.
AmrTestLevels Nested(int ratio)
{
  AmrTestLevels levels;
  levels.Boxes = { CutBox({ glm::ivec3(0), glm::ivec3(7) }, 4) };
  levels.Boxes.push_back(
    CutBox({ glm::ivec3(2 * ratio), glm::ivec3(6 * ratio - 1, 5 * ratio - 1, 5 * ratio - 1) }, 5));
  const int first = (2 * ratio + 2) * ratio;
  levels.Boxes.push_back({ { glm::ivec3(first), glm::ivec3(first + 2 * ratio - 1) } });
  levels.Ratios = { ratio, ratio };
  return levels;
}

/// Above 0 at the upper end, below 0 at the lower end, and anything in between: whatever goes from
/// end to end meets a surface, unless there is a hole.
double Noise(const glm::dvec3& at)
{
  const double random = std::sin(127.1 * at.x + 311.7 * at.y + 74.7 * at.z) * 43758.5453;
  const double noise = 2.0 * (random - std::floor(random)) - 1.0;
  return at.z > 7.0 ? 1.0 + noise * 0.5 : at.z < 1.0 ? -1.0 + noise * 0.5 : noise;
}

/// Rays through the corners and edges of hexahedra: where holes would be.
void TestRaysThroughCorners(Scene& scene, int ratio, const std::string& what)
{
  // Centres of all levels lie on a lattice of these steps.
  const double step = 0.5 / (ratio * ratio) / 2.0;
  const int pixels = static_cast<int>(6.5 / step);
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(0.5 * pixels * step);
  const double middle = 0.75 + (0.5 * pixels - 0.5) * step;
  camera->SetFocalPoint(middle, middle, 4.0);
  camera->SetPosition(middle, middle, 20.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetClippingRange(1.0, 40.0);
  Expect(scene.Render(pixels, pixels), what + ": is drawn");
  int holes = 0;
  for (int y = 0; y < pixels; ++y)
  {
    for (int x = 0; x < pixels; ++x)
    {
      holes += std::isinf(scene.DepthAt(x, y));
    }
  }
  std::cout << what << ": " << holes << " holes in " << pixels * pixels << " rays\n";
  Expect(holes == 0, what + ": no holes in the picture");
}

/// Random lines through the faces of hexahedra that have corners on several levels.
void TestLinesThroughFaces(Scene& scene, vtkOverlappingAMR* amr, int count, const std::string& what)
{
  ScalarChoice choice;
  choice.Mode = VTK_SCALAR_MODE_USE_CELL_FIELD_DATA;
  choice.IsByName = true;
  choice.Name = "values";
  std::vector<MeshPart> parts;
  std::string error;
  Expect(AppendAmrMesh(amr, choice, 0, parts, error), what + ": a mesh " + error);
  std::vector<MeshCell> between;
  for (std::int64_t c = 0; c < parts.front().NumberOfCells; ++c)
  {
    MeshCell cell;
    ReadCell(parts.front(), c, cell);
    bool isRepeated = false;
    for (std::size_t corner = 1; corner < 8; ++corner)
    {
      isRepeated |= cell.Points[corner] == cell.Points[corner - 1];
    }
    if (isRepeated)
    {
      between.push_back(cell);
    }
  }
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> random(0.0, 1.0);
  int holes = 0, lines = 0;
  while (lines < count)
  {
    const MeshCell& cell = between[engine() % between.size()];
    glm::dvec3 on(random(engine), random(engine), random(engine));
    on[static_cast<int>(engine() % 3)] = engine() % 2 ? 1.0 : 0.0;
    const glm::dvec3 through(HexahedronAt(cell, on));
    const glm::dvec3 direction(random(engine) - 0.5, random(engine) - 0.5, 0.7);
    const glm::dvec3 low = through + (0.4 - through.z) / direction.z * direction;
    const glm::dvec3 high = through + (7.6 - through.z) / direction.z * direction;
    if (glm::min(glm::min(low.x, low.y), glm::min(high.x, high.y)) < 0.5 ||
      glm::max(glm::max(low.x, low.y), glm::max(high.x, high.y)) > 7.5)
    {
      continue;
    }
    ++lines;
    double t = 0.0;
    glm::dvec3 position, normal;
    int isovalue = -1;
    holes += !scene.Mapper->IntersectWithLine(
      scene.Volume, &high.x, &low.x, t, &position.x, &normal.x, &isovalue);
  }
  std::cout << what << ": " << holes << " holes on " << lines << " lines, " << between.size()
            << " hexahedra between levels\n";
  Expect(holes == 0, what + ": no holes between levels");
}

void TestHoles()
{
  for (const int ratio : { 2, 4 })
  {
    const std::string what = "ratio " + std::to_string(ratio);
    const auto amr = MakeAmr(Nested(ratio), Noise);
    Scene scene(nullptr, { 0.0 });
    scene.Mapper->SetInputDataObject(amr);
    ChooseCells(scene);
    TestRaysThroughCorners(scene, ratio, what);
    TestLinesThroughFaces(scene, amr, IsMemorySanitized ? 500 : 50000, what);
  }
}

/// A linear field: each hexahedron has the same plane, at the depth of the plane.
void TestPlane()
{
  const auto amr = MakeAmr(Nested(2), [](const glm::dvec3& at) { return at.z + 0.2 * at.x; });
  Scene scene(nullptr, { 4.4 });
  scene.Mapper->SetInputDataObject(amr);
  ChooseCells(scene);
  double worst = 0.0;
  for (int line = 0; line < 2000; ++line)
  {
    const double x = 0.7 + 6.6 * (line % 50) / 50.0, y = 0.7 + 6.6 * line / 2000.0;
    const glm::dvec3 high(x, y, 7.6), low(x, y, 0.4);
    double t = 0.0;
    glm::dvec3 position, normal;
    int isovalue = -1;
    const bool isHit = scene.Mapper->IntersectWithLine(
      scene.Volume, &high.x, &low.x, t, &position.x, &normal.x, &isovalue);
    Expect(isHit, "a plane has no holes");
    worst = std::max(worst, std::abs(position.z + 0.2 * position.x - 4.4));
  }
  Expect(worst < 1e-9, "a plane is exact on all levels: " + std::to_string(worst));
}

/// Two scenes have the same picture, which is not empty.
void ExpectTheSame(Scene& scene, Scene& reference, const std::string& what)
{
  for (const bool isSolid : { false, true })
  {
    for (Scene* each : { &scene, &reference })
    {
      ChooseCells(*each);
      isSolid ? each->Mapper->SetSurfaceModeToThreshold()
              : each->Mapper->SetSurfaceModeToCrossing();
    }
    scene.LookFrom(-1.0, 2.0, 0.7);
    reference.Renderer->SetActiveCamera(scene.Renderer->GetActiveCamera());
    Expect(scene.Render(120, 90) && reference.Render(120, 90), what + ": drawn");
    int hits = 0;
    for (int pixel = 0; pixel < 120 * 90; ++pixel)
    {
      hits += !std::isinf(scene.DepthAt(pixel % 120, pixel / 120));
    }
    Expect(hits > 500, what + ": the picture is not empty");
    Expect(AreIdentical(scene.Color, reference.Color) && AreIdentical(scene.Depth, reference.Depth),
      what + (isSolid ? ", solid" : ""));
  }
}

/// Cells without a value are hidden as blanked ones are.
void TestMissingCells()
{
  const auto isMissing = [](const glm::dvec3& at)
  { return glm::distance(at, glm::dvec3(2.0, 5.0, 5.0)) < 2.2 || at.x > 7.2; };
  const auto holed = MakeAmr(
    Nested(2), [&](const glm::dvec3& at) { return isMissing(at) ? std::nan("") : Waves(at); });
  const auto blanked = MakeAmr(Nested(2), Waves);
  for (unsigned int level = 0; level < blanked->GetNumberOfLevels(); ++level)
  {
    for (unsigned int block = 0; block < BlocksAt(blanked, level); ++block)
    {
      vtkUniformGrid* grid = GridAt(blanked, level, block);
      for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
      {
        double bounds[6];
        grid->GetCellBounds(cell, bounds);
        const glm::dvec3 low(bounds[0], bounds[2], bounds[4]),
          high(bounds[1], bounds[3], bounds[5]);
        if (isMissing(0.5 * (low + high)))
        {
          grid->BlankCell(cell);
        }
      }
    }
  }
  Scene scene(nullptr, { 60.0 }), reference(nullptr, { 60.0 });
  scene.Mapper->SetInputDataObject(holed);
  reference.Mapper->SetInputDataObject(blanked);
  ExpectTheSame(scene, reference, "missing cells are blanked ones");
}

/// Blocks with a layer of copies of other blocks' cells around them, as they are in distributed
/// data. The values of copies are wrong, so that they are seen if they are used.
vtkSmartPointer<vtkOverlappingAMR> WithCopies(const AmrTestLevels& levels)
{
  AmrTestLevels larger = levels;
  int size = 8;
  for (std::size_t l = 0; l < levels.Boxes.size(); ++l)
  {
    for (AmrTestBox& box : larger.Boxes[l])
    {
      box.First = glm::max(box.First - 1, 0);
      box.Last = glm::min(box.Last + 1, size - 1);
    }
    size *= l < levels.Ratios.size() ? levels.Ratios[l] : 1;
  }
  const auto amr = MakeAmr(larger, Waves);
  for (unsigned int level = 0; level < amr->GetNumberOfLevels(); ++level)
  {
    for (unsigned int block = 0; block < BlocksAt(amr, level); ++block)
    {
      const AmrTestBox &own = levels.Boxes[level][block], &all = larger.Boxes[level][block];
      const glm::ivec3 cells = all.Last - all.First + 1;
      vtkUniformGrid* grid = GridAt(amr, level, block);
      vtkUnsignedCharArray* ghosts = grid->AllocateCellGhostArray();
      for (int c = 0; c < cells.x * cells.y * cells.z; ++c)
      {
        const glm::ivec3 at =
          all.First + glm::ivec3(c % cells.x, c / cells.x % cells.y, c / cells.x / cells.y);
        if (glm::any(glm::lessThan(at, own.First)) || glm::any(glm::greaterThan(at, own.Last)))
        {
          ghosts->SetValue(c, vtkDataSetAttributes::DUPLICATECELL);
          grid->GetCellData()->GetArray("values")->SetTuple1(c, 100.0 * (c % 2));
        }
      }
    }
  }
  return amr;
}

void TestCopies()
{
  for (const int ratio : { 2, 4 })
  {
    const auto copies = WithCopies(Nested(ratio));
    const auto plain = MakeAmr(Nested(ratio), Waves);
    Scene scene(nullptr, { 60.0 }), reference(nullptr, { 60.0 });
    scene.Mapper->SetInputDataObject(copies);
    reference.Mapper->SetInputDataObject(plain);
    ExpectTheSame(
      scene, reference, "layers of copies change nothing, ratio " + std::to_string(ratio));
  }
}

}

int TestAmrFrames(int, char*[])
{
  TestOneLevel();
  TestHoles();
  TestPlane();
  TestMissingCells();
  TestCopies();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
