// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Volumes.h"

#include <vtkDataArray.h>
#include <vtkMetaImageReader.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>
#include <vtkStructuredPoints.h>
#include <vtkStructuredPointsReader.h>
#include <vtkXMLImageDataReader.h>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace Volumes
{
namespace
{

constexpr double Pi = 3.14159265358979323846;

template <typename Reader>
vtkSmartPointer<vtkImageData> Read(const std::string& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  return image;
}

/// Samples a side of a volume made by formula, from a name such as "spheres256"; 0 if the name is
/// not of that kind, or the size not one that can be made.
int SizeBehind(const std::string& kind, const std::string& name)
{
  constexpr std::size_t mostDigits = 4;
  const std::string digits = name.rfind(kind, 0) == 0 ? name.substr(kind.size()) : "";
  const bool isNumber = !digits.empty() && digits.size() <= mostDigits &&
    digits.find_first_not_of("0123456789") == std::string::npos;
  const int size = isNumber ? std::atoi(digits.c_str()) : 0;
  return size >= 2 && size <= LargestSize ? size : 0;
}

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

}

vtkSmartPointer<vtkImageData> FromFormula(
  int n, int scalarType, const std::function<double(double, double, double)>& value)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, n, n);
  const double step = 2.0 / (n - 1);
  image->SetSpacing(step, step, step);
  image->SetOrigin(-1.0, -1.0, -1.0);
  image->AllocateScalars(scalarType, 1);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  vtkSMPTools::For(0, n,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType k = begin; k < end; ++k)
      {
        for (vtkIdType j = 0; j < n; ++j)
        {
          for (vtkIdType i = 0; i < n; ++i)
          {
            scalars->SetComponent((k * n + j) * n + i, 0,
              value(-1.0 + step * static_cast<double>(i), -1.0 + step * static_cast<double>(j),
                -1.0 + step * static_cast<double>(k)));
          }
        }
      }
    });
  return image;
}

vtkSmartPointer<vtkImageData> Waves()
{
  return Volumes::FromFormula(32, VTK_SHORT,
    [](double x, double y, double z)
    { return 1000.0 * (std::sin(5.0 * x) * std::cos(4.0 * y) + 0.7 * z); });
}

vtkSmartPointer<vtkImageData> Noise(int n, int scalarType, double low, double high)
{
  // Samples are made in parallel, in no order: each must be a function of its place.
  return FromFormula(n, scalarType,
    [low, high](double x, double y, double z)
    {
      const double place = std::sin(12.9898 * x + 78.233 * y + 37.719 * z) * 43758.5453;
      return low + (high - low) * (place - std::floor(place));
    });
}

vtkSmartPointer<vtkImageData> FourSpheres(int n)
{
  constexpr std::array<std::array<double, 3>, 4> centres = { { { -.4, -.4, -.2 }, { .45, -.3, .3 },
    { -.3, .45, .35 }, { .35, .4, -.4 } } };
  auto image = FromFormula(n, VTK_UNSIGNED_CHAR,
    [&centres](double x, double y, double z)
    {
      double value = 0.0;
      for (const std::array<double, 3>& c : centres)
      {
        value = std::max(value, 1.0 - std::hypot(x - c[0], y - c[1], z - c[2]) / 0.6);
      }
      return 255.0 * value;
    });
  image->SetSpacing(1.0, 1.0, 1.0);
  return image;
}

vtkSmartPointer<vtkImageData> MarschnerLobb(int n)
{
  auto image = FromFormula(n, VTK_UNSIGNED_CHAR,
    [](double x, double y, double z)
    {
      const double rho = std::cos(12.0 * Pi * std::cos(0.5 * Pi * std::hypot(x, y)));
      return 255.0 * ((1.0 - std::sin(0.5 * Pi * z)) + 0.25 * (1.0 + rho)) / 2.5;
    });
  image->SetSpacing(1.0, 1.0, 1.0);
  return image;
}

std::string DataDirectory()
{
  const char* named = std::getenv("TEMPORAL_COHERENCE_DATA");
  return named ? named : "";
}

vtkSmartPointer<vtkImageData> Load(const std::string& name)
{
  if (const int size = SizeBehind("spheres", name))
  {
    return FourSpheres(size);
  }
  if (const int size = SizeBehind("marschner-lobb", name))
  {
    return MarschnerLobb(size);
  }
  if (const int size = SizeBehind("noise", name))
  {
    return Noise(size, VTK_UNSIGNED_CHAR, 0.0, 256.0);
  }
  const std::string folder =
    EndsWith(name, ".nii.gz") ? "/usr/share/mricron/templates" : DataDirectory();
  const std::string path = folder + "/" + name;
  if (folder.empty() || !vtksys::SystemTools::FileExists(path, true))
  {
    return nullptr;
  }
  return EndsWith(name, ".vti") ? Read<vtkXMLImageDataReader>(path)
    : EndsWith(name, ".mhd")    ? Read<vtkMetaImageReader>(path)
    : EndsWith(name, ".nii.gz") ? Read<vtkNIFTIImageReader>(path)
                                : Read<vtkStructuredPointsReader>(path);
}

}
