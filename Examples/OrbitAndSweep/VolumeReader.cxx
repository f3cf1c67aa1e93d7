// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeReader.h"

#include "Options.h"

#include <vtkDICOMImageReader.h>
#include <vtkDataArray.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkImageReader2.h>
#include <vtkMetaImageReader.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSLCReader.h>
#include <vtkSMPTools.h>
#include <vtkXMLImageDataReader.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>

namespace
{

namespace fs = std::filesystem;

const char* const KnownSuffixes = ".vti, .vtk, .mhd, .mha, .nii, .nii.gz, .slc";

// VTK's readers tell a broken file in several lines; our one sentence takes their place.
class SilentVtk
{
public:
  SilentVtk()
    : Before(vtkObject::GetGlobalWarningDisplay())
  {
    vtkObject::GlobalWarningDisplayOff();
  }
  ~SilentVtk() { vtkObject::SetGlobalWarningDisplay(this->Before); }
  SilentVtk(const SilentVtk&) = delete;
  SilentVtk& operator=(const SilentVtk&) = delete;

private:
  int Before;
};

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::string LowerCase(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

UserError Unreadable(const std::string& path, const std::string& format)
{
  return UserError("'" + path + "' could not be read as " + format +
    "; check that the file is whole and that its suffix tells its format.");
}

// For the readers of IOImage, which know their files by CanReadFile.
template <typename Reader>
vtkSmartPointer<vtkImageData> ReadImage(
  Reader* reader, const std::string& path, const std::string& format)
{
  if (!reader->CanReadFile(path.c_str()))
  {
    throw Unreadable(path, format);
  }
  reader->SetFileName(path.c_str());
  reader->Update();
  if (reader->GetErrorCode() != 0)
  {
    throw Unreadable(path, format);
  }
  return reader->GetOutput();
}

vtkSmartPointer<vtkImageData> ReadLegacy(const std::string& path)
{
  vtkNew<vtkGenericDataObjectReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkDataObject* output = reader->GetOutput();
  if (!output || reader->GetErrorCode() != 0)
  {
    throw Unreadable(path, "legacy VTK");
  }
  auto* image = vtkImageData::SafeDownCast(output);
  if (!image)
  {
    throw UserError("'" + path + "' holds a " + output->GetClassName() +
      ", not an image; resample it with vtkResampleToImage and save it as .vti.");
  }
  return image;
}

vtkSmartPointer<vtkImageData> ReadDicom(const std::string& path)
{
  vtkNew<vtkDICOMImageReader> reader;
  reader->SetDirectoryName(path.c_str());
  reader->Update();
  // A directory without a series leaves no file to name.
  if (reader->GetErrorCode() != 0 || reader->GetOutput()->GetNumberOfPoints() < 2)
  {
    throw UserError("The directory '" + path +
      "' holds no DICOM series that VTK reads; name the directory with the slices themselves.");
  }
  return reader->GetOutput();
}

vtkSmartPointer<vtkImageData> ReadRaw(
  const std::string& path, const RawLayout& layout, bool isBigEndian)
{
  std::uintmax_t wanted =
    static_cast<std::uintmax_t>(vtkDataArray::GetDataTypeSize(layout.ScalarType));
  for (const int n : layout.Dimensions)
  {
    wanted *= static_cast<std::uintmax_t>(n);
  }
  const std::uintmax_t there = fs::file_size(path);
  if (there != wanted)
  {
    throw UserError("'" + path + "' has " + std::to_string(there) + " bytes, but --raw tells of " +
      std::to_string(wanted) + "; correct the dimensions or the type.");
  }
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
  reader->Update();
  return reader->GetOutput();
}

// A header may place the samples among the patient's axes: the scanner's (q) or a template's (s).
Volume ReadNifti(const std::string& path)
{
  Volume volume;
  vtkNew<vtkNIFTIImageReader> reader;
  volume.Image = ReadImage(reader.Get(), path, "NIfTI");
  vtkMatrix4x4* placement =
    reader->GetSFormMatrix() ? reader->GetSFormMatrix() : reader->GetQFormMatrix();
  if (placement && std::abs(placement->Determinant()) > 0.0)
  {
    volume.Placement = placement;
  }
  volume.From = "+y";
  return volume;
}

Volume ReadFile(const std::string& path)
{
  const std::string name = LowerCase(path);
  Volume volume;
  if (EndsWith(name, ".vti"))
  {
    volume.Image = ReadImage(vtkNew<vtkXMLImageDataReader>().Get(), path, "a VTK XML image");
  }
  else if (EndsWith(name, ".vtk"))
  {
    volume.Image = ReadLegacy(path);
  }
  else if (EndsWith(name, ".mhd") || EndsWith(name, ".mha"))
  {
    volume.Image = ReadImage(vtkNew<vtkMetaImageReader>().Get(), path, "a MetaImage");
  }
  else if (EndsWith(name, ".nii") || EndsWith(name, ".nii.gz"))
  {
    volume = ReadNifti(path);
  }
  else if (EndsWith(name, ".slc"))
  {
    volume.Image = ReadImage(vtkNew<vtkSLCReader>().Get(), path, "SLC");
  }
  else
  {
    throw UserError("The suffix of '" + path + "' is none of " + KnownSuffixes +
      "; convert the volume, or describe it with --raw NX,NY,NZ,TYPE.");
  }
  return volume;
}

// The paper's volume: the value is 1 in the middle of a sphere, and 0 at 0.6 from it.
vtkSmartPointer<vtkImageData> MakeSpheres(int samples)
{
  static const double centres[4][3] = { { -0.4, -0.4, -0.2 }, { 0.45, -0.3, 0.3 },
    { -0.3, 0.45, 0.35 }, { 0.35, 0.4, -0.4 } };
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(samples, samples, samples);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  const double step = 2.0 / std::max(samples - 1, 1);
  vtkSMPTools::For(0, samples,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType k = begin; k < end; ++k)
      {
        auto* sample =
          static_cast<unsigned char*>(image->GetScalarPointer(0, 0, static_cast<int>(k)));
        const double z = -1.0 + step * static_cast<double>(k);
        for (int j = 0; j < samples; ++j)
        {
          for (int i = 0; i < samples; ++i, ++sample)
          {
            double value = 0.0;
            for (const double* c : centres)
            {
              const double d = std::hypot(-1.0 + step * i - c[0], -1.0 + step * j - c[1], z - c[2]);
              value = std::max(value, 1.0 - d / 0.6);
            }
            *sample = static_cast<unsigned char>(255.0 * value);
          }
        }
      }
    });
  return image;
}

void CheckImage(vtkImageData* image, const std::string& name)
{
  int dimensions[3];
  image->GetDimensions(dimensions);
  if (std::min({ dimensions[0], dimensions[1], dimensions[2] }) < 2)
  {
    throw UserError(name + " has " + std::to_string(dimensions[0]) + " x " +
      std::to_string(dimensions[1]) + " x " + std::to_string(dimensions[2]) +
      " samples; a volume needs at least 2 along each axis.");
  }
  vtkPointData* points = image->GetPointData();
  if (!points->GetScalars())
  {
    vtkDataArray* first = points->GetArray(0);
    if (!first)
    {
      throw UserError(
        name + " has no scalars at its points; cell data become such with vtkCellDataToPointData.");
    }
    points->SetActiveScalars(first->GetName());
  }
}

}

Volume ReadVolume(const Options& options)
{
  const SilentVtk silent;
  const std::string& path = options.Volume;
  Volume volume;
  if (path.empty())
  {
    volume.Image = MakeSpheres(options.Spheres);
    volume.Name = "four generated spheres";
    CheckImage(volume.Image, "The generated volume");
    return volume;
  }

  std::error_code error;
  if (!fs::exists(path, error))
  {
    throw UserError("There is no file '" + path + "'; check the path.");
  }
  if (fs::is_directory(path, error))
  {
    volume.Image = ReadDicom(path);
    volume.From = "+y";
  }
  else if (!std::ifstream(path))
  {
    throw UserError("'" + path + "' may not be read; check its permissions.");
  }
  else if (options.Raw)
  {
    volume.Image = ReadRaw(path, *options.Raw, options.BigEndian);
  }
  else
  {
    volume = ReadFile(path);
  }
  volume.Name = fs::path(path).filename().string();
  CheckImage(volume.Image, "'" + path + "'");
  return volume;
}
