// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Writes the slices that VTK's medical examples read: quarter.1 to quarter.93, each of 64 x 64
// numbers of 16 bits. They are those of VTK's CT head (headsq.vti) where it is there; else another
// volume takes its place, with values that fit the examples' isovalues. Says which.
//
// usage: HeadSlices FOLDER [--generated]

#include "Volumes/Volumes.h"

#include <vtkImageData.h>
#include <vtkImageResize.h>
#include <vtkNew.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iostream>
#include <string>

namespace
{

constexpr std::array<int, 3> Size = { 64, 64, 93 };
constexpr double Skin = 500.0; ///< isovalue of the examples

/// A volume, and the isovalue at which it has the examples' skin.
struct Source
{
  std::string Name;
  vtkSmartPointer<vtkImageData> Image;
  double Isovalue = Skin;
  bool IsUpsideDown = false; ///< in the examples' views
};

Source Find(bool isGenerated)
{
  if (!isGenerated)
  {
    if (const auto head = Volumes::Load("headsq.vti"))
    {
      return { "VTK's CT head", head };
    }
    if (const auto head = Volumes::Load("ch2.nii.gz"))
    {
      return { "an MR head (Debian's mricron-data) in place of VTK's CT head", head, 45.0, true };
    }
  }
  return { "four generated spheres in place of VTK's CT head", Volumes::FourSpheres(64), 100.0 };
}

/// With as many samples as the examples expect.
vtkSmartPointer<vtkImageData> Resized(vtkImageData* image)
{
  vtkNew<vtkImageResize> resize;
  resize->SetInputData(image);
  resize->SetOutputDimensions(Size[0], Size[1], Size[2]);
  resize->Update();
  return resize->GetOutput();
}

/// The examples' reader takes the last row first, and the lower byte first.
bool WriteSlice(const Source& source, vtkImageData* image, int slice, const std::string& path)
{
  std::ofstream file(path, std::ios::binary);
  const int z = source.IsUpsideDown ? Size[2] - 1 - slice : slice;
  for (int y = Size[1] - 1; y >= 0; --y)
  {
    for (int x = 0; x < Size[0]; ++x)
    {
      const double value =
        image->GetScalarComponentAsDouble(x, y, z, 0) * Skin / source.Isovalue + 0.5;
      const auto bits = static_cast<std::uint16_t>(std::clamp(value, 0.0, 65535.0));
      file.put(static_cast<char>(bits & 255U)).put(static_cast<char>(bits >> 8U));
    }
  }
  return static_cast<bool>(file.flush());
}

}

int main(int argc, char* argv[])
{
  if (argc < 2)
  {
    std::cerr << "HeadSlices: name the folder that the slices go to.\n";
    return 1;
  }
  const Source source = Find(argc > 2 && std::strcmp(argv[2], "--generated") == 0);
  const vtkSmartPointer<vtkImageData> image = Resized(source.Image);
  for (int slice = 0; slice < Size[2]; ++slice)
  {
    const std::string path = std::string(argv[1]) + "/quarter." + std::to_string(slice + 1);
    if (!WriteSlice(source, image, slice, path))
    {
      std::cerr << "HeadSlices: cannot write " << path
                << "; name a folder that can be written in.\n";
      return 1;
    }
  }
  std::cout << source.Name << '\n';
  return 0;
}
