// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Hdf5Types_h
#define TemporalCoherence_Hdf5Types_h

#include "Scene/ScalarType.h"
#include "VolumeFiles/Hdf5Library.h"

namespace TemporalCoherence
{

/// Find the type in memory that holds all values of a type in a file. Needs an Hdf5Turn.
/// \return false if a sample is no integer or floating-point number of 8 to 64 bits
bool FindScalarType(hid_t type, ScalarType& scalarType);

/// HDF5's description of a type in memory. Not to be closed. Needs an Hdf5Turn.
hid_t MemoryTypeOf(ScalarType type);

}

#endif
