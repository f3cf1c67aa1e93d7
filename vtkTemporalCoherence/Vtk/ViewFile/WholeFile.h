// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_WholeFile_h
#define TemporalCoherence_WholeFile_h

#include <cstdint>
#include <string>
#include <vector>

namespace TemporalCoherence
{

/// Replace a file when all bytes are written.
/// \param path in UTF-8
/// \return what went wrong, as a sentence; empty if nothing did
std::string ReplaceFile(const std::string& path, const std::vector<std::uint8_t>& bytes);

/// Read a file.
/// \return what went wrong, as a sentence; empty if nothing did
/// \throws std::bad_alloc
std::string ReadWholeFile(const std::string& path, std::vector<std::uint8_t>& bytes);

}

#endif
