// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Pictures_h
#define Pictures_h

#include <string>

class Model;
struct Options;

// Draws the picture, the film or the shared view that the options ask for, and writes it. Returns
// what is where, for people. Throws UserError.
std::string WritePictures(Model& model, const Options& options);

// Throws UserError where the output cannot be what is asked for: before anything takes long.
void CheckOutput(const Options& options);

#endif
