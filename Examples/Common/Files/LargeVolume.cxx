// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/LargeVolume.h"

#include "Files/CoarseImage.h"
#include "Files/FileCheck.h"
#include "Files/MedicalReader.h"
#include "Files/NrrdHeader.h"
#include "Files/RawReader.h"
#include "Files/SliceReader.h"
#include "Files/StackFiles.h"
#include "Program/Memory.h"
#include "Program/Quoted.h"
#include "Program/Silence.h"

#include <vtkCallbackCommand.h>
#include <vtkDataArray.h>
#include <vtkExecutive.h>
#include <vtkPointData.h>

#include <algorithm>
#include <filesystem>

namespace
{

namespace fs = std::filesystem;

using Source = vtkTemporalCoherenceBrickSource;

constexpr double LargeShare = 0.25;   // of the machine: larger volumes are read as needed
constexpr double FewBytes = 64 << 20; // of pictures, which are small if compressed, too

bool IsZarrFolder(const std::string& path)
{
  std::error_code error;
  const auto has = [&](const char* name) { return fs::exists(fs::path(path) / name, error); };
  return fs::is_directory(path, error) &&
    (has(".zattrs") || has(".zgroup") || has(".zarray") || has("zarr.json"));
}

bool IsStack(const std::string& path)
{
  std::error_code error;
  return fs::is_directory(path, error) ? IsFolderOfPictures(path) : IsPictureName(path);
}

// Whether the name is that of a format whose samples may lie in a file as they are.
bool HasHeader(const std::string& path)
{
  const std::string name = LowerCase(path);
  return EndsWith(name, ".mhd") || EndsWith(name, ".mha") || EndsWith(name, ".nrrd") ||
    EndsWith(name, ".nhdr") || EndsWith(name, ".vti");
}

bool IsTooLarge(double bytes)
{
  return bytes > LargeShare * MemoryOfMachine();
}

// The first sentence that a source tells of itself while it lives.
class Complaint
{
public:
  explicit Complaint(Source* source)
    : Of(source)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback(&Complaint::OnError);
    this->Of->AddObserver(vtkCommand::ErrorEvent, this->Command);
  }
  ~Complaint() { this->Of->RemoveObserver(this->Command); }
  Complaint(const Complaint&) = delete;
  Complaint& operator=(const Complaint&) = delete;

  std::string Text;

private:
  // "ERROR: In file, line n\nclass (address): sentence\n\n"
  static void OnError(vtkObject*, unsigned long, void* clientData, void* said)
  {
    std::string& text = static_cast<Complaint*>(clientData)->Text;
    const std::string all = static_cast<const char*>(said);
    const std::size_t begin = all.find("): ");
    if (text.empty())
    {
      text = begin == std::string::npos ? all : all.substr(begin + 3);
      text.resize(text.find_last_not_of("\n ") + 1);
    }
  }

  Source* Of;
  vtkNew<vtkCallbackCommand> Command;
};

// The slices' reader, for a source. Throws UserError.
vtkSmartPointer<SliceReader> ReaderOf(const std::string& path, std::string& remark)
{
  const SliceStack slices = SlicesOf(path);
  const std::unique_ptr<PictureFile> first = OpenPicture(slices.Files.front());
  first->Next();
  if (first->Kind().Components > 1)
  {
    throw UserError("The slices of " + Quoted(path) +
      " have several components, which are not read as they are needed; leave out --large, or save "
      "them in grey.");
  }
  const auto reader = vtkSmartPointer<SliceReader>::New();
  reader->SetSlices(slices, first->Kind());
  remark = slices.Remark;
  return reader;
}

vtkSmartPointer<Source> MakeSource(const VolumeSource& wanted, std::string& remark)
{
  const auto source = vtkSmartPointer<Source>::New();
  if (IsStack(wanted.Path) && !IsZarrFolder(wanted.Path))
  {
    source->SetReader(ReaderOf(wanted.Path, remark));
  }
  else if (wanted.Raw)
  {
    RequireRawSize(wanted.Path, *wanted.Raw);
    source->SetRawLayout(
      wanted.Raw->Dimensions.data(), wanted.Raw->ScalarType, 0, wanted.BigEndian);
    source->SetRawSpacing(wanted.Raw->Spacing.data());
  }
  source->SetFileName(wanted.Path);
  source->SetLevel(wanted.Level);
  source->SetChannel(wanted.Channel);
  source->SetTimePoint(wanted.TimeStep - 1);
  source->SetArrayName(wanted.Array);
  if (wanted.MemoryMiB > 0)
  {
    source->SetMemoryLimit(static_cast<vtkTypeInt64>(wanted.MemoryMiB) << 20);
  }
  return source;
}

// What keeps the samples of a header's file from being mapped; empty if nothing does.
std::string Obstacle(const VolumeSource& wanted)
{
  const std::string name = LowerCase(wanted.Path);
  if ((EndsWith(name, ".mhd") || EndsWith(name, ".mha")) && IsRescaledMetaImage(wanted.Path))
  {
    return "its samples stand for other values";
  }
  if (EndsWith(name, ".nrrd") || EndsWith(name, ".nhdr"))
  {
    const NrrdHeader header = ReadNrrdHeader(wanted.Path);
    for (int axis = 0; axis < 3; ++axis)
    {
      if (!(header.Axes[static_cast<std::size_t>(axis)][axis] > 0.0))
      {
        return "its axes are not those of x, y and z";
      }
    }
  }
  std::string remark;
  const Silence silence;
  const vtkSmartPointer<Source> source = MakeSource(wanted, remark);
  const Complaint heard(source);
  source->UpdateInformation();
  return heard.Text;
}

// Before samples are read of what cannot be drawn.
void RequireThick(const VolumeSource& wanted, Source& source)
{
  int n[3] = { 0, 0, 0 };
  source.GetLevelDimensions(wanted.Level, n);
  if (source.GetNumberOfLevels() > 0 && std::min({ n[0], n[1], n[2] }) < 2)
  {
    throw UserError(Quoted(wanted.Path) + " has " + std::to_string(n[0]) + " x " +
      std::to_string(n[1]) + " x " + std::to_string(n[2]) +
      " samples; a volume needs at least 2 along each axis.");
  }
}

bool IsLargeStack(const std::string& path)
{
  if (BytesWithParts(path) < FewBytes)
  {
    return false;
  }
  try
  {
    const SliceStack slices = SlicesOf(path);
    const std::unique_ptr<PictureFile> first = OpenPicture(slices.Files.front());
    first->Next();
    const PictureKind& kind = first->Kind();
    return kind.Components == 1 &&
      IsTooLarge(static_cast<double>(kind.BytesOfRow()) * kind.Height * slices.Count());
  }
  catch (const UserError&)
  {
    return false; // it is told where the stack is read
  }
}

// Whether so many samples lie in a file, and can be mapped.
bool IsLargeFile(const VolumeSource& source)
{
  try
  {
    const double bytes =
      source.Raw ? static_cast<double>(SizeOf(source.Path)) : BytesWithParts(source.Path);
    return IsTooLarge(bytes) && Obstacle(source).empty();
  }
  catch (const UserError&)
  {
    return false;
  }
}

}

bool IsHdf5Name(const std::string& path)
{
  const std::string name = LowerCase(path);
  return EndsWith(name, ".ims") || EndsWith(name, ".h5") || EndsWith(name, ".hdf5");
}

bool IsReadAsNeeded(const VolumeSource& source)
{
  const std::string& path = source.Path;
  if (IsZarrFolder(path) || (IsHdf5Name(path) && !source.Raw))
  {
    return true;
  }
  const bool isStack = IsStack(path) && !source.Raw;
  const bool mayBeMapped = source.Raw ? !HasHeader(path) && !IsHdf5Name(path) : HasHeader(path);
  if (!source.IsLarge)
  {
    return isStack ? IsLargeStack(path) : mayBeMapped && IsLargeFile(source);
  }
  if (isStack)
  {
    return true;
  }
  const std::string obstacle = mayBeMapped ? Obstacle(source) : "it is of another format";
  if (!obstacle.empty())
  {
    // A sentence of the source's ends with what a programmer would do.
    throw UserError(Quoted(path) + " cannot be read as it is needed (" +
      obstacle.substr(0, obstacle.find(';')) +
      "); leave out --large, which is for raw samples without compression and for stacks.");
  }
  return true;
}

void OpenLarge(const VolumeSource& source, const ReadingProgress& progress, Volume& volume)
{
  std::string remark;
  const vtkSmartPointer<Source> bricks = MakeSource(source, remark);
  const Complaint heard(bricks);
  bricks->UpdateInformation();
  RequireThick(source, *bricks);
  if (heard.Text.empty())
  {
    Watch(bricks, progress).Update(source.Path);
  }
  vtkImageData* const image = bricks->GetOutput();
  if (!heard.Text.empty() || !image->GetPointData()->GetScalars())
  {
    throw heard.Text.empty() ? Unreadable(source.Path) : UserError(heard.Text);
  }
  const std::string name = LowerCase(source.Path);
  if (EndsWith(name, ".nrrd") || EndsWith(name, ".nhdr"))
  {
    volume.From = ReadNrrdHeader(source.Path).From;
  }
  volume.Data = image;
  volume.IsRaw = source.Raw.has_value();
  volume.Bricks = bricks;
  volume.Coarse = CoarseImageOf(bricks);
  volume.Remark = "The volume is read as it is needed." + (remark.empty() ? "" : " " + remark);
}
