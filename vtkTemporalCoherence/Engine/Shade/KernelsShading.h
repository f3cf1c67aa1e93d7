// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KernelsShading_h
#define TemporalCoherence_KernelsShading_h

#include "Scene/Frame.h"
#include "Scene/HitRays.h"
#include "Scene/View.h"

#include <array>
#include <cstdint>

namespace TemporalCoherence
{

/// Kernels that shade the hits of a tile, in the widest vectors of the machine. Every kind of
/// vectors gives bit-identical results. Arrays are read and written up to the end of the last
/// vector.
namespace ShadingKernels
{

template <typename T>
using Array = RayBatch::Array<T>;

/// Set up the rays of a view, up to the end of the last vector.
/// \param x, y normalised device coordinates
void FindRays(const View& view, const Array<double>& x, const Array<double>& y, HitRays& rays);

/// Copy the distances of a whole tile. The first finite distance replaces infinite ones.
/// \return one bit for each finite distance
std::uint64_t TakeFinite(const Array<double>& distances, Array<double>& finite);

/// Make unit normals that face the viewer from gradients. Where the gradient is 0, the surface is
/// taken to face the viewer.
/// \param normals result
void FindFacingNormals(const HitRays& rays, const glm::dmat3& worldFromGradient,
  const HitRays::Vectors& gradients, Array<std::array<float, 3>>& normals);

/// Sums of reflected light (Phong's model).
struct PhongSums
{
  std::size_t Count = 0;
  Array<std::array<float, 3>> Normal;
  std::array<Array<float>, 3> Color, Sum; ///< Color: what diffuse light finds

  // One light:
  bool IsPositional = false;
  bool HasShares = false;
  std::array<float, 3> Toward;         ///< unit vector to a light that is not positional
  std::array<Array<float>, 3> ToLight; ///< unit vectors to a positional light
  Array<float> Share;                  ///< share of its light that arrives, if HasShares
  std::array<float, 3> Diffuse, Specular;
  double Power = 1.0;
};
void AddLight(const HitRays& rays, PhongSums& sums);

/// One light that is not positional.
struct SimpleLight
{
  float Ambient;               ///< share of its colour that a surface has without the light
  std::array<float, 3> Toward; ///< unit vector to the light
  std::array<float, 3> Diffuse, Specular;
  double Power;
};

/// Find the colours of hits in one pass: the same bits as AddLight and RoundColors give. Normals
/// and colours are read up to the end of the last vector.
/// \param own colours of the surfaces
void FindColors(const HitRays& rays, const Array<std::array<float, 3>>& normals,
  const std::array<Array<float>, 3>& own, const SimpleLight& light,
  Array<std::array<std::uint8_t, 4>>& colors);

/// The pixels of a tile while surfaces are composited.
struct CompositedPixels
{
  std::array<Array<float>, 3> Sum; ///< of their colours
  Array<float> Passed;             ///< share of light from behind that passes the surfaces
  std::uint64_t Passing;           ///< one bit for each pixel with Passed > 0
  Array<LayerColor> Colors;        ///< colours with opacity, where surfaces were composited
};

/// Surfaces of a tile's pixels, each pixel at most once.
struct LayerRound
{
  std::uint64_t Which = 0; ///< one bit for each pixel with a surface; others have an alpha of 0
  std::array<Array<float>, 3> Color{};
  Array<float> Alpha{};
};

/// Composite surfaces behind the present ones.
void CompositeRound(const LayerRound& round, CompositedPixels& pixels);

/// Convert the sums to opaque RGBA colours.
void RoundColors(const PhongSums& sums, Array<std::array<std::uint8_t, 4>>& colors);

}

}

#endif
