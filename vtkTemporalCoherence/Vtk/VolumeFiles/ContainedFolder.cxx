// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/ContainedFolder.h"

#include <system_error>

namespace TemporalCoherence
{
namespace
{

namespace fs = std::filesystem;

/// \return false for names that are no names of folders, or lead upwards
bool IsPlainName(const std::string& name)
{
  if (name.empty() || name.find('\0') != std::string::npos || name.find('\\') != std::string::npos)
  {
    return false;
  }
  const fs::path path(name);
  if (path.has_root_path())
  {
    return false;
  }
  for (const fs::path& part : path)
  {
    if (part == "..")
    {
      return false;
    }
  }
  return true;
}

/// A name for an error sentence. Bytes that end or disturb a line become question marks.
std::string Printable(std::string name)
{
  constexpr std::size_t Longest = 200;
  if (name.size() > Longest)
  {
    name.resize(Longest);
    name += "...";
  }
  for (char& letter : name)
  {
    const auto code = static_cast<unsigned char>(letter);
    letter = code < 0x20 || code == 0x7f ? '?' : letter;
  }
  return name;
}

bool IsMissing(const std::error_code& code)
{
  return code == std::errc::no_such_file_or_directory || code == std::errc::not_a_directory;
}

bool IsFolder(const fs::path& path)
{
  std::error_code code;
  return fs::is_directory(path, code) && !code;
}

}

bool ContainedFolder::Open(const std::string& path, std::string& error)
{
  std::error_code code;
  if (path.empty() || path.find('\0') != std::string::npos)
  {
    error = "A volume needs the path of its folder; give a path without null characters.";
    return false;
  }
  this->Root = fs::canonical(path, code);
  if (code || !IsFolder(this->Root))
  {
    error = "Folder " + Printable(path) + " cannot be opened" +
      (code ? " (" + code.message() + ")" : std::string()) + "; check the path of the volume.";
    return false;
  }
  return true;
}

bool ContainedFolder::Find(
  const fs::path& parent, const std::string& name, fs::path& found, std::string& error) const
{
  if (!IsPlainName(name))
  {
    error = "Name \"" + Printable(name) + "\" in " + parent.string() +
      " is not the name of a folder within the volume; use a relative path without \"..\".";
    return false;
  }
  std::error_code code;
  found = fs::canonical(parent / name, code);
  if (!code && !this->Contains(found))
  {
    error = "Link " + Printable((parent / name).string()) +
      " leads out of the volume's folder; copy what it points to into the folder.";
    return false;
  }
  if (code || !IsFolder(found))
  {
    error = "Folder " + Printable((parent / name).string()) +
      " does not exist; copy the volume again or choose another array.";
    return false;
  }
  return true;
}

bool ContainedFolder::Contains(const fs::path& path) const
{
  const auto& whole = path.native();
  const auto& start = this->Root.native();
  if (whole.compare(0, start.size(), start) != 0)
  {
    return false;
  }
  return whole.size() == start.size() || start.back() == fs::path::preferred_separator ||
    whole[start.size()] == fs::path::preferred_separator;
}

FileState ContainedFile::Open(
  const ContainedFolder& folder, const fs::path& path, std::string& error)
{
  std::error_code code;
  const fs::path real = fs::canonical(path, code);
  if (code)
  {
    std::error_code ignored;
    if (IsMissing(code) && !fs::is_symlink(fs::symlink_status(path, ignored)))
    {
      return FileState::Missing;
    }
    error = "File " + path.string() + " cannot be found (" + code.message() +
      "); check its folder's permissions and links.";
    return FileState::Refused;
  }
  if (!folder.Contains(real))
  {
    error = "Link " + path.string() +
      " leads out of the volume's folder; copy what it points to into the folder.";
    return FileState::Refused;
  }
  // Opening a pipe would wait forever.
  if (!fs::is_regular_file(real, code))
  {
    error = "File " + path.string() + " is not a regular file; copy the volume again.";
    return FileState::Refused;
  }
  this->Stream.open(real, std::ios::binary | std::ios::ate);
  const std::streamoff end = this->Stream ? std::streamoff(this->Stream.tellg()) : -1;
  if (end < 0)
  {
    error = "File " + path.string() + " cannot be opened; check its permissions.";
    return FileState::Refused;
  }
  this->Bytes = static_cast<std::uint64_t>(end);
  return FileState::Opened;
}

bool ContainedFile::Read(std::uint64_t offset, std::size_t bytes, void* to)
{
  if (offset > this->Bytes || bytes > this->Bytes - offset)
  {
    return false;
  }
  this->Stream.seekg(static_cast<std::streamoff>(offset));
  this->Stream.read(static_cast<char*>(to), static_cast<std::streamsize>(bytes));
  return static_cast<std::size_t>(this->Stream.gcount()) == bytes;
}

}
