// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/Rescale.h"

#include <vtkDataArray.h>
#include <vtkDataArrayRange.h>

#include <algorithm>
#include <cmath>

namespace
{

constexpr double FloatSteps = 1 << 22; // from 0, which floats of 24 bits tell apart

}

void ValueType::Add(vtkDataArray* samples, const Rescaling& rescaling)
{
  const int type = samples->GetDataType();
  const bool isFloat = type == VTK_FLOAT || type == VTK_DOUBLE;
  for (int component = 0; component < samples->GetNumberOfComponents(); ++component)
  {
    double range[2];
    samples->GetFiniteRange(range, component);
    for (const double sample : { range[0], range[1] })
    {
      const double value = rescaling.Slope * sample + rescaling.Offset;
      this->Least = std::min(this->Least, value);
      this->Most = std::max(this->Most, value);
    }
  }
  this->Step = std::min(this->Step, isFloat ? 0.0 : std::abs(rescaling.Slope));
  this->IsWhole = this->IsWhole && !isFloat && std::floor(rescaling.Slope) == rescaling.Slope &&
    std::floor(rescaling.Offset) == rescaling.Offset;
}

int ValueType::Get() const
{
  for (const int type : { VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT, VTK_INT })
  {
    if (this->IsWhole && this->Least >= vtkDataArray::GetDataTypeMin(type) &&
      this->Most <= vtkDataArray::GetDataTypeMax(type))
    {
      return type;
    }
  }
  const double most = std::max(std::abs(this->Least), std::abs(this->Most));
  const bool isOfFloats =
    !this->IsWhole && most <= FloatSteps * this->Step && most <= static_cast<double>(VTK_FLOAT_MAX);
  return isOfFloats ? VTK_FLOAT : VTK_DOUBLE;
}

vtkSmartPointer<vtkDataArray> MakeArrayLike(vtkDataArray* other, int type, vtkIdType tuples)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetName(other->GetName());
  array->SetNumberOfComponents(other->GetNumberOfComponents());
  array->SetNumberOfTuples(tuples);
  return array;
}

void Rescale(vtkDataArray* from, vtkIdType begin, vtkIdType end, const Rescaling& rescaling,
  vtkDataArray* to, vtkIdType at)
{
  const auto samples = vtk::DataArrayValueRange(from, begin, end);
  auto values = vtk::DataArrayValueRange(to, at, at + end - begin);
  std::transform(samples.begin(), samples.end(), values.begin(),
    [&rescaling](double sample) { return rescaling.Slope * sample + rescaling.Offset; });
}
