// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Request/LabelLooksFromVolume.h"

#include "Request/GradientOpacityFromVolume.h"
#include "Scene/LabelSets.h"

#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <limits>
#include <memory>
#include <utility>
#include <vector>

namespace TemporalCoherence
{

bool LabelLooksFromVolume::Make(vtkVolumeProperty* property, int component, double blendFactor,
  const Field& samples, Blending& blending, std::string& error)
{
  if (!blending.Others.empty())
  {
    error = "Labels of a mask give looks to volumes of one component only; choose one with "
            "SetVectorModeToComponent(), or call SetMaskBlendFactor(0).";
    return false;
  }
  LabelMap map = *std::exchange(blending.Labels, nullptr);
  try
  {
    if (!this->Labels.Make(map.Samples, 0.0, {}, error) ||
      !this->MakeLooks(property, component, blendFactor, samples, blending, map, error))
    {
      return false;
    }
    if (!map.Looks.empty())
    {
      blending.Labels = std::make_shared<const LabelMap>(std::move(map));
    }
    return true;
  }
  catch (const std::exception&)
  {
    error = "There is not enough memory for the labels of the mask; free memory.";
    return false;
  }
}

bool LabelLooksFromVolume::MakeLooks(vtkVolumeProperty* property, int component, double blendFactor,
  const Field& samples, const Blending& volume, LabelMap& made, std::string& error)
{
  const glm::dvec2& range = volume.ScalarRanges.front();
  const GradientOpacity& ofVolume = volume.Looks.front().ByGradient;
  const std::vector<std::int64_t>& present = made.Samples.Labels->Labels();
  std::map<int, SampledTransfer> kept;
  for (const int label : property->GetLabelMapLabels())
  {
    if (label <= 0 || !std::binary_search(present.begin(), present.end(), std::int64_t(label)))
    {
      continue; // VTK draws labels from 1 on
    }
    const ComponentLook& common = volume.Looks.front();
    ComponentLook look;
    look.UnitDistance = common.UnitDistance;
    look.Material = common.Material;
    look.ByGradient.PerStep = common.ByGradient.PerStep;
    if (!MakeLabelGradientOpacity(property, label, look.ByGradient, error))
    {
      return false;
    }
    if (blendFactor < 1.0 && !(look.ByGradient.Nodes.empty() && ofVolume.Nodes.empty()))
    {
      error = "Looks of labels cannot be mixed with that of the volume where gradients have an "
              "opacity; call SetMaskBlendFactor(1), or DisableGradientOpacityOn and "
              "SetLabelGradientOpacity(label, nullptr) of the volume's property.";
      return false;
    }
    SampledTransfer& transfer = kept[label] = std::move(this->Transfers[label]);
    const TransferFunctions own(property, component, label), others(property, component);
    if (!(blendFactor < 1.0 ? transfer.FindMixture(own, blendFactor, others, error)
                            : transfer.Find(own, error)))
    {
      return false;
    }
    LeaveOutBeyond((range.y - range.x) * glm::length(look.ByGradient.PerStep), look.ByGradient);
    look.Transfer = transfer.SampleFor(samples, range);
    made.Looks.push_back({ label, std::move(look) });
  }
  this->Transfers.swap(kept);
  constexpr std::size_t most = std::numeric_limits<std::int16_t>::max();
  if (made.Looks.size() > most)
  {
    error = "The mask has " + std::to_string(made.Looks.size()) +
      " labels with looks, more than the " + std::to_string(most) +
      " that can be drawn; give fewer labels functions of their own.";
    return false;
  }
  return true;
}

}
