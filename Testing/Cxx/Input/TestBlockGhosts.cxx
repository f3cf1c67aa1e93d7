// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Nothing is seen in cells that no block has, owns and shows. Of several blocks with a sample, the
// owner's counts.

#include "Truth/Agreement.h"
#include "Truth/ImageBlocks.h"

#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <cstdlib>

namespace
{

using namespace ImageBlocks;
using Mapper = vtkTemporalCoherenceVolumeMapper;

/// An image that marks cells with a flag.
Image Marked(vtkImageData* image, const Extent& cells, unsigned char flag)
{
  auto marked = Image::New();
  marked->ShallowCopy(image);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(image->GetNumberOfCells());
  ghosts->Fill(0);
  int size[3];
  image->GetDimensions(size);
  const int* first = image->GetExtent();
  for (vtkIdType i = 0; i < ghosts->GetNumberOfTuples(); ++i)
  {
    const vtkIdType x = i % (size[0] - 1), y = i / (size[0] - 1) % (size[1] - 1),
                    z = i / (size[0] - 1) / (size[1] - 1);
    const vtkIdType at[3] = { x + first[0], y + first[2], z + first[4] };
    bool isInside = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      isInside = isInside && cells[2 * axis] <= at[axis] && at[axis] <= cells[2 * axis + 1];
    }
    ghosts->SetValue(i, isInside ? flag : 0);
  }
  marked->GetCellData()->AddArray(ghosts);
  return marked;
}

/// Cells of no block are left out, as if the whole image marked them as hidden.
void TestHoles()
{
  const Image whole = Whole();
  constexpr int Half = N / 2;
  std::vector<Extent> parts = Eight();
  parts.erase(parts.begin() + 6);
  const Extent missing = { 0, Half - 1, Half, N - 2, Half, N - 2 };
  const Image marked = Marked(whole, missing, vtkDataSetAttributes::HIDDENCELL);

  Scene one(marked, { 60.0 }), several(nullptr, { 60.0 });
  several.Mapper->SetInputDataObject(Blocks(whole, parts));
  one.LookFrom(-1.0, 2.0, 1.6);
  several.LookFrom(-1.0, 2.0, 1.6);
  for (const int mode : { Mapper::CROSSING, Mapper::THRESHOLD })
  {
    one.Mapper->SetSurfaceMode(mode);
    several.Mapper->SetSurfaceMode(mode);
    one.Renderer->SetActiveCamera(several.Renderer->GetActiveCamera());
    Expect(one.Render(Size, Size) && several.Render(Size, Size), "rendered");
    Expect(AreIdentical(one.Depth, several.Depth), "a missing block is a hole");
  }

  // Of scalars on cells, the field ends at the centres of the outermost cells that are there.
  Scene ofCells(nullptr, { 60.0 });
  ofCells.Mapper->SetInputDataObject(Blocks(whole, parts));
  ofCells.Mapper->SetScalarModeToUseCellFieldData();
  ofCells.Mapper->SelectScalarArray("of cells");
  ofCells.LookFrom(-1.0, 2.0, 1.6);
  BruteForceTracer truth(marked, ofCells.Volume, 0, marked->GetCellData()->GetArray("of cells"));
  truth.Isovalues = { 60.0 };
  ExpectColdTruth("cells with a hole", ofCells, truth, Size, Size);

  // A block hides cells itself; what another one owns and shows is seen.
  const Image low = Part(whole, { 0, N - 1, 0, N - 1, 0, 20 });
  const Image high = Part(whole, { 0, N - 1, 0, N - 1, 12, N - 1 });
  const Extent hidden = { 8, 24, 8, 24, 5, 8 };
  vtkNew<vtkMultiBlockDataSet> tree;
  tree->SetBlock(0, Marked(low, hidden, vtkDataSetAttributes::HIDDENCELL));
  tree->SetBlock(1, Marked(high, { 0, N, 0, N, 12, 19 }, vtkDataSetAttributes::DUPLICATECELL));
  ExpectSame("hidden in its block", tree, Marked(whole, hidden, vtkDataSetAttributes::HIDDENCELL));
  tree->SetBlock(1, Marked(high, { 0, N, 0, N, 12, 14 }, vtkDataSetAttributes::HIDDENCELL));
  ExpectSame(
    "hidden here and shown there", tree, Marked(whole, hidden, vtkDataSetAttributes::HIDDENCELL));
}

/// Beside a gap gradients are one-sided, as at the boundary of a block that is alone.
void TestRims()
{
  for (const int type : { VTK_FLOAT, VTK_DOUBLE, VTK_SHORT })
  {
    const Image whole = Whole(type);
    const Extent front = { 0, N - 1, 0, N - 1, 0, 12 }, back = { 0, N - 1, 0, N - 1, 20, N - 1 };
    Scene alone(Part(whole, front), { 60.0 }), both(nullptr, { 60.0 });
    both.Mapper->SetInputDataObject(Blocks(whole, { front, back }));
    both.LookFrom(0.3, 0.5, -2.0);
    alone.Renderer->SetActiveCamera(both.Renderer->GetActiveCamera());
    Expect(alone.Render(Size, Size) && both.Render(Size, Size), "rendered");
    int hits = 0, different = 0;
    for (int y = 0; y < Size; ++y)
    {
      for (int x = 0; x < Size; ++x)
      {
        const bool isHit = alone.ColorAt(x, y)[3] != 0;
        hits += isHit;
        for (int c = 0; c < 3 && isHit; ++c)
        {
          different += std::abs(alone.ColorAt(x, y)[c] - both.ColorAt(x, y)[c]) > 1;
        }
        different += isHit && alone.DepthAt(x, y) != both.DepthAt(x, y);
      }
    }
    Expect(hits > Size && different == 0,
      std::to_string(different) + " of " + std::to_string(hits) + " pixels differ at the rim");
  }
}

/// Values of duplicates count only where nobody owns the point.
void TestDuplicates()
{
  const Image whole = Whole();
  const Image low = Part(whole, { 0, N - 1, 0, N - 1, 0, 20 });
  const Image high = Part(whole, { 0, N - 1, 0, N - 1, 16, N - 1 });
  // The first block has wrong values in its ghost layers, the points above z = 16.
  const Image wrong = Image::New();
  wrong->DeepCopy(low);
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(wrong->GetNumberOfPoints());
  for (vtkIdType i = 0; i < wrong->GetNumberOfPoints(); ++i)
  {
    const bool isGhost = i / (N * N) > 16;
    ghosts->SetValue(i, isGhost ? vtkDataSetAttributes::DUPLICATEPOINT : 0);
    if (isGhost)
    {
      wrong->GetPointData()->GetScalars()->SetComponent(i, 0, 1e6);
    }
  }
  wrong->GetPointData()->AddArray(ghosts);
  for (const bool isFirst : { true, false })
  {
    vtkNew<vtkMultiBlockDataSet> tree;
    tree->SetBlock(
      isFirst ? 0 : 1, Marked(wrong, { 0, N, 0, N, 16, N }, vtkDataSetAttributes::DUPLICATECELL));
    tree->SetBlock(isFirst ? 1 : 0, high);
    ExpectSame("the owner's values", tree, whole);
  }

  // Cells that only others own are not seen, whether samples are those of points or of cells.
  const Extent foreign = { 0, 40, 0, 40, 16, 40 };
  const Image alone = Part(whole, { 0, N - 1, 0, N - 1, 0, 20 });
  vtkNew<vtkMultiBlockDataSet> tree;
  tree->SetBlock(0, Marked(alone, foreign, vtkDataSetAttributes::DUPLICATECELL));
  const Image hidden = Marked(alone, foreign, vtkDataSetAttributes::HIDDENCELL);
  ExpectSame("points of duplicate cells", tree, hidden);
  ExpectSame("scalars of duplicate cells", tree, hidden,
    [](Scene& scene)
    {
      scene.Mapper->SetScalarModeToUseCellFieldData();
      scene.Mapper->SelectScalarArray("of cells");
    });
}

}

int TestBlockGhosts(int, char*[])
{
  TestHoles();
  TestRims();
  TestDuplicates();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
