// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Target_h
#define Target_h

#include <filesystem>

struct Options;

// How a user is told that something cannot be written.
inline const char* const OutputRemedy = "name another one with -o";

// Where the picture or the film goes: what was asked for, or a name like that of the volume. It is
// tried, before drawing takes its time. Throws UserError.
std::filesystem::path TargetOf(const Options& options);

// Bytes of a file, or of all files of a directory, for people: "812 kB".
std::string SizeForPeople(const std::filesystem::path& target);

#endif
