// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_StandIn_h
#define TemporalCoherence_StandIn_h

#include "Scene/Field.h"

#include <glm/glm.hpp>

#include <memory>

namespace TemporalCoherence
{

/// A small field in memory that is shown until samples of a large one are read.
struct StandIn
{
  Field Samples;
  std::shared_ptr<const void> Owner; ///< of the samples
  /// Sample i of this field lies at index First + i * Step of the large field.
  glm::dvec3 First{ 0.0 }, Step{ 1.0 };
};

}

#endif
