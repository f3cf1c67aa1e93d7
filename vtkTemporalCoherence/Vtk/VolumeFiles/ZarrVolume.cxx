// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/ZarrVolume.h"

#include "VolumeFiles/ZarrChunk.h"

#include <limits>
#include <sstream>
#include <system_error>

namespace TemporalCoherence
{
namespace
{

class ZarrVolume : public VolumeFile
{
public:
  bool Open(const std::string& path, const VolumeChoice& choice, std::string& error);

  bool ReadChunk(
    std::size_t level, const glm::ivec3& chunk, void* samples, std::string& error) const override;

  std::string Identity() const override { return this->IdentityText; }

private:
  bool AddLevel(const ZarrSource& source, const ZarrImageLevel& from, const VolumeChoice& choice,
    JsonFiles& files, std::string& error);

  void Identify(const VolumeChoice& choice, const std::string& stamps);

  ContainedFolder Root;
  std::vector<ZarrLevel> Sources; ///< of Levels()
  std::string IdentityText;
};

bool ZarrVolume::Open(const std::string& path, const VolumeChoice& choice, std::string& error)
{
  if (!this->Root.Open(path, error))
  {
    return false;
  }
  JsonFiles files(this->Root);
  ZarrSource source;
  if (!FindZarrImage(this->Root, files, choice.Array, source, error))
  {
    return false;
  }
  for (const ZarrImageLevel& level : source.Image.Levels)
  {
    if (!this->AddLevel(source, level, choice, files, error))
    {
      return false;
    }
  }
  this->SampleType = this->Sources.front().Array.Type;
  this->Identify(choice, files.Stamps());
  return true;
}

bool ZarrVolume::AddLevel(const ZarrSource& source, const ZarrImageLevel& from,
  const VolumeChoice& choice, JsonFiles& files, std::string& error)
{
  ZarrLevel level;
  if (!this->Root.Find(source.Folder, from.Path, level.Folder, error))
  {
    return false;
  }
  const FileState state = ReadZarrArray(files, level.Folder, level.Array, error);
  if (state != FileState::Opened)
  {
    error = state == FileState::Refused ? error
                                        : "Folder " + level.Folder.string() +
        " holds no Zarr array, but the image's metadata name it; copy the volume again.";
    return false;
  }
  const std::vector<ZarrAxis> axes =
    source.Image.Axes.empty() ? UnnamedZarrAxes(level.Array.Shape.size()) : source.Image.Axes;
  VolumeLevel geometry;
  if (!ChooseZarrVolume(axes, choice, level, geometry, error))
  {
    return false;
  }
  const bool isFirst = this->Sources.empty();
  if (!isFirst && level.Array.Type != this->Sources.front().Array.Type)
  {
    error = "Array " + level.Folder.string() +
      " has another type of samples than the first level; write all levels with one type.";
    return false;
  }
  if (!isFirst &&
    glm::any(glm::greaterThan(geometry.Dimensions, this->Resolutions.back().Dimensions)))
  {
    error = "Array " + level.Folder.string() +
      " is larger than the level before it; write the levels from the finest to the coarsest.";
    return false;
  }
  PlaceZarrLevel(axes, from, isFirst ? geometry : this->Resolutions.front(), geometry);
  this->Resolutions.push_back(geometry);
  this->Sources.push_back(std::move(level));
  return true;
}

void ZarrVolume::Identify(const VolumeChoice& choice, const std::string& stamps)
{
  std::ostringstream text;
  text.precision(std::numeric_limits<double>::max_digits10);
  text << "Zarr " << this->Root.Path().string() << '\n'
       << "channel " << choice.Channel << " time " << choice.TimePoint << " array " << choice.Array
       << " type " << static_cast<int>(this->SampleType) << '\n';
  for (std::size_t i = 0; i < this->Resolutions.size(); ++i)
  {
    const VolumeLevel& level = this->Resolutions[i];
    text << this->Sources[i].Folder.string();
    for (int axis = 0; axis < 3; ++axis)
    {
      text << ' ' << level.Dimensions[axis] << ' ' << level.Chunk[axis] << ' '
           << level.Spacing[axis] << ' ' << level.Origin[axis];
    }
    text << '\n';
  }
  text << stamps;
  this->IdentityText = text.str();
}

bool ZarrVolume::ReadChunk(
  std::size_t level, const glm::ivec3& chunk, void* samples, std::string& error) const
{
  if (level >= this->Sources.size() || glm::any(glm::lessThan(chunk, glm::ivec3(0))) ||
    glm::any(glm::greaterThanEqual(chunk, this->Resolutions[level].NumberOfChunks())))
  {
    error = "Volume " + this->Root.Path().string() +
      " has no such chunk; ask for one within the grid of chunks.";
    return false;
  }
  return ReadZarrChunk(this->Root, this->Sources[level], chunk, samples, error);
}

/// The folder of a file with metadata. Users may choose such a file, too.
std::string FolderOf(const std::string& path)
{
  const std::filesystem::path file(path);
  const std::string name = file.filename().string();
  const bool isMetadata =
    name == ".zattrs" || name == ".zarray" || name == ".zgroup" || name == "zarr.json";
  std::error_code code;
  if (!isMetadata || path.find('\0') != std::string::npos ||
    !std::filesystem::is_regular_file(file, code))
  {
    return path;
  }
  const std::string folder = file.parent_path().string();
  return folder.empty() ? "." : folder;
}

}

std::unique_ptr<VolumeFile> OpenZarr(
  const std::string& path, const VolumeChoice& choice, std::string& error)
{
  try
  {
    auto volume = std::make_unique<ZarrVolume>();
    if (volume->Open(FolderOf(path), choice, error))
    {
      return volume;
    }
  }
  catch (const Json::exception&)
  {
    error = "The metadata of volume " + path + " are not understood; copy the volume again.";
  }
  return nullptr;
}

}
