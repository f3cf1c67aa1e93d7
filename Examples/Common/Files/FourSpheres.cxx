// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/FourSpheres.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <cmath>

namespace
{

constexpr double Centres[4][3] = { { -0.4, -0.4, -0.2 }, { 0.45, -0.3, 0.3 }, { -0.3, 0.45, 0.35 },
  { 0.35, 0.4, -0.4 } };
constexpr double Radius = 0.6;

unsigned char ValueAt(double x, double y, double z)
{
  double value = 0.0;
  for (const double* centre : Centres)
  {
    const double distance = std::hypot(x - centre[0], y - centre[1], z - centre[2]);
    value = std::max(value, 1.0 - distance / Radius);
  }
  return static_cast<unsigned char>(255.0 * value);
}

}

vtkSmartPointer<vtkImageData> MakeFourSpheres(int samplesPerAxis)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(samplesPerAxis, samplesPerAxis, samplesPerAxis);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  const double step = 2.0 / std::max(samplesPerAxis - 1, 1);
  vtkSMPTools::For(0, samplesPerAxis,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType k = begin; k < end; ++k)
      {
        auto* sample =
          static_cast<unsigned char*>(image->GetScalarPointer(0, 0, static_cast<int>(k)));
        for (int j = 0; j < samplesPerAxis; ++j)
        {
          for (int i = 0; i < samplesPerAxis; ++i)
          {
            *sample++ =
              ValueAt(-1.0 + step * i, -1.0 + step * j, -1.0 + step * static_cast<double>(k));
          }
        }
      }
    });
  return image;
}
