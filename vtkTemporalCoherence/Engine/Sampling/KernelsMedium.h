// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsMedium_h
#define TemporalCoherence_KernelsMedium_h

#include "Blending/TransferTables.h"
#include "Blending/VolumeLights.h"
#include "Sampling/MediumTables.h"
#include "Scene/Blending.h"
#include "Scene/RayBatch.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Kernels that tell what a ray meets at places, of all components together, in the widest vectors
/// of the machine. Every kind of vectors gives the same bits.
namespace MediumKernels
{

/// Numbers along a segment: the sum of [i] x^i.
using Row = std::array<float, 4>;

/// A component that is blended by itself, or all that depend on each other.
struct PartLook
{
  const MediumTable* Table;
  const GradientTable* ByGradient; ///< null: gradients do not count
  const VolumeLights* Lights;      ///< null: it is not shaded
  glm::vec3 PerStep;               ///< scales gradients in bins to those that ByGradient knows
  float Weight;
  float PerEdge;        ///< the shortest edge of a cell / the world distance of an opacity
  std::size_t Opacity;  ///< row of the value that gives its opacity; or of its look
  std::size_t Gradient; ///< first of three rows, if gradients count
};

/// How all components look.
struct MediumLook
{
  ComponentUse Use = ComponentUse::Independent;
  std::vector<PartLook> Parts;
  glm::mat3 WorldFromGradient{ 1.0f };
  std::size_t RowsOfSegment = 0;
  bool AreEven = false; ///< values stay as they are in a segment
  bool HasGradientOpacity = false;
  float EdgesPerLength = 1.0f; ///< 1 / the shortest edge, in the world
};

/// The segments of a ray. Each has RowsOfSegment rows: values of components in bins, but those of
/// a colour in shares of their range; then gradients in bins. Where values stay as they are, looks
/// of parts instead of values: opacity, red, green and blue.
struct MediumSegments
{
  glm::vec3 Begin, Direction; ///< of the ray, in the world
  std::vector<Row> Rows;
  std::vector<float> Enter, Length; ///< world distances from Begin
};

/// Places of a ray, and what is there.
struct MediumPlaces
{
  static constexpr std::size_t Most = 2048;

  template <typename T>
  using Array = std::array<T, Most + WidestVector>;

  std::size_t Count = 0;
  Array<float> Share; ///< of the segment
  Array<std::int32_t> Segment;
  Array<float> Extinction; ///< per shortest edge; negative where it is opaque
  /// Per shortest edge; where it is opaque, what is seen.
  std::array<Array<float>, 3> Emission;
};

/// Find out what is at the places from the given one on.
void FindMedium(
  const MediumLook& look, const MediumSegments& segments, std::size_t from, MediumPlaces& places);

}

}

#endif
