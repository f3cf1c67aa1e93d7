// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FileCheck_h
#define FileCheck_h

#include "Program/UserError.h"

#include <cstdint>
#include <string>

// VTK's readers believe what the header of a file says: some take memory for it, some write where
// there is none, some never end. So headers are looked at before: what they tell must be possible,
// and must fit what the file has. Each throws UserError where it does not; a file that passes may
// still be refused by its reader.
void CheckDicomFiles(const std::string& directory);
std::string CheckLegacyFile(const std::string& path); // "structured_points" or a mesh
void CheckMetaImage(const std::string& path);
void CheckNifti(const std::string& path);
void CheckSlc(const std::string& path);
void CheckXmlFile(const std::string& path);

// The sentence that tells what is wrong with a file.
UserError Damaged(const std::string& path, const std::string& reason);

// How many bytes one byte of a file can become at most.
constexpr double MostByDeflation = 1032.0; // zlib: "Maximum Compression Factor"

// Throws if samples take more bytes than a file has for them.
// \param samples   how many there are; not a whole number where that would be too large
// \param bytes     what each takes
// \param there     bytes of the file that may hold them
// \param inflation how many bytes one of them can become
void RequireSamples(
  const std::string& path, double samples, double bytes, double there, double inflation = 1.0);

// The whole file, or its beginning. Throws if it is no regular file or cannot be read.
std::string BytesOf(const std::string& path, std::uintmax_t most = UINTMAX_MAX);

// Bytes of a regular file; throws if it is none.
std::uintmax_t SizeOf(const std::string& path);

// The text is a whole number, with nothing around it, from the least to the most.
bool IsWhole(const std::string& text, long long least, long long most, long long& number);

#endif
