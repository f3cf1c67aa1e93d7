// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_ProcessMemory_h
#define Testing_ProcessMemory_h

/// Memory of this process in bytes, as Linux tells it; not a number on other systems.
namespace ProcessMemory
{

/// In physical memory now. What was freed is given back to the system first.
double Resident();

/// The most there was in physical memory since the last call of ResetPeak(), or from the beginning.
double Peak();

/// False if the system does not let the peak be forgotten.
bool ResetPeak();

}

#endif
