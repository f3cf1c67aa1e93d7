// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_RandomDirection_h
#define Testing_RandomDirection_h

#include <glm/glm.hpp>

#include <random>

/// A unit vector; all directions are equally likely.
inline glm::dvec3 RandomDirection(std::mt19937& engine)
{
  std::normal_distribution<double> component;
  return glm::normalize(glm::dvec3(component(engine), component(engine), component(engine)));
}

#endif
