// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Fuzz_Report_h
#define Fuzz_Report_h

#include "Oracle/Tally.h"

#include <cstdint>
#include <string>
#include <vector>

namespace Fuzz
{

/// Tells of runs that fail, and of all runs in the end.
namespace Report
{

/// Where the bytes of runs that fail are written.
void SaveTo(const std::string& folder);

/// A run begins.
void Begin(const std::vector<std::uint8_t>& bytes, const std::string& name, const Tally& tally);

/// The run failed.
void TellFailure(const std::string& why);

/// Tell of the run where the program crashes.
void TellCrashes();

/// In a signal handler: the run hangs.
void TellHang();

/// \param expectsAll every route has to be reached, and few pixels differ where some may
/// \return true if all is well
bool Finish(const Tally& tally, int failures, bool expectsAll);

}

}

#endif
