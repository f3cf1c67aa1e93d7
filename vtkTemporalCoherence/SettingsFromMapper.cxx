// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SettingsFromMapper.h"

#include "vtkTemporalCoherenceVolumeMapper.h"

namespace TemporalCoherence
{
namespace
{

using Mapper = vtkTemporalCoherenceVolumeMapper;

VectorChoice VectorsOf(Mapper* mapper)
{
  using Modes = VectorChoice::Modes;
  switch (mapper->GetVectorMode())
  {
    case Mapper::MAGNITUDE:
      return { Modes::Magnitude, mapper->GetVectorComponent() };
    case Mapper::COMPONENT:
      return { Modes::Component, mapper->GetVectorComponent() };
    default:
      return { Modes::Property, mapper->GetVectorComponent() };
  }
}

}

PictureSettings SettingsOf(Mapper* mapper)
{
  PictureSettings settings;
  settings.Vectors = VectorsOf(mapper);
  settings.Labels = { mapper->GetSurfaceMode() == Mapper::LABELS, mapper->GetOutsideLabel(),
    mapper->GetLabelTable(), mapper->GetLabelRadius() };
  settings.ByArray = { { mapper->GetColorArrayName(), mapper->GetColorArrayOnCells() != 0,
                         mapper->GetColorArrayComponent() },
    mapper->GetColorTable(), mapper->GetColorArrayOpacity() != 0 };
  settings.Mode =
    mapper->GetSurfaceMode() == Mapper::THRESHOLD ? SurfaceMode::Threshold : SurfaceMode::Crossing;
  settings.ColorByAnswer = mapper->GetColorByAnswer() != 0;
  settings.ColorWindow = static_cast<double>(mapper->GetFinalColorWindow());
  settings.ColorLevel = static_cast<double>(mapper->GetFinalColorLevel());
  settings.DepthPass = mapper->GetUseDepthPass() ? mapper->GetDepthPassContourValues() : nullptr;
  settings.Mask = { mapper->GetMaskInput(), mapper->GetMaskType() == Mapper::LabelMapMaskType,
    mapper->GetMaskBlendFactor() };
  settings.SampleDistance =
    mapper->GetFixedStepSampling() ? static_cast<double>(mapper->GetSampleDistance()) : 0.0;
  settings.AveragedGradients = mapper->GetSmoothMeshNormals() != 0;
  settings.IsOccluded = mapper->GetAmbientOcclusion() != 0;
  settings.Occlusion = { mapper->GetAmbientOcclusionRadius(),
    mapper->GetAmbientOcclusionStrength() };
  settings.HasShadows = mapper->GetShadows() != 0;
  settings.LightRadius = mapper->GetLightRadius();
  settings.MeshMemoryLimit = static_cast<std::size_t>(mapper->GetMeshMemoryLimit()) << 20;
  return settings;
}

FrameRenderer::Options OptionsOf(Mapper* mapper, bool isForImage)
{
  static_assert(static_cast<int>(Antialiasing::Off) == Mapper::ANTIALIASING_OFF &&
      static_cast<int>(Antialiasing::WhenStill) == Mapper::ANTIALIASING_WHEN_STILL &&
      static_cast<int>(Antialiasing::Always) == Mapper::ANTIALIASING_ALWAYS,
    "AntialiasingModes tells the same as Antialiasing");
  FrameRenderer::Options options;
  options.SpaceLeaping = mapper->GetSpaceLeaping() != 0;
  options.Reuse.Frames = mapper->GetReuseFrames() != 0;
  options.Reuse.Isomap = mapper->GetIsomap() != 0;
  options.Reuse.RefineWhenStill = mapper->GetRefineWhenStill() != 0;
  options.Accuracy =
    mapper->GetReuseAccuracy() == Mapper::PAPER ? ReuseAccuracy::Paper : ReuseAccuracy::Exact;
  options.InterpolateColors = mapper->GetImageCacheShading() == Mapper::INTERPOLATE;
  options.Images.Policy = mapper->GetImageCachePolicy() == Mapper::KEY_IMAGE
    ? ImageCachePolicy::KeyImage
    : ImageCachePolicy::Latest;
  options.Images.KeyImageInterval = mapper->GetKeyImageInterval();
  options.Images.NumberOfImages = mapper->GetNumberOfCachedImages();
  options.Light.RaysOfFrame = static_cast<std::uint32_t>(mapper->GetAmbientOcclusionRays());
  options.Light.RaysWhenStill = 32 * options.Light.RaysOfFrame;
  const auto when = static_cast<Antialiasing>(mapper->GetAntialiasing());
  const bool isAtOnce = isForImage && !mapper->GetProgressiveImages();
  options.Antialias = when == Antialiasing::WhenStill && isAtOnce ? Antialiasing::Always : when;
  options.Map.Range = { mapper->GetIsomapRange()[0], mapper->GetIsomapRange()[1] };
  options.Map.Tolerance = mapper->GetIsomapTolerance();
  options.Map.HasNormals = mapper->GetIsomapShading() == Mapper::INTERPOLATE;
  options.Map.MemoryLimit = static_cast<std::size_t>(mapper->GetIsomapMemoryLimit()) << 20;
  return options;
}

}
