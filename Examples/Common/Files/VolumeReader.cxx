// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/VolumeReader.h"

#include "Files/Arrays.h"
#include "Files/FileCheck.h"
#include "Files/FourSpheres.h"
#include "Files/LargeVolume.h"
#include "Files/MedicalReader.h"
#include "Files/MeshReader.h"
#include "Files/NrrdReader.h"
#include "Files/PlaceCheck.h"
#include "Files/RawReader.h"
#include "Files/Reading.h"
#include "Files/SeriesFile.h"
#include "Files/StackFiles.h"
#include "Files/StackReader.h"
#include "Files/Trial.h"
#include "Files/WholeCheck.h"
#include "Program/Quoted.h"
#include "Program/Silence.h"
#include "Program/UserError.h"

#include <vtkBitArray.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSLCReader.h>
#include <vtkStructuredPoints.h>
#include <vtkStructuredPointsReader.h>
#include <vtkVector.h>
#include <vtkXMLImageDataReader.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <new>

namespace
{

namespace fs = std::filesystem;

constexpr std::array<const char*, 9> KnownSuffixes = { ".vti", ".vtk", ".mhd", ".mha", ".nii",
  ".nii.gz", ".nrrd", ".nhdr", ".slc" };

std::string ListOfSuffixes()
{
  std::string list;
  for (const char* suffix : KnownSuffixes)
  {
    list += std::string(list.empty() ? "" : ", ") + suffix;
  }
  return list + ", " + ListOfMeshSuffixes() +
    ", .pvd, .series, .tif, .tiff, .png, .ims, .h5, .hdf5";
}

bool IsImageFile(const std::string& legacyPath)
{
  vtkNew<vtkStructuredPointsReader> reader;
  reader->SetFileName(legacyPath.c_str());
  return reader->IsFileStructuredPoints() != 0;
}

vtkSmartPointer<vtkImageData> ReadLegacy(const std::string& path, const ReadingProgress& progress)
{
  vtkNew<vtkStructuredPointsReader> reader;
  reader->SetFileName(path.c_str());
  ReadAllArrays(reader);
  Watch(reader, progress).Update(path);
  return reader->GetOutput();
}

Volume ReadFile(const VolumeSource& source, const ReadingProgress& progress)
{
  const std::string& path = source.Path;
  const std::string name = LowerCase(path);
  Volume volume;
  if (IsMeshName(path))
  {
    ReadMesh(source, progress, volume);
  }
  else if (EndsWith(name, ".vti"))
  {
    RequireWholeXml(path);
    volume.Data = ReadImage(vtkNew<vtkXMLImageDataReader>().Get(), path, progress);
  }
  else if (EndsWith(name, ".vtk"))
  {
    if (IsImageFile(path))
    {
      volume.Data = ReadLegacy(path, progress);
    }
    else
    {
      ReadMesh(source, progress, volume);
    }
  }
  else if (EndsWith(name, ".mhd") || EndsWith(name, ".mha"))
  {
    ReadMetaImage(path, progress, volume);
  }
  else if (EndsWith(name, ".nii") || EndsWith(name, ".nii.gz"))
  {
    ReadNifti(path, source.TimeStep, progress, volume);
  }
  else if (EndsWith(name, ".nrrd") || EndsWith(name, ".nhdr"))
  {
    ReadNrrd(path, source.TimeStep, progress, volume);
  }
  else if (IsPictureName(path))
  {
    ReadStack(path, progress, volume);
  }
  else if (EndsWith(name, ".slc"))
  {
    volume.Data = ReadImage(vtkNew<vtkSLCReader>().Get(), path, progress);
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
  vtkDataArray* scalars = points->GetScalars();
  if (scalars && scalars->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    throw UserError(name + " has " + std::to_string(scalars->GetNumberOfTuples()) + " scalars at " +
      std::to_string(image->GetNumberOfPoints()) + " points; check that the file is whole.");
  }
  RemoveUnfitting(image);
  const bool hasBits = vtkBitArray::SafeDownCast(scalars) != nullptr;
  if (hasBits)
  {
    points->SetActiveScalars(nullptr);
  }
  // Some arrays have no name, and some no numbers.
  for (int i = 0; i < points->GetNumberOfArrays() && !points->GetScalars(); ++i)
  {
    if (!vtkBitArray::SafeDownCast(points->GetArray(i)))
    {
      points->SetActiveAttribute(i, vtkDataSetAttributes::SCALARS);
    }
  }
  if (hasBits && !points->GetScalars() && AllArrays(image).empty())
  {
    throw UserError(name + " has samples of one bit; save them with 8 bits or more.");
  }
}

// What is drawn of the cells of an image are samples in their middles.
void CheckCellSamples(const Volume& volume, const std::string& name)
{
  int n[3] = { 3, 3, 3 };
  if (auto* image = vtkImageData::SafeDownCast(volume.Data))
  {
    image->GetDimensions(n);
  }
  if (volume.Array.IsOnCells && std::min({ n[0], n[1], n[2] }) < 3)
  {
    throw UserError(name + " has " + std::to_string(n[0] - 1) + " x " + std::to_string(n[1] - 1) +
      " x " + std::to_string(n[2] - 1) +
      " cells with samples; a volume needs at least 2 along each axis.");
  }
}

// \param placement may be null
void CheckPlace(vtkImageData* image, vtkMatrix4x4* placement, const std::string& name)
{
  vtkNew<vtkMatrix4x4> place;
  vtkMatrix4x4::Multiply4x4(
    placement ? placement : place.Get(), image->GetIndexToPhysicalMatrix(), place);
  const int* extent = image->GetExtent();
  std::array<vtkVector3d, 3> edges;
  vtkVector3d corner;
  for (int i = 0; i < 3; ++i)
  {
    corner[i] = place->GetElement(i, 3);
    for (int axis = 0; axis < 3; ++axis)
    {
      const double step = place->GetElement(i, axis);
      corner[i] += step * extent[2 * axis];
      edges[static_cast<std::size_t>(axis)][i] = step * (extent[2 * axis + 1] - extent[2 * axis]);
    }
  }
  if (!CanBeSeen(corner, edges))
  {
    throw UserError(name +
      " has a spacing, an origin or a direction with which it cannot be seen; correct them in its "
      "header.");
  }
}

}

bool HasVolumeSuffix(const std::string& path)
{
  const std::string name = LowerCase(path);
  return IsMeshName(path) || IsSeriesName(path) || IsPictureName(path) || IsHdf5Name(path) ||
    std::any_of(KnownSuffixes.begin(), KnownSuffixes.end(),
      [&name](const char* suffix) { return EndsWith(name, suffix); });
}

namespace
{

void RequireReadable(const std::string& path)
{
  std::error_code error;
  if (!fs::exists(path, error))
  {
    throw UserError("There is no file " + Quoted(path) + "; check the path.");
  }
  if (!fs::is_regular_file(path, error) && !fs::is_directory(path, error))
  {
    // To open others may take for ever.
    throw UserError(Quoted(path) + " could not be read: it is no file; name one.");
  }
  if (fs::is_regular_file(path, error) && !std::ifstream(path))
  {
    throw UserError(Quoted(path) + " may not be read; check its permissions.");
  }
}

UserError NoTimeStep(const VolumeSource& source, int count)
{
  return UserError(Quoted(source.Path) + " has " + std::to_string(count) +
    " time steps; choose one of these instead of " + std::to_string(source.TimeStep) + ".");
}

Volume ReadPath(const VolumeSource& source, const ReadingProgress& progress)
{
  const Silence silence;
  const std::string& path = source.Path;
  Volume volume;

  std::error_code error;
  if (IsReadAsNeeded(source))
  {
    OpenLarge(source, progress, volume);
  }
  else if (fs::is_directory(path, error) && IsFolderOfPictures(path))
  {
    ReadStack(path, progress, volume);
  }
  else if (fs::is_directory(path, error))
  {
    ReadDicom(path, progress, volume);
  }
  else if (source.Raw)
  {
    volume.Data = ReadRaw(path, *source.Raw, source.BigEndian, progress);
    volume.IsRaw = true;
  }
  else
  {
    volume = ReadFile(source, progress);
  }
  // vtkDataReader tells of a file that ends too early by a warning; others warn of what they skip.
  if (silence.HeardErrors() || (silence.HeardWarnings() && EndsWith(LowerCase(path), ".vtk")))
  {
    throw UnreadableOrPart(path);
  }
  if (!source.Raw && volume.Data && !volume.Bricks)
  {
    RequireBytesFor(path, 1024.0 * static_cast<double>(volume.Data->GetActualMemorySize()));
  }
  volume.Name = Printable(fs::path(path).filename().string());
  if (source.TimeStep > volume.TimeSteps && !volume.Bricks)
  {
    throw NoTimeStep(source, volume.TimeSteps);
  }
  if (auto* image = vtkImageData::SafeDownCast(volume.Data))
  {
    CheckImage(image, Quoted(path));
    CheckPlace(image, nullptr, Quoted(path));
    CheckPlace(image, volume.Placement, Quoted(path));
  }
  else
  {
    CheckMesh(volume.Data, Quoted(path));
  }
  ChooseArray(volume, source.Array);
  CheckCellSamples(volume, Quoted(path));
  return volume;
}

}

Volume ReadUntried(const VolumeSource& source, const ReadingProgress& progress)
{
  try
  {
    return ReadPath(source, progress);
  }
  catch (const UserError&)
  {
    throw;
  }
  catch (const std::bad_alloc&)
  {
    throw TooLarge(source.Path);
  }
  catch (const std::exception&)
  {
    // Readers throw where a header leads them astray.
    throw Unreadable(source.Path);
  }
}

namespace
{

// Of files that are read whole.
void RequireOneOfEach(const VolumeSource& source)
{
  if (source.Level > 0 || source.Channel > 0)
  {
    throw UserError(Quoted(source.Path) +
      " is read as one resolution and one channel; leave out --resolution and --channel.");
  }
}

// A file that is no list of others: read on trial first, unless it is read as it is needed.
Volume ReadOne(const VolumeSource& source, const ReadingProgress& progress)
{
  if (IsReadAsNeeded(source))
  {
    return ReadUntried(source, progress);
  }
  RequireOneOfEach(source);
  // The trial is told as the first half of reading.
  double begin = 0.0;
  const ReadingProgress half = [&](double share)
  { return !progress || progress(begin + 0.5 * share); };
  if (const std::optional<Volume> volume = TryReading(source, half))
  {
    return *volume;
  }
  begin = 0.5;
  return ReadUntried(source, half);
}

// The files of one time step of a list, each of which is read as if it were opened.
Volume ReadSeries(const VolumeSource& source, const ReadingProgress& progress)
{
  const std::vector<SeriesStep> steps = ReadSeriesFile(source.Path);
  const auto count = static_cast<int>(steps.size());
  if (source.TimeStep > count)
  {
    throw NoTimeStep(source, count);
  }
  const SeriesStep& step = steps[static_cast<std::size_t>(source.TimeStep - 1)];
  const double share = 1.0 / static_cast<double>(step.Files.size());
  std::vector<Volume> parts;
  for (const std::string& file : step.Files)
  {
    std::error_code error;
    if (!fs::is_regular_file(file, error))
    {
      throw UserError(Quoted(source.Path) + " names the file " + Quoted(file) +
        ", which is not there; put it there, or correct the list.");
    }
    VolumeSource part = source;
    part.Path = file;
    part.TimeStep = 1;
    const double begin = share * static_cast<double>(parts.size());
    parts.push_back(
      ReadOne(part, [&](double done) { return !progress || progress(begin + share * done); }));
  }
  Volume volume = parts.front();
  if (parts.size() > 1)
  {
    const auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
    for (const Volume& part : parts)
    {
      if (part.Placement)
      {
        throw UserError(Quoted(source.Path) +
          " has several files of one time that lie aslant; name one file for each time.");
      }
      blocks->SetBlock(blocks->GetNumberOfBlocks(), part.Data);
    }
    volume.Data = blocks;
    CheckMesh(volume.Data, Quoted(source.Path));
    ChooseArray(volume, source.Array);
  }
  volume.Name = Printable(fs::path(source.Path).filename().string());
  volume.TimeSteps = count;
  return volume;
}

}

Volume ReadVolume(const VolumeSource& source, const ReadingProgress& progress)
{
  if (source.Path.empty())
  {
    Volume volume;
    volume.Data = MakeFourSpheres(source.Spheres);
    volume.Name = "four generated spheres";
    CheckImage(vtkImageData::SafeDownCast(volume.Data), "The generated volume");
    return volume;
  }
  RequireReadable(source.Path);
  if (source.Raw)
  {
    RequireOneOfEach(source);
    return ReadUntried(source, progress);
  }
  return IsSeriesName(source.Path) ? ReadSeries(source, progress) : ReadOne(source, progress);
}
