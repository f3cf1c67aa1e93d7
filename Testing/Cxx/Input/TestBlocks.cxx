// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Blocks of images are drawn as the one image that they are parts of: no seams, nothing stale when
// one of them changes, mistakes named by the block.

#include "Truth/Agreement.h"
#include "Truth/ColdWitness.h"
#include "Truth/ImageBlocks.h"
#include "Volumes/Ghosts.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkMultiBlockDataSetAlgorithm.h>
#include <vtkObjectFactory.h>
#include <vtkPartitionedDataSet.h>
#include <vtkPartitionedDataSetCollection.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkSOADataArrayTemplate.h>
#include <vtkSphereSource.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>
#include <vtkUniformGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>

namespace
{

using namespace ImageBlocks;
using Mapper = vtkTemporalCoherenceVolumeMapper;

/// However an image is cut.
void TestSeams()
{
  const Image whole = Whole();
  ExpectSame("one block", Blocks(whole, { { 0, N - 1, 0, N - 1, 0, N - 1 } }), whole);
  ExpectSame("eight blocks", Blocks(whole), whole);
  ExpectSame("each with its own origin", Blocks(whole, Eight(), true), whole);
  std::vector<Extent> backwards = Eight(5);
  std::reverse(backwards.begin(), backwards.end());
  ExpectSame("in another order", Blocks(whole, backwards), whole);
  ExpectSame("overlapping",
    Blocks(whole,
      { { 0, 20, 0, N - 1, 0, N - 1 }, { 9, N - 1, 0, N - 1, 0, 20 },
        { 9, N - 1, 0, N - 1, 15, N - 1 } }),
    whole);
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_DOUBLE, VTK_LONG_LONG })
  {
    const Image typed = Whole(type);
    ExpectSame(typed->GetScalarTypeAsString(), Blocks(typed), typed);
  }
  const auto ofCells = [](Scene& scene)
  {
    scene.Mapper->SetScalarModeToUseCellFieldData();
    scene.Mapper->SelectScalarArray("of cells");
  };
  ExpectSame("cells", Blocks(whole), whole, ofCells);
  ExpectSame("cells, other origins", Blocks(whole, Eight(9), true), whole, ofCells);
}

/// Whatever holds the blocks, and holes in the tree itself.
void TestTrees()
{
  const Image whole = Whole();
  const std::vector<Extent> parts = Eight();

  vtkNew<vtkMultiBlockDataSet> nested;
  nested->SetBlock(0, nullptr);
  nested->SetBlock(1, vtkNew<vtkImageData>().Get());
  vtkNew<vtkMultiBlockDataSet> inner;
  for (unsigned int i = 0; i < 8; ++i)
  {
    i % 2 ? inner->SetBlock(2 * i, Part<vtkUniformGrid>(whole, parts[i]))
          : nested->SetBlock(2 + i, Part(whole, parts[i]));
  }
  nested->SetBlock(20, inner);
  nested->SetBlock(21, vtkNew<vtkPolyData>().Get());
  ExpectSame("nested blocks, nulls and uniform grids", nested, whole);

  vtkNew<vtkPartitionedDataSet> partitions;
  vtkNew<vtkPartitionedDataSetCollection> collection;
  for (unsigned int i = 0; i < 8; ++i)
  {
    partitions->SetPartition(i, Part(whole, parts[i]));
    collection->SetPartition(i / 3, i % 3, Part(whole, parts[i]));
  }
  ExpectSame("partitioned data set", partitions, whole);
  ExpectSame("partitioned data set collection", collection, whole);

  // Component-wise memory, vectors and their length.
  vtkNew<vtkSOADataArrayTemplate<float>> separate;
  vtkNew<vtkFloatArray> interleaved;
  const vtkIdType points = whole->GetNumberOfPoints();
  for (vtkDataArray* array :
    { static_cast<vtkDataArray*>(separate.Get()), static_cast<vtkDataArray*>(interleaved.Get()) })
  {
    array->SetNumberOfComponents(2);
    array->SetNumberOfTuples(points);
    for (vtkIdType i = 0; i < points; ++i)
    {
      const double value = whole->GetPointData()->GetScalars()->GetComponent(i, 0);
      array->SetTuple2(i, -value, 0.7 * value);
    }
  }
  Image vectors = Image::New(), same = Image::New();
  vectors->CopyStructure(whole);
  vectors->GetPointData()->SetScalars(interleaved);
  same->CopyStructure(whole);
  same->GetPointData()->SetScalars(separate);
  const auto tree = Blocks(vectors, { { 0, N - 1, 0, N - 1, 0, 9 } });
  tree->SetBlock(1, same);
  ExpectSame("lengths of vectors", tree, vectors,
    [](Scene& scene) { scene.Mapper->SetVectorModeToMagnitude(); });
  ExpectSame("a component", tree, vectors,
    [](Scene& scene)
    {
      scene.Mapper->SetVectorModeToComponent();
      scene.Mapper->SetVectorComponent(1);
    });
}

/// A tilted, stretched lattice with indices that begin anywhere, against brute force.
void TestObliqueLattice()
{
  const Image whole = Whole();
  whole->SetExtent(-4, N - 5, 7, N + 6, 100, N + 99);
  whole->SetSpacing(0.07, 0.05, 0.06);
  whole->SetOrigin(10.1, -3.3, 0.7);
  whole->SetDirectionMatrix(0.0, -0.6, 0.8, 0.0, 0.8, 0.6, -1.0, 0.0, 0.0);
  vtkNew<vtkMultiBlockDataSet> tree;
  for (const Extent& part : Eight())
  {
    const Extent extent = { part[0] - 4, part[1] - 4, part[2] + 7, part[3] + 7, part[4] + 100,
      part[5] + 100 };
    tree->SetBlock(tree->GetNumberOfBlocks(), Part(whole, extent, tree->GetNumberOfBlocks() % 2));
  }
  Scene scene(nullptr, { 60.0 });
  scene.Mapper->SetInputDataObject(tree);
  scene.LookFrom(1.0, -2.0, 0.6);
  BruteForceTracer truth(whole, scene.Volume);
  truth.Isovalues = { 60.0 };
  ExpectColdTruth("oblique blocks", scene, truth, Size, Size);
}

/// Whatever changes in the tree is seen, and only that costs a cold frame.
void TestChanges()
{
  const Image whole = Whole();
  const auto tree = Blocks(whole);
  Scene several(nullptr, { 60.0 });
  several.Mapper->SetInputDataObject(tree);
  several.LookFrom(1.0, -2.0, 0.6);
  Expect(several.Render(Size, Size), "rendered");
  const auto expect = [&](const std::string& what)
  {
    Scene fresh(nullptr, { 60.0 });
    fresh.Mapper->SetInputDataObject(tree);
    fresh.Mapper->SetScalarMode(several.Mapper->GetScalarMode());
    fresh.Mapper->SelectScalarArray(several.Mapper->GetArrayName());
    vtkNew<vtkImageData> before;
    before->DeepCopy(several.Depth);
    ExpectSame(what, several, fresh, Size);
    Expect(IsRoute(several, "Cold"), what + ": seen");
    Expect(!AreIdentical(before, several.Depth), what + ": another picture");
    Expect(several.Render(Size, Size) && IsRoute(several, "Redisplay"), what + ": once");
  };
  auto* block = vtkImageData::SafeDownCast(tree->GetBlock(1));
  vtkDataArray* values = block->GetPointData()->GetScalars();
  const auto change = [&](double difference)
  {
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    {
      values->SetComponent(i, 0, values->GetComponent(i, 0) + difference);
    }
  };
  change(9.0);
  values->Modified();
  expect("values of a block, the array tells");
  change(-18.0);
  block->Modified();
  expect("values of a block, the block tells");
  tree->SetBlock(8, Part(whole, { 0, N - 1, 0, 8, 0, N - 1 }));
  {
    // It may bring no other numbers, and then no other picture.
    Scene fresh(nullptr, { 60.0 });
    fresh.Mapper->SetInputDataObject(tree);
    ExpectSame("a block more", several, fresh, Size);
  }
  tree->SetBlock(1, nullptr);
  expect("a block less");
  several.Mapper->SetScalarModeToUseCellFieldData();
  several.Mapper->SelectScalarArray("of cells");
  expect("scalars of cells");
  several.Mapper->SetScalarModeToDefault();
  expect("scalars of points");
  several.Mapper->ClearCache();
  Expect(several.Render(Size, Size) && IsRoute(several, "Cold"), "all is forgotten");
  several.Mapper->SetInputDataObject(whole);
  Scene one(whole, { 60.0 });
  ExpectSame("an image instead of blocks", several, one, Size);
  several.Mapper->SetInputDataObject(tree);
  expect("blocks instead of an image");
}

/// A pipeline that makes another tree in each time step.
class TimeSource : public vtkMultiBlockDataSetAlgorithm
{
public:
  static TimeSource* New();
  vtkTypeMacro(TimeSource, vtkMultiBlockDataSetAlgorithm);
  vtkSetMacro(Step, int);

  static Image StepOf(int step)
  {
    return Volumes::FromFormula(
      N, VTK_FLOAT, [step](double x, double y, double z) { return Waves(x + 0.1 * step, y, z); });
  }

protected:
  TimeSource() { this->SetNumberOfInputPorts(0); }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* out) override
  {
    vtkMultiBlockDataSet::GetData(out)->ShallowCopy(Blocks(StepOf(this->Step), Eight(9)));
    return 1;
  }

  int Step = 0;
};
vtkStandardNewMacro(TimeSource);

void TestTimeSteps()
{
  vtkNew<TimeSource> source;
  Scene several(nullptr, { 60.0 });
  several.Mapper->SetInputConnection(source->GetOutputPort());
  several.Mapper->SetReuseAccuracyToPaper();
  for (int step = 0; step < 3; ++step)
  {
    source->SetStep(step);
    Scene one(TimeSource::StepOf(step), { 60.0 });
    several.LookFrom(1.0, -2.0, 0.6);
    ExpectSame("time step " + std::to_string(step), several, one, Size);
    Expect(IsRoute(several, "Cold"), "other data");
    several.Renderer->GetActiveCamera()->Azimuth(3.0);
    Expect(several.Render(Size, Size) && IsRoute(several, "ImageCache"), "the same data");
  }
}

/// The renderer's own way to a composite input: camera, culler, bounds.
void TestWindowWithBlocks()
{
  Scene several(nullptr, { 60.0 });
  vtkNew<TimeSource> source;
  several.Mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(Size, Size);
  window->AddRenderer(several.Renderer);
  window->Render(); // resets the camera by the bounds of what is seen
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetRGBACharPixelData(0, 0, Size - 1, Size - 1, 0, pixels);
  Expect(several.Render(Size, Size) && IsRoute(several, "Redisplay"), "the picture of the window");
  int hits = 0, different = 0;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      const unsigned char* expected = several.ColorAt(x, y);
      hits += expected[3] != 0;
      for (int c = 0; c < 3; ++c)
      {
        different +=
          std::abs((expected[3] ? expected[c] : 0) - pixels->GetPointer(4 * (y * Size + x))[c]) > 1;
      }
    }
  }
  Expect(hits > Size * Size / 10 && different == 0, "blocks in a window");
}

/// One error that names the block, and the last picture stays.
void ExpectError(const std::string& word, const std::function<void(vtkMultiBlockDataSet*)>& spoil,
  const std::function<void(Scene&)>& arrange = {})
{
  const Image whole = Whole();
  const auto tree = Blocks(whole);
  tree->GetMetaData(3u)->Set(vtkCompositeDataSet::NAME(), "the fourth");
  Scene scene(nullptr, { 60.0 });
  scene.Mapper->SetInputDataObject(tree);
  scene.LookFrom(1.0, 2.0, 0.5);
  vtkNew<vtkTest::ErrorObserver> observer;
  scene.Mapper->AddObserver(vtkCommand::ErrorEvent, observer);
  Expect(scene.Render(60, 60), word + ": valid before");
  vtkNew<vtkImageData> color;
  color->DeepCopy(scene.Color);
  spoil(tree);
  if (arrange)
  {
    arrange(scene);
  }
  Expect(!scene.Render(60, 60), word + ": refused");
  Expect(observer->GetError() && observer->GetErrorMessage().find(word) != std::string::npos,
    word + ": the message names it, but is: " + observer->GetErrorMessage());
  Expect(scene.Mapper->PickPixel(30, 30, nullptr, nullptr, nullptr),
    word + ": the last picture can still be picked");
  observer->Clear();
  Expect(!scene.Render(60, 60) && !observer->GetError(), word + ": said once only");
  scene.Mapper->SetScalarModeToDefault();
  scene.Mapper->SetInputDataObject(Blocks(whole));
  Expect(scene.Render(60, 60) && AreIdentical(color, scene.Color), word + ": mended");
}

void TestMistakes()
{
  const auto fourth = [](vtkMultiBlockDataSet* tree)
  { return vtkImageData::SafeDownCast(tree->GetBlock(3)); };
  ExpectError("The input has no cells;",
    [](vtkMultiBlockDataSet* tree)
    {
      tree->Initialize();
      tree->SetBlock(3, nullptr);
    });
  ExpectError("Block 4 ('the fourth') is a vtkTable",
    [](vtkMultiBlockDataSet* tree) { tree->SetBlock(3, vtkNew<vtkTable>().Get()); });
  ExpectError("Block 4 ('the fourth') does not fit the points of Block 1: its spacing",
    [&](vtkMultiBlockDataSet* tree) { fourth(tree)->SetSpacing(0.0625, 0.0625, 0.0626); });
  ExpectError("Block 4 ('the fourth') does not fit the points of Block 1: its spacing",
    [&](vtkMultiBlockDataSet* tree)
    {
      fourth(tree)->SetSpacing(0.0625, 0.0625, 0.0626);
      tree->SetBlock(8, vtkNew<vtkUnstructuredGrid>().Get()); // changes nothing
    });
  ExpectError("does not fit the points of Block 1: its spacing (nan",
    [&](vtkMultiBlockDataSet* tree)
    { fourth(tree)->SetSpacing(std::numeric_limits<double>::quiet_NaN(), 1.0, 1.0); });
  ExpectError("or its direction",
    [&](vtkMultiBlockDataSet* tree)
    { fourth(tree)->SetDirectionMatrix(0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0); });
  for (const double miss : { 2e-6, 0.5, 1e300, std::numeric_limits<double>::quiet_NaN() })
  {
    ExpectError("Block 4 ('the fourth') does not fit the points of Block 1: its origin",
      [&](vtkMultiBlockDataSet* tree)
      { fourth(tree)->SetOrigin(-1.0, -1.0 + 0.0625 * miss, -1.0); });
  }
  ExpectError("Block 4 ('the fourth') has an array 'waves' of double with 1 component(s), but "
              "Block 1 has 'waves' of float",
    [&](vtkMultiBlockDataSet* tree)
    {
      vtkNew<vtkDoubleArray> other;
      other->DeepCopy(fourth(tree)->GetPointData()->GetScalars());
      fourth(tree)->GetPointData()->SetScalars(other);
    });
  ExpectError("of 9 tuples, but ",
    [&](vtkMultiBlockDataSet* tree)
    {
      vtkNew<vtkFloatArray> few;
      few->SetNumberOfTuples(9);
      fourth(tree)->GetPointData()->SetScalars(few);
    });
  // More values than cells are those of other cells.
  ExpectError(
    "Block 4 ('the fourth') has an array (unnamed) of ",
    [&](vtkMultiBlockDataSet* tree)
    {
      for (unsigned int i = 0; i < tree->GetNumberOfBlocks(); ++i)
      {
        auto* block = vtkImageData::SafeDownCast(tree->GetBlock(i));
        vtkNew<vtkFloatArray> values;
        values->SetNumberOfTuples(block->GetNumberOfCells() + (i == 3 ? 1 : 0));
        values->FillValue(60.0f);
        block->GetCellData()->SetScalars(values);
      }
    },
    [](Scene& scene) { scene.Mapper->SetScalarModeToUseCellData(); });
  for (const vtkIdType more : { -1, 1 })
  {
    ExpectError("Block 4 ('the fourth') has a ghost array 'vtkGhostType' of ",
      [&](vtkMultiBlockDataSet* tree)
      {
        vtkImageData* const block = fourth(tree);
        Ghosts::AddFlags(block->GetCellData(), block->GetNumberOfCells() + more);
      });
  }
  ExpectError("Block 4 ('the fourth') has a ghost array 'vtkGhostType' of 9 tuples",
    [&](vtkMultiBlockDataSet* tree) { Ghosts::AddFlags(fourth(tree)->GetPointData(), 9); });
  ExpectError(
    "by its name with SelectScalarArray",
    [&](vtkMultiBlockDataSet* tree)
    { fourth(tree)->GetPointData()->GetScalars()->SetName("of another kind"); },
    [](Scene& scene)
    {
      scene.Mapper->SetScalarModeToUsePointFieldData();
      scene.Mapper->SelectScalarArray(0);
    });
  ExpectError(
    "named 'pressure' on its cells", [](vtkMultiBlockDataSet*) {},
    [](Scene& scene)
    {
      scene.Mapper->SetScalarModeToUseCellFieldData();
      scene.Mapper->SelectScalarArray("pressure");
    });
  ExpectError("a vtkVolume and a mapper each",
    [&](vtkMultiBlockDataSet* tree) { fourth(tree)->SetOrigin(-1.0, -1.0, 1e4); });
  ExpectError("spacing (0, ",
    [](vtkMultiBlockDataSet* tree)
    {
      const Image flat = Whole();
      flat->SetSpacing(0.0, 1.0, 1.0);
      tree->Initialize();
      tree->SetBlock(0, flat);
    });
}

/// What has nothing to draw, but is no mistake; and arrays that some blocks lack.
void TestPartialAndEmpty()
{
  const Image whole = Whole();
  const auto tree = Blocks(whole), with = Blocks(whole);
  vtkImageData::SafeDownCast(tree->GetBlock(2))->GetPointData()->Initialize();
  with->SetBlock(2, nullptr);
  Scene partial(nullptr, { 60.0 }), fewer(nullptr, { 60.0 });
  partial.Mapper->SetInputDataObject(tree);
  fewer.Mapper->SetInputDataObject(with);
  partial.LookFrom(1.0, -2.0, 0.6);
  ExpectSame("a block without the array", partial, fewer, Size);

  vtkNew<vtkSphereSource> sphere; // inside, so that the clipping range stays
  sphere->SetCenter(-0.5, -0.5, -0.5);
  sphere->SetRadius(0.2);
  sphere->Update();
  tree->SetBlock(8, sphere->GetOutput());
  tree->SetBlock(9, vtkNew<vtkUnstructuredGrid>().Get());
  ExpectSame("beside polygons and an empty grid", partial, fewer, Size);

  vtkNew<vtkMultiBlockDataSet> flat;
  flat->SetBlock(0, Part(whole, { 0, N - 1, 0, N - 1, 3, 3 }));
  Scene scene(nullptr, { 60.0 });
  scene.Mapper->SetInputDataObject(flat);
  scene.LookFrom(1.0, -2.0, 0.6);
  vtkNew<vtkTest::ErrorObserver> observer;
  scene.Mapper->AddObserver(vtkCommand::ErrorEvent, observer);
  Expect(scene.Render(30, 30) && !observer->GetError(), "a slice is no error");
  Expect(!scene.Mapper->PickPixel(15, 15, nullptr, nullptr, nullptr), "nothing is seen");
}

}

int TestBlocks(int, char*[])
{
  // The Debug driver traps operations on what is not a number, which is what is tested here.
  vtkFloatingPointExceptions::Disable();
  TestSeams();
  TestTrees();
  TestObliqueLattice();
  TestChanges();
  TestTimeSteps();
  TestWindowWithBlocks();
  TestMistakes();
  TestPartialAndEmpty();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
