// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Recorder_h
#define Recorder_h

#include "Model/Film.h"

#include <vtkImageData.h>

#include <optional>
#include <string>

// Keeps pictures: single ones, and one after another as a recording. Names are counted up, so that
// nothing is written over. The functions throw UserError.
class Recorder
{
public:
  explicit Recorder(const std::string& directory);

  std::string NextPath() const;            // of a single picture
  std::string Save(vtkImageData* picture); // there; where it is

  // As "png", a directory of numbered pictures, or as "ogv", a film.
  void Start(const std::string& format);
  bool IsRecording() const { return this->IsOn; }
  void Add(vtkImageData* picture);

  // How many pictures are where.
  std::string Stop();

  const std::string Directory;

private:
  std::optional<Film> Target; // of the recording, or of the last one
  bool IsOn = false;
};

#endif
