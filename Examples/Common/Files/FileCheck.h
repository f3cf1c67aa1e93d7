// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FileCheck_h
#define FileCheck_h

#include "Program/UserError.h"

#include <cstdint>
#include <string>

// The sentence that tells what is wrong with a file.
UserError Damaged(const std::string& path, const std::string& reason);

// The sentence for a file that there is not enough memory for.
UserError TooLarge(const std::string& path);

// Bytes of a regular file; throws if it is none.
std::uintmax_t SizeOf(const std::string& path);

// The whole file, or its beginning. Throws if it is no regular file or cannot be read.
std::string BytesOf(const std::string& path, std::uintmax_t most = UINTMAX_MAX);

// Bytes of a file and of the files that it names, or of all files of a folder.
double BytesWithParts(const std::string& path);

// What reading may take, by these bytes.
struct ReadingLimits
{
  double Seconds = 0.0; // of a processor
  double Bytes = 0.0;   // of memory
};
ReadingLimits LimitsOf(const std::string& path);

// Throws if a file cannot hold so many bytes of samples, however they are compressed.
void RequireBytesFor(const std::string& path, double bytes);

#endif
