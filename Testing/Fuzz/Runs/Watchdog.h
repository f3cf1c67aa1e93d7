// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Fuzz_Watchdog_h
#define Fuzz_Watchdog_h

namespace Fuzz
{

/// Ends the program, with a message, where a step takes too long.
namespace Watchdog
{

/// From now on: so many seconds a step.
/// \param bark is called before the end, in a signal handler
void Release(unsigned seconds, void (*bark)());

/// A step begins.
void Feed();

/// No step is made for a while.
void Rest();

}

}

#endif
