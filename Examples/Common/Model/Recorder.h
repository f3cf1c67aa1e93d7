// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Recorder_h
#define Recorder_h

#include <vtkAlgorithm.h>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <filesystem>
#include <string>

// Keeps pictures: single ones, and one after another as a recording. Names are counted up, so that
// nothing is written over. The functions throw UserError.
class Recorder
{
public:
  explicit Recorder(const std::string& directory);

  std::string NextPath() const;            // of a single picture
  std::string Save(vtkImageData* picture); // there; where it is

  // As "png", a directory of numbered pictures, or as "ogv", a film of so many frames a second.
  // Without a path it is counted up.
  void Start(const std::string& format, const std::string& path = "", int rate = 25);
  bool IsRecording() const { return !this->Target.empty(); }
  void Add(vtkImageData* picture);

  // How many pictures are where.
  std::string Stop();

  const std::string Directory;

private:
  std::filesystem::path Target;
  vtkSmartPointer<vtkAlgorithm> Film; // null: pictures
  int Frames = 0;
};

#endif
