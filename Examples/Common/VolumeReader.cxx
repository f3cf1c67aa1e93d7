// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeReader.h"

#include "FourSpheres.h"
#include "Quoted.h"
#include "Silence.h"
#include "UserError.h"

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkDICOMImageReader.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkGenericDataObjectReader.h>
#include <vtkImageReader2.h>
#include <vtkMetaImageReader.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSLCReader.h>
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

constexpr std::array<const char*, 7> KnownSuffixes = { ".vti", ".vtk", ".mhd", ".mha", ".nii",
  ".nii.gz", ".slc" };

std::string ListOfSuffixes()
{
  std::string list;
  for (const char* suffix : KnownSuffixes)
  {
    list += std::string(list.empty() ? "" : ", ") + suffix;
  }
  return list;
}

// Passes a reader's progress on, and what is answered back.
class Watch
{
public:
  Watch(vtkAlgorithm* reader, const ReadingProgress& progress)
    : Reader(reader)
    , Progress(progress)
  {
    if (this->Progress)
    {
      this->Command->SetClientData(this);
      this->Command->SetCallback(&Watch::OnProgress);
      this->Reader->AddObserver(vtkCommand::ProgressEvent, this->Command);
    }
  }
  ~Watch() { this->Reader->RemoveObserver(this->Command); }
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  // Reads the file. Throws UserError if it was stopped.
  void Update(const std::string& path)
  {
    this->Reader->Update();
    if (this->IsStopped)
    {
      throw UserError("Reading " + Quoted(path) + " was stopped; open it again to read all of it.");
    }
  }

private:
  static void OnProgress(vtkObject*, unsigned long, void* clientData, void* callData)
  {
    auto* self = static_cast<Watch*>(clientData);
    if (!self->IsStopped && !self->Progress(*static_cast<double*>(callData)))
    {
      self->IsStopped = true;
      self->Reader->SetAbortExecute(1);
    }
  }

  vtkAlgorithm* Reader;
  const ReadingProgress& Progress;
  vtkNew<vtkCallbackCommand> Command;
  bool IsStopped = false;
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

UserError Unreadable(const std::string& path)
{
  return UserError(Quoted(path) +
    " could not be read as what its suffix says; check that the file is whole and of that "
    "format.");
}

// For the readers of IOImage, which know their files by CanReadFile.
template <typename Reader>
vtkSmartPointer<vtkImageData> ReadImage(
  Reader* reader, const std::string& path, const ReadingProgress& progress)
{
  if (!reader->CanReadFile(path.c_str()))
  {
    throw Unreadable(path);
  }
  reader->SetFileName(path.c_str());
  Watch(reader, progress).Update(path);
  return reader->GetOutput();
}

vtkSmartPointer<vtkImageData> ReadLegacy(const std::string& path, const ReadingProgress& progress)
{
  vtkNew<vtkGenericDataObjectReader> reader;
  reader->SetFileName(path.c_str());
  Watch(reader, progress).Update(path);
  vtkDataObject* output = reader->GetOutput();
  if (!vtkDataSet::SafeDownCast(output))
  {
    throw Unreadable(path);
  }
  auto* image = vtkImageData::SafeDownCast(output);
  if (!image)
  {
    throw UserError(Quoted(path) + " holds a " + output->GetClassName() +
      ", not an image; resample it with vtkResampleToImage and save it as .vti.");
  }
  return image;
}

vtkSmartPointer<vtkImageData> ReadDicom(const std::string& path, const ReadingProgress& progress)
{
  vtkNew<vtkDICOMImageReader> reader;
  reader->SetDirectoryName(path.c_str());
  Watch(reader, progress).Update(path);
  // A directory without a series leaves no file to name.
  if (reader->GetErrorCode() != 0 || reader->GetOutput()->GetNumberOfPoints() < 2)
  {
    throw UserError("The directory " + Quoted(path) +
      " holds no DICOM series that VTK reads; name the directory with the slices themselves.");
  }
  return reader->GetOutput();
}

vtkSmartPointer<vtkImageData> ReadRaw(const std::string& path, const RawLayout& layout,
  bool isBigEndian, const ReadingProgress& progress)
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
    throw UserError(Quoted(path) + " has " + std::to_string(there) + " bytes, but --raw tells of " +
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
  Watch(reader, progress).Update(path);
  return reader->GetOutput();
}

// A header may place the samples among the patient's axes: the scanner's (q) or a template's (s).
Volume ReadNifti(const std::string& path, const ReadingProgress& progress)
{
  Volume volume;
  vtkNew<vtkNIFTIImageReader> reader;
  volume.Image = ReadImage(reader.Get(), path, progress);
  vtkMatrix4x4* placement =
    reader->GetSFormMatrix() ? reader->GetSFormMatrix() : reader->GetQFormMatrix();
  if (placement && std::abs(placement->Determinant()) > 0.0)
  {
    volume.Placement = placement;
  }
  volume.From = "+y";
  return volume;
}

Volume ReadFile(const std::string& path, const ReadingProgress& progress)
{
  const std::string name = LowerCase(path);
  Volume volume;
  if (EndsWith(name, ".vti"))
  {
    volume.Image = ReadImage(vtkNew<vtkXMLImageDataReader>().Get(), path, progress);
  }
  else if (EndsWith(name, ".vtk"))
  {
    volume.Image = ReadLegacy(path, progress);
  }
  else if (EndsWith(name, ".mhd") || EndsWith(name, ".mha"))
  {
    volume.Image = ReadImage(vtkNew<vtkMetaImageReader>().Get(), path, progress);
  }
  else if (EndsWith(name, ".nii") || EndsWith(name, ".nii.gz"))
  {
    volume = ReadNifti(path, progress);
  }
  else if (EndsWith(name, ".slc"))
  {
    volume.Image = ReadImage(vtkNew<vtkSLCReader>().Get(), path, progress);
  }
  else
  {
    throw UserError("The suffix of " + Quoted(path) + " is none of " + ListOfSuffixes() +
      "; convert the volume, or describe it with --raw NX,NY,NZ,TYPE.");
  }
  return volume;
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

bool HasVolumeSuffix(const std::string& path)
{
  const std::string name = LowerCase(path);
  return std::any_of(KnownSuffixes.begin(), KnownSuffixes.end(),
    [&name](const char* suffix) { return EndsWith(name, suffix); });
}

Volume ReadVolume(const VolumeSource& source, const ReadingProgress& progress)
{
  const Silence silence;
  const std::string& path = source.Path;
  Volume volume;
  if (path.empty())
  {
    volume.Image = MakeFourSpheres(source.Spheres);
    volume.Name = "four generated spheres";
    CheckImage(volume.Image, "The generated volume");
    return volume;
  }

  std::error_code error;
  if (!fs::exists(path, error))
  {
    throw UserError("There is no file " + Quoted(path) + "; check the path.");
  }
  if (fs::is_directory(path, error))
  {
    volume.Image = ReadDicom(path, progress);
    volume.From = "+y";
  }
  else if (!std::ifstream(path))
  {
    throw UserError(Quoted(path) + " may not be read; check its permissions.");
  }
  else if (source.Raw)
  {
    volume.Image = ReadRaw(path, *source.Raw, source.BigEndian, progress);
  }
  else
  {
    volume = ReadFile(path, progress);
  }
  if (silence.HeardErrors())
  {
    throw Unreadable(path);
  }
  volume.Name = Printable(fs::path(path).filename().string());
  CheckImage(volume.Image, Quoted(path));
  return volume;
}
