// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "BlendErrors.h"

#include "Input/FieldFromImage.h"
#include "Integral/BlendTruth.h"
#include "Measuring.h"
#include "Request/ViewFromRenderer.h"

#include <vtkCamera.h>
#include <vtkPointData.h>
#include <vtkSMPTools.h>
#include <vtkVolumeMapper.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace BlendErrors
{
namespace
{

using namespace TemporalCoherence;

/// So many nodes show a function that is linear between points.
constexpr std::size_t Nodes = 65537;

void Check(bool isMade, const std::string& error)
{
  if (!isMade)
  {
    throw Measuring::Failure(error);
  }
}

TransferFunction TransferOf(const BlendLooks::Look& look)
{
  TransferFunction transfer;
  const std::vector<BlendLooks::Point>& points = look.Points;
  transfer.Range = { points.front().Value, points.back().Value };
  std::size_t next = 1;
  for (std::size_t node = 0; node < Nodes; ++node)
  {
    const double value = glm::mix(transfer.Range.x, transfer.Range.y,
      static_cast<double>(node) / static_cast<double>(Nodes - 1));
    while (next + 1 < points.size() && points[next].Value <= value)
    {
      ++next;
    }
    const BlendLooks::Point &before = points[next - 1], &behind = points[next];
    const double share = (value - before.Value) / (behind.Value - before.Value);
    glm::dvec4 color;
    for (std::size_t c = 0; c < 4; ++c)
    {
      color[static_cast<int>(c)] = glm::mix(before.Color[c], behind.Color[c], share);
    }
    transfer.Nodes.push_back(color);
  }
  return transfer;
}

/// The stage's frame, from what VTK says of it.
FrameKey KeyOf(const Stage& stage, const BlendLooks::Look& look, int mode)
{
  FrameKey key;
  std::string error;
  Check(
    MakeField(stage.Image, stage.Image->GetPointData()->GetScalars(), false, 0, key.Samples, error),
    error);
  Check(MakeIndexTransform(stage.Image, false, stage.Volume, key.Transform, error), error);
  Check(MakeView(stage.Renderer, glm::ivec2(stage.Size), 1.0, key.View, error), error);
  key.Shown.emplace<Blending>().Mode =
    mode == vtkVolumeMapper::COMPOSITE_BLEND ? BlendMode::Composite : BlendMode::Maximum;
  ComponentLook component;
  component.Transfer = TransferOf(look);
  vtkVolumeProperty* property = stage.Volume->GetProperty();
  component.UnitDistance = property->GetScalarOpacityUnitDistance();
  component.Material = { property->GetShade() != 0, property->GetAmbient(), property->GetDiffuse(),
    property->GetSpecular(), property->GetSpecularPower() };
  key.Blended().Looks = { component };
  // A headlight.
  Light light;
  const double* direction = stage.Renderer->GetActiveCamera()->GetDirectionOfProjection();
  light.Direction = { direction[0], direction[1], direction[2] };
  key.Appearance.Lights = { light };
  return key;
}

}

Truth::Truth(const Stage& stage, const BlendLooks::Look& look, int mode, std::size_t stride)
{
  const FrameKey key = KeyOf(stage, look, mode);
  const BlendTruth truth(key);
  const auto size = static_cast<std::size_t>(stage.Size);
  for (std::size_t pixel = 0; pixel < size * size; pixel += stride)
  {
    this->Pixels.push_back(pixel);
  }
  this->Colors.resize(this->Pixels.size());
  vtkSMPTools::For(0, static_cast<vtkIdType>(this->Pixels.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        const std::size_t pixel = this->Pixels[i];
        const glm::dvec4 color =
          truth.ShownAt(static_cast<int>(pixel % size), static_cast<int>(pixel / size));
        this->Colors[i] = { color.x, color.y, color.z };
      }
    });
}

Errors Truth::Of(const BlendWays::Picture& picture) const
{
  std::vector<double> errors;
  for (std::size_t i = 0; i < this->Pixels.size(); ++i)
  {
    double error = 0.0;
    for (std::size_t c = 0; c < 3; ++c)
    {
      error = std::max(
        error, std::abs(this->Colors[i][c] - static_cast<double>(picture[this->Pixels[i]][c])));
    }
    errors.push_back(error);
  }
  std::sort(errors.begin(), errors.end());
  const auto beyond = std::count_if(errors.begin(), errors.end(), [](double e) { return e > 1.0; });
  const auto count = static_cast<double>(errors.size());
  return { Measuring::Mean(errors), errors[static_cast<std::size_t>(0.999 * (count - 1.0))],
    errors.back(), 100.0 * static_cast<double>(beyond) / count };
}

}
