// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTemporalCoherencePicker
 * @brief   picks the isosurface that vtkTemporalCoherenceVolumeMapper draws
 *
 * A vtkVolumePicker, and so usable wherever a vtkCellPicker or vtkVolumePicker is. Where the prop's
 * mapper is a vtkTemporalCoherenceVolumeMapper, the pick is the first surface on the line, the one
 * that is seen there: its isovalues (those with an opacity above 0), surface mode and
 * interpolation. It needs no frame. Everything else is picked as by vtkVolumePicker.
 *
 * After such a pick PickPosition and MapperPosition lie on the surface, PickNormal and
 * MapperNormal are its normal, facing the viewer; DataSet is the mapper's input, CellId, CellIJK
 * and PCoords tell where in it the surface was hit, PointId and PointIJK the nearest sample.
 * GetIsovalueIndex() tells which isovalue it was.
 *
 * Why vtkCellPicker and vtkVolumePicker cannot pick isosurfaces: they know a volume by its scalar
 * opacity only. They read opacities where the line passes from cell to cell, and stop where it is
 * above VolumeOpacityIsovalue. Isovalues are not asked for; with the opacity function that a new
 * property has, 1 everywhere, every pick ends on the box around the volume. VolumeOpacityIsovalue
 * and UseVolumeGradientOpacity mean nothing to this mapper's volumes.
 *
 * With PickCroppingPlanes or PickClippingPlanes on, the planes that crop or clip the volume are
 * picked instead of it, as by the superclasses.
 *
 * @sa vtkTemporalCoherenceVolumeMapper::IntersectWithLine
 * vtkTemporalCoherenceVolumeMapper::PickPixel vtkCellPicker vtkVolumePicker
 */

#ifndef vtkTemporalCoherencePicker_h
#define vtkTemporalCoherencePicker_h

#include "vtkTemporalCoherenceCompatibility.h"
#include "vtkTemporalCoherenceModule.h" // For export macro
#include "vtkVolumePicker.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkDataSet;
class vtkTemporalCoherenceVolumeMapper;
class vtkVolumeProperty;

class VTKTEMPORALCOHERENCE_EXPORT vtkTemporalCoherencePicker : public vtkVolumePicker
{
public:
  static vtkTemporalCoherencePicker* New();
  vtkTypeMacro(vtkTemporalCoherencePicker, vtkVolumePicker);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Position of the isovalue that was picked in vtkVolumeProperty::GetIsoSurfaceValues(); -1 if
   * something else was picked, or nothing.
   */
  vtkGetMacro(IsovalueIndex, int);

protected:
  vtkTemporalCoherencePicker() = default;
  ~vtkTemporalCoherencePicker() override = default;

  void ResetPickInfo() override;

  double IntersectVolumeWithLine(const double p1[3], const double p2[3], double t1, double t2,
    vtkProp3D* prop, vtkAbstractVolumeMapper* mapper) override;

private:
  vtkTemporalCoherencePicker(const vtkTemporalCoherencePicker&) = delete;
  void operator=(const vtkTemporalCoherencePicker&) = delete;

  void SetDataPickInfo(vtkDataSet* data);
  int FindCroppingPlane(vtkTemporalCoherenceVolumeMapper* mapper, const double p1[3],
    const double p2[3], double t1, double t2, double tHit);

  int IsovalueIndex = -1;
};
VTK_ABI_NAMESPACE_END

#endif
