// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Fuzz_Tally_h
#define Fuzz_Tally_h

#include <map>
#include <string>

namespace Fuzz
{

/// What was met in all runs together.
struct Tally
{
  long Runs = 0, Steps = 0;
  long Refused = 0;                   ///< frames
  long WithSurface = 0;               ///< frames that show a surface
  std::map<std::string, long> Routes; ///< frames of each, which show a surface
  std::map<std::string, long> Merged; ///< of these, frames with merged layers
  std::map<std::string, long> Acts;   ///< what else was asked of the mapper
  std::map<std::string, long> Errors; ///< by their first words
  /// Of tame look-ups with a tolerance: all pixels, and those that differ.
  double TolerantPixels = 0, TolerantOthers = 0;
};

}

#endif
