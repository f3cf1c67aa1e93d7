// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Program/StatusLine.h"

#include "Program/Terminal.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

StatusLine::~StatusLine()
{
  this->Show("");
}

void StatusLine::Show(const std::string& text)
{
  if (text == this->Shown || !IsTerminal(stderr))
  {
    return;
  }
  const std::size_t width = std::max(text.size(), this->Shown.size());
  std::string line = text;
  line.resize(width, ' '); // over what was there
  std::fprintf(stderr, "\r%s\r%s", line.c_str(), text.c_str());
  std::fflush(stderr);
  this->Shown = text;
}

void StatusLine::Show(const std::string& what, double share)
{
  const long percent = std::lround(100.0 * std::clamp(share, 0.0, 1.0));
  this->Show(what + ": " + std::to_string(percent) + " %");
}
