// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewFile/WholeFile.h"

#include <filesystem>
#include <fstream>
#include <system_error>

namespace TemporalCoherence
{

std::string ReplaceFile(const std::string& path, const std::vector<std::uint8_t>& bytes)
{
  const std::filesystem::path file = std::filesystem::u8path(path);
  std::filesystem::path unfinished = file;
  unfinished += ".part";
  std::error_code failure;
  {
    std::ofstream stream(unfinished, std::ios::binary);
    stream.write(
      reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    stream.flush();
    if (!stream)
    {
      stream.close();
      std::filesystem::remove(unfinished, failure);
      return path + " cannot be written; is its folder there, and is there room?";
    }
  }
  std::filesystem::rename(unfinished, file, failure);
  if (failure)
  {
    const std::string reason = failure.message();
    std::filesystem::remove(unfinished, failure);
    return path + " cannot be replaced: " + reason + ".";
  }
  return {};
}

std::string ReadWholeFile(const std::string& path, std::vector<std::uint8_t>& bytes)
{
  const std::filesystem::path file = std::filesystem::u8path(path);
  std::error_code failure;
  const std::uintmax_t size = std::filesystem::file_size(file, failure);
  std::ifstream stream(file, std::ios::binary);
  if (failure || !stream)
  {
    return path + " cannot be read; is it a file?";
  }
  bytes.resize(static_cast<std::size_t>(size));
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  return stream && static_cast<std::uintmax_t>(stream.gcount()) == size
    ? std::string()
    : path + " cannot be read to its end.";
}

}
