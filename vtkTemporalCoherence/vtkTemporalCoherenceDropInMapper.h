// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTemporalCoherenceDropInMapper
 * @brief   settings of VTK's volume mappers that have no effect
 *
 * This is a base class of vtkTemporalCoherenceVolumeMapper. It lets a program that was written
 * for one of VTK's volume mappers compile when only the name of the class is changed. It is a
 * vtkGPUVolumeRayCastMapper. It adds methods that only vtkSmartVolumeMapper,
 * vtkFixedPointVolumeRayCastMapper, vtkMultiBlockVolumeMapper and vtkOpenGLGPUVolumeRayCastMapper
 * have. Newer versions of VTK have some of them in vtkGPUVolumeRayCastMapper, too.
 *
 * All settings of this header except SetSharedDepthTexture are stored and returned, but they do not
 * change the picture. Values beyond their ranges are clamped, as by VTK's mappers. There is no
 * distance between samples: rays are intersected with isosurfaces exactly, and blended volumes are
 * converged unless FixedStepSampling is on. No volume is kept on the GPU. These settings of
 * vtkGPUVolumeRayCastMapper have no effect either: LockSampleDistanceToInputSpacing, UseJittering,
 * MaxMemoryInBytes, MaxMemoryFraction, ReportProgress, Transfer2DYAxisArray,
 * GlobalIlluminationReach, VolumetricScatteringBlending, ComputeNormalFromOpacity, ColorRangeType,
 * ScalarOpacityRangeType and GradientOpacityRangeType.
 *
 * @sa vtkTemporalCoherenceVolumeMapper vtkGPUVolumeRayCastMapper
 */

#ifndef vtkTemporalCoherenceDropInMapper_h
#define vtkTemporalCoherenceDropInMapper_h

#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkNew.h" // For a stand-in for missing input
#include "vtkTemporalCoherenceCompatibility.h"
#include "vtkTemporalCoherenceModule.h" // For export macro
#include "vtkVersionMacros.h"           // For members that old superclasses lack

VTK_ABI_NAMESPACE_BEGIN
class vtkImageData;
class vtkRenderWindow;
class vtkRenderer;
class vtkTextureObject;
class vtkVolume;
class vtkVolumeProperty;

class VTKTEMPORALCOHERENCE_EXPORT VTK_MARSHALAUTO vtkTemporalCoherenceDropInMapper
  : public vtkGPUVolumeRayCastMapper
{
public:
  vtkAbstractTypeMacro(vtkTemporalCoherenceDropInMapper, vtkGPUVolumeRayCastMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Return true for any window and any property, since nothing depends on the hardware.
   */
  int IsRenderSupported(vtkRenderWindow* window, vtkVolumeProperty* property) override;

  /**
   * Get the ratio by which the input is reduced to fit into memory: always 1 along each axis.
   */
  void GetReductionRatio(double ratio[3]) override;

  /** Values of RequestedRenderMode. */
  enum RenderModes
  {
    DefaultRenderMode = 0,
    RayCastRenderMode = 1,
    GPURenderMode = 2,
    OSPRayRenderMode = 3,
    AnariRenderMode = 4,
    UndefinedRenderMode = 5,
    InvalidRenderMode = 6
  };

  //@{
  /**
   * Set/Get the renderer that vtkSmartVolumeMapper and vtkMultiBlockVolumeMapper use. Default:
   * DefaultRenderMode. No effect here: rays are always cast on the CPU, and
   * GetLastUsedRenderMode() returns RayCastRenderMode.
   */
  vtkSetClampMacro(RequestedRenderMode, int, DefaultRenderMode, InvalidRenderMode);
  vtkGetMacro(RequestedRenderMode, int);
  void SetRequestedRenderModeToDefault() { this->SetRequestedRenderMode(DefaultRenderMode); }
  void SetRequestedRenderModeToRayCast() { this->SetRequestedRenderMode(RayCastRenderMode); }
  void SetRequestedRenderModeToGPU() { this->SetRequestedRenderMode(GPURenderMode); }
  void SetRequestedRenderModeToOSPRay() { this->SetRequestedRenderMode(OSPRayRenderMode); }
  void SetRequestedRenderModeToAnari() { this->SetRequestedRenderMode(AnariRenderMode); }
  int GetLastUsedRenderMode() { return RayCastRenderMode; }
  //@}

  //@{
  /**
   * Set/Get how vtkSmartVolumeMapper shrinks a volume that does not fit the GPU:
   * VTK_RESLICE_NEAREST, VTK_RESLICE_LINEAR or VTK_RESLICE_CUBIC (default). LowResMode (default 0)
   * says whether it does so. No effect here: no volume is made smaller.
   */
  vtkSetClampMacro(InterpolationMode, int, VTK_NEAREST_INTERPOLATION, VTK_CUBIC_INTERPOLATION);
  vtkGetMacro(InterpolationMode, int);
  void SetInterpolationModeToNearestNeighbor()
  {
    this->SetInterpolationMode(VTK_NEAREST_INTERPOLATION);
  }
  void SetInterpolationModeToLinear() { this->SetInterpolationMode(VTK_LINEAR_INTERPOLATION); }
  void SetInterpolationModeToCubic() { this->SetInterpolationMode(VTK_CUBIC_INTERPOLATION); }
  enum LowResModeType
  {
    LowResModeDisabled = 0,
    LowResModeResample = 1
  };
  vtkSetMacro(LowResMode, int);
  vtkGetMacro(LowResMode, int);
  //@}

  //@{
  /**
   * Set/Get the desired update rate at or above which vtkSmartVolumeMapper treats a frame as
   * interactive (default: 1), and whether it then adjusts sample distances (default: on). No effect
   * here: AutoAdjustSampleDistances alone decides.
   */
  vtkSetClampMacro(InteractiveUpdateRate, double, 1.0e-10, 1.0e10);
  vtkGetMacro(InteractiveUpdateRate, double);
  vtkSetClampMacro(InteractiveAdjustSampleDistances, vtkTypeBool, 0, 1);
  vtkGetMacro(InteractiveAdjustSampleDistances, vtkTypeBool);
  vtkBooleanMacro(InteractiveAdjustSampleDistances, vtkTypeBool);
  //@}

  //@{
  /**
   * Set/Get the distance between samples that vtkFixedPointVolumeRayCastMapper uses during an
   * interaction. Default: 1. No effect here: rays meet surfaces exactly.
   */
  vtkSetMacro(InteractiveSampleDistance, float);
  vtkGetMacro(InteractiveSampleDistance, float);
  //@}

  //@{
  /**
   * Set/Get whether polygons and the volume hide each other in vtkFixedPointVolumeRayCastMapper.
   * Default: on. No effect here: they always do.
   */
  vtkSetClampMacro(IntermixIntersectingGeometry, vtkTypeBool, 0, 1);
  vtkGetMacro(IntermixIntersectingGeometry, vtkTypeBool);
  vtkBooleanMacro(IntermixIntersectingGeometry, vtkTypeBool);
  //@}

  //@{
  /**
   * Set/Get the number of threads of vtkFixedPointVolumeRayCastMapper. Default: vtkMultiThreader's
   * number. No effect here: vtkSMPTools runs the threads, and vtkSMPTools::Initialize() limits
   * their number.
   */
  vtkSetClampMacro(NumberOfThreads, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfThreads, int);
  //@}

  //@{
  /**
   * Methods of vtkOpenGLGPUVolumeRayCastMapper for textures: the partitions in which a volume is
   * loaded (default: 1, 1, 1), a depth texture that mappers share, and loading in advance. No
   * effect here: the volume is in no texture. PreLoadData returns true; GetDepthTexture and
   * GetColorTexture return null.
   */
  void SetPartitions(unsigned short x, unsigned short y, unsigned short z);
  vtkGetVector3Macro(Partitions, unsigned short);
  void SetSharedDepthTexture(vtkTextureObject*) {}
  bool PreLoadData(vtkRenderer*, vtkVolume*) { return true; }
  vtkTextureObject* GetDepthTexture() { return nullptr; }
  vtkTextureObject* GetColorTexture() { return nullptr; }
  //@}

#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0)
  //@{
  /**
   * Set/Get how light is scattered, and whether normals are computed from the gradient of the
   * opacity. Defaults: 0, 0 and off. The superclasses have these settings since VTK 9.2. No effect
   * here.
   */
  vtkSetClampMacro(GlobalIlluminationReach, float, 0.0f, 1.0f);
  vtkGetMacro(GlobalIlluminationReach, float);
  vtkSetClampMacro(VolumetricScatteringBlending, float, 0.0f, 2.0f);
  vtkGetMacro(VolumetricScatteringBlending, float);
  vtkSetMacro(ComputeNormalFromOpacity, bool);
  vtkGetMacro(ComputeNormalFromOpacity, bool);
  vtkBooleanMacro(ComputeNormalFromOpacity, bool);
  //@}
#endif

  //@{
  /**
   * Get the input of port 0, or of a given port; null if there is none. If the input is not a
   * vtkDataSet (blocks, for example), GetInput() returns null, and GetInput(port) returns an image
   * without points.
   */
  vtkDataSet* GetInput() override;
  vtkDataSet* GetInput(int port) override;
  //@}

  /**
   * WARNING: INTERNAL METHOD - NOT INTENDED FOR GENERAL USE
   * Draw the volume by calling Render().
   */
  void GPURender(vtkRenderer* renderer, vtkVolume* volume) override;

protected:
  vtkTemporalCoherenceDropInMapper();
  ~vtkTemporalCoherenceDropInMapper() override;

  //@{
  /**
   * Do nothing: these are methods of mappers for AMR data.
   */
  void PreRender(vtkRenderer* renderer, vtkVolume* volume, double bounds[6], double range[2],
    int components, unsigned int levels) override;
  void RenderBlock(vtkRenderer* renderer, vtkVolume* volume, unsigned int level) override;
  void PostRender(vtkRenderer* renderer, int components) override;
  //@}

private:
  vtkTemporalCoherenceDropInMapper(const vtkTemporalCoherenceDropInMapper&) = delete;
  void operator=(const vtkTemporalCoherenceDropInMapper&) = delete;

  int RequestedRenderMode = DefaultRenderMode;
  int InterpolationMode = VTK_CUBIC_INTERPOLATION;
  int LowResMode = LowResModeDisabled;
  double InteractiveUpdateRate = 1.0;
  vtkTypeBool InteractiveAdjustSampleDistances = 1;
  float InteractiveSampleDistance = 1.0f;
  vtkTypeBool IntermixIntersectingGeometry = 1;
  int NumberOfThreads;
  unsigned short Partitions[3] = { 1, 1, 1 };
#if VTK_VERSION_NUMBER < VTK_VERSION_CHECK(9, 2, 0)
  float GlobalIlluminationReach = 0.0f;
  float VolumetricScatteringBlending = 0.0f;
  bool ComputeNormalFromOpacity = false;
#endif
  vtkNew<vtkImageData> NoDataSet;
};
VTK_ABI_NAMESPACE_END

#endif
