// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// usage: CheckPicture PNG...   Fails if a picture shows nothing: a file that is not there or
// cannot be read, or a picture in which (nearly) every row is of one colour, as a background is.
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>

#include <cstdio>
#include <cstring>
#include <filesystem>

namespace
{

// A surface has to show in this share of the rows.
constexpr double LeastShare = 0.1;

bool RowVaries(vtkImageData* image, int y, int width)
{
  const auto bytes = static_cast<std::size_t>(image->GetNumberOfScalarComponents());
  const auto* row = static_cast<const unsigned char*>(image->GetScalarPointer(0, y, 0));
  for (std::size_t x = 1; x < static_cast<std::size_t>(width); ++x)
  {
    if (std::memcmp(row, row + x * bytes, bytes) != 0)
    {
      return true;
    }
  }
  return false;
}

bool ShowsSomething(const char* path)
{
  vtkNew<vtkPNGReader> reader;
  if (!std::filesystem::exists(path) || !reader->CanReadFile(path))
  {
    std::printf("%s: not there, or not a PNG file\n", path);
    return false;
  }
  reader->SetFileName(path);
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  int size[3];
  image->GetDimensions(size);
  int rows = 0;
  for (int y = 0; y < size[1]; ++y)
  {
    rows += RowVaries(image, y, size[0]) ? 1 : 0;
  }
  std::printf("%s: %d x %d, %d rows with something in them\n", path, size[0], size[1], rows);
  return size[1] > 0 && rows >= LeastShare * size[1];
}

}

int main(int argc, char* argv[])
{
  bool isGood = argc > 1;
  for (int i = 1; i < argc; ++i)
  {
    isGood = ShowsSomething(argv[i]) && isGood;
  }
  return isGood ? 0 : 1;
}
