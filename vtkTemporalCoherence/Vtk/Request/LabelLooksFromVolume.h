// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LabelLooksFromVolume_h
#define TemporalCoherence_LabelLooksFromVolume_h

#include "Request/LabelsFromVolume.h"
#include "Request/SampledTransfer.h"
#include "Scene/Blending.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <map>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkVolumeProperty;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Makes the looks that a mask's labels give to parts of a composite volume. Keeps labels and
/// sampled functions until these change.
class LabelLooksFromVolume
{
public:
  /// Make the looks for blending.Labels. Drops these if no label that is present has functions.
  /// \param component   of the property, for functions that a label lacks
  /// \param blendFactor share of a label's functions; the rest is the share of the component's
  /// \param samples     of the volume
  /// \param blending    has labels and transfer functions
  /// \param error       receives the mistake and its remedy
  /// \return false on error, for example if the volume has several components
  bool Make(vtkVolumeProperty* property, int component, double blendFactor, const Field& samples,
    Blending& blending, std::string& error);

  void Release() { *this = LabelLooksFromVolume(); }

private:
  bool MakeLooks(vtkVolumeProperty* property, int component, double blendFactor,
    const Field& samples, const Blending& volume, LabelMap& made, std::string& error);

  LabelsFromVolume Labels;
  std::map<int, SampledTransfer> Transfers; ///< by label
};

}

#endif
