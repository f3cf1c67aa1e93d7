// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MatrixFromVtk_h
#define TemporalCoherence_MatrixFromVtk_h

#include <vtkMatrix4x4.h>

#include <glm/glm.hpp>

namespace TemporalCoherence
{

/// A matrix of VTK as one of GLM: VTK stores rows, GLM columns.
inline glm::dmat4 MatrixFromVtk(vtkMatrix4x4* matrix)
{
  glm::dmat4 result;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      result[column][row] = matrix->GetElement(row, column);
    }
  }
  return result;
}

}

#endif
