// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LargeVolume_h
#define LargeVolume_h

#include "Files/Reading.h"
#include "Files/Volume.h"
#include "Program/VolumeSource.h"

#include <string>

// Volumes that are read as they are needed, by vtkTemporalCoherenceBrickSource: those of Zarr and
// HDF5, and raw samples and stacks of slices that would fill much of the memory, or that the user
// calls large.

// Whether the name ends as that of HDF5 does: .ims, .h5, .hdf5.
bool IsHdf5Name(const std::string& path);

// Whether a volume is read so. Throws UserError if the user asks for it, and it cannot be.
bool IsReadAsNeeded(const VolumeSource& source);

// Opens it. The first time, that takes as long as to read all of it. Throws UserError.
void OpenLarge(const VolumeSource& source, const ReadingProgress& progress, Volume& volume);

#endif
