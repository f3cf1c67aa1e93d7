// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_FreeSpace_h
#define TemporalCoherence_FreeSpace_h

#include "Frame.h"
#include "View.h"

#include <limits>
#include <vector>

namespace TemporalCoherence
{

/// The space that a finished picture shows to be free of surfaces: for each pixel, in the order of
/// the frame's planes, the disparity above which it is.
///
/// At edges this is the nearest surface of the pixel and its eight neighbours, moved nearer by a
/// margin. Where the nine are one smooth surface, it is the nearest point that this surface has
/// within the pixel, moved nearer by an eighth of the margin.
class FreeSpace
{
public:
  struct Options
  {
    double Margin = 0.0;                                            ///< world units
    double FarthestDepth = std::numeric_limits<double>::infinity(); ///< nothing is known behind
    bool OnlyEntered = false; ///< nothing is known where no surface was met from outside

    bool operator==(const Options& other) const
    {
      return this->Margin == other.Margin && this->FarthestDepth == other.FarthestDepth &&
        this->OnlyEntered == other.OnlyEntered;
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
  std::vector<float> Filled; ///< for each tile, what all of its pixels have; or NaN
  Options MadeWith;
  bool IsMade = false;
};

}

#endif
