// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Samples/LookTables.h"

#include "Scene/FieldShape.h"

#include <algorithm>

namespace TemporalCoherence
{
namespace
{

/// Unit distances in each edge of a cell, at most: with more, any opacity becomes opaque.
constexpr double MostPerEdge = 1e6;

/// Matrix from gradients in index space to normals in the world, of about the same length.
glm::mat3 NormalMatrix(const IndexTransform& transform)
{
  const glm::dmat3 matrix = glm::transpose(glm::dmat3(transform.IndexFromWorld));
  double largest = 0.0;
  for (int column = 0; column < 3; ++column)
  {
    const glm::dvec3 all = glm::abs(matrix[column]);
    largest = std::max({ largest, all.x, all.y, all.z });
  }
  return glm::mat3(largest > 0.0 ? matrix / largest : matrix);
}

}

LookTables::LookTables(const BlendScene& scene, const ComponentLooks& looks)
  : Edge(scene.Key.Samples.Shape->VoxelSizeIn(scene.Key.Transform).Shortest)
{
  this->Made.EdgesPerLength = static_cast<float>(1.0 / this->Edge);
  this->Made.Use = looks.AreIndependent() ? ComponentUse::Independent : scene.Key.Blended().Use;
  this->Made.WorldFromGradient = NormalMatrix(scene.Key.Transform);
  this->Made.AreEven = scene.Key.Samples.Between == Interpolation::Nearest;
  this->Made.RowsOfSegment = this->Made.AreEven ? looks.Parts() : looks.Components();
  for (std::size_t part = 0; part < looks.Parts(); ++part)
  {
    this->Tables.push_back(std::make_unique<const PartTables>(scene, looks.Of(part)));
    if (looks.WeightOf(part) > 0.0)
    {
      this->AddPart(looks, part);
    }
  }
  this->AddScales(scene, looks);
  const std::vector<Light>& lights = scene.Key.Appearance.Lights;
  this->HaveNearLights =
    std::any_of(lights.begin(), lights.end(), [](const Light& light) { return light.Positional; });
}

/// Add a part that has a weight.
void LookTables::AddPart(const ComponentLooks& looks, std::size_t part)
{
  const ComponentLook& look = looks.Of(part);
  const PartTables& tables = *this->Tables[part];
  MediumKernels::PartLook made;
  made.Table = &tables.Values;
  made.ByGradient = look.ByGradient.Nodes.empty() ? nullptr : &tables.ByGradient;
  made.Lights = look.Material.Shade ? &tables.Lights : nullptr;
  made.PerStep = glm::vec3(look.ByGradient.PerStep / tables.Values.PerValue);
  this->Made.HasGradientOpacity |= made.ByGradient != nullptr;
  made.PerEdge = static_cast<float>(std::min(this->Edge / look.UnitDistance, MostPerEdge));
  made.Weight = static_cast<float>(looks.WeightOf(part));
  made.Opacity = this->Made.AreEven ? part : looks.OpacityOf(part);
  made.Gradient = 0;
  if (made.ByGradient || made.Lights)
  {
    made.Gradient = this->Made.RowsOfSegment;
    this->Made.RowsOfSegment += 3;
    this->OfGradients.push_back({ looks.GradientOf(part), made.Gradient, tables.Values.PerValue });
  }
  this->Made.Parts.push_back(made);
}

/// Find the scales of component values, and the values of their bends.
void LookTables::AddScales(const BlendScene& scene, const ComponentLooks& looks)
{
  for (std::size_t c = 0; c < looks.Components(); ++c)
  {
    const bool isColor = this->Made.Use == ComponentUse::RgbOpacity && c < 3;
    if (isColor)
    {
      const glm::dvec2& range = scene.Key.Blended().ScalarRanges[c];
      const double width = range.y - range.x;
      this->Scales[c] = { range.x, width > 0.0 ? 1.0 / width : 0.0, 0.0 };
    }
    else
    {
      const std::size_t part = looks.AreIndependent() ? c : 0;
      const MediumTable& table = this->Tables[part]->Values;
      this->Scales[c] = { table.Low, table.PerValue, 1.0 };
    }
    if (!looks.AreIndependent() || looks.WeightOf(c) > 0.0)
    {
      this->Bends[c] = looks.KinksOf(c);
    }
  }
}

MediumKernels::Row LookTables::RowOf(
  const ComponentLooks& looks, std::size_t part, const ComponentValues& values)
{
  if (!(looks.WeightOf(part) > 0.0))
  {
    return {};
  }
  const glm::dvec4 color = looks.ColorOf(part, values);
  return { SingleOpacity(color.w), static_cast<float>(color.x), static_cast<float>(color.y),
    static_cast<float>(color.z) };
}

bool LookTables::IsSeen(const std::array<double, 4>& low, const std::array<double, 4>& high) const
{
  return std::any_of(this->Made.Parts.begin(), this->Made.Parts.end(),
    [&](const MediumKernels::PartLook& part)
    { return part.Table->IsSeen(low[part.Opacity], high[part.Opacity]); });
}

}
