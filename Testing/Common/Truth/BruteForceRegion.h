// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_BruteForceRegion_h
#define Testing_BruteForceRegion_h

#include "Truth/BruteForceTracer.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <array>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkVolume;
class vtkVolumeMapper;
VTK_ABI_NAMESPACE_END

/// Clips lines in the world to the clipping planes and cropping of a mapper, without any code of
/// the engine.
class BruteForceRegion
{
public:
  /// \param volume its transform
  BruteForceRegion(vtkVolumeMapper* mapper, vtkVolume* volume);

  /// The parts of a line that are kept, from front to back. Parts that touch are joined: a solid is
  /// not capped between them.
  std::vector<BruteForceTracer::Line> Of(const BruteForceTracer::Line& line) const;

  /// The first hit on the kept parts of a line.
  BruteForceTracer::Hit Trace(
    const BruteForceTracer& truth, const BruteForceTracer::Line& line) const;

private:
  using Point = std::array<double, 3>;

  Point DataFromWorld(const Point& world) const;
  bool Keeps(const Point& world) const;
  std::vector<double> PlanesAt(const Point& world) const;

  vtkVolumeMapper* Mapper;
  std::array<double, 16> Back; ///< from the world to coordinates of the data
};

#endif
