// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/ZarrImage.h"
#include "VolumeFiles/ZarrMetadata.h"

#include <algorithm>
#include <system_error>

namespace TemporalCoherence
{
namespace
{

namespace fs = std::filesystem;

/// Read the attributes of a folder, of version 2 or 3.
/// \param path receives the file that holds them
FileState ReadAttributes(
  JsonFiles& files, const fs::path& folder, fs::path& path, Json& attributes, std::string& error)
{
  path = folder / ".zattrs";
  FileState state = files.Read(path, attributes, error);
  if (state == FileState::Missing)
  {
    path = folder / "zarr.json";
    Json metadata;
    state = files.Read(path, metadata, error);
    const Json& all = MemberOf(metadata, "attributes");
    const Json& ome = MemberOf(all, "ome");
    attributes = ome.is_object() ? ome : all;
  }
  return state;
}

/// Find an image by its name in the list of a folder's images.
/// \param name empty: the first
/// \return null if there is none
const Json* FindMultiscale(const Json& attributes, const std::string& name)
{
  const Json& list = MemberOf(attributes, "multiscales");
  for (std::size_t i = 0; list.is_array() && i < list.size(); ++i)
  {
    if (name.empty() || TextOf(list[i], "name") == name)
    {
      return &list[i];
    }
  }
  return nullptr;
}

/// Take an image of this very folder.
/// \return Missing if the folder has no such image
FileState TakeImage(JsonFiles& files, const fs::path& folder, const std::string& name,
  ZarrSource& source, std::string& error)
{
  fs::path path;
  Json attributes;
  const FileState state = ReadAttributes(files, folder, path, attributes, error);
  if (state != FileState::Opened)
  {
    return state;
  }
  const Json* multiscale = FindMultiscale(attributes, name);
  if (!multiscale)
  {
    return FileState::Missing;
  }
  source.Folder = folder;
  std::string defect;
  if (!ParseZarrImage(*multiscale, source.Image, defect))
  {
    error = "File " + path.string() + ' ' + defect + '.';
    return FileState::Refused;
  }
  return FileState::Opened;
}

/// Take the array, or the first image, of this very folder.
/// \return Missing if the folder is none of both
FileState TakeFolder(
  JsonFiles& files, const fs::path& folder, ZarrSource& source, std::string& error)
{
  ZarrArray array;
  const FileState state = ReadZarrArray(files, folder, array, error);
  if (state != FileState::Opened)
  {
    return state == FileState::Refused ? state : TakeImage(files, folder, "", source, error);
  }
  source.Folder = folder;
  source.Image = ZarrImage();
  source.Image.Levels.resize(1);
  source.Image.Levels.front().Path = ".";
  return FileState::Opened;
}

bool IsNumber(const std::string& name)
{
  return !name.empty() && name.find_first_not_of("0123456789") == std::string::npos;
}

/// Whether a name comes before another one: 9 before 10, and numbers before words.
bool IsEarlier(const std::string& left, const std::string& right)
{
  const bool isNumber = IsNumber(left);
  if (isNumber != IsNumber(right))
  {
    return isNumber;
  }
  return isNumber && left.size() != right.size() ? left.size() < right.size() : left < right;
}

/// Names of the folders in a folder, in order.
std::vector<std::string> ListFolders(const fs::path& folder)
{
  constexpr std::size_t Most = 10000;
  std::vector<std::string> names;
  std::error_code code;
  fs::directory_iterator entry(folder, code);
  for (; !code && entry != fs::directory_iterator() && names.size() < Most; entry.increment(code))
  {
    std::error_code ignored;
    if (entry->is_directory(ignored))
    {
      names.push_back(entry->path().filename().string());
    }
  }
  std::sort(names.begin(), names.end(), IsEarlier);
  return names;
}

}

bool FindZarrImage(const ContainedFolder& root, JsonFiles& files, const std::string& name,
  ZarrSource& source, std::string& error)
{
  fs::path folder = root.Path();
  FileState state = FileState::Missing;
  if (!name.empty())
  {
    state = TakeImage(files, folder, name, source, error);
    if (state == FileState::Missing && !root.Find(root.Path(), name, folder, error))
    {
      return false;
    }
  }
  if (state == FileState::Missing)
  {
    state = TakeFolder(files, folder, source, error);
  }
  if (state != FileState::Missing)
  {
    return state == FileState::Opened;
  }
  for (const std::string& child : ListFolders(folder))
  {
    fs::path path;
    state = root.Find(folder, child, path, error) ? TakeFolder(files, path, source, error)
                                                  : FileState::Refused;
    if (state != FileState::Missing)
    {
      return state == FileState::Opened;
    }
  }
  error = "Folder " + folder.string() +
    " holds no Zarr array and no OME-Zarr image; choose the folder of an array or of an image.";
  return false;
}

}
