// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Blocks of any sort are drawn together; ghost cells and blanking hide cells; picks tell the cell
// and the block that are hit.

#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Truth/SameSurface.h"
#include "Volumes/Ghosts.h"
#include "Volumes/Volumes.h"
#include "Volumes/VtkMeshes.h"
#include "vtkTemporalCoherencePicker.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkExtractVOI.h>
#include <vtkGenericCell.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

namespace
{

using Image = vtkSmartPointer<vtkImageData>;

constexpr int N = 17;

Image Waves()
{
  const Image image = Volumes::FromFormula(N, VTK_FLOAT,
    [](double x, double y, double z)
    { return 50.0 * (1.0 + std::sin(3.0 * x + y) * std::cos(2.5 * y) + 0.5 * z); });
  image->SetSpacing(0.25, 0.5, 0.125);
  return image;
}

/// A slab of an image along x, with an extent that begins at 0.
Image Slab(vtkImageData* image, int first, int last)
{
  vtkNew<vtkExtractVOI> extract;
  extract->SetInputData(image);
  extract->SetVOI(first, last, 0, N - 1, 0, N - 1);
  extract->Update();
  Image slab = Image::New();
  slab->ShallowCopy(extract->GetOutput());
  slab->SetOrigin(image->GetOrigin()[0] + first * image->GetSpacing()[0], image->GetOrigin()[1],
    image->GetOrigin()[2]);
  slab->SetExtent(0, last - first, 0, N - 1, 0, N - 1);
  return slab;
}

/// Five slabs of an image, each of another sort.
std::vector<vtkSmartPointer<vtkDataObject>> Slabs(vtkImageData* image)
{
  return { VtkMeshes::Unstructured(Slab(image, 0, 3), VTK_VOXEL), Slab(image, 3, 6),
    VtkMeshes::Curvilinear(Slab(image, 6, 10)), VtkMeshes::Rectilinear(Slab(image, 10, 13)),
    VtkMeshes::Explicit(Slab(image, 13, N - 1)) };
}

void ExpectBlocks(const std::string& name, vtkDataObject* blocks, vtkImageData* image)
{
  Scene ofImage(image, { 60.0 }), ofBlocks(nullptr, { 60.0 });
  ofBlocks.Mapper->SetInputDataObject(blocks);
  for (Scene* scene : { &ofImage, &ofBlocks })
  {
    scene->Mapper->SetSurfaceModeToThreshold();
    scene->LookFrom(1.0, 2.0, 0.7);
  }
  ExpectSameSurface(name, ofBlocks, ofImage);
}

void TestBlocksOfAllSorts()
{
  const Image image = Waves();
  const auto slabs = Slabs(image);
  vtkNew<vtkMultiBlockDataSet> tree, inner;
  vtkNew<vtkPartitionedDataSet> partitions;
  vtkNew<vtkPartitionedDataSetCollection> collection;
  for (unsigned int i = 0; i < slabs.size(); ++i)
  {
    i < 2 ? tree->SetBlock(i, slabs[i]) : inner->SetBlock(2 * i, slabs[i]);
    partitions->SetPartition(i, slabs[i]);
    collection->SetPartition(i, 0, slabs[i]);
  }
  tree->SetBlock(2, inner);
  tree->SetBlock(3, vtkNew<vtkUnstructuredGrid>().Get());
  ExpectBlocks("nested blocks", tree, image);
  ExpectBlocks("partitions", partitions, image);
  ExpectBlocks("a collection", collection, image);

  // Blocks of surfaces beside one with volume are ignored.
  vtkNew<vtkMultiBlockDataSet> withSheet, withPatches;
  vtkNew<vtkUnstructuredGrid> sheet;
  sheet->SetPoints(VtkMeshes::PointsOf(image));
  sheet->GetPointData()->ShallowCopy(image->GetPointData());
  const vtkIdType ids[] = { 0, 1, N };
  sheet->InsertNextCell(VTK_TRIANGLE, 3, ids);
  withSheet->SetBlock(0, sheet);
  withSheet->SetBlock(1, VtkMeshes::Curvilinear(image));
  ExpectBlocks("beside a sheet", withSheet, image);
  vtkNew<vtkSphereSource> patches;
  patches->Update();
  withPatches->SetBlock(0, patches->GetOutput());
  withPatches->SetBlock(1, VtkMeshes::Curvilinear(image));
  withPatches->SetBlock(2, vtkNew<vtkPolyData>().Get());
  ExpectBlocks("beside polygons", withPatches, image);
}

/// Hidden, refined and duplicate cells, and cells around hidden points, are not drawn.
void TestHiding()
{
  const auto hide = [](const std::string& name, const std::function<void(vtkImageData*)>& flag)
  {
    const Image image = Waves();
    flag(image);
    ExpectBlocks(name + " of a curvilinear grid", VtkMeshes::Curvilinear(image), image);
    ExpectBlocks(name + " of hexahedra", VtkMeshes::Unstructured(image, VTK_HEXAHEDRON), image);
    ExpectBlocks(name + " of an explicit grid", VtkMeshes::Explicit(image), image);
  };
  for (const int bit : { vtkDataSetAttributes::HIDDENCELL, vtkDataSetAttributes::REFINEDCELL,
         vtkDataSetAttributes::DUPLICATECELL })
  {
    hide("flag " + std::to_string(bit),
      [=](vtkImageData* image)
      {
        Ghosts::FlagCells(
          image, [=](int i, int j, int) { return i > 11 || (j > 3 && j < 7) ? bit : 0; });
      });
  }
  hide("other flags",
    [](vtkImageData* image)
    {
      Ghosts::FlagCells(
        image, [](int, int, int) { return vtkDataSetAttributes::HIGHCONNECTIVITYCELL; });
    });
  hide("hidden points",
    [](vtkImageData* image)
    {
      Ghosts::FlagPoints(image,
        [](int i, int, int k) { return i == 8 && k < 9 ? vtkDataSetAttributes::HIDDENPOINT : 0; });
    });
  const Image image = Waves();
  const auto blanked = VtkMeshes::Curvilinear(image);
  for (vtkIdType cell = 0; cell < 700; ++cell)
  {
    blanked->BlankCell(cell);
  }
  Ghosts::FlagCells(image,
    [](int i, int j, int k)
    { return i + 16 * j + 256 * k < 700 ? vtkDataSetAttributes::HIDDENCELL : 0; });
  ExpectBlocks("blanked", blanked, image);
}

/// Parts of distributed data overlap in ghost cells: without seams, and cell scalars agree.
void TestDistributed()
{
  const Image whole = Waves();
  vtkNew<vtkDoubleArray> ofCells;
  for (int i = 0; i < (N - 1) * (N - 1) * (N - 1); ++i)
  {
    const double x = i % (N - 1), y = i / (N - 1) % (N - 1), z = i / (N - 1) / (N - 1);
    ofCells->InsertNextValue(60.0 + 10.0 * std::sin(0.5 * x) + 5.0 * std::cos(0.7 * y) + z - 8.0);
  }
  whole->GetPointData()->Initialize();
  whole->GetCellData()->SetScalars(ofCells);
  const Image left = Slab(whole, 0, 9), right = Slab(whole, 7, N - 1); // two layers overlap
  Ghosts::FlagCells(
    left, [](int i, int, int) { return i >= 8 ? vtkDataSetAttributes::DUPLICATECELL : 0; });
  Ghosts::FlagCells(
    right, [](int i, int, int) { return i < 1 ? vtkDataSetAttributes::DUPLICATECELL : 0; });
  vtkNew<vtkMultiBlockDataSet> parts;
  parts->SetBlock(0, VtkMeshes::Unstructured(left, VTK_HEXAHEDRON));
  parts->SetBlock(1, VtkMeshes::Curvilinear(right));
  Scene ofWhole(VtkMeshes::Unstructured(whole, VTK_HEXAHEDRON), { 60.0 }),
    ofParts(nullptr, { 60.0 });
  ofParts.Mapper->SetInputDataObject(parts);
  for (Scene* scene : { &ofWhole, &ofParts })
  {
    scene->LookFrom(1.0, 2.0, 0.7);
  }
  ExpectSameSurface("parts with ghost cells", ofParts, ofWhole);
}

/// The cell of a pick holds the point that is hit.
void ExpectCell(const std::string& name, vtkDataSet* data, vtkIdType cell, double place[3])
{
  if (!data || cell < 0 || cell >= data->GetNumberOfCells())
  {
    Expect(false, name + ": no cell");
    return;
  }
  double bounds[6];
  data->GetCellBounds(cell, bounds);
  const double tolerance = 1e-5 * data->GetLength();
  bool isInside = true;
  for (int axis = 0; axis < 3; ++axis)
  {
    isInside = isInside && place[axis] >= bounds[2 * axis] - tolerance &&
      place[axis] <= bounds[2 * axis + 1] + tolerance;
  }
  Expect(isInside, name + ": another cell");
}

void TestPicks()
{
  const Image image = Waves();
  const auto slabs = Slabs(image);
  vtkNew<vtkMultiBlockDataSet> tree;
  for (unsigned int i = 0; i < slabs.size(); ++i)
  {
    tree->SetBlock(i, slabs[i]);
  }
  Scene scene(nullptr, { 60.0 });
  scene.Mapper->SetInputDataObject(tree);
  scene.LookFrom(1.0, 2.0, 0.7);
  Expect(scene.Render(60, 60), "picks: rendered");
  std::vector<int> hitsOf(slabs.size() + 1, 0);
  for (int pixel = 0; pixel < 60 * 60; pixel += 7)
  {
    double place[3], normal[3];
    unsigned int block = 77;
    const bool isHit = scene.Mapper->PickPixel(pixel % 60, pixel / 60, place, normal, nullptr);
    const vtkIdType cell = scene.Mapper->PickCell(pixel % 60, pixel / 60, &block);
    Expect(isHit == (cell >= 0) && (isHit || block == 77), "picks: a cell with a hit only");
    if (isHit && block >= 1 && block <= slabs.size())
    {
      ++hitsOf[block];
      ExpectCell("a pixel", vtkDataSet::SafeDownCast(slabs[block - 1]), cell, place);
      double t, begin[3], end[3];
      for (int axis = 0; axis < 3; ++axis)
      {
        const double eye = scene.Renderer->GetActiveCamera()->GetPosition()[axis];
        begin[axis] = eye;
        end[axis] = eye + 1.2 * (place[axis] - eye);
      }
      Expect(
        scene.Mapper->IntersectWithLine(scene.Volume, begin, end, t, nullptr, nullptr, nullptr) &&
          std::abs(1.2 * t - 1.0) < 1e-6,
        "picks: a line");
    }
  }
  Expect(std::count_if(hitsOf.begin(), hitsOf.end(), [](int hits) { return hits > 0; }) >= 3,
    "picks: blocks are seen");

  // In a window that is never drawn, for the size that pickers need.
  vtkNew<vtkRenderWindow> window;
  window->SetSize(60, 60);
  window->AddRenderer(scene.Renderer);
  vtkNew<vtkTemporalCoherencePicker> picker;
  int picked = 0;
  for (int pixel = 0; pixel < 60 * 60; pixel += 29)
  {
    unsigned int block = 0;
    const int x = pixel % 60, y = pixel / 60;
    const vtkIdType cell = scene.Mapper->PickCell(x, y, &block);
    const bool isHit = picker->Pick(x + 0.5, y + 0.5, 0.0, scene.Renderer) != 0;
    Expect(isHit == (cell >= 0), "picker: a hit");
    if (isHit && cell >= 0)
    {
      ++picked;
      Expect(picker->GetCompositeDataSet() == tree &&
          picker->GetFlatBlockIndex() == static_cast<vtkIdType>(block) &&
          picker->GetDataSet() == slabs[block - 1] && picker->GetCellId() == cell,
        "picker: the block and its cell");
      // The point is one of the cell, and the place in the cell is where the hit is.
      vtkNew<vtkIdList> points;
      picker->GetDataSet()->GetCellPoints(cell, points);
      Expect(points->IsId(picker->GetPointId()) >= 0, "picker: a point of the cell");
      vtkNew<vtkGenericCell> found;
      picker->GetDataSet()->GetCell(cell, found);
      int subId = 0;
      double at[3], weights[8], apart = 0.0;
      found->EvaluateLocation(subId, picker->GetPCoords(), at, weights);
      for (int axis = 0; axis < 3; ++axis)
      {
        apart = std::max(apart, std::abs(at[axis] - picker->GetMapperPosition()[axis]));
      }
      Expect(apart < 1e-5, "picker: the place in the cell");
    }
  }
  Expect(picked > 10, "picker: " + std::to_string(picked) + " hits");
}

}

int TestGridBlocks(int, char*[])
{
  TestBlocksOfAllSorts();
  TestHiding();
  TestDistributed();
  TestPicks();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
