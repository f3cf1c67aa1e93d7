// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SameCells_h
#define TemporalCoherence_SameCells_h

#include "Mesh/Mesh.h"

namespace TemporalCoherence
{

/// True if parts that were made of the same data set differ in nothing but values: cells, points
/// and the cells that they were made of are the same.
bool HaveSameCells(const MeshPart& a, const MeshPart& b);

}

#endif
