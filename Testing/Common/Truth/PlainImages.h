// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_PlainImages_h
#define Testing_PlainImages_h

#include "Truth/ExpectSame.h"
#include "Volumes/Volumes.h"

#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <cmath>
#include <functional>

/// Images of points that other inputs are compared with, to the last bit.
namespace PlainImages
{

using Image = vtkSmartPointer<vtkImageData>;

constexpr int Size = 90; ///< of pictures

inline double Waves(double x, double y, double z)
{
  return 50.0 + 45.0 * std::sin(3.0 * x + y) * std::cos(2.0 * z - y);
}

inline double Blob(double x, double y, double z)
{
  return 100.0 - 60.0 * (x * x + 2.0 * y * y + 0.5 * z * z + 0.3 * x * y - 0.4 * z);
}

/// An array of values of the points or cells of a box of n^3.
inline vtkSmartPointer<vtkDataArray> Values(
  const std::string& name, int n, double (*value)(double, double, double), int type = VTK_FLOAT)
{
  Image image = Volumes::FromFormula(n, type, value);
  vtkSmartPointer<vtkDataArray> array = image->GetPointData()->GetScalars();
  array->SetName(name.c_str());
  return array;
}

inline Image PlainImage(int n, vtkDataArray* scalars)
{
  auto image = Image::New();
  image->SetDimensions(n, n, n);
  image->SetSpacing(0.0625, 0.0625, 0.0625); // sums of it are exact
  image->SetOrigin(-1.0, -1.0, -1.0);
  image->GetPointData()->SetScalars(scalars);
  return image;
}

/// The image of points at the centres of the cells of a PlainImage.
inline Image Centres(int cells, vtkDataArray* scalars)
{
  Image image = PlainImage(cells, scalars);
  image->SetOrigin(-0.96875, -0.96875, -0.96875);
  return image;
}

/// The scene shows the same as a plain image.
inline void ExpectSame(const std::string& what, Scene& scene, vtkImageData* plain,
  const std::function<void(Scene&)>& arrange = {})
{
  Scene reference(plain, { 60.0 });
  reference.Mapper->SetSurfaceMode(scene.Mapper->GetSurfaceMode());
  reference.Mapper->SetShadows(scene.Mapper->GetShadows());
  if (arrange)
  {
    arrange(reference);
  }
  ::ExpectSame(what, scene, reference, Size);
}

}

#endif
