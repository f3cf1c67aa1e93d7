// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef HandOver_h
#define HandOver_h

#include "Files/Volume.h"

#include <optional>
#include <string>

// A volume on its way from one process of a program to another, in a file that nobody else reads.

// False if it is of a kind that is not handed over (composites, polyhedra), or if the file cannot
// be written.
bool WriteHandOver(const Volume& volume, const std::string& path);

// None if the file is not whole.
std::optional<Volume> ReadHandOver(const std::string& path);

#endif
