// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/FileFacts.h"

#include <filesystem>

namespace TemporalCoherence
{

std::string FileFacts(const std::string& path)
{
  const std::filesystem::path file = std::filesystem::u8path(path);
  std::error_code failure;
  std::string facts = path;
  const auto size = std::filesystem::file_size(file, failure);
  if (!failure)
  {
    facts += ", " + std::to_string(size) + " bytes";
  }
  const auto time = std::filesystem::last_write_time(file, failure);
  if (!failure)
  {
    facts += ", " + std::to_string(time.time_since_epoch().count());
  }
  return facts + '\n';
}

}
