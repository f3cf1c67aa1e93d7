// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Recorder_h
#define Recorder_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <string>

// Keeps pictures: single ones, and one after another as a recording. Names are counted up, so that
// nothing is written over. The functions throw UserError.
class Recorder
{
public:
  explicit Recorder(const std::string& directory);
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  // Where the picture is.
  std::string Save(vtkImageData* picture);

  // As "png", a directory of numbered pictures, or as "ogv", a film.
  void Start(const std::string& format);
  bool IsRecording() const { return this->Target != nullptr; }
  void Add(vtkImageData* picture);

  // How many pictures are where.
  std::string Stop();

private:
  struct Writer;
  struct PngWriter;
  struct FilmWriter;

  std::string Directory;
  std::unique_ptr<Writer> Target;
  int Frames = 0;
};

#endif
