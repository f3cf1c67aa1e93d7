// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Arrays that hold their numbers in other ways than one behind the other give the same pictures,
// byte for byte: bits and, since VTK 9.6, constant, affine, strided and computed arrays.

#include "Checks/AreIdentical.h"
#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Volumes/Volumes.h"
#include "Volumes/VtkMeshes.h"

#include <vtkBitArray.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkExplicitStructuredGrid.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVersionMacros.h>
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
#include <vtkConstantArray.h>
#include <vtkFloatArray.h>
#include <vtkImplicitArray.h>
#include <vtkShortArray.h>
#include <vtkStridedArray.h>
#include <vtkTypeInt64Array.h>
#endif

#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>
#include <vector>

namespace
{

using Image = vtkSmartPointer<vtkImageData>;
using Array = vtkSmartPointer<vtkDataArray>;

constexpr int Width = 90, Height = 70;

Image Waves(int type = VTK_FLOAT)
{
  return Volumes::FromFormula(15, type,
    [](double x, double y, double z)
    { return 50.0 * (1.0 + std::sin(3.0 * x + y) * std::cos(2.5 * y) + 0.5 * z); });
}

/// The pictures of two data sets in two views, and the cells that are picked.
void ExpectSamePicture(
  const std::string& name, vtkDataSet* one, vtkDataSet* plain, double isovalue = 60.0)
{
  Scene ofOne(one, { isovalue }), ofPlain(plain, { isovalue });
  for (const double side : { 1.0, -2.0 })
  {
    for (Scene* scene : { &ofOne, &ofPlain })
    {
      scene->LookFrom(side, 2.0, 0.7);
      Expect(scene->Render(Width, Height), name + ": not rendered");
    }
    Expect(AreIdentical(ofOne.Color, ofPlain.Color) && AreIdentical(ofOne.Depth, ofPlain.Depth),
      name + ": another picture");
    const vtkIdType cell = ofPlain.Mapper->PickCell(Width / 2, Height / 2, nullptr);
    Expect(ofOne.Mapper->PickCell(Width / 2, Height / 2, nullptr) == cell, name + ": another cell");
  }
}

void TestBits()
{
  const Image waves = Waves(), bytes = Image::New(), bits = Image::New();
  for (const Image& image : { bytes, bits })
  {
    image->CopyStructure(waves);
  }
  vtkNew<vtkUnsignedCharArray> ofBytes;
  vtkNew<vtkBitArray> ofBits;
  vtkDataArray* const samples = waves->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < samples->GetNumberOfTuples(); ++i)
  {
    ofBytes->InsertNextValue(samples->GetComponent(i, 0) > 60.0 ? 1 : 0);
    ofBits->InsertNextValue(samples->GetComponent(i, 0) > 60.0 ? 1 : 0);
  }
  bytes->GetPointData()->SetScalars(ofBytes);
  bits->GetPointData()->SetScalars(ofBits);
  ExpectSamePicture("bits", bits, bytes, 0.5);
}

/// Cells by their only type.
void TestOneType()
{
  for (const int type : { VTK_TETRA, VTK_HEXAHEDRON, VTK_WEDGE, VTK_PYRAMID })
  {
    const auto plain = VtkMeshes::Unstructured(Waves(), type);
    const auto grid = VtkMeshes::Unstructured(Waves(), type);
    grid->SetCells(type, plain->GetCells());
    ExpectSamePicture("cells of one type " + std::to_string(type), grid, plain);
  }
}

/// A grid of hexahedra that knows its neighbours.
void TestExplicitGrid()
{
  const auto plain = VtkMeshes::Unstructured(Waves(), VTK_HEXAHEDRON);
  const auto grid = VtkMeshes::Explicit(Waves());
  ExpectSamePicture("an explicit structured grid", grid, plain);
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  grid->GetCells()->ConvertToFixedSize64BitStorage();
  ExpectSamePicture("an explicit structured grid of fixed size", grid, plain);
#endif
}

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)

using Grid = vtkSmartPointer<vtkUnstructuredGrid>;

/// An array of the same numbers that a function gives one by one.
Array Computed(vtkDataArray* array)
{
  const Array source = array;
  const vtkIdType components = array->GetNumberOfComponents();
  vtkNew<vtkImplicitArray<std::function<double(vtkIdType)>>> computed;
  computed->SetName(array->GetName());
  computed->ConstructBackend([source, components](vtkIdType i)
    { return source->GetComponent(i / components, static_cast<int>(i % components)); });
  computed->SetNumberOfComponents(array->GetNumberOfComponents());
  computed->SetNumberOfTuples(array->GetNumberOfTuples());
  return computed.Get();
}

/// An array of the same numbers with room between tuples.
template <typename T>
struct Strided
{
  static constexpr vtkIdType Room = 3, First = 2;

  explicit Strided(vtkDataArray* array)
  {
    const int components = array->GetNumberOfComponents();
    const vtkIdType stride = components + Room, count = array->GetNumberOfTuples();
    this->Buffer.assign(static_cast<std::size_t>(stride * count + First), T(-7));
    for (vtkIdType i = 0; i < count * components; ++i)
    {
      const vtkIdType at = First + i / components * stride + i % components;
      this->Buffer[static_cast<std::size_t>(at)] =
        static_cast<T>(array->GetComponent(i / components, static_cast<int>(i % components)));
    }
    this->Made->SetName(array->GetName());
    this->Made->SetNumberOfComponents(components);
    this->Made->SetNumberOfTuples(count);
    this->Made->ConstructBackend(this->Buffer.data(), stride, components, First);
  }

  std::vector<T> Buffer;
  vtkNew<vtkStridedArray<T>> Made;
};

void TestImages()
{
  const Image plain = Waves(), strided = Image::New(), computed = Image::New();
  vtkDataArray* const samples = plain->GetPointData()->GetScalars();
  const Strided<float> spread(samples);
  strided->CopyStructure(plain);
  strided->GetPointData()->SetScalars(spread.Made);
  ExpectSamePicture("strided samples", strided, plain);
  const Image doubles = Waves(VTK_DOUBLE);
  computed->CopyStructure(plain);
  computed->GetPointData()->SetScalars(Computed(doubles->GetPointData()->GetScalars()));
  ExpectSamePicture("computed samples", computed, doubles);
}

/// A copy is kept while its array is, and made again when that changes.
void TestChanges()
{
  const Image doubles = Waves(VTK_DOUBLE), computed = Image::New();
  vtkDataArray* const samples = doubles->GetPointData()->GetScalars();
  const Array array = Computed(samples);
  computed->CopyStructure(doubles);
  computed->GetPointData()->SetScalars(array);
  Scene scene(computed, { 60.0 }), truth(doubles, { 60.0 });
  for (int step = 0; step < 3; ++step)
  {
    for (Scene* of : { &scene, &truth })
    {
      of->LookFrom(1.0, 2.0, 0.7);
      Expect(of->Render(Width, Height), "changes: not rendered");
    }
    Expect(AreIdentical(scene.Color, truth.Color) && AreIdentical(scene.Depth, truth.Depth),
      "changes: another picture");
    for (vtkIdType i = 0; i < samples->GetNumberOfTuples(); i += 3)
    {
      samples->SetComponent(i, 0, samples->GetComponent(i, 0) + 4.0);
    }
    samples->Modified();
    array->Modified();
  }
}

void TestCells()
{
  for (const int type : { VTK_TETRA, VTK_HEXAHEDRON })
  {
    const Grid plain = VtkMeshes::Unstructured(Waves(), type);
    const auto expect = [&](const std::string& name, const std::function<void(Grid&)>& change)
    {
      Grid grid = VtkMeshes::Unstructured(Waves(), type);
      change(grid);
      ExpectSamePicture(name + ", type " + std::to_string(type), grid, plain);
    };
    expect("64 bits of fixed size",
      [](Grid& grid) { grid->GetCells()->ConvertToFixedSize64BitStorage(); });
    expect("32 bits of fixed size",
      [](Grid& grid) { grid->GetCells()->ConvertToFixedSize32BitStorage(); });
    expect("32 bits", [](Grid& grid) { grid->GetCells()->ConvertTo32BitStorage(); });
    expect("types of another array",
      [](Grid& grid)
      {
        vtkNew<vtkShortArray> types;
        types->DeepCopy(VtkMeshes::TypesOf(grid));
        grid->SetCells(types.Get(), grid->GetCells());
      });
    expect("computed types",
      [](Grid& grid)
      { grid->SetCells(Computed(VtkMeshes::TypesOf(grid)).Get(), grid->GetCells()); });
    expect("computed points and values",
      [](Grid& grid)
      {
        grid->GetPoints()->SetData(Computed(grid->GetPoints()->GetData()));
        grid->GetPoints()->Modified();
      });
    vtkCellArray* const cells = plain->GetCells();
    const Strided<vtkTypeInt64> ids(cells->GetConnectivityArray());
    const Strided<vtkTypeInt64> offsets(cells->GetOffsetsArray());
    expect("strided ids",
      [&](Grid& grid)
      {
        grid->GetCells()->SetData(
          static_cast<vtkDataArray*>(offsets.Made), static_cast<vtkDataArray*>(ids.Made));
      });
    const Strided<double> points(plain->GetPoints()->GetData());
    const Strided<float> values(plain->GetPointData()->GetScalars());
    expect("strided points and values",
      [&](Grid& grid)
      {
        grid->GetPoints()->SetData(points.Made);
        grid->GetPointData()->SetScalars(values.Made);
      });
  }
}

#endif

}

int TestStorages(int, char*[])
{
  TestBits();
  TestOneType();
  TestExplicitGrid();
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  TestImages();
  TestChanges();
  TestCells();
#endif
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
