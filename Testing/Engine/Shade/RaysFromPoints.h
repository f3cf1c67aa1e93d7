// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_RaysFromPoints_h
#define Testing_RaysFromPoints_h

#include "Scene/HitRays.h"

namespace TemporalCoherence
{

/// A tile of rays, each of which begins at its hit.
struct RaysFromPoints : HitRays
{
  RaysFromPoints()
  {
    this->Count = RayBatch::Capacity;
    this->AreApart = true;
    this->T.fill(0.0);
  }
};

}

#endif
