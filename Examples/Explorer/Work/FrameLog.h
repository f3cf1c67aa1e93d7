// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FrameLog_h
#define FrameLog_h

#include <fstream>
#include <string>

struct FrameFacts;

// For scripts: a line for each frame, sentence and place, written at once. Without a path nothing
// is written.
class FrameLog
{
public:
  // Throws UserError if the file cannot be written.
  explicit FrameLog(const std::string& path);

  void Frame(const FrameFacts& facts, double isovalue, double windowMs);
  void Said(const std::string& sentence);
  void Place(const std::string& name, int x, int y); // in the window, from its upper left corner
  void Event(const std::string& name, const std::string& value);

private:
  std::ofstream File;
  int Frames = 0;
};

#endif
