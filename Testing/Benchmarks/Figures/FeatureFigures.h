// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_FeatureFigures_h
#define Benchmarks_FeatureFigures_h

#include "Figures.h"

/// Pictures that show what else the mapper draws.
namespace FeatureFigures
{

/// Each subject translucent, with others inside; and as a solid, clipped and cropped:
/// features.png.
void SeenThroughAndCutOpen(const Figures::Settings& settings);

}

#endif
