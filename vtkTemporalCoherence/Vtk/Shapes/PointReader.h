// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PointReader_h
#define TemporalCoherence_PointReader_h

#include "Shapes/MadeCells.h"

#include <vtkDataArray.h>
#include <vtkPoints.h>

#include <cmath>

namespace TemporalCoherence
{

/// One component of a tuple, or the tuple's length if the component is negative.
inline double ValueOf(vtkDataArray* array, vtkIdType tuple, int component)
{
  if (component >= 0)
  {
    return array->GetComponent(tuple, component);
  }
  double sum = 0.0;
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
  {
    const double value = array->GetComponent(tuple, c);
    sum += value * value;
  }
  return std::sqrt(sum);
}

/// Reads points of a data set with their values.
struct PointReader
{
  vtkPoints* Points;
  vtkDataArray* Values;
  int Component; ///< negative: the length of vectors

  PointValue Read(vtkIdType id) const
  {
    PointValue point;
    this->Points->GetPoint(id, point.data());
    point[3] = ValueOf(this->Values, id, this->Component);
    return point;
  }
};

}

#endif
