// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SeriesFile_h
#define SeriesFile_h

#include <string>
#include <vector>

// Files that belong to one time, and are drawn together.
struct SeriesStep
{
  double Time = 0.0;
  std::vector<std::string> Files;
};

// Whether the name ends as that of a list of files for times: .pvd and .series, as ParaView has
// them.
bool IsSeriesName(const std::string& path);

// In the order of their times, at least one. Throws UserError.
std::vector<SeriesStep> ReadSeriesFile(const std::string& path);

#endif
