// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef StatusLine_h
#define StatusLine_h

#include <string>

// How far a program is: one line on the terminal of standard error, which changes in place and is
// gone at the end. Where that is no terminal, nothing is written.
class StatusLine
{
public:
  StatusLine() = default;
  ~StatusLine();
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

  void Show(const std::string& text);
  void Show(const std::string& what, double share); // "Reading: 40 %"

private:
  std::string Shown;
};

#endif
