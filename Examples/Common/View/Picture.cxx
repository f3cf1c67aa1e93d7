// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "View/Picture.h"

#include "Program/Quoted.h"
#include "Program/UserError.h"

#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace
{

// Half of the time that the default takes, and hardly more bytes.
constexpr int CompressionLevel = 3;

}

vtkSmartPointer<vtkImageData> OnBackground(
  vtkImageData* rgba, const std::array<double, 3>& bottom, const std::array<double, 3>& top)
{
  int dimensions[3];
  rgba->GetDimensions(dimensions);
  auto rgb = vtkSmartPointer<vtkImageData>::New();
  rgb->SetDimensions(dimensions);
  rgb->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const auto* from = static_cast<const unsigned char*>(rgba->GetScalarPointer());
  auto* to = static_cast<unsigned char*>(rgb->GetScalarPointer());
  for (int y = 0; y < dimensions[1]; ++y)
  {
    const double height = (y + 0.5) / dimensions[1];
    for (int x = 0; x < dimensions[0]; ++x, from += 4, to += 3)
    {
      const double shinesThrough = 1.0 - from[3] / 255.0;
      for (std::size_t c = 0; c < 3; ++c)
      {
        const double back = bottom[c] + height * (top[c] - bottom[c]);
        to[c] = static_cast<unsigned char>(std::lround(from[c] + shinesThrough * back));
      }
    }
  }
  return rgb;
}

vtkSmartPointer<vtkImageData> WithoutBackground(vtkImageData* rgba)
{
  auto straight = vtkSmartPointer<vtkImageData>::New();
  straight->SetDimensions(rgba->GetDimensions());
  straight->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  const auto* from = static_cast<const unsigned char*>(rgba->GetScalarPointer());
  auto* to = static_cast<unsigned char*>(straight->GetScalarPointer());
  for (vtkIdType i = 0; i < rgba->GetNumberOfPoints(); ++i, from += 4, to += 4)
  {
    const double alpha = std::max(from[3] / 255.0, 1.0 / 255.0);
    for (int c = 0; c < 3; ++c)
    {
      to[c] = static_cast<unsigned char>(std::lround(std::min(from[c] / alpha, 255.0)));
    }
    to[3] = from[3];
  }
  return straight;
}

void WritePng(vtkImageData* picture, const std::string& path, const std::string& remedy)
{
  // Not by VTK: it takes any error for a full disk, of which libpng prints lines of its own.
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture);
  writer->SetCompressionLevel(CompressionLevel);
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* const png = writer->GetResult();
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  const bool isOpen = file.is_open();
  file.write(reinterpret_cast<const char*>(png->GetPointer(0)), png->GetNumberOfValues());
  file.close();
  if (!file)
  {
    const std::string reason = errno ? std::strerror(errno) : "it ends too early";
    if (isOpen && std::filesystem::is_regular_file(path))
    {
      std::remove(path.c_str());
    }
    throw UserError(
      Quoted(path) + " could not be written (" + reason + "); make room, or " + remedy + ".");
  }
}
