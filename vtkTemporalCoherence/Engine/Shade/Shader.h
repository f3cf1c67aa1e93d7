// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Shader_h
#define TemporalCoherence_Shader_h

#include "Scene/Appearance.h"
#include "Scene/Field.h"
#include "Scene/Frame.h"
#include "Scene/RayBatch.h"
#include "Scene/Region.h"
#include "Scene/Tiles.h"
#include "Scene/View.h"
#include "Shade/KernelsShading.h"

#include <array>

namespace TemporalCoherence
{

/// The hits of one tile, gathered into arrays.
struct HitList
{
  template <typename T>
  using Array = RayBatch::Array<T>;

  Array<std::int32_t> Pixel;   ///< position in the planes of the frame
  Array<std::int16_t> Surface; ///< position in the list of isovalues
  Array<HitKind> Kind;
  ShadingKernels::RayPoints Rays; ///< and the hits on them, in the world
  Array<std::array<float, 3>> Normal;
};

/// Where the hits of a picture get their normals from.
struct NormalSource
{
  Field Samples;
  IndexTransform Transform;
  std::vector<glm::dvec4> CapPlanes; ///< planes where solids are capped: RegionClipper::Planes
  std::vector<double> Isovalues;
  glm::dvec2 FiniteRange{ 0.0 };
};

/// Gather the hits of a part of at most RayBatch::Capacity pixels, and clear normals and colours of
/// the misses.
/// \param withDefiniteHits false: leave those out, as their colours are known already
void GatherHits(
  const View& view, const PixelRect& part, bool withDefiniteHits, Frame& frame, HitList& hits);

/// Find the points of the hits of a list on the rays of a view, once it has pixels and distances.
void FindHitPoints(const View& view, HitList& hits);

/// Fill the normals of hits. Pure: depths and surfaces decide normals, whatever route made them.
/// \param gradients gets the gradients of the field, per index step; may be null
void ComputeNormals(const NormalSource& source, HitList& hits,
  std::array<RayBatch::Array<double>, 3>* gradients = nullptr);

/// Copy the normals of hits to and from the planes of a frame.
void StoreNormals(const HitList& hits, Frame& frame);
void LoadNormals(const Frame& frame, HitList& hits);

/// Find the colours of hits from their positions and normals.
///
/// VTK's Phong model: ambient light is the surface's own colour; each light adds a diffuse term
/// max(0, N.L) and a specular term max(0, R.V)^power, R being the light mirrored at the normal
/// (vtkVolumeShaderComposer of VTK 9.2 and later). Normals face the viewer, as for polygons; where
/// lighting is not two-sided they face outside.
void SumLight(const Appearance& appearance, const HitList& hits, ShadingKernels::PhongSums& sums);

/// The same, to the colours of a frame: opaque, and yellow where the appearance asks for it.
void ShadeHits(const Appearance& appearance, const HitList& hits, Frame& frame);

/// Paint the pixels of hits that a cached image did not serve, if the appearance asks for it.
void PaintAnswers(const Appearance& appearance, const HitList& hits, Frame& frame);

}

#endif
