// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTemporalCoherencePresets
 * @brief   looks of blended volumes by name: colours and opacities over the values
 *
 * A preset is a few nodes: a value, its colour, and the opacity of one unit distance (see
 * vtkVolumeProperty::SetScalarOpacityUnitDistance(), which is that of samples as a rule).
 *
 * | preset | values | what it shows |
 * |---|---|---|
 * | ct bone | Hounsfield units | bone, opaque |
 * | ct soft tissue | Hounsfield units | skin and muscles, see-through, and bone |
 * | ct vessels | Hounsfield units | what a contrast agent fills, and bone |
 * | mr | shares of the range | rarer, brighter values are more opaque; suits any data |
 *
 * The functions are static and need no object.
 *
 * @sa vtkTemporalCoherenceVolumeMapper
 */

#ifndef vtkTemporalCoherencePresets_h
#define vtkTemporalCoherencePresets_h

#include "vtkObject.h"
#include "vtkTemporalCoherenceCompatibility.h"
#include "vtkTemporalCoherenceModule.h" // For export macro

VTK_ABI_NAMESPACE_BEGIN
class vtkVolumeProperty;

class VTKTEMPORALCOHERENCE_EXPORT vtkTemporalCoherencePresets : public vtkObject
{
public:
  static vtkTemporalCoherencePresets* New();
  vtkTypeMacro(vtkTemporalCoherencePresets, vtkObject);

  //@{
  /**
   * Get the number of presets, and the name of each: the first preset has index 0. The name of an
   * unknown index is null.
   */
  static int GetNumberOfPresets();
  static const char* GetPresetName(int index);
  //@}

  /**
   * Get whether the values of a preset are Hounsfield units. Else they are shares of the range of
   * the data: 0 is the least value of interest, 1 the greatest.
   */
  static bool GetPresetIsInHounsfieldUnits(const char* name);

  /**
   * Give a property new functions of colour and of scalar opacity. A node of the preset lies at
   * offset + scale * its value. An offset moves the look over the values. Data that hold Hounsfield
   * units need neither. For shares of a range, offset is its least value and scale its width.
   * @return false, with nothing changed, if there is no such preset, if the property is null, or if
   *         the numbers are not finite or scale is not positive
   */
  static bool Apply(
    const char* name, vtkVolumeProperty* property, double offset = 0.0, double scale = 1.0);

  /**
   * Give a property new functions as projections (such as the maximum) are read: grey from black to
   * white over the values level - window / 2 to level + window / 2, and opaque.
   * @return false, with nothing changed, if the property is null, or if the numbers are not finite
   *         or window is not positive
   */
  static bool ApplyWindowLevel(vtkVolumeProperty* property, double window, double level);

protected:
  vtkTemporalCoherencePresets() = default;
  ~vtkTemporalCoherencePresets() override = default;

private:
  vtkTemporalCoherencePresets(const vtkTemporalCoherencePresets&) = delete;
  void operator=(const vtkTemporalCoherencePresets&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
