// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTemporalCoherenceGPUVolumeRayCastMapper
 * @brief   VTK's GPU mapper, with isosurfaces drawn by vtkTemporalCoherenceVolumeMapper
 *
 * This class replaces vtkGPUVolumeRayCastMapper in programs that are not changed.
 * vtkTemporalCoherenceObjectFactory creates it wherever the program, vtkSmartVolumeMapper or
 * vtkMultiBlockVolumeMapper creates a vtkGPUVolumeRayCastMapper. It is a
 * vtkOpenGLGPUVolumeRayCastMapper that holds a vtkTemporalCoherenceVolumeMapper. In every frame the
 * settings decide which of the two draws.
 *
 * vtkTemporalCoherenceVolumeMapper draws if the blend mode is ISOSURFACE_BLEND. It also draws
 * COMPOSITE_BLEND, MAXIMUM_INTENSITY_BLEND, MINIMUM_INTENSITY_BLEND, AVERAGE_INTENSITY_BLEND and
 * ADDITIVE_BLEND if BlendVolumes allows it: by default where OpenGL has no GPU and VTK's mapper is
 * not estimated to be faster. Such a picture is converged: VTK's mapper would draw it with
 * infinitely dense samples.
 *
 * vtkOpenGLGPUVolumeRayCastMapper draws SLICE_BLEND. It also draws
 * - volumes with several inputs (vtkMultiVolume),
 * - volumes in a renderer that peels them by depth (UseDepthPeelingForVolumes),
 * - volumes with user-defined shaders (vtkShaderProperty),
 * - volumes with two-dimensional transfer functions,
 * - composite volumes with UseDepthPass,
 * - volumes with scattered light or shadows (GlobalIlluminationReach or
 *   VolumetricScatteringBlending above 0), or with normals from the opacity (VTK >= 9.2); for depth
 *   in isosurfaces call GetIsosurfaceMapper()->AmbientOcclusionOn() instead,
 * - all volumes after RenderToImageOn(), because only its textures hold that image,
 * - volumes whose input or settings vtkTemporalCoherenceVolumeMapper refuses.
 *
 * One line in VTK's log (vtkLogger, INFO) says that vtkTemporalCoherenceVolumeMapper draws, and
 * why. It is written once in a process, when that mapper draws first. If VTK's mapper has to draw,
 * a line says why, once for each reason. The environment variable VTK_TEMPORAL_COHERENCE_LOG (OFF,
 * NO, FALSE or 0) switches these lines off. PrintSelf and GetReason() tell the same of each mapper.
 *
 * The environment variable VTK_TEMPORAL_COHERENCE (OFF, NO, FALSE or 0) switches this class off, as
 * does TemporalCoherenceOff(). Nothing is logged then.
 *
 * GetIsosurfaceMapper() gives access to the settings that only vtkTemporalCoherenceVolumeMapper
 * has. Settings of this class that affect isosurfaces are copied to it in every frame. UseDepthPass
 * is not copied: VTK's mapper applies it to COMPOSITE_BLEND only.
 *
 * The events are those of vtkGPUVolumeRayCastMapper, whichever mapper draws. Observers of this
 * mapper get the errors and warnings of both.
 *
 * @sa vtkTemporalCoherenceObjectFactory vtkTemporalCoherenceVolumeMapper
 * vtkOpenGLGPUVolumeRayCastMapper
 */

#ifndef vtkTemporalCoherenceGPUVolumeRayCastMapper_h
#define vtkTemporalCoherenceGPUVolumeRayCastMapper_h

#include "vtkNew.h" // For the inner mapper
#include "vtkOpenGLGPUVolumeRayCastMapper.h"
#include "vtkRenderWindow.h" // For weak pointers to it
#include "vtkTemporalCoherenceCompatibility.h"
#include "vtkTemporalCoherenceModule.h" // For export macro
#include "vtkWeakPointer.h"             // For the window

#include <string> // For std::string
#include <tuple>  // For a key

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
   * Allow vtkTemporalCoherenceVolumeMapper to draw. Default: on, unless the environment
   * variable VTK_TEMPORAL_COHERENCE is OFF, NO, FALSE or 0 when the mapper is constructed.
   */
  vtkSetMacro(TemporalCoherence, vtkTypeBool);
  vtkGetMacro(TemporalCoherence, vtkTypeBool);
  vtkBooleanMacro(TemporalCoherence, vtkTypeBool);
  //@}

  /** Values of BlendVolumes. */
  enum BlendingRules
  {
    BLEND_NEVER = 0,
    BLEND_ON_SOFTWARE_OPENGL = 1,
    BLEND_ALWAYS = 2
  };

  //@{
  /**
   * Set/Get when vtkTemporalCoherenceVolumeMapper draws blend modes other than ISOSURFACE_BLEND.
   * BLEND_ON_SOFTWARE_OPENGL: if OpenGL itself runs on the CPU, which the name of its renderer
   * tells (llvmpipe, softpipe, swrast, SWR, SwiftShader, or any name with "software"). VTK's mapper
   * still draws what it draws faster: all with nearest interpolation, averages, sums, and composite
   * volumes of which so much is half transparent that this is estimated. Default:
   * DefaultBlendVolumes at the time of construction. Any other value than these three rules is an
   * error, and the setting stays.
   */
  virtual void SetBlendVolumes(int rule);
  vtkGetMacro(BlendVolumes, int);
  void SetBlendVolumesToNever() { this->SetBlendVolumes(BLEND_NEVER); }
  void SetBlendVolumesToOnSoftwareOpenGL() { this->SetBlendVolumes(BLEND_ON_SOFTWARE_OPENGL); }
  void SetBlendVolumesToAlways() { this->SetBlendVolumes(BLEND_ALWAYS); }
  //@}

  //@{
  /**
   * Set/Get the initial BlendVolumes of mappers that are constructed later, also inside of other
   * mappers. Default: BLEND_ON_SOFTWARE_OPENGL, or the rule in the environment variable
   * VTK_TEMPORAL_COHERENCE_BLEND_VOLUMES: NEVER, SOFTWARE or ALWAYS. Another value is an error, and
   * the setting stays. Another word in the variable is a warning.
   */
  static void SetDefaultBlendVolumes(int rule);
  static int GetDefaultBlendVolumes();
  //@}

  //@{
  /**
   * Get the mapper that draws isosurfaces and blended volumes, and whether it drew the last frame
   * (in any blend mode). If so, its GetStatistics() describes that frame.
   */
  vtkTemporalCoherenceVolumeMapper* GetIsosurfaceMapper();
  bool GetDrewIsosurfaces() { return this->DrawnBy == Drawer::Isosurfaces; }
  //@}

  /**
   * Get the reason for the choice of the mapper that drew the last frame; empty before the first
   * frame.
   */
  const char* GetReason() { return this->Reason.c_str(); }

  /**
   * Get the ratio by which the input is reduced to fit into memory: 1 along each axis in
   * ISOSURFACE_BLEND and after a frame of vtkTemporalCoherenceVolumeMapper.
   */
  void GetReductionRatio(double ratio[3]) override;

  /**
   * WARNING: INTERNAL METHOD - NOT INTENDED FOR GENERAL USE
   * Draw the volume into the renderer's window.
   */
  void Render(vtkRenderer* renderer, vtkVolume* volume) override;

  /**
   * WARNING: INTERNAL METHOD - NOT INTENDED FOR GENERAL USE
   * Free the textures and shaders that both mappers have in a window, or in all windows if it is
   * null.
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
  std::string WhySuperclassBlends(vtkRenderer* renderer);
  std::string WhySuperclassIsFaster(vtkVolume* volume);
  void PrepareIsosurfaces();
  void ForwardEvents();
  void TellWhoDraws(Drawer drawer, const std::string& reason);

  vtkTypeBool TemporalCoherence;
  int BlendVolumes;
  vtkWeakPointer<vtkRenderWindow> LastWindow;
  bool IsSoftware = false; ///< the OpenGL of that window runs on the CPU
  vtkNew<vtkTemporalCoherenceVolumeMapper> Isosurfaces;
  vtkNew<vtkEventForwarderCommand> Forwarder;
  Drawer DrawnBy = Drawer::Nobody;
  std::string Reason;
  using BlendingTimeKey =
    std::tuple<const void*, const void*, const void*, vtkMTimeType>; ///< property, data, volume
  double BlendingTime = 0.0;                                         ///< see BlendingTime.h
  BlendingTimeKey BlendingTimeOf;
  double SuperclassTimeToDraw = 0.0;
};
VTK_ABI_NAMESPACE_END

#endif
