// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FileParts_h
#define TemporalCoherence_FileParts_h

#include "ViewFile/ZlibBytes.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace TemporalCoherence
{

/// A view file in its parts, so that tests can change one and keep the others right.
struct FileParts
{
  using Bytes = std::vector<std::uint8_t>;

  static constexpr std::size_t BytesBeforeHeader = 24, PlaceOfLength = 12, PlaceOfChecksum = 16;

  explicit FileParts(const Bytes& file)
    : Begin(file.begin(), file.begin() + BytesBeforeHeader)
  {
    std::size_t length = 0;
    for (std::size_t byte = 0; byte < 4; ++byte)
    {
      length |= static_cast<std::size_t>(file[PlaceOfLength + byte]) << (8 * byte);
    }
    const auto header = file.begin() + BytesBeforeHeader;
    const auto sections = header + static_cast<std::ptrdiff_t>(length);
    this->Header.assign(header, sections);
    this->Sections.assign(sections, file.end());
  }

  /// The file of these parts: its length and its checksum are right.
  Bytes Join() const
  {
    Bytes file = this->Begin;
    Write(static_cast<std::uint32_t>(this->Header.size()), PlaceOfLength, file);
    Write(Checksum(this->Header), PlaceOfChecksum, file);
    file.insert(file.end(), this->Header.begin(), this->Header.end());
    file.insert(file.end(), this->Sections.begin(), this->Sections.end());
    return file;
  }

  Bytes Begin;
  std::string Header;
  Bytes Sections;

private:
  static void Write(std::uint32_t number, std::size_t at, Bytes& bytes)
  {
    for (std::size_t byte = 0; byte < 4; ++byte)
    {
      bytes[at + byte] = static_cast<std::uint8_t>(number >> (8 * byte));
    }
  }
};

}

#endif
