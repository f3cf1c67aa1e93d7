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
/// the frame's planes, the disparity above which it is.
///
/// A surface can only be in active cells, and rays no farther apart than a cell miss none: space is
/// free up to where the rays of the pixel and its eight neighbours first enter an active cell,
/// whether or not they meet the surface there. That is about a voxel before it. Where the nine see
/// one smooth surface right behind, space is free almost up to the nearest point that this surface
/// has within the pixel.
class FreeSpace
{
public:
  struct Options
  {
    double Voxel = 0.0;   ///< longest edge in the world
    double Bend = 0.0;    ///< the edge in units of which smooth surfaces bend
    double Spacing = 0.0; ///< of pixels in the world; for a perspective at depth 1
    /// Depth up to which pixels are so fine that surfaces alone tell what is free, where they are
    /// met from outside. (A surface that the volume's boundary cuts open is a sheet without
    /// thickness, which no ray meets along its edge; but on one side of it rays are inside.)
    double FineDepth = std::numeric_limits<double>::infinity();
    /// Depth behind which pixels are too coarse to tell anything.
    double FarthestDepth = std::numeric_limits<double>::infinity();
    bool OnlyEntered = false; ///< nothing is known where no surface was met from outside

    bool operator==(const Options& other) const
    {
      return this->Voxel == other.Voxel && this->Bend == other.Bend &&
        this->Spacing == other.Spacing && this->FineDepth == other.FineDepth &&
        this->FarthestDepth == other.FarthestDepth && this->OnlyEntered == other.OnlyEntered;
    }
  };

  /// Make it for a frame, unless it is made with these options already.
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
