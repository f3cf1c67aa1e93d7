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

/// Draw a viewer's last frame for the hardware selector of its renderer: with its depths, in the
/// colours that the selector reads as numbers in the pass that it is in. These are the numbers of
/// the prop or the process, of the point nearest to a hit, or of the cell around it.
/// \param data  where points and cells are; null if they have no numbers, which are 0 then
/// \param error gets what is wrong if the result is false
/// \throws std::bad_alloc
bool PresentToSelector(vtkRenderer* renderer, vtkVolume* volume, vtkDataSet* data,
  ViewerState& state, std::string& error);

}

#endif
