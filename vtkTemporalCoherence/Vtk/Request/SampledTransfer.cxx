// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Request/SampledTransfer.h"

#include <vtkPiecewiseFunction.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace TemporalCoherence
{
namespace
{

/// Lower limit of intervals between the remaining samples.
constexpr std::size_t FewestIntervals = 1 << 4;

/// Largest difference between straight lines and left-out samples. Opacities add up along a ray.
constexpr double LargestColorError = 0.0005, LargestOpacityError = 1e-5;

/// True if straight lines between every `stride`-th sample meet all samples.
bool IsEnough(const std::vector<glm::dvec4>& samples, std::size_t stride)
{
  for (std::size_t first = 0; first + stride < samples.size(); first += stride)
  {
    const glm::dvec4 &low = samples[first], &high = samples[first + stride];
    for (std::size_t i = 1; i < stride; ++i)
    {
      const double share = static_cast<double>(i) / static_cast<double>(stride);
      const glm::dvec4 error = glm::abs(low + share * (high - low) - samples[first + i]);
      if (std::max({ error.x, error.y, error.z }) > LargestColorError ||
        error.w > LargestOpacityError)
      {
        return false;
      }
    }
  }
  return true;
}

/// Leave out samples that interpolation of the others gives.
void Thin(TransferFunction& transfer)
{
  const std::vector<glm::dvec4>& samples = transfer.Nodes;
  std::size_t stride = 1;
  while ((samples.size() - 1) / (2 * stride) >= FewestIntervals && IsEnough(samples, 2 * stride))
  {
    stride *= 2;
  }
  std::vector<glm::dvec4> nodes;
  for (std::size_t i = 0; i < samples.size(); i += stride)
  {
    nodes.push_back(samples[i]);
  }
  transfer.Nodes.swap(nodes);
}

}

bool SampledTransfer::Find(vtkVolumeProperty* property, int component, std::string& error)
{
  const TransferFunctions functions(property, component);
  const vtkMTimeType colorTime = functions.Colors()->GetMTime();
  const vtkMTimeType opacityTime = functions.Opacity->GetMTime();
  if (this->Functions && this->Colors == functions.Colors() &&
    this->Opacities == functions.Opacity && this->ColorTime == colorTime &&
    this->OpacityTime == opacityTime)
  {
    return true;
  }
  this->Functions.reset();
  this->Transfer.Nodes.clear();
  if (!FindNodes(functions, this->Nodes, error))
  {
    return false;
  }
  this->Functions = functions;
  this->Colors = functions.Colors();
  this->Opacities = functions.Opacity;
  this->ColorTime = colorTime;
  this->OpacityTime = opacityTime;
  return true;
}

const TransferFunction& SampledTransfer::Sample(const AskedValues& asked)
{
  assert(this->Functions);
  if (this->Transfer.Nodes.empty() || !(this->Asked == asked))
  {
    this->Transfer = SampleFunctions(*this->Functions, this->Nodes, asked);
    Thin(this->Transfer);
    this->Asked = asked;
  }
  return this->Transfer;
}

}
