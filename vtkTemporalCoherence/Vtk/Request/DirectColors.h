// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_DirectColors_h
#define TemporalCoherence_DirectColors_h

#include "Scene/Blending.h"

namespace TemporalCoherence
{

/// Give four components that depend on each other the meaning that VTK's GPU mapper gives them.
///
/// They are shares, as its textures hold them: of the largest number of a type of 8 or 16 bits, the
/// values themselves if they are floats, and shares of the range of the data otherwise. The first
/// three are a colour. The last one tells a place between the ends of its range, whose opacity
/// counts; so does the first one, for AverageRange.
/// \param volume of the use RgbOpacity. Its ScalarRanges and functions are those of the data.
/// \param type   of the samples
void ShowDirectColors(ScalarType type, Blending& volume);

}

#endif
