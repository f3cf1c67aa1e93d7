// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Fuzz_Acts_h
#define Fuzz_Acts_h

#include "Oracle/Oracle.h"

namespace Fuzz
{

/// What is asked of a mapper other than frames.
namespace Acts
{

/// Something before the next frame; mostly nothing.
void Before(World& world, Oracle& oracle, Tally& tally);

/// Questions about the last frame or the scene; mostly none.
void After(World& world, Oracle& oracle, Tally& tally);

/// Ask for what is no frame or no setting: every question is answered by an error or not at all.
void AskInVain(World& world, Oracle& oracle);

/// Frames that are stopped, and observers that do what they may not.
void Interrupt(World& world, Oracle& oracle, Tally& tally);

}

}

#endif
