// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_VectorMagnitude_h
#define TemporalCoherence_VectorMagnitude_h

#include <vtkDataArray.h>
#include <vtkSmartPointer.h>
#include <vtkType.h>

namespace TemporalCoherence
{

/// The Euclidean length of each tuple of an array, computed once.
///
/// It is computed in double precision and stored as float, or as double if samples are double or
/// integers of 32 bits or more.
class VectorMagnitude
{
public:
  /// \pre AreInPlace(vectors)
  /// \param stamp differs whenever the tuples may have changed
  /// \return the array of lengths, which this object owns
  vtkDataArray* Of(vtkDataArray* vectors, vtkMTimeType stamp);

  void Release() { *this = VectorMagnitude(); }

private:
  vtkSmartPointer<vtkDataArray> Lengths;
  vtkDataArray* Vectors = nullptr; ///< only compared: it may dangle
  vtkMTimeType Stamp = 0;
};

}

#endif
