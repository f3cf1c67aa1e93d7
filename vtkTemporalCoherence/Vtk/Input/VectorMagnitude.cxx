// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/VectorMagnitude.h"

#include "Input/SamplesOfArray.h"
#include "Scene/Parallel.h"

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

namespace TemporalCoherence
{
namespace
{

constexpr std::int64_t TupleGrain = 1 << 14;

/// Beyond these limits, squares or their sums may overflow or lose digits.
constexpr double SmallestSquared = 0x1p-500, LargestSquared = 0x1p+500;

/// The length of a vector, also if its square overflows or underflows.
double ScaledLength(const double* vector, std::size_t components)
{
  double largest = 0.0, sum = 0.0;
  for (std::size_t c = 0; c < components; ++c)
  {
    if (std::isnan(vector[c]))
    {
      return vector[c];
    }
    largest = std::max(largest, std::abs(vector[c]));
  }
  if (largest == 0.0 || std::isinf(largest))
  {
    return largest;
  }
  for (std::size_t c = 0; c < components; ++c)
  {
    sum += (vector[c] / largest) * (vector[c] / largest);
  }
  return largest * std::sqrt(sum);
}

double PlainLength(const double* vector, std::size_t components)
{
  double sum = 0.0;
  for (std::size_t c = 0; c < components; ++c)
  {
    sum += vector[c] * vector[c];
  }
  return std::sqrt(sum);
}

template <typename T, typename Length>
void ComputeLengths(const std::vector<ArraySamples>& components, std::int64_t count, Length* to)
{
  ParallelForRanges(count, TupleGrain,
    [&](std::int64_t begin, std::int64_t end)
    {
      std::vector<double> vector(components.size());
      for (std::int64_t i = begin; i < end; ++i)
      {
        double largest = 0.0;
        for (std::size_t c = 0; c < components.size(); ++c)
        {
          const T* first = static_cast<const T*>(components[c].First);
          vector[c] = static_cast<double>(first[i * components[c].Step]);
          largest = std::max(largest, std::abs(vector[c]));
        }
        const bool isUsual = largest >= SmallestSquared && largest <= LargestSquared;
        to[i] = static_cast<Length>(isUsual ? PlainLength(vector.data(), vector.size())
                                            : ScaledLength(vector.data(), vector.size()));
      }
    });
}

/// Lengths of vectors of 32-bit integers do not fit into a float.
bool NeedsDouble(ScalarType type)
{
  return DispatchScalarType(type,
    [](auto sample)
    {
      using T = decltype(sample);
      return sizeof(T) > 2 && !std::is_same_v<T, float>;
    });
}

}

vtkDataArray* VectorMagnitude::Of(vtkDataArray* vectors, vtkMTimeType stamp)
{
  if (this->Lengths && this->Vectors == vectors && this->Stamp == stamp)
  {
    return this->Lengths;
  }
  std::vector<ArraySamples> components(static_cast<std::size_t>(vectors->GetNumberOfComponents()));
  for (std::size_t c = 0; c < components.size(); ++c)
  {
    components[c] = SamplesOf(vectors, static_cast<int>(c));
  }

  this->Release();
  const vtkIdType count = vectors->GetNumberOfTuples();
  const bool isDouble = NeedsDouble(components[0].Type);
  const auto lengths = vtkSmartPointer<vtkDataArray>::Take(
    isDouble ? static_cast<vtkDataArray*>(vtkDoubleArray::New()) : vtkFloatArray::New());
  lengths->SetName(vectors->GetName());
  lengths->SetNumberOfTuples(count);
  void* to = lengths->GetVoidPointer(0);
  DispatchScalarType(components[0].Type,
    [&](auto sample)
    {
      using T = decltype(sample);
      isDouble ? ComputeLengths<T>(components, count, static_cast<double*>(to))
               : ComputeLengths<T>(components, count, static_cast<float*>(to));
    });
  this->Lengths = lengths;
  this->Vectors = vectors;
  this->Stamp = stamp;
  return this->Lengths;
}

}
