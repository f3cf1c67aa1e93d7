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
class vtkScalarsToColors;
class vtkVolumeProperty;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// The list of isovalues: the property's own list or, if it is empty or VTK's default (a single 0),
/// the other list.
/// \param other may be null
vtkContourValues* ChooseIsovalues(vtkVolumeProperty* property, vtkContourValues* other);

/// Find the isovalues of a list with an opacity above 0, each once, with their opacities.
/// \param component of the property, for opacities
/// \param places    receives the position in the list of each isovalue found
/// \param error     receives the mistake and its remedy
/// \return false on error, for example if an isovalue or an opacity is not a finite number
bool FindSurfaces(vtkContourValues* list, vtkVolumeProperty* property, int component,
  Surfaces& surfaces, std::vector<int>& places, std::string& error);

/// True if all surfaces of a component of a property are opaque, whatever the gradient.
bool IsOpaque(vtkContourValues* list, vtkVolumeProperty* property, int component);

/// What surfaces look like.
struct SurfaceLooks
{
  vtkVolumeProperty* Property;
  int Component = 0;                   ///< of the property
  vtkScalarsToColors* Table = nullptr; ///< has colours and opacities; null: the property has them
};

/// Find the colour at a value.
/// \param what  the value is, for the error
/// \param error receives the mistake and its remedy
/// \return false if it is no colour
bool FindColor(
  const SurfaceLooks& looks, const char* what, double value, glm::dvec3& color, std::string& error);

/// Find the opacity at a value, in [0, 1].
/// \param what  the value is, for the error
/// \param error receives the mistake and its remedy
/// \return false if it is none
bool FindOpacity(
  const SurfaceLooks& looks, const char* what, double value, double& opacity, std::string& error);

/// Make the appearance: colours at the isovalues, shading of a component of the property, and
/// lights of the renderer. Numbers without effect are not checked, for example coefficients if
/// shading is off.
/// \param appearance is empty before
/// \param error      receives the mistake and its remedy
/// \return false on error, for example if a colour is NaN
bool MakeAppearance(const SurfaceLooks& looks, vtkRenderer* renderer,
  const std::vector<double>& isovalues, Appearance& appearance, std::string& error);

}

#endif
