// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Memory_h
#define Memory_h

// Bytes of memory that the machine has.
double MemoryOfMachine();

#endif
