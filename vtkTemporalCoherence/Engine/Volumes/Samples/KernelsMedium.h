// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsMedium_h
#define TemporalCoherence_KernelsMedium_h

#include "Scene/Blending.h"
#include "Scene/RayBatch.h"
#include "Volumes/Medium/TransferTables.h"
#include "Volumes/Medium/VolumeLights.h"
#include "Volumes/Samples/MediumTables.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// Kernels that find extinction and emission at places of a ray, of all components together, in the
/// widest vectors of the machine. Every kind of vectors gives the same bits.
namespace MediumKernels
{

/// A cubic along a segment: the sum of [i] x^i.
using Row = std::array<float, 4>;

/// The look of an independent component, or of all dependent components together.
struct PartLook
{
  const MediumTable* Table;
  const GradientTable* ByGradient; ///< null: gradients do not count
  const VolumeLights* Lights;      ///< null: unshaded
  glm::vec3 PerStep;               ///< scales gradients in bins to the units of ByGradient
  float Weight;
  float PerEdge;        ///< the shortest edge of a cell / the world distance of an opacity
  std::size_t Opacity;  ///< row of the value that gives its opacity; with AreEven, of its look
  std::size_t Gradient; ///< first of three rows, if gradients count
};

/// The looks of all components.
struct MediumLook
{
  ComponentUse Use = ComponentUse::Independent;
  std::vector<PartLook> Parts;
  glm::mat3 WorldFromGradient{ 1.0f };
  std::size_t RowsOfSegment = 0;
  bool AreEven = false; ///< values are constant in a segment
  bool HasGradientOpacity = false;
  float EdgesPerLength = 1.0f; ///< 1 / the shortest edge, in the world
};

/// The segments of a ray. Each has RowsOfSegment rows: values of components in bins, or of colours
/// as shares of their range; then gradients in bins. With AreEven, looks of parts replace the
/// values: opacity, red, green and blue.
struct MediumSegments
{
  glm::vec3 Begin, Direction; ///< of the ray, in the world
  std::vector<Row> Rows;
  std::vector<float> Enter, Length; ///< world distances from Begin
};

/// Places of a ray, with extinction and emission.
struct MediumPlaces
{
  static constexpr std::size_t Most = 2048;

  template <typename T>
  using Array = std::array<T, Most + WidestVector>;

  std::size_t Count = 0;
  Array<float> Share; ///< of the segment
  Array<std::int32_t> Segment;
  Array<float> Extinction; ///< per shortest edge; negative where it is opaque
  /// Emission per shortest cell edge; at opaque places (Extinction < 0) the colour itself.
  std::array<Array<float>, 3> Emission;
};

/// Find extinction and emission at the places from number `from` on.
void FindMedium(
  const MediumLook& look, const MediumSegments& segments, std::size_t from, MediumPlaces& places);

}

}

#endif
