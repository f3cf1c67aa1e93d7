// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GpuMapperSettings.h"

#include "Request/FieldFromMapper.h"
#include "vtkTemporalCoherenceVolumeMapper.h"

#include <vtkAlgorithmOutput.h>
#include <vtkMultiVolume.h>
#include <vtkPlaneCollection.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

namespace TemporalCoherence
{
namespace
{

bool HasShaders(vtkVolume* volume)
{
  vtkShaderProperty* shaders = volume->GetShaderProperty();
  return shaders->HasVertexShaderCode() || shaders->HasFragmentShaderCode() ||
    shaders->HasGeometryShaderCode() || shaders->GetNumberOfShaderReplacements() > 0;
}

/// True if light is scattered, or if normals come from the gradient of the opacity.
bool IsCloudy(vtkGPUVolumeRayCastMapper* mapper)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  return mapper->GetGlobalIlluminationReach() > 0.0f ||
    mapper->GetVolumetricScatteringBlending() > 0.0f || mapper->GetComputeNormalFromOpacity();
#else
  static_cast<void>(mapper);
  return false;
#endif
}

void HandOverScalarChoice(vtkGPUVolumeRayCastMapper* from, vtkTemporalCoherenceVolumeMapper* to)
{
  to->SetScalarMode(from->GetScalarMode());
  if (from->GetArrayAccessMode() == VTK_GET_ARRAY_BY_NAME)
  {
    to->SelectScalarArray(from->GetArrayName());
  }
  else
  {
    to->SelectScalarArray(from->GetArrayId());
  }
}

}

std::string WhyNotDrawn(vtkGPUVolumeRayCastMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  if (mapper->GetBlendMode() == vtkVolumeMapper::COMPOSITE_BLEND && mapper->GetUseDepthPass())
  {
    return "UseDepthPass is on";
  }
  if (vtkMultiVolume::SafeDownCast(volume) || OtherInputPort(mapper) > 0)
  {
    return "there are several inputs";
  }
  if (renderer->GetUseDepthPeeling() && renderer->GetUseDepthPeelingForVolumes())
  {
    return "volumes are peeled by depth";
  }
  if (volume->GetProperty()->GetTransferFunctionMode() != vtkVolumeProperty::TF_1D)
  {
    return "the transfer functions are two-dimensional";
  }
  if (HasShaders(volume))
  {
    return "the volume has user-defined shaders";
  }
  if (IsCloudy(mapper))
  {
    return "light is scattered, or normals come from the opacity";
  }
  if (mapper->GetRenderToImage())
  {
    return "RenderToImage is on";
  }
  return std::string();
}

void HandOver(vtkGPUVolumeRayCastMapper* from, vtkTemporalCoherenceVolumeMapper* to)
{
  vtkAlgorithmOutput* const input =
    from->GetNumberOfInputConnections(0) > 0 ? from->GetInputConnection(0, 0) : nullptr;
  vtkAlgorithmOutput* const last =
    to->GetNumberOfInputConnections(0) > 0 ? to->GetInputConnection(0, 0) : nullptr;
  if (input != last)
  {
    to->SetInputConnection(input);
  }
  HandOverScalarChoice(from, to);
  to->SetClippingPlanes(from->GetClippingPlanes());
  to->SetCropping(from->GetCropping());
  to->SetCroppingRegionPlanes(from->GetCroppingRegionPlanes());
  to->SetCroppingRegionFlags(from->GetCroppingRegionFlags());
  to->SetFinalColorWindow(from->GetFinalColorWindow());
  to->SetFinalColorLevel(from->GetFinalColorLevel());
  to->SetMaskInput(from->GetMaskInput());
  to->SetMaskType(from->GetMaskType());
  to->SetMaskBlendFactor(from->GetMaskBlendFactor());
  to->SetBlendMode(from->GetBlendMode());
  // Not SampleDistance: without it, pictures are converged.
  to->SetAverageIPScalarRange(from->GetAverageIPScalarRange());
  to->SetAutoAdjustSampleDistances(from->GetAutoAdjustSampleDistances());
  to->SetMaximumImageSampleDistance(from->GetMaximumImageSampleDistance());
  to->SetImageSampleDistance(from->GetAutoAdjustSampleDistances()
      ? from->GetMinimumImageSampleDistance()
      : from->GetImageSampleDistance());
}

}
