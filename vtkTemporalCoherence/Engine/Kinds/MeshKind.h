// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshKind_h
#define TemporalCoherence_MeshKind_h

#include "Kinds/FieldKind.h"
#include "Mesh/Tree/MeshTree.h"

#include <memory>

namespace TemporalCoherence
{

/// Make the kind of irregular fields: cells of any shape. The tree defines the field's lattice, and
/// index space contains the tree's boxes.
/// \param averagedGradients normals are continuous; otherwise each cell's interpolant gives them,
///                          so that a surface in tetrahedra has facets
/// \throws std::bad_alloc
std::shared_ptr<const FieldKind> MeshKind(
  std::shared_ptr<const MeshTree> tree, bool averagedGradients);

/// Make the field of a tree's mesh.
/// \param shape made by MeshKind
Field MeshField(const MeshTree& tree, std::shared_ptr<const FieldShape> shape);

}

#endif
