// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LabelGradients_h
#define TemporalCoherence_LabelGradients_h

#include "Lattice/SmoothLabels.h"
#include "Shade/SurfaceNormal.h"

namespace TemporalCoherence
{

/// Find directions into labels, for normals of surfaces between labels.
/// \param smooth surfaces; null: those of faces between voxels, of unit length in index space
void LabelGradients(
  const GradientQuery& query, const GradientTile& tile, const SmoothLabels* smooth);

}

#endif
