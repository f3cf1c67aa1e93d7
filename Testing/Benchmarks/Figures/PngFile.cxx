// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "PngFile.h"

#include "Measuring.h"

#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>

namespace
{

constexpr int SmallestFile = 9; ///< of zlib's levels

}

void WritePng(vtkImageData* image, const std::string& file)
{
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(file.c_str());
  writer->SetCompressionLevel(SmallestFile);
  writer->Write();
  if (writer->GetErrorCode() != vtkErrorCode::NoError)
  {
    throw Measuring::Failure("Cannot write " + file + ": name a folder that can be written in.");
  }
}
