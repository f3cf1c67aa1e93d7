// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellBox_h
#define TemporalCoherence_CellBox_h

#include <glm/glm.hpp>

namespace TemporalCoherence
{

/// The cells First .. First + Size - 1.
struct CellBox
{
  glm::ivec3 First{ 0 }, Size{ 0 };
};

}

#endif
