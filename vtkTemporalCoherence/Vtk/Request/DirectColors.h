// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_DirectColors_h
#define TemporalCoherence_DirectColors_h

#include "Scene/Blending.h"

namespace TemporalCoherence
{

/// Give four dependent components the meaning that they have in VTK's GPU mapper.
///
/// They are shares, as in its textures: shares of the largest number for types of 8 or 16 bits,
/// plain values for floats, and shares of the data's range otherwise. The first three are a colour.
/// The share of the last one selects a value in its range, whose opacity counts. AverageRange
/// treats the share of the first one likewise.
/// \param volume of the use RgbOpacity, with ScalarRanges and functions in units of the data.
/// \param type   of the samples
void ShowDirectColors(ScalarType type, Blending& volume);

}

#endif
