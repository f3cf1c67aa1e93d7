// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_BruteForceTracer_h
#define Testing_BruteForceTracer_h

#include "Truth/BruteForceField.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkImageData;
class vtkRectilinearGrid;
class vtkRenderer;
class vtkVolume;
VTK_ABI_NAMESPACE_END

/// The truth that pictures are compared with: searches every cell along every ray, in double
/// precision, without structures and without any code of the engine.
class BruteForceTracer
{
public:
  struct Hit
  {
    double Distance; ///< world distance along the ray; infinity if nothing is hit
    int Isovalue;    ///< position in the list; -1 if nothing is hit
    std::array<double, 3> Position;
  };

  /// The arguments are those of the field.
  BruteForceTracer(
    vtkImageData* image, vtkVolume* volume, int component = 0, vtkDataArray* cells = nullptr);
  BruteForceTracer(
    vtkRectilinearGrid* grid, vtkVolume* volume, int component = 0, vtkDataArray* cells = nullptr);

  BruteForceField Field;
  std::vector<double> Isovalues;
  bool IsThreshold = false; ///< THRESHOLD, otherwise CROSSING

  /// A piece of a line in the world.
  struct Line
  {
    std::array<double, 3> Origin, Direction; ///< the direction has unit length
    double Begin, End;                       ///< distances from the origin

    /// The point at a distance from the origin.
    std::array<double, 3> PointAt(double t) const
    {
      std::array<double, 3> point;
      for (std::size_t a = 0; a < 3; ++a)
      {
        point[a] = this->Origin[a] + t * this->Direction[a];
      }
      return point;
    }
  };

  /// The line of sight through the centre of pixel (x, y) of a picture of width x height, between
  /// the clipping planes of the renderer's camera. It starts at the eye, or on the plane through a
  /// parallel camera.
  static Line LineThrough(vtkRenderer* renderer, int x, int y, int width, int height);

  /// The first hit on a line.
  Hit Trace(const Line& line) const;

  /// The hit at the centre of pixel (x, y) in a picture of width x height by the renderer's camera.
  Hit Trace(vtkRenderer* renderer, int x, int y, int width, int height) const;
};

#endif
