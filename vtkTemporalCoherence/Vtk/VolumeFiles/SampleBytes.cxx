// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/SampleBytes.h"

#include <vtkByteSwap.h>

#include <cstring>

namespace TemporalCoherence
{

void SwapSampleBytes(ScalarType type, void* samples, std::size_t count)
{
  if (SizeOf(type) > 1)
  {
    vtkByteSwap::SwapVoidRange(samples, count, SizeOf(type));
  }
}

void FillSamples(ScalarType type, const SampleBytes& value, void* samples, std::size_t count)
{
  DispatchScalarType(type,
    [&](auto sample)
    {
      std::memcpy(&sample, value.data(), sizeof(sample));
      auto* bytes = static_cast<unsigned char*>(samples);
      for (std::size_t i = 0; i < count; ++i)
      {
        std::memcpy(bytes + i * sizeof(sample), &sample, sizeof(sample));
      }
    });
}

bool IsLittleEndianMachine()
{
  const std::uint16_t one = 1;
  unsigned char first = 0;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

}
