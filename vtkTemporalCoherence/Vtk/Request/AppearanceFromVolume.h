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

/// The list that isovalues are taken from: the property's; where that is empty or the single 0 that
/// VTK constructs it with, another one.
/// \param other may be null
vtkContourValues* ChooseIsovalues(vtkVolumeProperty* property, vtkContourValues* other);

/// The isovalues of a list that a property shows, with their opacities: those whose opacity is not
/// 0, each once.
/// \param component of the property whose opacity counts
/// \param places    gets the position in the list of each isovalue shown
/// \param error     gets what is wrong and what to do about it
/// \return false on error, for example if an isovalue or an opacity is not a finite number
bool FindSurfaces(vtkContourValues* list, vtkVolumeProperty* property, int component,
  Surfaces& surfaces, std::vector<int>& places, std::string& error);

/// What the gradient opacity of a component of the property multiplies opacities with.
/// \param distances of neighbouring samples along each axis of index space, in the volume's own
///                  coordinates
/// \param error    gets what is wrong and what to do about it
/// \return false on error, for example if a node is not a number
bool MakeGradientOpacity(vtkVolumeProperty* property, int component, const glm::dvec3& distances,
  GradientOpacity& made, std::string& error);

/// True if nothing can be seen through a surface that a component of a property shows, whatever the
/// gradient.
bool IsOpaque(vtkContourValues* list, vtkVolumeProperty* property, int component);

/// Colours at the isovalues, shading of a component of the property and lights of the renderer.
/// Only what the picture depends on is looked at: shading that is off may be anything.
/// \param appearance is empty before
/// \param error      gets what is wrong and what to do about it
/// \return false on error, for example if a colour is not a number
bool MakeAppearance(vtkVolumeProperty* property, int component, vtkRenderer* renderer,
  const std::vector<double>& isovalues, Appearance& appearance, std::string& error);

}

#endif
