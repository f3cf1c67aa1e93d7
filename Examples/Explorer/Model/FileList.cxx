// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Model/FileList.h"

#include "Files/VolumeReader.h"
#include "Model/Session.h"
#include "Program/Quoted.h"
#include "Program/UserError.h"

#include <algorithm>

namespace
{

namespace fs = std::filesystem;

bool IsSlice(const fs::path& path)
{
  return path.extension() == ".dcm" || path.extension() == ".DCM" || path.extension() == ".ima";
}

}

void FileList::Go(const fs::path& directory)
{
  std::error_code error;
  const fs::path where = fs::canonical(directory, error);
  fs::directory_iterator iterator(where, fs::directory_options::skip_permission_denied, error);
  if (error)
  {
    throw UserError("The directory " + Quoted(directory.string()) +
      " cannot be read; check the path and its permissions.");
  }
  std::vector<Entry> directories, files;
  bool hasSlices = false;
  for (const fs::directory_entry& entry : iterator)
  {
    const std::string name = entry.path().filename().string();
    if (name.empty() || name[0] == '.')
    {
      continue;
    }
    if (entry.is_directory(error))
    {
      directories.push_back({ name + "/", entry.path(), true });
    }
    else if (HasVolumeSuffix(name) || IsSessionName(name))
    {
      files.push_back({ name, entry.path(), false });
    }
    hasSlices = hasSlices || IsSlice(entry.path());
  }
  const auto byName = [](const Entry& a, const Entry& b) { return a.Label < b.Label; };
  std::sort(directories.begin(), directories.end(), byName);
  std::sort(files.begin(), files.end(), byName);

  const fs::path before = this->Where;
  this->Where = where;
  this->Found.clear();
  if (where.has_relative_path())
  {
    this->Found.push_back({ "../", where.parent_path(), true });
  }
  if (hasSlices)
  {
    this->Found.push_back({ "the slices here, as one volume", where, false });
  }
  this->Found.insert(this->Found.end(), files.begin(), files.end());
  this->Found.insert(this->Found.end(), directories.begin(), directories.end());
  // The first file; or where one came from.
  this->Selection = this->Found.size() > 1 && where.has_relative_path() ? 1 : 0;
  for (std::size_t i = 0; i < this->Found.size(); ++i)
  {
    if (this->Found[i].Path == before)
    {
      this->Selection = static_cast<int>(i);
    }
  }
}

void FileList::Select(int entry)
{
  this->Selection = std::clamp(entry, 0, std::max(static_cast<int>(this->Found.size()) - 1, 0));
}
