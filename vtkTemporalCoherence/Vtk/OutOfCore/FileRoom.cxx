// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OutOfCore/FileRoom.h"

#ifndef _WIN32
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <vector>
#endif

namespace TemporalCoherence
{

#ifdef _WIN32

std::shared_ptr<FileRoom> FileRoom::Create(const std::string&, std::size_t)
{
  return nullptr;
}
FileRoom::~FileRoom() = default;
bool FileRoom::Append(const void*, std::size_t)
{
  return false;
}
bool FileRoom::Keep()
{
  return false;
}

#else

std::shared_ptr<FileRoom> FileRoom::Create(const std::string& path, std::size_t bytes)
{
  const std::string pattern = path + ".XXXXXX";
  std::vector<char> name(pattern.begin(), pattern.end());
  name.push_back('\0');
  const std::shared_ptr<FileRoom> room(new FileRoom);
  room->Descriptor = mkostemp(name.data(), O_CLOEXEC);
  if (room->Descriptor < 0)
  {
    return nullptr;
  }
  room->Name = path;
  room->Unfinished = name.data();
  room->Length = bytes;
  if (posix_fallocate(room->Descriptor, 0, static_cast<off_t>(bytes)) != 0)
  {
    return nullptr;
  }
  void* const address =
    mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, room->Descriptor, 0);
  if (address == MAP_FAILED)
  {
    return nullptr;
  }
  room->Bytes = static_cast<std::byte*>(address);
  return room;
}

FileRoom::~FileRoom()
{
  if (this->Bytes)
  {
    munmap(this->Bytes, this->Length);
  }
  if (this->Descriptor >= 0)
  {
    close(this->Descriptor);
  }
  if (!this->Unfinished.empty())
  {
    unlink(this->Unfinished.c_str());
  }
}

bool FileRoom::Append(const void* bytes, std::size_t count)
{
  const auto* from = static_cast<const std::byte*>(bytes);
  auto at = static_cast<off_t>(this->Length);
  while (count > 0)
  {
    const ssize_t written = pwrite(this->Descriptor, from, count, at);
    if (written <= 0)
    {
      return false;
    }
    from += written;
    at += written;
    count -= static_cast<std::size_t>(written);
  }
  return true;
}

bool FileRoom::Keep()
{
  const mode_t mask = umask(0);
  umask(mask);
  if (fchmod(this->Descriptor, 0666 & ~mask) != 0 ||
    rename(this->Unfinished.c_str(), this->Name.c_str()) != 0)
  {
    return false;
  }
  this->Unfinished.clear();
  return true;
}

#endif

}
