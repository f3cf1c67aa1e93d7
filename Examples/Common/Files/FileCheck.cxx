// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/FileCheck.h"

#include "Program/Quoted.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace fs = std::filesystem;

UserError Damaged(const std::string& path, const std::string& reason)
{
  return UserError(Quoted(path) + " could not be read: " + reason +
    "; check that the file is whole and of the right format.");
}

void RequireSamples(
  const std::string& path, double samples, double bytes, double there, double inflation)
{
  if (!(samples * bytes <= there * inflation))
  {
    std::ostringstream what;
    what.precision(15);
    what << "its header tells of " << samples << " values of " << bytes << " bytes, but it has "
         << there << (inflation > 1.0 ? " compressed bytes" : " bytes") << " for them";
    throw Damaged(path, what.str());
  }
}

std::uintmax_t SizeOf(const std::string& path)
{
  std::error_code error;
  // Others may never end, or never begin.
  if (!fs::is_regular_file(path, error))
  {
    throw Damaged(path, fs::exists(path, error) ? "it is no regular file" : "it is not there");
  }
  const std::uintmax_t size = fs::file_size(path, error);
  return error ? 0 : size;
}

std::string BytesOf(const std::string& path, std::uintmax_t most)
{
  std::string bytes(static_cast<std::size_t>(std::min(SizeOf(path), most)), '\0');
  std::ifstream file(path, std::ios::binary);
  if (!file.read(bytes.data(), static_cast<std::streamsize>(bytes.size())) && !bytes.empty())
  {
    throw Damaged(path, "it could not be read to its end");
  }
  return bytes;
}

bool IsWhole(const std::string& text, long long least, long long most, long long& number)
{
  const bool isNumber = !text.empty() &&
    text.find_first_not_of("0123456789", text[0] == '-' || text[0] == '+') == std::string::npos;
  errno = 0;
  number = isNumber ? std::strtoll(text.c_str(), nullptr, 10) : 0;
  return isNumber && errno == 0 && number >= least && number <= most;
}
