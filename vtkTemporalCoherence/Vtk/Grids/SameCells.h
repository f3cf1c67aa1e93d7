// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SameCells_h
#define TemporalCoherence_SameCells_h

#include "Mesh/Cells/Mesh.h"

namespace TemporalCoherence
{

/// True if two parts made of one data set differ in values at most: cells, points and original
/// cells are equal.
bool HaveSameCells(const MeshPart& a, const MeshPart& b);

}

#endif
