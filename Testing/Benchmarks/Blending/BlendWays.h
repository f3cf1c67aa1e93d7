// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_BlendWays_h
#define Benchmarks_BlendWays_h

#include "Stage.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

/// Ways to draw a blended volume: this mapper, and what VTK has. All show the stage's volume from
/// the stage's camera.
namespace BlendWays
{

using Picture = std::vector<std::array<unsigned char, 3>>;

class Way
{
public:
  explicit Way(const std::string& who)
    : Who(who)
  {
  }
  virtual ~Way() = default;

  /// Called before something changes.
  virtual void BeforeChange(Stage&) {}

  /// Milliseconds.
  virtual double Draw(Stage& stage) = 0;

  /// What was drawn, before black.
  virtual Picture Shown() const = 0;

  const std::string Who;
  bool IsSlow = false; ///< it is drawn in one round only
};

/// \param mode of vtkVolumeMapper; the first two ways are this mapper's, cold and re-using
/// \param hasWindow false: the others are left out
std::vector<std::unique_ptr<Way>> All(const Stage& stage, int mode, bool hasWindow);

}

#endif
