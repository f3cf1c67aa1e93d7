// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MergedMesh_h
#define MergedMesh_h

#include "DistributedPart.h"

class vtkUnstructuredGrid;

/// All blocks that have an array as one mesh with this array alone; if none has it, all blocks with
/// what they have in common. ParaView exchanges cells of meshes between processes, but loses those
/// of blocks.
vtkSmartPointer<vtkUnstructuredGrid> Merge(vtkDataObject* blocks, const ArrayChoice& choice);

#endif
