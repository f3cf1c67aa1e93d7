// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/RawReader.h"

#include "Files/FileCheck.h"
#include "Program/Quoted.h"

#include <vtkDataArray.h>
#include <vtkImageReader2.h>

#include <cstdint>
#include <sstream>

void RequireRawSize(const std::string& path, const RawLayout& layout)
{
  double wanted = static_cast<double>(vtkDataArray::GetDataTypeSize(layout.ScalarType));
  for (const int n : layout.Dimensions)
  {
    wanted *= static_cast<double>(n);
  }
  const std::uintmax_t there = SizeOf(path);
  if (static_cast<double>(there) != wanted)
  {
    std::ostringstream what;
    what.precision(15);
    what << Quoted(path) << " has " << there << " bytes, but --raw tells of " << wanted
         << "; correct the dimensions or the type.";
    throw UserError(what.str());
  }
}

vtkSmartPointer<vtkImageData> ReadRaw(const std::string& path, const RawLayout& layout,
  bool isBigEndian, const ReadingProgress& progress)
{
  RequireRawSize(path, layout);
  vtkNew<vtkImageReader2> reader;
  reader->SetFileName(path.c_str());
  reader->SetFileDimensionality(3);
  reader->SetDataExtent(
    0, layout.Dimensions[0] - 1, 0, layout.Dimensions[1] - 1, 0, layout.Dimensions[2] - 1);
  reader->SetDataSpacing(layout.Spacing.data());
  reader->SetDataScalarType(layout.ScalarType);
  reader->SetNumberOfScalarComponents(1);
  // Rows in the order they have in the file, whatever the byte order.
  reader->FileLowerLeftOn();
  if (isBigEndian)
  {
    reader->SetDataByteOrderToBigEndian();
  }
  else
  {
    reader->SetDataByteOrderToLittleEndian();
  }
  Watch(reader, progress).Update(path);
  return reader->GetOutput();
}
