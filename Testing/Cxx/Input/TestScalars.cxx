// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Samples of all scalar types, of one of several components, in arrays by name and in
// component-wise memory, NaN among them, agree with brute force.

#include "Checks/Expect.h"
#include "Scenes/Scene.h"
#include "Truth/Agreement.h"
#include "Volumes/Volumes.h"

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkPointData.h>
#include <vtkSOADataArrayTemplate.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

namespace
{

constexpr int N = 40;

double Value(double x, double y, double z)
{
  return std::floor(50.0 + 45.0 * std::sin(3.0 * x + y) * std::cos(2.0 * z - y));
}

/// The same whole numbers in every type: the same hits.
void TestTypes()
{
  Scene reference(Volumes::FromFormula(N, VTK_DOUBLE, Value), { 42.5 });
  reference.LookFrom(1.0, -2.0, 0.6);
  Expect(reference.Render(200, 200), "the reference is rendered");
  for (const int type : { VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
         VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
         VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT })
  {
    vtkSmartPointer<vtkImageData> image = Volumes::FromFormula(N, type, Value);
    Scene scene(image, { 42.5 });
    scene.LookFrom(1.0, -2.0, 0.6);
    Expect(scene.Render(200, 200), std::string(image->GetScalarTypeAsString()) + ": rendered");
    int different = 0;
    for (int y = 0; y < 200; ++y)
    {
      for (int x = 0; x < 200; ++x)
      {
        const float a = scene.DepthAt(x, y), b = reference.DepthAt(x, y);
        different +=
          std::isinf(a) != std::isinf(b) || (!std::isinf(a) && std::abs(a - b) > 1e-3f * 2.0f / N);
      }
    }
    Expect(different <= 4,
      std::string(image->GetScalarTypeAsString()) + ": " + std::to_string(different) +
        " pixels differ from double");
  }
}

/// Whatever the scale of the values: every normal has unit length.
void ExpectUnitNormals(Scene& scene, const std::string& what)
{
  int size[3], hits = 0, wrong = 0;
  scene.Depth->GetDimensions(size);
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      double normal[3];
      if (scene.Mapper->PickPixel(x, y, nullptr, normal, nullptr))
      {
        ++hits;
        wrong += !(std::abs(std::hypot(normal[0], normal[1], normal[2]) - 1.0) < 1e-5);
      }
    }
  }
  Expect(hits > 0 && wrong == 0,
    what + ": " + std::to_string(wrong) + " of " + std::to_string(hits) +
      " normals have no unit length");
}

/// Small differences on a large offset need the full precision of the samples.
void TestOffsets()
{
  for (const int type : { VTK_FLOAT, VTK_DOUBLE, VTK_INT, VTK_LONG_LONG })
  {
    const double offset = type == VTK_FLOAT ? 1e5 : type == VTK_INT ? 2e9 : 1e12;
    vtkSmartPointer<vtkImageData> image = Volumes::FromFormula(
      N, type, [offset](double x, double y, double z) { return offset + Value(x, y, z); });
    Scene scene(image, { offset + 42.3 });
    scene.LookFrom(1.0, -2.0, 0.6);
    BruteForceTracer truth(image, scene.Volume);
    truth.Isovalues = { offset + 42.3 };
    ExpectColdTruth(
      std::string("large offset, ") + image->GetScalarTypeAsString(), scene, truth, 120, 120);
  }
  for (const double scale : { 1e-36, 1e-200, 1e30, 1e200 })
  {
    vtkSmartPointer<vtkImageData> image = Volumes::FromFormula(
      N, VTK_DOUBLE, [scale](double x, double y, double z) { return scale * Value(x, y, z); });
    Scene scene(image, { 42.3 * scale });
    scene.LookFrom(1.0, -2.0, 0.6);
    BruteForceTracer truth(image, scene.Volume);
    truth.Isovalues = { 42.3 * scale };
    ExpectColdTruth("values times " + std::to_string(std::log10(scale)), scene, truth, 90, 90);
    ExpectUnitNormals(scene, "values times " + std::to_string(std::log10(scale)));
  }
}

vtkSmartPointer<vtkDataArray> Components(vtkDataArray* array, vtkDataArray* into)
{
  into->SetNumberOfComponents(3);
  into->SetNumberOfTuples(array->GetNumberOfTuples());
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    const double value = array->GetComponent(i, 0);
    into->SetTuple3(i, -value, value, 2.0 * value);
  }
  into->SetName("three");
  return into;
}

/// The components of an array in memory of their own. (Since VTK 9.3, an array of separate
/// components that was filled value by value keeps them together.)
vtkSmartPointer<vtkDataArray> InOwnMemory(
  vtkDataArray* tuples, std::array<std::vector<float>, 3>& memory)
{
  const auto separate = vtkSmartPointer<vtkSOADataArrayTemplate<float>>::New();
  separate->SetNumberOfComponents(3);
  separate->SetName(tuples->GetName());
  for (int c = 0; c < 3; ++c)
  {
    std::vector<float>& values = memory[static_cast<std::size_t>(c)];
    for (vtkIdType i = 0; i < tuples->GetNumberOfTuples(); ++i)
    {
      values.push_back(static_cast<float>(tuples->GetComponent(i, c)));
    }
    separate->SetArray(c, values.data(), tuples->GetNumberOfTuples(), true, true);
  }
  return separate;
}

/// Component 1 of three holds the values, interleaved or not; the array is chosen by name.
void TestComponents()
{
  vtkSmartPointer<vtkImageData> image = Volumes::FromFormula(N, VTK_FLOAT, Value);
  Scene reference(image, { 42.5 });
  reference.LookFrom(1.0, -2.0, 0.6);
  Expect(reference.Render(200, 200), "the reference is rendered");

  vtkNew<vtkFloatArray> interleaved;
  vtkNew<vtkSOADataArrayTemplate<float>> separate;
  vtkDataArray* values = image->GetPointData()->GetScalars();
  std::array<std::vector<float>, 3> memory;
  const auto own = InOwnMemory(Components(values, vtkNew<vtkFloatArray>()), memory);
  const std::vector<vtkSmartPointer<vtkDataArray>> arrays = { Components(values, interleaved),
    Components(values, separate), own };
  for (vtkDataArray* array : arrays)
  {
    vtkNew<vtkImageData> several;
    several->CopyStructure(image);
    several->GetPointData()->AddArray(array);
    Scene scene(several, { 42.5 });
    scene.Mapper->SetScalarModeToUsePointFieldData();
    scene.Mapper->SelectScalarArray("three");
    scene.Mapper->SetVectorMode(vtkTemporalCoherenceVolumeMapper::COMPONENT);
    scene.Mapper->SetVectorComponent(1);
    scene.LookFrom(1.0, -2.0, 0.6);
    Expect(scene.Render(200, 200), "rendered");
    Expect(AreIdentical(scene.Depth, reference.Depth) && AreIdentical(scene.Color, reference.Color),
      std::string("component 1 of a ") + array->GetClassName());
    scene.Mapper->SetVectorComponent(2);
    Expect(scene.Render(200, 200) && !AreIdentical(scene.Depth, reference.Depth),
      "another component is another picture");
  }
}

/// Cells with a sample that is not a number are hidden; infinities count as what they are.
void TestNotFinite()
{
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    vtkSmartPointer<vtkImageData> image =
      Volumes::FromFormula(9, type, [](double, double, double) { return 5.0; });
    vtkDataArray* scalars = image->GetPointData()->GetScalars();
    Scene scene(image, { 3.0 });
    scene.LookFrom(0.0, 0.0, 1.0);
    Expect(scene.Render(99, 99), "rendered");
    Expect(std::isinf(scene.DepthAt(49, 49)), "5 everywhere: no crossing of 3");

    scalars->SetComponent(4 * 81 + 4 * 9 + 4, 0, std::numeric_limits<double>::quiet_NaN());
    image->Modified();
    Expect(scene.Render(99, 99), "rendered");
    Expect(!scene.Mapper->PickPixel(49, 49, nullptr, nullptr, nullptr),
      "no surface around the sample that is not a number");
    scene.Mapper->SetSurfaceModeToThreshold();
    Expect(scene.Render(99, 99), "rendered");
    Expect(scene.Mapper->PickPixel(49, 49, nullptr, nullptr, nullptr), "the solid is capped");
    scene.Mapper->SetSurfaceModeToCrossing();

    scalars->SetComponent(4 * 81 + 4 * 9 + 4, 0, std::numeric_limits<double>::infinity());
    image->Modified();
    scene.SetIsovalues({ 1e20 });
    Expect(scene.Render(99, 99), "rendered");
    int isovalue = -1;
    double position[3] = {}, normal[3] = {};
    Expect(scene.Mapper->PickPixel(49, 49, position, normal, &isovalue) && isovalue == 0 &&
        position[2] > 0.0 && position[2] < 0.25,
      "infinity is above 1e20");
    Expect(std::abs(std::hypot(normal[0], normal[1], normal[2]) - 1.0) < 1e-5,
      "with a normal of unit length");
  }
}

}

int TestScalars(int, char*[])
{
  // The Debug driver traps operations on what is not a number, which is what is tested here.
  vtkFloatingPointExceptions::Disable();
  TestTypes();
  TestOffsets();
  TestComponents();
  TestNotFinite();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
