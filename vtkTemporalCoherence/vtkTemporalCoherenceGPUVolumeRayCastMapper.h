// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTemporalCoherenceGPUVolumeRayCastMapper
 * @brief   VTK's GPU mapper, but that vtkTemporalCoherenceVolumeMapper draws isosurfaces
 *
 * It takes the place of vtkGPUVolumeRayCastMapper in programs that are left as they are:
 * vtkTemporalCoherenceObjectFactory makes it wherever they, or vtkSmartVolumeMapper and
 * vtkMultiBlockVolumeMapper, make that one. It is a vtkOpenGLGPUVolumeRayCastMapper, and draws as
 * such whatever a vtkTemporalCoherenceVolumeMapper, of which it holds one, does not. In every frame
 * the settings decide:
 *
 * vtkTemporalCoherenceVolumeMapper draws where the blend mode is ISOSURFACE_BLEND.
 *
 * vtkOpenGLGPUVolumeRayCastMapper draws all other blend modes, and isosurfaces of several inputs
 * (vtkMultiVolume), in a renderer that peels volumes by depth (UseDepthPeelingForVolumes), with
 * shaders of the user's (vtkShaderProperty), with transfer functions in two dimensions, with
 * scattered light or normals of the opacity (VTK >= 9.2), after RenderToImageOn() (whose textures
 * it gives), and of input or settings that vtkTemporalCoherenceVolumeMapper refuses.
 *
 * When it changes who draws in a renderer, and in the first frame, one line in the log of VTK
 * (vtkLogger, INFO) tells who and why, unless the last line told the same of another mapper;
 * PrintSelf tells it, too.
 *
 * The environment variable VTK_TEMPORAL_COHERENCE (OFF, NO, FALSE or 0) switches it off, as does
 * TemporalCoherenceOff().
 *
 * With the factory a program may give the mapper that draws isosurfaces settings of its own:
 * GetIsosurfaceMapper(). Those that this class has, too, are overwritten in every frame.
 *
 * Events are those of vtkGPUVolumeRayCastMapper, whoever draws. Observers of errors and warnings of
 * this mapper get those of either.
 *
 * @sa vtkTemporalCoherenceObjectFactory vtkTemporalCoherenceVolumeMapper
 * vtkOpenGLGPUVolumeRayCastMapper
 */

#ifndef vtkTemporalCoherenceGPUVolumeRayCastMapper_h
#define vtkTemporalCoherenceGPUVolumeRayCastMapper_h

#include "vtkNew.h" // For the mapper that is held
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkRenderer.h" // For weak pointers to it
#include "vtkTemporalCoherenceCompatibility.h"
#include "vtkTemporalCoherenceModule.h" // For export macro
#include "vtkWeakPointer.h"             // For renderers

#include <string>  // For std::string
#include <utility> // For std::pair
#include <vector>  // For std::vector

VTK_ABI_NAMESPACE_BEGIN
class vtkEventForwarderCommand;
class vtkTemporalCoherenceVolumeMapper;

class VTKTEMPORALCOHERENCE_EXPORT VTK_MARSHALAUTO vtkTemporalCoherenceGPUVolumeRayCastMapper
  : public vtkOpenGLGPUVolumeRayCastMapper
{
public:
  static vtkTemporalCoherenceGPUVolumeRayCastMapper* New();
  vtkTypeMacro(vtkTemporalCoherenceGPUVolumeRayCastMapper, vtkOpenGLGPUVolumeRayCastMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Allow vtkTemporalCoherenceVolumeMapper to draw isosurfaces. Default: on, unless the environment
   * variable VTK_TEMPORAL_COHERENCE is OFF, NO, FALSE or 0 when the mapper is constructed.
   */
  vtkSetMacro(TemporalCoherence, vtkTypeBool);
  vtkGetMacro(TemporalCoherence, vtkTypeBool);
  vtkBooleanMacro(TemporalCoherence, vtkTypeBool);
  //@}

  //@{
  /**
   * The mapper that draws isosurfaces, whose own settings may be changed; and whether it drew the
   * last frame. Its routes and counters are then those of that frame.
   */
  vtkTemporalCoherenceVolumeMapper* GetIsosurfaceMapper();
  bool GetDrewIsosurfaces() { return this->DrawnBy == Drawer::Isosurfaces; }
  //@}

  /**
   * Why the one that drew the last frame did; empty before the first frame.
   */
  const char* GetReason() { return this->Reason.c_str(); }

  /**
   * How much the input has to be reduced to fit: not at all where isosurfaces are drawn on the CPU.
   */
  void GetReductionRatio(double ratio[3]) override;

  /**
   * WARNING: INTERNAL METHOD - NOT INTENDED FOR GENERAL USE
   * Draw the volume into the renderer's window.
   */
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;

  /**
   * WARNING: INTERNAL METHOD - NOT INTENDED FOR GENERAL USE
   * Free textures and shaders of a window (of all, if it is null), whoever drew with them.
   */
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkTemporalCoherenceGPUVolumeRayCastMapper();
  ~vtkTemporalCoherenceGPUVolumeRayCastMapper() override;

private:
  vtkTemporalCoherenceGPUVolumeRayCastMapper(
    const vtkTemporalCoherenceGPUVolumeRayCastMapper&) = delete;
  void operator=(const vtkTemporalCoherenceGPUVolumeRayCastMapper&) = delete;

  enum class Drawer
  {
    Nobody,
    Isosurfaces,
    Superclass
  };

  std::string WhySuperclassDraws(vtkRenderer* renderer, vtkVolume* volume);
  void PrepareIsosurfaces();
  void ForwardEvents();
  void TellWhoDraws(vtkRenderer* renderer, Drawer drawer, const std::string& reason);

  vtkTypeBool TemporalCoherence;
  vtkNew<vtkTemporalCoherenceVolumeMapper> Isosurfaces;
  vtkNew<vtkEventForwarderCommand> Forwarder;
  Drawer DrawnBy = Drawer::Nobody;
  /// What the log was told last of each renderer: one may peel volumes, and another not.
  std::vector<std::pair<vtkWeakPointer<vtkRenderer>, Drawer>> Told;
  std::string Reason;
  double SuperclassTimeToDraw = 0.0;
};
VTK_ABI_NAMESPACE_END

#endif
