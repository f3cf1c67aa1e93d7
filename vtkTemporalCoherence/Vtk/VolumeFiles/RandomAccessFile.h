// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RandomAccessFile_h
#define TemporalCoherence_RandomAccessFile_h

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace TemporalCoherence
{

/// A file that several threads read at any place. It stays open, so that renamed and deleted files
/// can be read, too.
class RandomAccessFile
{
public:
  /// \param path  of a regular file; a folder or a pipe is an error
  /// \param error receives what is wrong and what to do, in one sentence
  /// \return null on error
  static std::unique_ptr<RandomAccessFile> Open(const std::string& path, std::string& error);

  ~RandomAccessFile();
  RandomAccessFile(const RandomAccessFile&) = delete;
  RandomAccessFile& operator=(const RandomAccessFile&) = delete;

  const std::string& Path() const { return this->Name; }

  /// Bytes of the file when it was opened.
  std::uint64_t Size() const { return this->Bytes; }

  /// Nanoseconds since the epoch of the file system's clock, when the file was opened.
  std::int64_t ModificationTime() const { return this->Modified; }

  /// Copy a part of the file. Thread-safe.
  /// \return false if the file has no such part now, or cannot be read; tells why in `error`
  bool Read(std::uint64_t offset, void* bytes, std::size_t count, std::string& error) const;

  /// The number by which POSIX systems know the open file; -1 on other systems.
  int Descriptor() const;

private:
  struct Handle;

  RandomAccessFile();

  std::string Name;
  std::uint64_t Bytes = 0;
  std::int64_t Modified = 0;
  std::unique_ptr<Handle> Opened;
};

}

#endif
