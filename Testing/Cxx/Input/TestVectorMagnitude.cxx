// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// MAGNITUDE draws the picture of an image of the lengths, which are computed once.

#include "Truth/ColdWitness.h"
#include "Truth/PlainImages.h"

#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkIntArray.h>
#include <vtkSOADataArrayTemplate.h>
#include <vtkShortArray.h>

#include <cmath>
#include <cstdlib>

namespace
{

using namespace PlainImages;

/// Vectors whose length is not that of any component.
template <typename Array>
vtkSmartPointer<Array> Vectors(int n, double scale)
{
  auto vectors = vtkSmartPointer<Array>::New();
  vectors->SetName("vectors");
  vectors->SetNumberOfComponents(3);
  const auto a = Values("a", n, Waves, VTK_DOUBLE), b = Values("b", n, Blob, VTK_DOUBLE);
  vectors->SetNumberOfTuples(a->GetNumberOfTuples());
  for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
  {
    vectors->SetTuple3(i, scale * a->GetTuple1(i), -0.5 * scale * b->GetTuple1(i), scale * 7.0);
  }
  return vectors;
}

template <typename Lengths>
vtkSmartPointer<Lengths> LengthsOf(vtkDataArray* vectors)
{
  auto lengths = vtkSmartPointer<Lengths>::New();
  lengths->SetNumberOfTuples(vectors->GetNumberOfTuples());
  for (vtkIdType i = 0; i < vectors->GetNumberOfTuples(); ++i)
  {
    double v[3];
    vectors->GetTuple(i, v);
    lengths->SetTuple1(i, std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]));
  }
  return lengths;
}

template <typename Array, typename Lengths>
void CheckMagnitude(const std::string& what, double scale = 1.0)
{
  constexpr int N = 33;
  const auto vectors = Vectors<Array>(N, scale);
  Image image = PlainImage(N, nullptr);
  image->GetPointData()->SetVectors(vectors);
  const auto isovalue = [&](Scene& scene) { scene.SetIsovalues({ 60.0 * scale }); };
  Scene scene(image, { 60.0 * scale });
  scene.Mapper->SetScalarModeToUsePointFieldData();
  scene.Mapper->SelectScalarArray("vectors");
  scene.Mapper->SetVectorModeToMagnitude();
  scene.LookFrom(1.0, -2.0, 0.6);
  const auto lengths = LengthsOf<Lengths>(vectors);
  ExpectSame(what, scene, PlainImage(N, lengths), isovalue);
  scene.Render(Size, Size);
  Expect(IsRoute(scene, "Redisplay"), what + ": lengths that are there are not computed again");

  for (const bool isArrayTold : { true, false })
  {
    for (vtkIdType i = 0; i < vectors->GetNumberOfTuples(); ++i)
    {
      vectors->SetComponent(i, 1, 0.0);
      vectors->SetComponent(i, 2, isArrayTold ? 0.0 : 30.0 * scale);
    }
    isArrayTold ? vectors->Modified() : image->Modified();
    ExpectSame(
      what + ", other values", scene, PlainImage(N, LengthsOf<Lengths>(vectors)), isovalue);
  }

  scene.Mapper->SetVectorModeToDisabled();
  Expect(scene.Render(Size, Size), "rendered");
  const auto first = vtkSmartPointer<Array>::New();
  first->SetNumberOfComponents(1);
  first->SetNumberOfTuples(vectors->GetNumberOfTuples());
  for (vtkIdType i = 0; i < vectors->GetNumberOfTuples(); ++i)
  {
    first->SetComponent(i, 0, vectors->GetComponent(i, 0));
  }
  ExpectSame(what + ", component 0 again", scene, PlainImage(N, first), isovalue);
}

void TestMagnitude()
{
  CheckMagnitude<vtkFloatArray, vtkFloatArray>("vectors of float");
  CheckMagnitude<vtkDoubleArray, vtkDoubleArray>("vectors of double");
  CheckMagnitude<vtkShortArray, vtkFloatArray>("vectors of short");
  CheckMagnitude<vtkIntArray, vtkDoubleArray>("vectors of int", 1e6);
  CheckMagnitude<vtkSOADataArrayTemplate<double>, vtkDoubleArray>("component-wise vectors");

  // Squares beyond the range of double.
  constexpr int N = 17;
  const auto small = Vectors<vtkDoubleArray>(N, 1.0), large = Vectors<vtkDoubleArray>(N, 1e200);
  Scene scene(PlainImage(N, small), { 60.0 }), huge(PlainImage(N, large), { 60e200 });
  for (Scene* each : { &scene, &huge })
  {
    each->Mapper->SetVectorModeToMagnitude();
    each->LookFrom(1.0, -2.0, 0.6);
    Expect(each->Render(Size, Size), "rendered");
  }
  int different = 0, hits = 0;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      const float a = scene.DepthAt(x, y), b = huge.DepthAt(x, y);
      hits += !std::isinf(a);
      different += std::isinf(a) != std::isinf(b) || (!std::isinf(a) && std::abs(a - b) > 1e-5f);
    }
  }
  Expect(hits > Size && different <= 1, "lengths of 1e202");

  // Of one component it is the array itself.
  const auto single = Values("single", 33, Waves);
  Scene plain(PlainImage(33, single), { 60.0 });
  plain.LookFrom(1.0, -2.0, 0.6);
  plain.Mapper->SetVectorModeToMagnitude();
  ExpectSame("one component", plain, PlainImage(33, single));

  // The lengths of the vectors of cells.
  const auto ofCells = Vectors<vtkFloatArray>(32, 1.0);
  Image image = PlainImage(33, nullptr);
  image->GetCellData()->SetScalars(ofCells);
  Scene cells(image, { 60.0 });
  cells.LookFrom(1.0, -2.0, 0.6);
  cells.Mapper->SetVectorModeToMagnitude();
  ExpectSame("vectors of cells", cells, Centres(32, LengthsOf<vtkFloatArray>(ofCells)));
}

}

int TestVectorMagnitude(int, char*[])
{
  TestMagnitude();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
