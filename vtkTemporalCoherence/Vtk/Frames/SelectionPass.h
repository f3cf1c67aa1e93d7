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

/// Draw a viewer's last frame for the hardware selector of its renderer: with depths, and with
/// colours that encode one id for the present pass of the selector: the id of the prop, process or
/// hit block, of the point nearest to the hit, or of the cell around it. For a mesh: the hit cell,
/// and its point nearest to the hit.
/// \param data  with the points and cells, unless it is a mesh; null: their ids are 0
/// \param error receives the mistake if the result is false
/// \throws std::bad_alloc
bool PresentToSelector(vtkRenderer* renderer, vtkVolume* volume, vtkDataSet* data,
  ViewerState& state, std::string& error);

}

#endif
