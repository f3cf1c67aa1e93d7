// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTemporalCoherencePicker
 * @brief   picks the isosurface that vtkTemporalCoherenceVolumeMapper draws
 *
 * As a vtkVolumePicker, it can replace any vtkCellPicker or vtkVolumePicker. If the prop's mapper
 * is a vtkTemporalCoherenceVolumeMapper, it picks the first surface on the line. That is the
 * surface that is seen there: the picker uses the isovalues with an opacity above 0, the surface
 * mode and the interpolation. No frame is needed. A vtkTemporalCoherenceGPUVolumeRayCastMapper is
 * picked likewise if its last frame showed isosurfaces. Everything else is picked as
 * vtkVolumePicker does it.
 *
 * After such a pick, PickPosition and MapperPosition lie on the surface. PickNormal and
 * MapperNormal are its normal and face the viewer. DataSet is the mapper's input or, of blocks that
 * are drawn as a mesh, the block that was hit (FlatBlockIndex). CellId, CellIJK and PCoords locate
 * the hit in it, and PointId and PointIJK name the nearest sample. GetIsovalueIndex() tells which
 * isovalue was hit.
 *
 * vtkCellPicker and vtkVolumePicker cannot pick isosurfaces, because they use the scalar opacity
 * only. They read the opacity where the line passes from cell to cell, and stop where it is above
 * VolumeOpacityIsovalue. The opacity function of a new property is 1 everywhere, so every pick ends
 * on the volume's box. VolumeOpacityIsovalue and UseVolumeGradientOpacity have no effect on
 * isosurfaces of this mapper.
 *
 * In the other blend modes, volumes are picked by the superclasses. These can only pick images
 * whose active point scalars are drawn. PickPixel finds the first visible place of any volume in
 * the last picture.
 *
 * With PickCroppingPlanes or PickClippingPlanes on, the planes that crop or clip the volume are
 * picked instead of the volume, as by the superclasses.
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
   * Get the index of the picked isovalue in vtkVolumeProperty::GetIsoSurfaceValues(); -1 if nothing
   * or something else was picked.
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

  void SetPickedData(vtkDataSet* data, vtkIdType cellId);
  void SetDataPickInfo(vtkDataSet* data);
  void SetCellPickInfo(vtkDataSet* data, vtkIdType cellId);
  int FindCroppingPlane(vtkTemporalCoherenceVolumeMapper* mapper, const double p1[3],
    const double p2[3], double t1, double t2, double tHit);

  int IsovalueIndex = -1;
};
VTK_ABI_NAMESPACE_END

#endif
