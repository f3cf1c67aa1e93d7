// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewFile/ViewMaker.h"

#include "Acceleration/FieldStructures.h"

#include <algorithm>
#include <limits>
#include <sstream>

namespace TemporalCoherence
{

std::string ViewMaker::WhyNot(const FrameKey& key)
{
  if (key.IsBlended())
  {
    return "WriteView writes isosurfaces, but this volume is blended; set the blend mode to "
           "isosurfaces.";
  }
  if (key.Samples.Labels)
  {
    return "WriteView writes isosurfaces, not labels.";
  }
  if (!key.Samples.HasCells())
  {
    return "WriteView found no cells; give the mapper an input with cells.";
  }
  if (!key.Samples.Shape->Abilities().Isomaps || key.Samples.Shape->Abilities().IsMesh)
  {
    return "WriteView writes images and rectilinear grids; resample other data to an image first "
           "(vtkResampleToImage).";
  }
  if (key.Samples.Between != Interpolation::Linear)
  {
    return "WriteView needs linear interpolation; call SetInterpolationTypeToLinear() of the "
           "volume's property.";
  }
  if (!key.Region.IsConvex())
  {
    return "WriteView cannot write a volume that cropping cuts into several parts; crop to one "
           "box.";
  }
  return {};
}

/// Only the isovalues of the range count.
FrameKey ViewMaker::WithoutLook(const FrameKey& key, double isovalue)
{
  FrameKey bare = key;
  Surfaces surfaces;
  surfaces.Isovalues = { isovalue };
  bare.Shown = surfaces;
  bare.Appearance.Colors = { glm::dvec3(1.0) };
  bare.Appearance.ByArray = nullptr;
  return bare;
}

SurfaceHistogram ViewMaker::CountSurfaces(const FrameKey& key)
{
  const FrameKey bare = WithoutLook(key, 0.0);
  return TemporalCoherence::CountSurfaces(key.Samples.Type, *this->Renderer.RangesOf(bare).Pyramid);
}

bool ViewMaker::Make(const FrameKey& key, const ValueBand& range, const ReportProgress& report,
  KnotImage& knots, std::string& error)
{
  FrameKey bare = WithoutLook(key, 0.0);
  const FieldRanges& ranges = this->Renderer.RangesOf(bare);
  if (ranges.Samples.Hidden)
  {
    error = "WriteView cannot write data with hidden cells or samples that are no numbers; give "
            "these a value first.";
    return false;
  }
  const glm::dvec2 samples = ranges.Pyramid->FiniteRange();
  const ValueBand met{ std::max(range.Low, samples.x), std::min(range.High, samples.y) };
  if (!(met.Low <= met.High))
  {
    std::ostringstream text;
    text << "WriteView was asked for isovalues from " << range.Low << " to " << range.High
         << ", but samples lie from " << samples.x << " to " << samples.y << "; set another range.";
    error = text.str();
    return false;
  }
  bare = WithoutLook(key, met.Low + 0.5 * (met.High - met.Low));
  FrameRenderer::Options options;
  options.Map.Range = met;
  options.Map.Tolerance = this->Tolerance;
  options.Map.HasNormals = true;
  options.Map.MemoryLimit = std::numeric_limits<std::size_t>::max();
  const Isomap::Outcome outcome = this->Renderer.BuildIsomap(bare, options, report);
  const Isomap& map = this->Renderer.IsomapOfLastView();
  if (outcome == Isomap::Outcome::Stopped)
  {
    return false;
  }
  if (outcome != Isomap::Outcome::Built || !(map.Tolerance() > 0.0))
  {
    error = "WriteView could not find the surfaces of this view within the tolerance; set a larger "
            "tolerance.";
    return false;
  }
  knots = ImageOf(map, met, samples);
  this->Renderer.Release();
  return true;
}

const Frame& ViewMaker::Draw(
  const FrameKey& key, const std::vector<ViewSurface>& surfaces, const ValueBand& range)
{
  FrameKey plain = key;
  Surfaces shown;
  plain.Appearance.Colors.clear();
  for (const ViewSurface& surface : surfaces)
  {
    const double isovalue = std::min(std::max(surface.Isovalue, range.Low), range.High);
    if (std::count(shown.Isovalues.begin(), shown.Isovalues.end(), isovalue) > 0)
    {
      continue;
    }
    shown.Isovalues.push_back(isovalue);
    shown.Opacities.push_back(surface.Opacity);
    plain.Appearance.Colors.push_back(surface.Color);
  }
  plain.Shown = shown;
  plain.Appearance.ByArray = nullptr;
  plain.Appearance.Occlusion = {};
  for (Light& light : plain.Appearance.Lights)
  {
    light.CastsShadows = false;
  }
  this->Renderer.Render(plain, {});
  return this->Renderer.LastFrame();
}

}
