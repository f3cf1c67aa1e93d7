// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeanEdge_h
#define TemporalCoherence_MeanEdge_h

namespace TemporalCoherence
{

struct Mesh;

/// The mean length of the edges of a mesh's cells, in its own coordinates: of cells that are spread
/// over the mesh, as all of them would take long. Edges without length do not count. 0 if there are
/// no cells.
/// \pre the mesh is valid
double MeanEdgeOf(const Mesh& mesh);

}

#endif
