// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FileRoom_h
#define TemporalCoherence_FileRoom_h

#include <cstddef>
#include <memory>
#include <string>

namespace TemporalCoherence
{

/// A file whose bytes serve as memory. A complete file gets its name at last, so no program finds
/// half a file. Systems without POSIX have no such files.
class FileRoom
{
public:
  /// Make a file for writing. Its space on the disk is reserved, so a full disk
  /// cannot stop the writing. Without Keep() the file is deleted.
  /// \param path name of the finished file
  /// \return null if it cannot be made
  static std::shared_ptr<FileRoom> Create(const std::string& path, std::size_t bytes);

  ~FileRoom();
  FileRoom(const FileRoom&) = delete;
  FileRoom& operator=(const FileRoom&) = delete;

  std::byte* Data() { return this->Bytes; }

  /// Write bytes behind the mapped ones.
  bool Append(const void* bytes, std::size_t count);

  /// Give a file that was made its name, in place of a file of that name.
  bool Keep();

private:
  FileRoom() = default;

  std::string Name, Unfinished;
  int Descriptor = -1;
  std::byte* Bytes = nullptr;
  std::size_t Length = 0;
};

}

#endif
