// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MappedFile_h
#define TemporalCoherence_MappedFile_h

#include "VolumeFiles/BusErrors.h"

#include <cstddef>
#include <cstdint>
#include <memory>

namespace TemporalCoherence
{

class RandomAccessFile;

/// The first bytes of a file, at addresses in memory. Writing changes memory only, not the file.
/// The system reads pages when they are needed, and drops them when memory is short.
class MappedFile
{
public:
  /// \param bytes of the file to map, from its start; at most its size
  /// \return null if the system cannot map the file, or cannot guard it against bus errors (on
  ///         Windows: always); read the file then
  static std::unique_ptr<MappedFile> Map(const RandomAccessFile& file, std::uint64_t bytes);

  ~MappedFile();
  MappedFile(const MappedFile&) = delete;
  MappedFile& operator=(const MappedFile&) = delete;

  /// The address of the file's first byte; a multiple of the size of a page.
  const std::byte* Data() const { return this->Begin; }

  /// True once a part could not be read, for example because the file became shorter. The part
  /// reads as zero. Thread-safe.
  bool IsBroken() const { return this->Guard.IsBroken(); }

private:
  MappedFile() = default;

  std::byte* Begin = nullptr;
  std::size_t Bytes = 0;
  GuardedRange Guard;
};

}

#endif
