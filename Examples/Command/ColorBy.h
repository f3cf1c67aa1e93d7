// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ColorBy_h
#define ColorBy_h

#include "Model/Model.h"

#include <string>

// The array of an open volume, and its component, that a text names: NAME, NAME:N from 1, or
// NAME:length, which NAME alone means, too, if it has several components. Throws UserError.
ArrayColor ColorByOf(const Model& model, const std::string& text);

#endif
