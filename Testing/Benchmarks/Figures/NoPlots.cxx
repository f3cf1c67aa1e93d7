// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Takes the place of Plots.cxx where VTK has no charts.

#include "Plots.h"

#include "Measuring.h"

void Plots::Write(const Chart&, const std::string&)
{
  throw Measuring::Failure(
    "This VTK has no charts: leave --plots out, or use one with ChartsCore and IOExport.");
}
