// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KeptLayers_h
#define TemporalCoherence_KeptLayers_h

#include "Scene/Frame.h"
#include "Scene/HitOrder.h"
#include "Scene/RayBatch.h"
#include "Scene/Surfaces.h"
#include "Scene/Tiles.h"
#include "Shade/KnownLayers.h"

#include <cstddef>
#include <cstdint>
#include <vector>

// What the last picture knows about the layers of one that has some of its isovalues and others.

namespace TemporalCoherence
{

/// How the isovalues of the last picture and of the next one are related, by value.
struct KeptIsovalues
{
  /// \throws std::bad_alloc
  KeptIsovalues(const std::vector<double>& last, const std::vector<double>& next);

  /// For each isovalue of the last picture, its position in the next one; or Frame::NoSurface.
  std::vector<std::int16_t> Next;
  /// Positions in the next picture of those that the last one lacks.
  std::vector<std::int16_t> New;
};

/// Opacities of isovalues, or what they are at least if only shading tells them.
std::vector<double> LeastOpacitiesOf(const Surfaces& surfaces);

/// Known layers of the isovalues that the next picture keeps, in one tile.
///
/// Each ray has a limit: up to it, all its layers of these isovalues are known. What is behind the
/// limit is not known, or no light reaches it.
struct KeptLayers
{
  /// \param known     by the last picture
  /// \param width     of the picture
  /// \param isovalues of the last picture
  /// \param kept      from the last picture to the next one
  /// \param alphas    least opacities of the next picture
  /// \throws std::bad_alloc
  KeptLayers(const KnownLayers& known, const PixelRect& part, int width,
    const std::vector<double>& isovalues, const KeptIsovalues& kept,
    const std::vector<float>& alphas);

  /// True if a surface on a ray is in front of its limit.
  bool IsWithin(std::size_t place, const MetSurface& met) const
  {
    return !(this->Limited >> place & 1u) || IsInFront(met, this->Limits[place]);
  }

  /// The least t behind the limit of a ray, or infinity.
  double EndOf(std::size_t place) const;

  std::vector<LayerHit> Hits; ///< those of each pixel from front to back, by their new positions
  std::uint64_t Limited = 0;  ///< one bit for each pixel whose ray has a limit
  RayBatch::Array<MetSurface> Limits;
};

/// Drop the layers that no light reaches.
/// \param layers those of each pixel from front to back
/// \return one bit for each pixel whose ray is opaque
std::uint64_t DropUnlit(const PixelRect& part, int width, const std::vector<float>& alphas,
  std::vector<LayerHit>& layers);

}

#endif
