// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_SelectionPass_h
#define TemporalCoherence_SelectionPass_h

#include "Frames/ViewerStates.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
class vtkRenderer;
class vtkVolume;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Draw a viewer's last frame for the hardware selector of its renderer: with its depths, and in
/// colours that encode the numbers for the present pass of the selector. These are the ids of the
/// prop, of the process, of the block that is hit, of the point nearest to a hit, or of the cell
/// around it. Of a mesh these are the cell that is hit, and the nearest of its points.
/// \param data  with the points and cells, unless it is a mesh; null: their ids are 0
/// \param error gets what is wrong if the result is false
/// \throws std::bad_alloc
bool PresentToSelector(vtkRenderer* renderer, vtkVolume* volume, vtkDataSet* data,
  ViewerState& state, std::string& error);

}

#endif
