// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTemporalCoherenceVolume
 * @brief   a vtkVolume whose opaque isosurfaces are drawn with the opaque props
 *
 * vtkVolume draws after all translucent polygons. That suits fog, but not an opaque isosurface: a
 * translucent polygon in front of it is covered, one behind it is drawn in vain, and vtkSSAOPass
 * and vtkShadowMapPass, which work on what the opaque pass has drawn, do not know of it; nor does
 * depth peeling, unless it peels volumes, too (vtkRenderer::UseDepthPeelingForVolumes).
 *
 * This prop draws in the opaque pass where its mapper is a vtkTemporalCoherenceVolumeMapper that
 * shows nothing but opaque isosurfaces: those whose scalar opacity is 1 (or 0, which leaves them
 * out) in a property without a gradient opacity. Otherwise, and with any other mapper, it behaves
 * as vtkVolume, and what is said there about order holds. It may be put in place of any vtkVolume.
 *
 * Under vtkSSAOPass the isosurfaces occlude and are occluded as polygons are. Under
 * vtkShadowMapPass they cast shadows but receive none, since they are lit before they get there.
 * vtkShadowMapBakerPass makes its maps anew when a prop is modified, not when its mapper or data
 * are: call Modified() on this prop then.
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
   * Draw in the pass that what is shown belongs to, and in no other. Never translucent polygons.
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
