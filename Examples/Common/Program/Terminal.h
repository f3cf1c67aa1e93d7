// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Terminal_h
#define Terminal_h

#include <cstdio>

// Whether a stream is read by a person; else by a file or a program.
bool IsTerminal(std::FILE* stream);

#endif
