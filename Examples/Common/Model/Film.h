// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Film_h
#define Film_h

#include <vtkAlgorithm.h>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>

// Pictures, one after another: as a film (.ogv), or in a directory, numbered. The functions throw
// UserError.
class Film
{
public:
  // A path that ends with .ogv is that of a film, any other one that of a directory.
  // \param rate pictures a second, of a film
  // \param remedy if it cannot be written: "name another directory with --output"
  Film(const std::filesystem::path& path, int rate, const std::string& remedy);

  void Add(vtkImageData* picture);
  void End();

  int NumberOfPictures() const { return this->Pictures; }
  const std::filesystem::path& Path() const { return this->Target; }

  static bool IsFilmName(const std::filesystem::path& path);
  static bool CanBeWritten(); // .ogv, by this VTK

private:
  std::filesystem::path Target;
  std::string Remedy;
  vtkSmartPointer<vtkAlgorithm> Writer; // null: a directory
  int Pictures = 0;
};

#endif
