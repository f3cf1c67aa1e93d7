// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Pictures_h
#define Pictures_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

// Writes PNG files into one directory and gathers small ones into a contact sheet: one block of
// rows for each part of a tour.
class PictureBook
{
public:
  // Makes the directory. Throws UserError if it cannot be written in.
  explicit PictureBook(const std::string& directory);

  // Lays an RGBA picture on the background and writes it as PART_NNN.png; of all the frames of a
  // part, as many as fit are taken into the contact sheet, with a caption.
  void Add(vtkImageData* picture, const std::string& part, int frame, int frames,
    const std::string& caption);

  void WriteContactSheet() const;

  int NumberOfPictures() const { return this->Written; }
  std::string ContactSheet() const;

private:
  std::filesystem::path Directory;
  int Written = 0;
  std::vector<std::string> Parts; // in the order of the sheet
  std::map<std::string, std::vector<vtkSmartPointer<vtkImageData>>> Thumbnails;
};

#endif
