// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Request/LabelsFromVolume.h"

#include "Kinds/LabelKind.h"
#include "Request/AppearanceFromVolume.h"

#include <vtkLookupTable.h>
#include <vtkVariant.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace TemporalCoherence
{
namespace
{

/// Smooth surfaces that take more, in bytes, are forgotten before the next frame.
constexpr std::size_t MostMemory = std::size_t(1) << 30;

/// True if a table has a colour of its own for a label.
bool Has(vtkScalarsToColors* table, std::int64_t label)
{
  if (table->GetIndexedLookup())
  {
    return table->GetAnnotatedValueIndex(vtkVariant(static_cast<double>(label))) >= 0;
  }
  const auto* const lookup = vtkLookupTable::SafeDownCast(table);
  const double* const range = table->GetRange();
  const auto value = static_cast<double>(label);
  return !lookup || (value >= range[0] && value <= range[1]);
}

bool CheckTable(vtkScalarsToColors* table, std::int64_t label, std::string& error)
{
  if (Has(table, label))
  {
    return true;
  }
  error = "The LabelTable has no colour for label " + std::to_string(label) +
    (table->GetIndexedLookup()
        ? "; add one with SetAnnotation, with an opacity of 0 if it is not to be drawn."
        : "; widen it with SetNumberOfTableValues and SetTableRange, with an opacity of 0 if the "
          "label is not to be drawn.");
  return false;
}

}

bool LabelsFromVolume::Make(
  Field& samples, double radius, const std::vector<SampleChange>& told, std::string& error)
{
  const bool isLattice = !samples.Shape->Abilities().IsMesh;
  if (!isLattice || !AreSame(samples.Shape, UniformShape()))
  {
    error = "Labels can only be drawn of images; call SetSurfaceModeToThreshold(), or resample the "
            "input with vtkResampleToImage.";
    return false;
  }
  if (samples.Type == ScalarType::Float32 || samples.Type == ScalarType::Float64)
  {
    error =
      "The samples are floating-point numbers, but labels are whole ones; cast the array with "
      "vtkImageCast, or call SetSurfaceModeToThreshold().";
    return false;
  }
  if (!(this->Known == samples) || !this->Known.Labels)
  {
    this->See(samples, told);
  }
  if (!this->Smooth || this->Smooth->Radius() != radius)
  {
    this->Smooth = radius > 0.0 ? std::make_shared<const SmoothLabels>(samples, radius) : nullptr;
  }
  else if (this->Smooth->Memory() > MostMemory)
  {
    this->Smooth->Clear();
  }
  samples.Labels = this->Known.Labels;
  samples.Shape = LabelKind(this->Smooth);
  return true;
}

/// Find the labels of new samples. What was known of samples that have not changed stays.
void LabelsFromVolume::See(const Field& samples, const std::vector<SampleChange>& told)
{
  const Field& last = this->Print.Samples;
  // Cells that flags hide have labels, too.
  const bool areKept = this->Known.Labels && last.Samples == samples.Samples &&
    last.Strides == samples.Strides && last.Type == samples.Type &&
    last.Dimensions == samples.Dimensions;
  const Field known = std::exchange(this->Known, Field()); // the next steps may fail
  const std::optional<std::vector<SampleBox>> within =
    areKept ? ChangesBetween(told, last.Stamp, samples.Stamp) : std::nullopt;
  FieldFingerprint now =
    within ? FingerprintOf(samples, this->Print, *within) : FingerprintOf(samples);
  std::shared_ptr<const LabelSets> labels;
  if (areKept)
  {
    const std::vector<CellBox> changed = ChangedCells(this->Print, now, within);
    labels = known.Labels->Updated(samples, changed, now.Nodes, told);
    for (std::size_t i = 0; this->Smooth && i < changed.size(); ++i)
    {
      this->Smooth->Forget(changed[i]);
    }
  }
  else
  {
    this->Smooth.reset();
    labels = LabelSets::Make(samples, now.Nodes);
  }
  this->Print = std::move(now);
  this->Known = samples;
  this->Known.Labels = labels;
}

bool LabelsFromVolume::Find(const LabelSettings& settings, vtkVolumeProperty* property,
  int component, Surfaces& surfaces, std::vector<int>& places, std::string& error) const
{
  constexpr std::int64_t largest = std::numeric_limits<int>::max();
  if (settings.Table)
  {
    settings.Table->Build();
  }
  for (const std::int64_t label : this->Known.Labels->Labels())
  {
    if (label == settings.Outside)
    {
      continue;
    }
    if (settings.Table && !CheckTable(settings.Table, label, error))
    {
      return false;
    }
    const auto value = static_cast<double>(label);
    double opacity = 0.0;
    if (!FindOpacity({ property, component, settings.Table }, "label", value, opacity, error))
    {
      return false;
    }
    if (!(opacity > 0.0))
    {
      continue;
    }
    if (label > largest || label < -largest)
    {
      error = "Label " + std::to_string(label) +
        " cannot be drawn; use labels from -2147483647 to 2147483647.";
      return false;
    }
    surfaces.Isovalues.push_back(value);
    surfaces.Opacities.push_back(opacity);
    places.push_back(static_cast<int>(label));
  }
  const auto isOpaque = [](double opacity) { return opacity == 1.0; };
  if (std::all_of(surfaces.Opacities.begin(), surfaces.Opacities.end(), isOpaque))
  {
    surfaces.Opacities.clear();
  }
  return true;
}

}
