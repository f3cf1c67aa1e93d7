// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/JsonFiles.h"

#include "VolumeFiles/FileFacts.h"

#include <system_error>

namespace TemporalCoherence
{
namespace
{

constexpr std::uint64_t MostBytes = 16U << 20U;
constexpr int MostLevels = 64;

/// Functions that walk through values may call themselves for each level.
bool IsTooDeep(const std::string& text)
{
  int depth = 0;
  bool isInString = false;
  for (std::size_t i = 0; i < text.size() && depth <= MostLevels; ++i)
  {
    const char letter = text[i];
    if (isInString)
    {
      i += letter == '\\' ? 1 : 0;
      isInString = letter != '"';
    }
    else
    {
      isInString = letter == '"';
      depth += letter == '[' || letter == '{' ? 1 : letter == ']' || letter == '}' ? -1 : 0;
    }
  }
  return depth > MostLevels;
}

bool ParseObject(const std::string& text, Json& object)
{
  if (IsTooDeep(text))
  {
    return false;
  }
  constexpr bool AllowsExceptions = false;
  object = Json::parse(text, nullptr, AllowsExceptions);
  return object.is_object();
}

}

FileState JsonFiles::Read(const std::filesystem::path& path, Json& object, std::string& error)
{
  ContainedFile file;
  const FileState state = file.Open(this->Folder, path, error);
  if (state != FileState::Opened)
  {
    return state;
  }
  if (file.Size() > MostBytes)
  {
    error = "File " + path.string() +
      " has more than 16 MiB, too much for metadata; copy the volume again.";
    return FileState::Refused;
  }
  std::string text(static_cast<std::size_t>(file.Size()), ' ');
  if (!file.Read(0, text.size(), text.data()))
  {
    error = "File " + path.string() + " cannot be read; check its disk.";
    return FileState::Refused;
  }
  if (!ParseObject(text, object))
  {
    error = "File " + path.string() + " is not a valid JSON object; copy the volume again.";
    return FileState::Refused;
  }
  this->StampText += FileFacts(path.string());
  return FileState::Opened;
}

const Json& MemberOf(const Json& value, const char* name)
{
  static const Json Null;
  if (!value.is_object())
  {
    return Null;
  }
  const auto found = value.find(name);
  return found == value.end() ? Null : *found;
}

std::string TextOf(const Json& value, const char* name)
{
  const Json& member = MemberOf(value, name);
  return member.is_string() ? member.get<std::string>() : std::string();
}

}
