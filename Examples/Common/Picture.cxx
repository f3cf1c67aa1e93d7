// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Picture.h"

#include "Silence.h"
#include "UserError.h"

#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>

#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstring>
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

void WritePng(vtkImageData* picture, const std::string& path, const std::string& remedy)
{
  // VTK takes any error in opening a file for a full disk.
  errno = 0;
  if (!std::ofstream(path, std::ios::binary))
  {
    throw UserError(
      "'" + path + "' could not be written (" + std::strerror(errno) + "); " + remedy + ".");
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(picture);
  writer->SetFileName(path.c_str());
  writer->SetCompressionLevel(CompressionLevel);
  {
    const Silence silence;
    writer->Write();
  }
  if (writer->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw UserError("'" + path + "' could not be written (" +
      vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode()) + "); make room, or " + remedy +
      ".");
  }
}
