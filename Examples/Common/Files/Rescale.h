// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Rescale_h
#define Rescale_h

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <limits>

class vtkDataArray;

// What samples of a scanner's file stand for: slope * sample + offset.
struct Rescaling
{
  double Slope = 1.0, Offset = 0.0;
};

// Finds the smallest type that holds what samples stand for: whole numbers if all are.
class ValueType
{
public:
  void Add(vtkDataArray* samples, const Rescaling& rescaling);
  int Get() const;

private:
  double Least = std::numeric_limits<double>::infinity(), Most = -this->Least;
  double Step = this->Least; // between neighbours, where samples are whole
  bool IsWhole = true;
};

// An array that has the name and the components of another one.
vtkSmartPointer<vtkDataArray> MakeArrayLike(vtkDataArray* other, int type, vtkIdType tuples);

// Values begin to end of an array become the values from another place on of a second one.
void Rescale(vtkDataArray* from, vtkIdType begin, vtkIdType end, const Rescaling& rescaling,
  vtkDataArray* to, vtkIdType at);

#endif
