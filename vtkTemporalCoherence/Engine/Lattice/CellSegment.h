// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellSegment_h
#define TemporalCoherence_CellSegment_h

#include "Lattice/CellRoot.h"
#include "Lattice/SegmentBatch.h"

#include <algorithm>
#include <array>
#include <limits>

namespace TemporalCoherence
{

/// A cell segment: where the ray enters and leaves its cell, and the path between.
template <typename Real>
struct CellSegment
{
  CellSegment(const SegmentBatch<Real>& in, std::size_t i)
    : Enter(in.BeginOf()[i])
    , Leave(in.EndOf()[i])
  {
    std::array<double, 3> enter, leave;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const double ahead = in.DirectionOf(a)[i] > 0.0 ? 1.0 : 0.0;
      enter[a] = (in.Cell[a][i] + (1.0 - ahead) - in.OriginOf(a)[i]) * in.InverseOf(a)[i];
      leave[a] = (in.Cell[a][i] + ahead - in.OriginOf(a)[i]) * in.InverseOf(a)[i];
      this->Enter = std::max(this->Enter, enter[a]);
      this->Leave = std::min(this->Leave, leave[a]);
    }
    for (std::size_t a = 0; a < 3; ++a)
    {
      // On a face the coordinate is exactly 0 or 1, as the neighbour across the face has it.
      const auto at = [&](double t)
      {
        const double x = in.OriginOf(a)[i] + t * in.DirectionOf(a)[i] - in.Cell[a][i];
        return static_cast<Real>(std::min(std::max(x, 0.0), 1.0));
      };
      const Real ahead = in.DirectionOf(a)[i] > 0.0 ? Real(1) : Real(0);
      this->Path.Begin[a] = this->Enter == enter[a] ? Real(1) - ahead : at(this->Enter);
      this->Path.End[a] = this->Leave == leave[a] ? ahead : at(this->Leave);
    }
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      this->Values[corner] = in.Corners[corner][i];
    }
  }

  /// t at a share of the path; infinity if the ray only touches the cell.
  double DistanceAt(double share) const
  {
    return this->Enter < this->Leave ? this->Enter + share * (this->Leave - this->Enter)
                                     : std::numeric_limits<double>::infinity();
  }

  /// The nearest samples along segment i.
  NearestPath Nearest(const SegmentBatch<Real>& in, std::size_t i) const
  {
    std::array<double, 3> midway;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const double middle = in.Cell[a][i] + 0.5 - in.OriginOf(a)[i];
      midway[a] = (middle * in.InverseOf(a)[i] - this->Enter) / (this->Leave - this->Enter);
    }
    return FindNearestPath(this->Path, midway);
  }

  double Enter, Leave;
  CellPath<Real> Path;
  Corners<Real> Values;
};

}

#endif
