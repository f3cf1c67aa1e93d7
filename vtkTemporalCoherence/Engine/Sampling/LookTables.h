// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_LookTables_h
#define TemporalCoherence_LookTables_h

#include "Blending/BlendTracer.h"
#include "Blending/TransferTables.h"
#include "Blending/VolumeLights.h"
#include "Sampling/ComponentLooks.h"
#include "Sampling/ComponentSegment.h"
#include "Sampling/KernelsMedium.h"
#include "Sampling/MediumTables.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace TemporalCoherence
{

/// The looks of all components, as kernels take them: tables, and which rows of a segment they
/// read.
class LookTables
{
public:
  /// \param looks of the scene's volume
  /// \throws std::bad_alloc
  LookTables(const BlendScene& scene, const ComponentLooks& looks);

  const MediumKernels::MediumLook& Look() const { return this->Made; }

  /// A value as kernels take it: in bins, or as a share of its range.
  struct Scale
  {
    /// It does not leave what single precision holds.
    double Of(double value) const
    {
      constexpr double most = 1e30;
      return std::clamp((value - this->Low) * this->PerValue + this->Shift, -most, most);
    }

    double Low, PerValue, Shift;
  };

  const Scale& ScaleOf(std::size_t component) const { return this->Scales[component]; }

  /// The values, ascending, at which a component bends what is seen. None if it has no weight.
  const std::vector<double>& BendsOf(std::size_t component) const { return this->Bends[component]; }

  /// A component with gradients that count, and the rows for them.
  struct Gradients
  {
    std::size_t Component, Row;
    double Scale; ///< of a gradient of index space
  };

  const std::vector<Gradients>& AllGradients() const { return this->OfGradients; }

  /// What a part looks like where values stay as they are, with nothing but the functions: a row.
  static MediumKernels::Row RowOf(
    const ComponentLooks& looks, std::size_t part, const ComponentValues& values);

  /// True if something may be seen of values between others.
  /// \param low, high of each component, in bins
  bool IsSeen(const std::array<double, 4>& low, const std::array<double, 4>& high) const;

  /// The same of one component of several that are independent.
  bool IsSeenOf(std::size_t component, double low, double high) const
  {
    return this->Tables[component]->Values.IsSeen(low, high);
  }

  /// True if light changes from place to place, and not by the normal alone.
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
  double Edge; ///< the shortest of a cell, in the world
  std::array<Scale, 4> Scales{};
  std::array<std::vector<double>, 4> Bends;
  std::vector<Gradients> OfGradients;
  bool HaveNearLights = false;
};

}

#endif
