// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_View_h
#define TemporalCoherence_View_h

#include <glm/glm.hpp>

namespace TemporalCoherence
{

/// Row `r` of a matrix stored by columns, as a plane: normal in xyz, offset in w.
inline glm::dvec4 RowOf(const glm::dmat4& m, int r)
{
  return { m[0][r], m[1][r], m[2][r], m[3][r] };
}

/// A half line in the world; `Direction` has unit length, so that t is a world distance.
struct Ray
{
  glm::dvec3 Origin;
  glm::dvec3 Direction;
};

/// A camera and a viewport of `Size` pixels: one ray through the centre of each pixel.
///
/// Pixel (0, 0) is at the lower left. The origin and the unnormalised direction of a pixel's ray
/// are linear in the pixel's normalised device coordinates. This holds for every perspective and
/// parallel projection, off-axis and sheared ones included. A perspective ray starts at the eye; a
/// parallel ray starts on the plane through the camera's position.
struct View
{
  glm::ivec2 Size{ 0 };
  bool Parallel = false;
  glm::dvec3 Position{ 0.0 };           ///< the eye, or where the central ray begins
  glm::dvec3 Forward{ 0.0, 0.0, -1.0 }; ///< unit vector of the optical axis
  glm::dvec3 Origin{ 0.0 }, OriginX{ 0.0 }, OriginY{ 0.0 };
  glm::dvec3 Direction{ 0.0 }, DirectionX{ 0.0 }, DirectionY{ 0.0 };
  double Near = 0.0; ///< world distance of the clipping planes from the camera, along `Forward`
  double Far = 0.0;
  glm::dmat4 ClipFromWorld{ 1.0 }; ///< to OpenGL clip coordinates

  /// Normalised device coordinates of the centre of a pixel.
  glm::dvec2 PixelCentre(int x, int y) const
  {
    return { (2.0 * x + 1.0) / this->Size.x - 1.0, (2.0 * y + 1.0) / this->Size.y - 1.0 };
  }

  /// The ray through the centre of pixel (x, y).
  Ray RayThrough(int x, int y) const
  {
    const glm::dvec2 p = this->PixelCentre(x, y);
    return { this->Origin + p.x * this->OriginX + p.y * this->OriginY,
      glm::normalize(this->Direction + p.x * this->DirectionX + p.y * this->DirectionY) };
  }
};

/// Build a view from the matrices of a camera. The matrices alone decide whether it is parallel: a
/// user's transform may turn a camera's parallel projection into a perspective.
/// \param viewFromWorld to camera coordinates: the camera at the origin looks along -z
/// \param clipFromView  projection matrix, to OpenGL clip coordinates
/// \param range         distances of the near and the far clipping plane, in camera coordinates
/// \param size          viewport in pixels
/// \return false if the matrices are degenerate: some pixel would have no ray
bool MakeView(const glm::dmat4& viewFromWorld, const glm::dmat4& clipFromView,
  const glm::dvec2& range, const glm::ivec2& size, View& view);

/// True if both views show every world point at the same pixel.
bool operator==(const View& a, const View& b);

}

#endif
