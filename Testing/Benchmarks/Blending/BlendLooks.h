// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_BlendLooks_h
#define Benchmarks_BlendLooks_h

#include <array>
#include <string>
#include <vector>

class vtkVolumeProperty;

/// Transfer functions like those of CT presets, fitted to each volume.
namespace BlendLooks
{

/// A volume, and two values that matter in it: of what surrounds, and of what is inside.
struct Subject
{
  std::string Volume;
  double Soft, Hard;
};

const std::vector<Subject>& Subjects();

struct Point
{
  double Value;
  std::array<double, 4> Color; ///< RGB and opacity
};

/// Functions that are linear between points.
struct Look
{
  std::string Name;
  std::vector<Point> Points; ///< by ascending values
};

/// A nearly opaque ramp to the inside; both, the outer one like a veil; thin peaks at both.
/// \param range of the volume's values
std::vector<Look> Of(const Subject& subject, const std::array<double, 2>& range);

/// The same with the lower end of its ramp so much higher.
Look Dragged(Look look, double by);

/// The same in other colours, with the same opacities.
Look Recolored(Look look);

/// Set the functions of a property.
void Apply(const Look& look, vtkVolumeProperty* property);

}

#endif
