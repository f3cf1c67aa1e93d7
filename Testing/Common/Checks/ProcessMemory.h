// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_ProcessMemory_h
#define Testing_ProcessMemory_h

/// Memory of this process in bytes, as reported by Linux; NaN on other systems.
namespace ProcessMemory
{

/// Present resident memory, after returning freed memory to the system.
double Resident();

/// Peak resident memory since the last call of ResetPeak(), or since the start.
double Peak();

/// Returns false if the system does not allow it.
bool ResetPeak();

}

#endif
