// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_BlendingFromVolume_h
#define TemporalCoherence_BlendingFromVolume_h

#include "Input/ScalarChoice.h"
#include "Request/SampledTransfer.h"
#include "Scene/Appearance.h"
#include "Scene/Blending.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderer;
class vtkVolume;
class vtkVolumeMapper;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Limit of blended components.
constexpr int MostBlended = 4;

/// The blend mode of a mapper; none if the library lacks it.
std::optional<BlendMode> BlendModeOf(vtkVolumeMapper* mapper);

/// Makes the settings of blended volumes. Keeps the samples of transfer functions.
class BlendingFromVolume
{
public:
  /// Make all settings of mapper and property except transfer functions. Samples of other
  /// components, ranges of scalars and ends of rays are not touched.
  /// \param drawn          the components of the array, and of the property
  /// \param sampleDistance as set by the user, in coordinates of the data; 0: converged
  /// \param error          receives the mistake and its remedy
  /// \return false on error, for example if an opacity is NaN
  bool Make(vtkVolumeMapper* mapper, vtkVolume* volume, const DrawnComponent& drawn,
    double sampleDistance, Blending& made, std::string& error);

  /// Make the transfer functions for the last call of Make, over the range of each component.
  /// \param first component
  void MakeTransfers(const Field& first, Blending& made);

  /// Make the lights, if a component is shaded.
  /// \param appearance is empty before
  /// \param error      as above
  static bool MakeLights(
    vtkRenderer* renderer, Blending& blending, Appearance& appearance, std::string& error);

private:
  bool MakeLook(
    vtkVolume* volume, int component, int ofOpacity, ComponentLook& look, std::string& error);

  /// By component of the property. The last volume uses them from FirstTransfer on.
  std::array<SampledTransfer, MostBlended> Transfers;
  std::size_t FirstTransfer = 0;
};

}

#endif
