// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/RandomAccessFile.h"

#include <algorithm>
#include <cerrno>
#include <system_error>

#ifdef _WIN32
#include <chrono>
#include <filesystem>
#include <fstream>
#include <mutex>
#else
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#endif

namespace TemporalCoherence
{
namespace
{

std::string CannotOpen(const std::string& path, const std::string& reason)
{
  return "Cannot open '" + path + "': " + reason + "; check the path and the permissions.";
}

std::string CannotRead(const std::string& path, std::uint64_t offset, const std::string& reason)
{
  return "Cannot read '" + path + "' at byte " + std::to_string(offset) + ": " + reason +
    "; restore the file and open it again.";
}

const char* const NoRegularFile = "it is no regular file";
const char* const TooShort = "the file ends before";

}

RandomAccessFile::RandomAccessFile() = default;

#ifdef _WIN32

/// Streams have one position: threads take turns.
struct RandomAccessFile::Handle
{
  std::mutex Mutex;
  std::ifstream Stream;
};

RandomAccessFile::~RandomAccessFile() = default;

std::unique_ptr<RandomAccessFile> RandomAccessFile::Open(
  const std::string& path, std::string& error)
{
  const std::filesystem::path place = std::filesystem::u8path(path);
  std::error_code failure;
  if (!std::filesystem::is_regular_file(place, failure))
  {
    error = CannotOpen(path, failure ? failure.message() : NoRegularFile);
    return nullptr;
  }
  std::unique_ptr<RandomAccessFile> file(new RandomAccessFile);
  file->Name = path;
  file->Opened = std::make_unique<Handle>();
  file->Opened->Stream.open(place, std::ios::binary);
  file->Bytes = std::filesystem::file_size(place, failure);
  const auto modified =
    failure ? std::filesystem::file_time_type{} : std::filesystem::last_write_time(place, failure);
  if (failure || !file->Opened->Stream)
  {
    error = CannotOpen(path, failure ? failure.message() : "the system refuses it");
    return nullptr;
  }
  file->Modified =
    std::chrono::duration_cast<std::chrono::nanoseconds>(modified.time_since_epoch()).count();
  return file;
}

bool RandomAccessFile::Read(
  std::uint64_t offset, void* bytes, std::size_t count, std::string& error) const
{
  const std::lock_guard<std::mutex> lock(this->Opened->Mutex);
  std::ifstream& stream = this->Opened->Stream;
  stream.clear();
  stream.seekg(static_cast<std::streamoff>(offset));
  if (!stream.read(static_cast<char*>(bytes), static_cast<std::streamsize>(count)))
  {
    error = CannotRead(this->Name, offset, TooShort);
    return false;
  }
  return true;
}

int RandomAccessFile::Descriptor() const
{
  return -1;
}

#else

struct RandomAccessFile::Handle
{
  int Descriptor = -1;
};

RandomAccessFile::~RandomAccessFile()
{
  if (this->Opened && this->Opened->Descriptor >= 0)
  {
    ::close(this->Opened->Descriptor);
  }
}

std::unique_ptr<RandomAccessFile> RandomAccessFile::Open(
  const std::string& path, std::string& error)
{
  std::unique_ptr<RandomAccessFile> file(new RandomAccessFile);
  file->Name = path;
  file->Opened = std::make_unique<Handle>();
  // O_NONBLOCK: opening a pipe would wait for its other end. Regular files ignore it.
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
  file->Opened->Descriptor = descriptor;
  struct stat about;
  if (descriptor < 0 || ::fstat(descriptor, &about) != 0)
  {
    error = CannotOpen(path, std::generic_category().message(errno));
    return nullptr;
  }
  if (!S_ISREG(about.st_mode))
  {
    error = CannotOpen(path, NoRegularFile);
    return nullptr;
  }
#ifdef __APPLE__
  const struct timespec modified = about.st_mtimespec;
#else
  const struct timespec modified = about.st_mtim;
#endif
  file->Bytes = static_cast<std::uint64_t>(about.st_size);
  file->Modified = static_cast<std::int64_t>(modified.tv_sec) * 1000000000 + modified.tv_nsec;
  return file;
}

bool RandomAccessFile::Read(
  std::uint64_t offset, void* bytes, std::size_t count, std::string& error) const
{
  constexpr std::size_t mostAtOnce = std::size_t(1) << 30; // systems limit it to 2 GiB
  auto* target = static_cast<char*>(bytes);
  while (count > 0)
  {
    const ssize_t got = ::pread(
      this->Opened->Descriptor, target, std::min(count, mostAtOnce), static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR)
    {
      continue;
    }
    if (got <= 0)
    {
      error =
        CannotRead(this->Name, offset, got < 0 ? std::generic_category().message(errno) : TooShort);
      return false;
    }
    target += got;
    offset += static_cast<std::uint64_t>(got);
    count -= static_cast<std::size_t>(got);
  }
  return true;
}

int RandomAccessFile::Descriptor() const
{
  return this->Opened->Descriptor;
}

#endif

}
