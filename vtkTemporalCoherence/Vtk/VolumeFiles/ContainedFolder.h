// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ContainedFolder_h
#define TemporalCoherence_ContainedFolder_h

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

namespace TemporalCoherence
{

/// Whether a file could be opened.
enum class FileState : std::uint8_t
{
  Opened,
  Missing,
  Refused ///< it exists, but cannot or must not be read
};

/// A folder that contains all files that may be read. Names in its files, and symbolic links in it,
/// must not lead out of it: a volume from a stranger could show the user's other files.
class ContainedFolder
{
public:
  /// \param path  the folder; it may be a symbolic link, as the user named it
  /// \param error receives what is wrong, in one sentence
  bool Open(const std::string& path, std::string& error);

  /// The folder's path, absolute and without symbolic links.
  const std::filesystem::path& Path() const { return this->Root; }

  /// Find an existing folder by a name that a file or the user gives.
  /// \param parent the folder that the name is relative to
  /// \param name   names of folders, with slashes
  /// \param found  receives the path without symbolic links
  /// \param error  receives what is wrong, in one sentence
  /// \return false if there is no such folder, or if it lies outside of this folder
  bool Find(const std::filesystem::path& parent, const std::string& name,
    std::filesystem::path& found, std::string& error) const;

  /// \param path an absolute path without symbolic links
  bool Contains(const std::filesystem::path& path) const;

private:
  std::filesystem::path Root;
};

/// A file in a folder, opened for reading.
class ContainedFile
{
public:
  /// \param error receives what is wrong, in one sentence, if the file is refused
  FileState Open(
    const ContainedFolder& folder, const std::filesystem::path& path, std::string& error);

  /// Bytes of the file.
  std::uint64_t Size() const { return this->Bytes; }

  /// \param offset first byte to read
  /// \param bytes  number of bytes to read
  /// \param to     room for these bytes
  /// \return false if the file ends before, or if the system reports an error
  bool Read(std::uint64_t offset, std::size_t bytes, void* to);

private:
  std::ifstream Stream;
  std::uint64_t Bytes = 0;
};

}

#endif
