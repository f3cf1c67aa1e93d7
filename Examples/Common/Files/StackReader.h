// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef StackReader_h
#define StackReader_h

#include "Files/PictureFile.h"
#include "Files/Reading.h"
#include "Files/Volume.h"

#include <string>
#include <vector>

// Slices: the pages of a TIFF, or the numbered pictures that one is named of, or of a folder.
struct SliceStack
{
  std::vector<std::string> Files;
  int Pages = 1;      // of each file
  std::string Remark; // on what is missing; seldom one

  int Count() const { return static_cast<int>(this->Files.size()) * this->Pages; }
};

// Finds them. Throws UserError.
SliceStack SlicesOf(const std::string& path);

// A file of pictures, by its suffix.
std::unique_ptr<PictureFile> OpenPicture(const std::string& path);

// Throws UserError if a picture is of another kind than the slices before it.
void RequireLike(
  const PictureKind& before, const PictureFile& picture, const std::string& file, int page);

// The first row of a picture is at y = 0. Throws UserError.
void ReadStack(const std::string& path, const ReadingProgress& progress, Volume& volume);

#endif
