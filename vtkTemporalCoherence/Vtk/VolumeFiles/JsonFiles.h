// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_JsonFiles_h
#define TemporalCoherence_JsonFiles_h

#include "VolumeFiles/ContainedFolder.h"

#include <nlohmann/json.hpp>

#include <string>

namespace TemporalCoherence
{

using Json = nlohmann::json;

/// Reads a folder's metadata, which are objects in JSON files.
class JsonFiles
{
public:
  /// \param folder must outlive this
  explicit JsonFiles(const ContainedFolder& folder)
    : Folder(folder)
  {
  }

  /// \param path   the file
  /// \param object receives the file's object
  /// \param error  receives what is wrong, in one sentence, if the file is refused
  FileState Read(const std::filesystem::path& path, Json& object, std::string& error);

  /// Paths, sizes and modification times of the files that were read.
  const std::string& Stamps() const { return this->StampText; }

private:
  const ContainedFolder& Folder;
  std::string StampText;
};

/// The member of an object.
/// \param value an object or anything else
/// \return null if the value is not an object, or has no such member
const Json& MemberOf(const Json& value, const char* name);

/// The text of a member; empty if the member is missing or no text.
std::string TextOf(const Json& value, const char* name);

}

#endif
