// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LookTables_h
#define TemporalCoherence_LookTables_h

#include "Volumes/Medium/BlendTracer.h"
#include "Volumes/Medium/TransferTables.h"
#include "Volumes/Medium/VolumeLights.h"
#include "Volumes/Samples/ComponentLooks.h"
#include "Volumes/Samples/ComponentSegment.h"
#include "Volumes/Samples/KernelsMedium.h"
#include "Volumes/Samples/MediumTables.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// The looks of all components for kernels: tables, and their rows of a segment.
class LookTables
{
public:
  /// \param looks of the scene's volume
  /// \throws std::bad_alloc
  LookTables(const BlendScene& scene, const ComponentLooks& looks);

  const MediumKernels::MediumLook& Look() const { return this->Made; }

  /// Maps values to bins, or to shares of their range, for kernels.
  struct Scale
  {
    /// Clamps to the range of single precision.
    double Of(double value) const
    {
      constexpr double most = 1e30;
      return std::clamp((value - this->Low) * this->PerValue + this->Shift, -most, most);
    }

    double Low, PerValue, Shift;
  };

  const Scale& ScaleOf(std::size_t component) const { return this->Scales[component]; }

  /// The values, ascending, at which the look of a component bends. Empty for components without
  /// weight.
  const std::vector<double>& BendsOf(std::size_t component) const { return this->Bends[component]; }

  /// A component with gradients that count, and their first row.
  struct Gradients
  {
    std::size_t Component, Row;
    double Scale; ///< of a gradient of index space
  };

  const std::vector<Gradients>& AllGradients() const { return this->OfGradients; }

  /// The row of a part's unlit look, for constant values.
  static MediumKernels::Row RowOf(
    const ComponentLooks& looks, std::size_t part, const ComponentValues& values);

  /// True if values from low to high may be visible.
  /// \param low, high of each component, in bins
  bool IsSeen(const std::array<double, 4>& low, const std::array<double, 4>& high) const;

  /// True if values from low to high of an independent component may be visible.
  bool IsSeenOf(std::size_t component, double low, double high) const
  {
    return this->Tables[component]->Values.IsSeen(low, high);
  }

  /// True if a light has a position, so that lighting depends on places, not on normals alone.
  bool AreLightsNear() const { return this->HaveNearLights; }

private:
  struct PartTables
  {
    PartTables(const BlendScene& scene, const ComponentLook& look)
      : Values(look.Transfer)
      , ByGradient(look.ByGradient)
      , Lights(scene.Key.Appearance, look.Material)
    {
    }

    MediumTable Values;
    GradientTable ByGradient;
    VolumeLights Lights;
  };

  void AddPart(const ComponentLooks& looks, std::size_t part);
  void AddScales(const BlendScene& scene, const ComponentLooks& looks);

  std::vector<std::unique_ptr<const PartTables>> Tables; ///< of all parts
  MediumKernels::MediumLook Made;
  double Edge; ///< shortest edge of a cell, in the world
  std::array<Scale, 4> Scales{};
  std::array<std::vector<double>, 4> Bends;
  std::vector<Gradients> OfGradients;
  bool HaveNearLights = false;
};

}

#endif
