// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isomap/BandTracer.h"

namespace TemporalCoherence
{

std::shared_ptr<const BandTracer> BandTracer::Make(const BandScene& scene)
{
  return scene.Samples.Kind->MakeBandTracer(scene);
}

}
