// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LabelsFromVolume_h
#define TemporalCoherence_LabelsFromVolume_h

#include "Acceleration/FieldFingerprint.h"
#include "Lattice/SmoothLabels.h"
#include "Scene/Field.h"
#include "Scene/LabelSets.h"
#include "Scene/Surfaces.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <memory>
#include <string>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkScalarsToColors;
class vtkVolumeProperty;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// How labels are drawn.
struct LabelSettings
{
  bool AreDrawn = false;               ///< samples are labels
  int Outside = 0;                     ///< the label that is never drawn
  vtkScalarsToColors* Table = nullptr; ///< colours and opacities; null: those of the property
  double Radius = 0.0;                 ///< of SmoothLabels; 0: faces of voxels
};

/// Finds the labels of data and which of them are drawn. Keeps the labels until the data change.
class LabelsFromVolume
{
public:
  /// Let the samples of a field be labels.
  /// \param radius as in the settings
  /// \param told   changes of the samples in place (ToldChanges)
  /// \param error  receives the mistake and its remedy
  /// \return false on error, for example if samples are no whole numbers
  /// \throws std::bad_alloc
  bool Make(
    Field& samples, double radius, const std::vector<SampleChange>& told, std::string& error);

  /// Find the labels with an opacity above 0, with their opacities.
  /// \param component of the property, for opacities
  /// \param places    receives these labels
  /// \pre Make has returned true
  bool Find(const LabelSettings& settings, vtkVolumeProperty* property, int component,
    Surfaces& surfaces, std::vector<int>& places, std::string& error) const;

  /// True if the labels of some data are known.
  bool AreKnown() const { return this->Known.Labels != nullptr; }

  void Release() { *this = LabelsFromVolume(); }

private:
  void See(const Field& samples, const std::vector<SampleChange>& told);

  Field Known;                                ///< whose labels are known
  std::shared_ptr<const SmoothLabels> Smooth; ///< of labels, or null
  FieldFingerprint Print;                     ///< of the samples whose labels are known
};

}

#endif
