// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PictureFile_h
#define PictureFile_h

#include <array>
#include <cstddef>
#include <memory>
#include <string>

// What the header of a picture tells.
struct PictureKind
{
  int Width = 0, Height = 0, Components = 1;
  int Type = 0; // VTK_UNSIGNED_CHAR, ...
  std::array<double, 3> Spacing = { 1.0, 1.0, 1.0 };
  bool IsOfPalette = false; // samples are numbers of colours in a table

  std::size_t BytesOfRow() const;
  bool IsLike(const PictureKind& other) const; // they may be slices of one volume
  std::string Text() const;                    // "512 x 512, unsigned short"
};

// A file of pictures of the same or other kinds. All functions throw UserError. VTK's readers draw
// what is missing in a file as what memory held before, and colours of 16 bits by half.
class PictureFile
{
public:
  virtual ~PictureFile() = default;

  // Goes to the next picture, at first to the first one. False after the last one.
  virtual bool Next() = 0;

  const PictureKind& Kind() const { return this->Picture; }

  // All rows of the picture, the uppermost first, samples in the order of this machine's bytes.
  virtual void Read(unsigned char* to) = 0;

protected:
  PictureKind Picture;
};

std::unique_ptr<PictureFile> OpenTiff(const std::string& path);
std::unique_ptr<PictureFile> OpenPng(const std::string& path);

#endif
