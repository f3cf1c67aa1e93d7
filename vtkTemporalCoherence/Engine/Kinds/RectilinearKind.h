// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RectilinearKind_h
#define TemporalCoherence_RectilinearKind_h

#include "Kinds/FieldKind.h"
#include "Scene/GridCoordinates.h"

#include <memory>

namespace TemporalCoherence
{

/// Make the kind of rectilinear grids, whose samples lie at given coordinates along each axis.
/// \param coordinates one for each sample along each axis
/// \throws std::bad_alloc
std::shared_ptr<const FieldKind> RectilinearKind(
  std::shared_ptr<const GridCoordinates> coordinates);

/// Where the samples of a shape lie; null if it is no rectilinear grid.
std::shared_ptr<const GridCoordinates> CoordinatesOf(const FieldShape& shape);

}

#endif
