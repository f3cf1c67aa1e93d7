// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ViewLookUp_h
#define TemporalCoherence_ViewLookUp_h

#include "Isomap/KnotImage.h"
#include "Scene/Frame.h"
#include "ViewFile/ViewDescription.h"

namespace TemporalCoherence
{

/// Make the depths and normals that a view has for an isovalue: the planes of a frame with one
/// surface. Normals face the viewer; colours are not made.
/// \throws std::bad_alloc
void LookUpView(
  const ViewGeometry& geometry, const KnotImage& knots, double isovalue, Frame& frame);

}

#endif
