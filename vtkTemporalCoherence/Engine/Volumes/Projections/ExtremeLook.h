// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ExtremeLook_h
#define TemporalCoherence_ExtremeLook_h

#include "Volumes/Medium/BlendTracer.h"
#include "Volumes/Projections/FieldProbe.h"
#include "Volumes/Samples/ComponentLooks.h"

#include <cstddef>
#include <vector>

namespace TemporalCoherence
{

/// Shows the extremes along rays.
class ExtremeLook : public BlendTracer
{
public:
  void Begin(BlendedRays& seen) const override;
  void Finish(const RayBatch& rays, const WorldDirections&, BlendedRays& seen) const override;

protected:
  ExtremeLook(const BlendScene& scene, const GridCoordinates* grid);

  static BlendedRays::Array<double>& ValueOf(BlendedRays& seen, std::size_t part)
  {
    return part == 0 ? seen.Value : seen.OtherValues[part - 1];
  }

  bool IsMinimum() const { return this->Volume.Mode == BlendMode::Minimum; }

  const Blending& Volume;
  ComponentLooks Looks;

private:
  void Show(const RayBatch& rays, std::size_t ray, BlendedRays& seen) const;

  std::vector<FieldProbe> Probes; ///< of all components, if they are dependent
};

}

#endif
