// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTemporalCoherenceDropInMapper
 * @brief   what programs say to VTK's volume mappers, accepted by one that has no use for it
 *
 * The base class of vtkTemporalCoherenceVolumeMapper, apart from it so that the mapper's own header
 * tells what the mapper does. It is a vtkGPUVolumeRayCastMapper, and has besides what
 * vtkSmartVolumeMapper, vtkFixedPointVolumeRayCastMapper, vtkMultiBlockVolumeMapper and
 * vtkOpenGLGPUVolumeRayCastMapper have and that class lacks (in some versions of VTK, at least):
 * a program that was written for one of them compiles when only the name of the class is changed.
 *
 * All settings of this header are kept and returned, and change nothing that is drawn: rays meet
 * surfaces exactly, and there is neither a distance between samples nor memory of a GPU. The same
 * goes for these settings of vtkGPUVolumeRayCastMapper: SampleDistance,
 * LockSampleDistanceToInputSpacing, UseJittering, MaxMemoryInBytes, MaxMemoryFraction,
 * ReportProgress, Transfer2DYAxisArray, GlobalIlluminationReach, VolumetricScatteringBlending,
 * ComputeNormalFromOpacity, ColorRangeType, ScalarOpacityRangeType and GradientOpacityRangeType.
 *
 * @sa vtkTemporalCoherenceVolumeMapper vtkGPUVolumeRayCastMapper
 */

#ifndef vtkTemporalCoherenceDropInMapper_h
#define vtkTemporalCoherenceDropInMapper_h

#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkNew.h" // For an image that stands in for input
#include "vtkTemporalCoherenceCompatibility.h"
#include "vtkTemporalCoherenceModule.h" // For export macro
#include "vtkVersionMacros.h"           // For what the superclass has not yet

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
   * True, in any window and for any property: nothing is asked of the hardware.
   */
  int IsRenderSupported(vtkRenderWindow* window, vtkVolumeProperty* property) override;

  /**
   * How much the input has to be reduced to fit: not at all, the ratio is 1 along each axis.
   */
  void GetReductionRatio(double ratio[3]) override;

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
   * Which renderer vtkSmartVolumeMapper and vtkMultiBlockVolumeMapper should take. Default:
   * DefaultRenderMode. Without effect: rays are always cast on the CPU, and so
   * GetLastUsedRenderMode() is RayCastRenderMode.
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
   * How vtkSmartVolumeMapper makes a volume smaller that does not fit the GPU: VTK_RESLICE_NEAREST,
   * VTK_RESLICE_LINEAR or VTK_RESLICE_CUBIC (default); and whether it does so (LowResMode, default
   * 0). Without effect: no volume is made smaller.
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
   * From which desired update rate on vtkSmartVolumeMapper takes a frame for a part of an
   * interaction (default 1), and whether it then adjusts sample distances (default on). Without
   * effect: AutoAdjustSampleDistances alone says so.
   */
  vtkSetClampMacro(InteractiveUpdateRate, double, 1.0e-10, 1.0e10);
  vtkGetMacro(InteractiveUpdateRate, double);
  vtkSetClampMacro(InteractiveAdjustSampleDistances, vtkTypeBool, 0, 1);
  vtkGetMacro(InteractiveAdjustSampleDistances, vtkTypeBool);
  vtkBooleanMacro(InteractiveAdjustSampleDistances, vtkTypeBool);
  //@}

  //@{
  /**
   * Distance between samples in interactions, of vtkFixedPointVolumeRayCastMapper. Default: 1.
   * Without effect: nothing is sampled at distances.
   */
  vtkSetMacro(InteractiveSampleDistance, float);
  vtkGetMacro(InteractiveSampleDistance, float);
  //@}

  //@{
  /**
   * Whether polygons and the volume hide each other, of vtkFixedPointVolumeRayCastMapper. Default:
   * on. Without effect: they always do.
   */
  vtkSetClampMacro(IntermixIntersectingGeometry, vtkTypeBool, 0, 1);
  vtkGetMacro(IntermixIntersectingGeometry, vtkTypeBool);
  vtkBooleanMacro(IntermixIntersectingGeometry, vtkTypeBool);
  //@}

  //@{
  /**
   * Threads of vtkFixedPointVolumeRayCastMapper. Default: what vtkMultiThreader takes. Without
   * effect: threads are those of vtkSMPTools, which vtkSMPTools::Initialize() limits.
   */
  vtkSetClampMacro(NumberOfThreads, int, 1, VTK_INT_MAX);
  vtkGetMacro(NumberOfThreads, int);
  //@}

  //@{
  /**
   * What vtkOpenGLGPUVolumeRayCastMapper does with textures: the parts that a volume is loaded in
   * (default 1, 1, 1), a depth texture that mappers share, and loading ahead. Without effect, as
   * there are none; PreLoadData returns true, GetDepthTexture and GetColorTexture null.
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
   * How light is scattered in clouds, and whether the gradient of the opacity makes normals, which
   * the superclasses have since VTK 9.2. Default: 0, 0 and off. Without effect on isosurfaces.
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
   * The input of port 0, or of any port; null where there is none, or none that is a vtkDataSet.
   * Of a port with another input, blocks for example, the second gives an image without points.
   */
  vtkDataSet* GetInput() override;
  vtkDataSet* GetInput(int port) override;
  //@}

  /**
   * WARNING: INTERNAL METHOD - NOT INTENDED FOR GENERAL USE
   * Draw the volume, as Render() does.
   */
  void GPURender(vtkRenderer* renderer, vtkVolume* volume) override;

protected:
  vtkTemporalCoherenceDropInMapper();
  ~vtkTemporalCoherenceDropInMapper() override;

  //@{
  /**
   * Of mappers of AMR data, which this one is not: nothing is done.
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
