// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_BlendTruthBreaks_h
#define Testing_BlendTruthBreaks_h

#include <functional>
#include <vector>

/// Finds where a function of t comes to certain values, for BlendTruth.
namespace BlendTruthBreaks
{

/// A part of a ray.
struct Part
{
  double Begin, End;
};

/// Add where a cubic turns, and where it passes bends.
/// \param bends ascending
void AddOfCubic(const std::function<double(double)>& valueAt, const Part& part,
  const std::vector<double>& bends, std::vector<double>& breaks);

/// The same for a function that is smooth, but for sharp turns within a part in 64 of the part.
void AddOfSmooth(const std::function<double(double)>& valueAt, const Part& part,
  const std::vector<double>& bends, std::vector<double>& breaks);

}

#endif
