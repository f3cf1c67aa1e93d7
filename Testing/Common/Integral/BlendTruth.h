// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_BlendTruth_h
#define Testing_BlendTruth_h

#include "Integral/BlendTruthBreaks.h"
#include "Integral/BlendTruthField.h"
#include "Integral/BlendTruthLook.h"
#include "Scene/FrameKey.h"

#include <glm/glm.hpp>

#include <vector>

/// What a pixel shows of a blended volume, in double precision, without any tracer of the engine.
/// Each ray is divided where cells begin and where transfer functions bend. What lies between is
/// integrated by halves until nothing changes, so that no peak is stepped over.
class BlendTruth
{
public:
  /// \param key outlives this; its volume is on
  /// \param coordinates of the samples of a rectilinear field; null: they lie at integers
  explicit BlendTruth(const TemporalCoherence::FrameKey& key,
    const TemporalCoherence::GridCoordinates* coordinates = nullptr);

  /// RGB multiplied by opacity, and opacity: before scale and shift of the appearance.
  glm::dvec4 At(int x, int y) const;

  /// RGBA as it is shown, in units of 1/255, but not rounded.
  glm::dvec4 ShownAt(int x, int y) const;

private:
  /// A colour in front of something, and the share of light that passes it.
  struct Veil
  {
    glm::dvec3 Color{ 0.0 };
    double Passed = 1.0;
  };
  struct Line
  {
    glm::dvec3 Origin, Direction;           ///< in the world
    glm::dvec3 IndexOrigin, IndexDirection; ///< in index space
    BlendTruthLook::Place At(double t) const;
  };
  using Part = BlendTruthBreaks::Part;
  struct Sums;

  std::vector<Part> KeptOf(const Line& line, double end, double& entry) const;
  bool IsKept(const glm::dvec3& index) const;
  void AddCells(const Line& line, const Part& kept, Sums& sums) const;
  void AddCell(
    const Line& line, const BlendTruthField::Cell& cell, const Part& part, Sums& sums) const;
  std::vector<double> BreaksOf(
    const Line& line, const BlendTruthField::Cell& cell, const Part& part) const;
  void AddPart(
    const Line& line, const BlendTruthField::Cell& cell, const Part& part, Sums& sums) const;
  void AddValues(const std::array<double, 4>& values, Sums& sums) const;
  std::array<double, 4> ValuesAt(
    const Line& line, const BlendTruthField::Cell& cell, double t) const;
  Veil VeilOf(const Line& line, const BlendTruthField::Cell& cell, const Part& part) const;
  Veil VeilWithin(const Line& line, const BlendTruthField::Cell& cell, const Part& part,
    const Veil& whole, double passed, int depth) const;
  void AddShares(
    const Line& line, const BlendTruthField::Cell& cell, const Part& part, Sums& sums) const;
  void AddSamples(const Line& line, const std::vector<Part>& kept, double entry, Sums& sums) const;
  glm::dvec4 ColorOf(const Sums& sums) const;

  const TemporalCoherence::FrameKey& Key;
  BlendTruthField Field;
  BlendTruthLook Look;
  std::vector<std::vector<double>> Bends; ///< of each component
};

#endif
