// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MeshReader_h
#define MeshReader_h

#include "Files/Reading.h"
#include "Files/Volume.h"
#include "Program/VolumeSource.h"

#include <string>

// Whether the name ends as that of a grid that is read here: other than images, and not .vtk.
bool IsMeshName(const std::string& path);

// For messages: those of this build of VTK.
std::string ListOfMeshSuffixes();

// Read a grid, or a composite of grids, by VTK's readers: data and time steps of the volume are
// set, and a remark. Throws UserError.
void ReadMesh(const VolumeSource& source, const ReadingProgress& progress, Volume& volume);

// What is told of a file whose reader had errors: the part that it could not read, of a list of
// files.
UserError UnreadableOrPart(const std::string& path);

#endif
