// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_SteppedIntegral_h
#define Benchmarks_SteppedIntegral_h

#include "BlendLooks.h"
#include "Stage.h"

#include <array>
#include <vector>

/// The volume rendering integral by many equal steps a ray, along which values change evenly, in
/// double precision. It shares nothing with the mapper: rays come from VTK's camera, values from
/// VTK's image.
class SteppedIntegral
{
public:
  /// For each ray, within the volume. With twice as many, no pixel of the scenario "jumps" changes
  /// by more than 0.02/255.
  static constexpr int Steps = 24000;

  /// \param stage outlives this; its image has no direction, and its volume no light
  explicit SteppedIntegral(const Stage& stage);

  /// The colour of a pixel before black, in units of 1/255, but not rounded.
  std::array<double, 3> ColorAt(int x, int y, const BlendLooks::Look& look) const;

private:
  using Point = std::array<double, 3>;

  /// Where a ray begins and ends in index space, and its length in the world.
  struct Line
  {
    Point Begin, End;
    double Length;
  };

  Point WorldAt(double x, double y, double depth) const;
  bool FindLine(int x, int y, Line& line) const;
  double ValueAt(const Point& index) const;

  const Stage& Of;
  std::array<int, 3> Dimensions;
  std::vector<double> Values;
  std::array<double, 16> FromPicture; ///< from normalized device coordinates to the world
};

#endif
