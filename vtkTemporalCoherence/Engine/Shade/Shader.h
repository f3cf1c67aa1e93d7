// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_Shader_h
#define TemporalCoherence_Shader_h

#include "Lattice/RaySource.h"
#include "Scene/Appearance.h"
#include "Scene/Field.h"
#include "Scene/Frame.h"
#include "Scene/FrameKey.h"
#include "Scene/RayBatch.h"
#include "Scene/Surfaces.h"
#include "Scene/TileHits.h"
#include "Scene/Tiles.h"
#include "Scene/View.h"
#include "Shade/CapNormal.h"
#include "Shade/FieldNormals.h"
#include "Shade/KernelsShading.h"
#include "Shade/Light/ArrivingLight.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{

/// The hits of one tile in arrays. Rays without a hit may be among them: they are shaded at the
/// distance of another ray's hit, and then cleared.
struct HitList
{
  template <typename T>
  using Array = RayBatch::Array<T>;

  Array<std::int32_t> Pixel;   ///< position in the planes of the frame
  Array<SurfaceIndex> Surface; ///< position in the list of isovalues
  Array<HitKind> Kind;
  Array<CellNumber> Cell; ///< of a mesh; NoCell also at misses. Not set for other fields
  Array<double> X, Y;     ///< normalised device coordinates, if FindHitRays is to be called
  HitRays Rays;
  Array<std::array<float, 3>> Normal;
  Array<double> Values; ///< of the array that gives looks, once they are found; NaN: there is none
  std::uint64_t Misses = 0;                  ///< one bit for each place without a hit
  const KnownGradients* Gradients = nullptr; ///< of some of the hits; null: none is known
};

/// Repeat the last element up to the end of the last vector, so that no lane is uninitialised.
template <typename T>
void FillLastVector(std::size_t count, RayBatch::Array<T>& array)
{
  std::fill(array.begin() + static_cast<std::ptrdiff_t>(count),
    array.begin() + static_cast<std::ptrdiff_t>(WholeVectors(count)), array[count - 1]);
}

/// The field and the planes from which normals are computed.
struct NormalSource
{
  Field Samples;
  const FieldNormals& Normals;
  IndexTransform Transform;
  CapPlanes Planes; ///< where solids are capped
  std::vector<double> Isovalues;
  glm::dvec2 FiniteRange{ 0.0 };
};

/// The source of the normals of a key's isosurfaces.
/// \param normals     of the key's field, which must outlive the result
/// \param finiteRange smallest and largest finite sample
NormalSource NormalSourceOf(
  const FrameKey& key, const FieldNormals& normals, const glm::dvec2& finiteRange);

/// Gather the hits of a part of at most RayBatch::Capacity pixels, and clear the normals and
/// colours of misses.
/// \param withDefiniteHits false: skip definite hits, whose colours are known already
void GatherHits(
  const View& view, const PixelRect& part, bool withDefiniteHits, Frame& frame, HitList& hits);

/// Take the hits of a whole tile of a perspective view, whose planes hold them already. Misses are
/// taken too, and not cleared. The list refers to the directions of the tile.
void TakeHits(const View& view, const TileHits& found, HitList& hits);

/// Take the hits of rays that form no tile.
void TakeHitsAt(const View& view, const RayPlaces& at, const TileHits& found, HitList& hits);

/// Clear the normals and colours of the misses in a list.
void ClearMisses(const HitList& hits, Frame& frame);

/// Find the rays of hits from their normalised device coordinates.
void FindHitRays(const View& view, HitList& hits);

/// Find the normals of hits. They depend on depths and surfaces alone, not on the route.
/// \param gradients gets the gradients of the field, per index step; may be null
void ComputeNormals(const NormalSource& source, HitList& hits,
  std::array<RayBatch::Array<double>, 3>* gradients = nullptr);

/// Copy the normals of hits to the planes of a frame, and back.
void StoreNormals(const HitList& hits, Frame& frame);
void LoadNormals(const Frame& frame, HitList& hits);

/// Find the colours of hits from their positions and normals.
///
/// VTK's Phong model: ambient light is the surface's own colour; each light adds a diffuse term
/// max(0, N.L) and a specular term max(0, R.V)^power, where R is the light mirrored at the normal
/// (vtkVolumeShaderComposer of VTK 9.2 and later). Normals face the viewer, as for polygons; if
/// lighting is one-sided, they face outside.
///
/// \param hits     know their values, if an array gives colours
/// \param arriving null: all light arrives
void SumLight(const Appearance& appearance, const HitList& hits, const ArrivingLight* arriving,
  ShadingKernels::PhongSums& sums);

/// Find the colours of hits as SumLight does, and write them as opaque colours of a frame. Pixels
/// are yellow where the appearance asks for it.
void ShadeHits(
  const Appearance& appearance, const HitList& hits, const ArrivingLight* arriving, Frame& frame);

/// Paint the hits that a cached image did not serve yellow, if the appearance asks for it.
void PaintAnswers(const Appearance& appearance, const HitList& hits, Frame& frame);

}

#endif
