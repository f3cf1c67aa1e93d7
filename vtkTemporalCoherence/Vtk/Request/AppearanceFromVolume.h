// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_AppearanceFromVolume_h
#define TemporalCoherence_AppearanceFromVolume_h

#include "Scene/Appearance.h"
#include "Scene/Surfaces.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkContourValues;
class vtkRenderer;
class vtkVolumeProperty;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// The list of isovalues: that of the property or, if it is empty or VTK's default of a single 0,
/// another one.
/// \param other may be null
vtkContourValues* ChooseIsovalues(vtkVolumeProperty* property, vtkContourValues* other);

/// Find the isovalues of a list whose opacity is not 0, each once, and their opacities.
/// \param component whose opacity the property gives
/// \param places    gets the position in the list of each isovalue shown
/// \param error     gets what is wrong and what to do about it
/// \return false on error, for example if an isovalue or an opacity is not a finite number
bool FindSurfaces(vtkContourValues* list, vtkVolumeProperty* property, int component,
  Surfaces& surfaces, std::vector<int>& places, std::string& error);

/// True if all surfaces of a component of a property are opaque, whatever the gradient.
bool IsOpaque(vtkContourValues* list, vtkVolumeProperty* property, int component);

/// Make the appearance: colours at the isovalues, shading of a component of the property, and
/// lights of the renderer. Only what the picture depends on is checked: if shading is off, its
/// coefficients may have any value.
/// \param appearance is empty before
/// \param error      gets what is wrong and what to do about it
/// \return false on error, for example if a colour is NaN
bool MakeAppearance(vtkVolumeProperty* property, int component, vtkRenderer* renderer,
  const std::vector<double>& isovalues, Appearance& appearance, std::string& error);

}

#endif
