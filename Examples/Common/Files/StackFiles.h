// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef StackFiles_h
#define StackFiles_h

#include <string>
#include <vector>

// Whether the name ends as that of a picture that may be a slice.
bool IsPictureName(const std::string& path);

// Whether more than half of a folder's files are such pictures.
bool IsFolderOfPictures(const std::string& folder);

// Pictures whose names differ by a number.
struct StackFiles
{
  std::vector<std::string> Paths; // in the order of the numbers: 2 before 10
  std::string Twin;               // a picture of the same number as another one; empty: none is
  double Missing = 0.0;           // numbers between the first and the last one
  std::size_t Others = 0;         // pictures of the folder that have other names
};

// The stack that a picture is one of, or the largest stack of a folder. A picture without a number
// is one by itself.
StackFiles StackFilesOf(const std::string& path);

#endif
