// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RectilinearGradients_h
#define TemporalCoherence_RectilinearGradients_h

#include "Fields/GridCoordinates.h"
#include "Shade/SurfaceNormal.h"

namespace TemporalCoherence
{

/// Gradients of a field whose samples lie at coordinates: differences are divided by the distance
/// between the samples that they are taken of, as vtkRectilinearSynchronizedTemplates does.
void RectilinearGradients(
  const GridCoordinates& grid, const GradientQuery& query, const GradientTile& tile);

}

#endif
