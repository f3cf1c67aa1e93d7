// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MergedMesh_h
#define MergedMesh_h

#include "DistributedPart.h"

class vtkUnstructuredGrid;

/// All blocks that have the first of some arrays as one mesh, with those of these arrays that they
/// have in common; if none has it, all blocks with what they have in common. ParaView exchanges
/// cells of meshes between processes, but loses those of blocks.
vtkSmartPointer<vtkUnstructuredGrid> Merge(
  vtkDataObject* blocks, const std::vector<ArrayChoice>& choices);

#endif
