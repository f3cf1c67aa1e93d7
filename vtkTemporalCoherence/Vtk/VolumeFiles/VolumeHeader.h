// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_VolumeHeader_h
#define TemporalCoherence_VolumeHeader_h

#include "VolumeFiles/RawLayout.h"

#include <cstddef>
#include <cstdint>
#include <string>

/// \file
/// What the headers of several formats have in common. Nothing in a header is trusted.

namespace TemporalCoherence
{

/// The text of a header. Samples may follow it in the same file.
struct HeaderText
{
  std::string Path;
  std::string Text; ///< the first MiB of the file
};

/// Read the beginning of a file.
/// \return false if the file cannot be read; tells why in `error`
bool ReadHeader(const std::string& path, HeaderText& header, std::string& error);

/// The sentence: Cannot use 'path': what; remedy.
std::string HeaderError(
  const std::string& path, const std::string& what, const std::string& remedy);

/// Text without spaces, tabs and returns at its ends.
std::string Trimmed(const std::string& text);

/// ASCII letters in lower case.
std::string LowerCase(std::string text);

/// Take the next line of a text.
/// \param position of the line; then that of the next one
/// \param line receives the line, trimmed
/// \return false at the end of the text
bool NextLine(const std::string& text, std::size_t& position, std::string& line);

/// Read exactly `count` numbers with spaces between them. The user's language has no influence.
bool ParseNumbers(const std::string& text, std::size_t count, double* numbers);
bool ParseIntegers(const std::string& text, std::size_t count, std::int64_t* numbers);

/// Read three positive numbers that fit into int.
bool ParseDimensions(const std::string& text, glm::ivec3& dimensions);

/// True if nine numbers are those of the identity matrix, but for rounding.
bool IsIdentity(const double* matrix);

/// The path of a file that a header names.
/// \param name relative to the header's folder, or absolute; names of files beyond the header's
///             folder are an error, so that no header can make a program read any file
bool FindDataFile(
  const HeaderText& header, const std::string& name, std::string& path, std::string& error);

/// The offset of samples that end with the file.
/// \return false if the file cannot be read, or is too small
bool FindOffsetFromEnd(const std::string& path, RawLayout& layout, std::string& error);

}

#endif
