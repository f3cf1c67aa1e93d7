// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_GradientOpacityFromVolume_h
#define TemporalCoherence_GradientOpacityFromVolume_h

#include "Scene/Surfaces.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkVolumeProperty;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Make the nodes of the gradient opacity of a component of the property.
/// \param error receives the mistake and its remedy
/// \return false on error, for example if a node is NaN
bool MakeGradientOpacity(
  vtkVolumeProperty* property, int component, GradientOpacity& made, std::string& error);

/// Make the nodes of the gradient opacity of a mask's label: none without such a function.
/// \param error as above
bool MakeLabelGradientOpacity(
  vtkVolumeProperty* property, int label, GradientOpacity& made, std::string& error);

/// Leave out nodes beyond the steepest gradient, because tables spread over all nodes.
/// \param steepest bound of the gradient magnitude
void LeaveOutBeyond(double steepest, GradientOpacity& opacity);

}

#endif
