// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTemporalCoherenceVolume
 * @brief   a vtkVolume whose opaque isosurfaces are drawn with the opaque props
 *
 * vtkVolume draws after all translucent polygons. That suits fog, but not an opaque isosurface,
 * which then covers translucent polygons in front of it. vtkSSAOPass and vtkShadowMapPass do not
 * know the surface, because they work on what the opaque pass has drawn. Depth peeling does not
 * know it either, unless it peels volumes as well (vtkRenderer::UseDepthPeelingForVolumes).
 *
 * This prop draws in the opaque pass if its mapper is a vtkTemporalCoherenceVolumeMapper and all
 * isosurfaces are opaque: each has a scalar opacity of 1 (or of 0, which leaves it out), and the
 * property has no gradient opacity. Otherwise, and with any other mapper, it draws as vtkVolume
 * does. It can replace any vtkVolume. Antialiased edges are drawn in the volumetric pass, so that
 * they blend over all opaque props.
 *
 * With vtkSSAOPass, the isosurfaces occlude and are occluded as polygons are. With
 * vtkShadowMapPass, they cast shadows but receive none, because they are lit before that pass.
 * vtkShadowMapBakerPass renews its maps when a prop is modified, but not when a mapper or its data
 * are modified. Call Modified() of this prop then.
 *
 * @sa vtkTemporalCoherenceVolumeMapper vtkVolume
 */

#ifndef vtkTemporalCoherenceVolume_h
#define vtkTemporalCoherenceVolume_h

#include "vtkTemporalCoherenceCompatibility.h"
#include "vtkTemporalCoherenceModule.h" // For export macro
#include "vtkVolume.h"

VTK_ABI_NAMESPACE_BEGIN
class VTKTEMPORALCOHERENCE_EXPORT VTK_MARSHALAUTO vtkTemporalCoherenceVolume : public vtkVolume
{
public:
  static vtkTemporalCoherenceVolume* New();
  vtkTypeMacro(vtkTemporalCoherenceVolume, vtkVolume);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * WARNING: INTERNAL METHOD - NOT INTENDED FOR GENERAL USE
   * Draw opaque isosurfaces in the opaque pass, and everything else in the volumetric pass. There
   * are no translucent polygons.
   */
  int RenderOpaqueGeometry(vtkViewport* viewport) override;
  int RenderVolumetricGeometry(vtkViewport* viewport) override;
  vtkTypeBool HasOpaqueGeometry() override;
  vtkTypeBool HasTranslucentPolygonalGeometry() override;
  //@}

protected:
  vtkTemporalCoherenceVolume() = default;
  ~vtkTemporalCoherenceVolume() override = default;

private:
  vtkTemporalCoherenceVolume(const vtkTemporalCoherenceVolume&) = delete;
  void operator=(const vtkTemporalCoherenceVolume&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
