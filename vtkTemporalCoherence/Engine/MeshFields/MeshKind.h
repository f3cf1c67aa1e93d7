// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshKind_h
#define TemporalCoherence_MeshKind_h

#include "Scene/Field.h"
#include "Trees/MeshTree.h"

#include <memory>

namespace TemporalCoherence
{

/// The kind of irregular fields: cells of any shape. The lattice of such a field is that of its
/// tree, and its index space is that of the tree's boxes.
/// \param averagedGradients normals are continuous; otherwise, they are those of the interpolant in
///                          each cell, so that a surface in tetrahedra has facets
/// \throws std::bad_alloc
std::shared_ptr<const FieldKind> MeshKind(
  std::shared_ptr<const MeshTree> tree, bool averagedGradients);

/// A field of a kind made by MeshKind.
Field MeshField(const MeshTree& tree, std::shared_ptr<const FieldKind> kind);

}

#endif
