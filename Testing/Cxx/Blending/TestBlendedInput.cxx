// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Blended volumes take components, wherever an array stores them, blocks, and rectilinear grids.
// Cropping, clipping and masks cut them.

#include "BlendedScene.h"
#include "Checks/Expect.h"

#include <vtkExtractVOI.h>
#include <vtkFloatArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkSOADataArrayTemplate.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <string>

namespace
{

constexpr int Size = 60;
constexpr int Maximum = vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND;

/// An image on [-1, 1]^3 whose component c is value(c, x, y, z).
vtkSmartPointer<vtkImageData> Components(
  int n, int count, const std::function<double(int, double, double, double)>& value)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, n, n);
  image->SetOrigin(-1.0, -1.0, -1.0);
  image->SetSpacing(2.0 / (n - 1), 2.0 / (n - 1), 2.0 / (n - 1));
  image->AllocateScalars(VTK_FLOAT, count);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* at = image->GetPoint(i);
    for (int c = 0; c < count; ++c)
    {
      image->GetPointData()->GetScalars()->SetComponent(i, c, value(c, at[0], at[1], at[2]));
    }
  }
  return image;
}

double Ball(int component, double x, double y, double z)
{
  const double centre = 0.3 * component - 0.4;
  return 200.0 + 10.0 * component - 150.0 * std::hypot(x - centre, y + 0.5 * centre, z);
}

/// The samples of an image between two places along x.
vtkSmartPointer<vtkImageData> Part(vtkImageData* whole, int first, int last)
{
  vtkNew<vtkExtractVOI> extract;
  extract->SetInputData(whole);
  extract->SetVOI(first, last, 0, 31, 0, 31);
  extract->Update();
  return extract->GetOutput();
}

void LookAtCube(Scene& scene)
{
  scene.LookFrom(1.0, 2.0, 0.5);
}

void ExpectSamePicture(Scene& a, Scene& b, const std::string& what)
{
  Expect(a.Render(Size, Size) && b.Render(Size, Size), what + ": frames");
  int seen = 0;
  for (int i = 0; i < Size * Size; ++i)
  {
    seen += a.ColorAt(i % Size, i / Size)[3] != 0;
  }
  Expect(seen > 200 && AreIdentical(a.Color, b.Color) && AreIdentical(a.Depth, b.Depth), what);
}

/// A component of several, by itself, looks as an image of it alone.
void TestOneComponent(int mode)
{
  const auto vectors = Components(24, 3, Ball);
  const auto second =
    Components(24, 1, [](int, double x, double y, double z) { return Ball(1, x, y, z); });
  BlendedScene alone(mode, second), chosen(mode, vectors);
  LookAtCube(alone);
  LookAtCube(chosen);
  chosen.Mapper->SetVectorModeToComponent();
  chosen.Mapper->SetVectorComponent(1);
  ExpectSamePicture(alone, chosen, NameOfMode(mode) + ", one component");

  chosen.Mapper->SetVectorModeToMagnitude();
  const auto lengths = Components(24, 1,
    [](int, double x, double y, double z)
    {
      double sum = 0.0;
      for (int c = 0; c < 3; ++c)
      {
        const double value = static_cast<float>(Ball(c, x, y, z));
        sum += value * value;
      }
      return std::sqrt(sum);
    });
  BlendedScene magnitude(mode, lengths);
  LookAtCube(magnitude);
  ExpectSamePicture(magnitude, chosen, NameOfMode(mode) + ", magnitude");
}

/// Independent components, each with functions and a weight of its own: their pictures add up.
void TestIndependent()
{
  const auto vectors = Components(24, 4, Ball);
  BlendedScene all(Maximum, vectors);
  LookAtCube(all);
  std::array<std::array<double, 4>, static_cast<std::size_t>(Size * Size)> sum{};
  vtkVolumeProperty* property = all.Volume->GetProperty();
  for (int c = 0; c < 4; ++c)
  {
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(0.0, c == 0, c == 1, c == 2);
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(50.0, 0.0);
    opacity->AddPoint(250.0, 0.5 + 0.1 * c);
    const double weight = 0.1 + 0.1 * c;
    property->SetColor(c, color);
    property->SetScalarOpacity(c, opacity);
    property->SetComponentWeight(c, weight);
    const auto image =
      Components(24, 1, [c](int, double x, double y, double z) { return Ball(c, x, y, z); });
    BlendedScene one(Maximum, image);
    LookAtCube(one);
    one.Volume->GetProperty()->SetColor(color);
    one.Volume->GetProperty()->SetScalarOpacity(opacity);
    Expect(one.Render(Size, Size), "one component");
    for (int i = 0; i < Size * Size; ++i)
    {
      for (std::size_t channel = 0; channel < 4; ++channel)
      {
        sum[static_cast<std::size_t>(i)][channel] +=
          weight * one.ColorAt(i % Size, i / Size)[channel];
      }
    }
  }
  Expect(all.Render(Size, Size), "all components");
  int different = 0;
  for (int i = 0; i < Size * Size; ++i)
  {
    for (std::size_t channel = 0; channel < 4; ++channel)
    {
      different += std::abs(sum[static_cast<std::size_t>(i)][channel] -
                     all.ColorAt(i % Size, i / Size)[channel]) > 2.0;
    }
  }
  Expect(different == 0, "independent components: " + std::to_string(different) + " differ");
}

/// Samples of a component that lie apart, or beside one another, are the same.
void TestArrays(int mode)
{
  const auto vectors = Components(24, 3, Ball);
  const auto apart = vtkSmartPointer<vtkImageData>::New();
  apart->CopyStructure(vectors);
  vtkNew<vtkSOADataArrayTemplate<float>> array;
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(vectors->GetNumberOfPoints());
  array->DeepCopy(vectors->GetPointData()->GetScalars());
  array->SetName("apart");
  apart->GetPointData()->SetScalars(array);
  BlendedScene a(mode, vectors), b(mode, apart);
  for (BlendedScene* scene : { &a, &b })
  {
    LookAtCube(*scene);
    scene->Mapper->SetVectorModeToComponent();
    scene->Mapper->SetVectorComponent(2);
  }
  ExpectSamePicture(a, b, NameOfMode(mode) + ", an array by components");
  a.Mapper->SetVectorModeToDisabled();
  b.Mapper->SetVectorModeToDisabled();
  ExpectSamePicture(a, b, NameOfMode(mode) + ", all components by components");
}

/// Two blocks of an image, and an image as a rectilinear grid, look as the image.
void TestShapes(int mode)
{
  const auto whole = Volumes::FourSpheres(32);
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (int half = 0; half < 2; ++half)
  {
    const auto part = Part(whole, half * 16, half == 0 ? 16 : 31);
    blocks->SetBlock(static_cast<unsigned int>(half), part);
  }
  BlendedScene image(mode, whole), merged(mode);
  merged.Mapper->SetInputDataObject(blocks);
  ExpectSamePicture(image, merged, NameOfMode(mode) + ", blocks");
  vtkNew<vtkRectilinearGrid> grid;
  grid->SetDimensions(32, 32, 32);
  vtkNew<vtkFloatArray> places;
  for (int i = 0; i < 32; ++i)
  {
    places->InsertNextValue(static_cast<float>(i - 1)); // as the image
  }
  grid->SetXCoordinates(places);
  grid->SetYCoordinates(places);
  grid->SetZCoordinates(places);
  grid->GetPointData()->SetScalars(whole->GetPointData()->GetScalars());
  BlendedScene rectilinear(mode);
  rectilinear.Mapper->SetInputData(grid);
  Expect(image.Render(Size, Size) && rectilinear.Render(Size, Size), "frames");
  int different = 0;
  for (int i = 0; i < Size * Size * 4; ++i)
  {
    const int pixel = i / 4;
    different += std::abs(image.ColorAt(pixel % Size, pixel / Size)[i % 4] -
                   rectilinear.ColorAt(pixel % Size, pixel / Size)[i % 4]) > 1;
  }
  Expect(different < 4,
    NameOfMode(mode) + ", a rectilinear grid: " + std::to_string(different) + " channels differ");
}

/// Cropping to a box, planes that clip the same box, and an image of that box.
void TestParts(int mode)
{
  const auto whole = Volumes::FourSpheres(32);
  const auto part = Part(whole, 0, 20);
  BlendedScene box(mode, part), cropped(mode, whole), clipped(mode, whole);
  cropped.Mapper->CroppingOn();
  cropped.Mapper->SetCroppingRegionPlanes(-1.0, 19.0, -1.0, 40.0, -1.0, 40.0);
  cropped.Mapper->SetCroppingRegionFlagsToSubVolume();
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(19.0, 0.0, 0.0);
  plane->SetNormal(-1.0, 0.0, 0.0);
  clipped.Mapper->AddClippingPlane(plane);
  Expect(box.Render(Size, Size) && cropped.Render(Size, Size) && clipped.Render(Size, Size),
    "parts are drawn");
  int byCropping = 0, byClipping = 0;
  for (int i = 0; i < Size * Size * 4; ++i)
  {
    const int x = i / 4 % Size, y = i / 4 / Size, c = i % 4;
    byCropping += std::abs(box.ColorAt(x, y)[c] - cropped.ColorAt(x, y)[c]) > 1;
    byClipping += std::abs(box.ColorAt(x, y)[c] - clipped.ColorAt(x, y)[c]) > 1;
  }
  Expect(byCropping < 8 && byClipping < 8,
    NameOfMode(mode) + ": " + std::to_string(byCropping) + " channels differ by cropping, " +
      std::to_string(byClipping) + " by clipping");
}

/// A mask that shows half of the samples hides the cells of the others.
void TestMask(int mode)
{
  const auto whole = Volumes::FourSpheres(32);
  vtkNew<vtkImageData> mask;
  const auto part = Part(whole, 0, 20);
  mask->SetDimensions(32, 32, 32);
  mask->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  for (vtkIdType i = 0; i < mask->GetNumberOfPoints(); ++i)
  {
    mask->GetPointData()->GetScalars()->SetComponent(i, 0, i % 32 < 20 ? 1.0 : 0.0);
  }
  BlendedScene masked(mode, whole), box(mode, part);
  masked.Mapper->SetMaskInput(mask);
  masked.Mapper->SetMaskTypeToBinary();
  Expect(masked.Render(Size, Size) && box.Render(Size, Size), "a mask");
  int different = 0;
  for (int i = 0; i < Size * Size * 4; ++i)
  {
    const int x = i / 4 % Size, y = i / 4 / Size, c = i % 4;
    different += std::abs(box.ColorAt(x, y)[c] - masked.ColorAt(x, y)[c]) > 1;
  }
  Expect(different < 8, NameOfMode(mode) + ", mask: " + std::to_string(different) + " differ");
}

/// Window and level change the blended colours, as VTK's shader does it.
void TestWindowAndLevel(int mode)
{
  BlendedScene plain(mode), spread(mode);
  spread.Mapper->SetFinalColorWindow(0.5f);
  spread.Mapper->SetFinalColorLevel(0.4f);
  Expect(plain.Render(Size, Size) && spread.Render(Size, Size), "frames");
  int different = 0;
  for (int i = 0; i < Size * Size; ++i)
  {
    const unsigned char* before = plain.ColorAt(i % Size, i / Size);
    const unsigned char* after = spread.ColorAt(i % Size, i / Size);
    for (int c = 0; c < 3; ++c)
    {
      const double expected = before[c] * 2.0 + (0.5 - 0.4 / 0.5) * before[3];
      different += std::abs(std::min(std::max(expected, 0.0), 255.0) - after[c]) > 2.0;
    }
    different += before[3] != after[3];
  }
  Expect(different == 0, NameOfMode(mode) + ", window and level: " + std::to_string(different));
}

}

int TestBlendedInput(int, char*[])
{
  for (const int mode : BlendModes)
  {
    TestOneComponent(mode);
    TestArrays(mode);
    TestShapes(mode);
    if (!IsGrey(mode)) // a part has a range of its own
    {
      TestParts(mode);
      TestMask(mode);
    }
    TestWindowAndLevel(mode);
  }
  TestIndependent();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
