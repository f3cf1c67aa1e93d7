// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FreeSpace_h
#define TemporalCoherence_FreeSpace_h

#include "Scene/Frame.h"
#include "Scene/View.h"

#include <limits>
#include <vector>

namespace TemporalCoherence
{

/// The space that a finished picture shows to be free of surfaces: for each pixel, in the order of
/// the frame's planes, the disparity above which space is free.
///
/// Surfaces lie in active cells only, and rays no farther apart than a cell miss no active cell. So
/// space is free up to where the rays of the pixel and its eight neighbours first enter an active
/// cell, whether or not they meet a surface there. That is about a voxel before the surface. Where
/// the nine rays show one smooth surface right behind, space is free almost up to the nearest point
/// of this surface within the pixel.
class FreeSpace
{
public:
  struct Options
  {
    double Voxel = 0.0;   ///< longest edge in the world
    double Bend = 0.0;    ///< the edge by which the bending of smooth surfaces is measured
    double Spacing = 0.0; ///< of pixels in the world; for a perspective at depth 1
    /// Up to this depth pixels are so fine that the surfaces alone tell what is free, if they are
    /// met from outside. (A surface clipped by the volume's boundary is a sheet without thickness.
    /// No ray meets its edge, but rays on one side of it run inside.)
    double FineDepth = std::numeric_limits<double>::infinity();
    /// Behind this depth pixels are too coarse to tell anything.
    double FarthestDepth = std::numeric_limits<double>::infinity();

    bool operator==(const Options& other) const
    {
      return this->Voxel == other.Voxel && this->Bend == other.Bend &&
        this->Spacing == other.Spacing && this->FineDepth == other.FineDepth &&
        this->FarthestDepth == other.FarthestDepth;
    }
  };

  /// Compute it for a frame, unless that was done with these options before.
  /// \throws std::bad_alloc
  void Make(const Frame& frame, const View& view, const Options& options);

  /// Forget the frame; memory is kept.
  void Clear() { this->IsMade = false; }

  const float* Guard() const { return this->Disparities.data(); }

private:
  std::vector<float> Disparities;
  std::vector<float> Filled; ///< by tile
  glm::ivec2 Size{ 0 };
  Options MadeWith;
  bool IsMade = false;
};

}

#endif
