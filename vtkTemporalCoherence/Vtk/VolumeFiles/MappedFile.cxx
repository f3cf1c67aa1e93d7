// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/MappedFile.h"

#include "VolumeFiles/RandomAccessFile.h"

#ifdef _WIN32

namespace TemporalCoherence
{

std::unique_ptr<MappedFile> MappedFile::Map(const RandomAccessFile&, std::uint64_t)
{
  return nullptr;
}

MappedFile::~MappedFile() = default;

}

#else

#include <limits>
#include <utility>

#include <sys/mman.h>

namespace TemporalCoherence
{

std::unique_ptr<MappedFile> MappedFile::Map(const RandomAccessFile& file, std::uint64_t bytes)
{
  if (bytes == 0 || bytes > file.Size() || bytes > std::numeric_limits<std::size_t>::max() / 2)
  {
    return nullptr;
  }
  std::unique_ptr<MappedFile> mapped(new MappedFile);
  mapped->Bytes = static_cast<std::size_t>(bytes);
  void* begin = ::mmap(nullptr, mapped->Bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_NORESERVE,
    file.Descriptor(), 0);
  if (begin == MAP_FAILED)
  {
    return nullptr;
  }
  mapped->Begin = static_cast<std::byte*>(begin);
  return mapped->Guard.Guard(begin, mapped->Bytes) ? std::move(mapped) : nullptr;
}

MappedFile::~MappedFile()
{
  if (this->Begin)
  {
    this->Guard.Release();
    ::munmap(this->Begin, this->Bytes);
  }
}

}

#endif
