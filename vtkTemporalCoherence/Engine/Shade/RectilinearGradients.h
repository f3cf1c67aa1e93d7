// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RectilinearGradients_h
#define TemporalCoherence_RectilinearGradients_h

#include "Scene/GridCoordinates.h"
#include "Shade/SurfaceNormal.h"

namespace TemporalCoherence
{

/// Find gradients of a rectilinear field. Differences are divided by the distance between the
/// samples, as vtkRectilinearSynchronizedTemplates does.
void RectilinearGradients(
  const GridCoordinates& grid, const GradientQuery& query, const GradientTile& tile);

}

#endif
