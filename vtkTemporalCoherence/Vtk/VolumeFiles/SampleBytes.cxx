// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/SampleBytes.h"

#include <cstring>

namespace TemporalCoherence
{
namespace
{

inline std::uint16_t Reversed(std::uint16_t value)
{
  return static_cast<std::uint16_t>(value << 8 | value >> 8);
}

inline std::uint32_t Reversed(std::uint32_t value)
{
  value = (value & 0x00ff00ffU) << 8 | (value >> 8 & 0x00ff00ffU);
  return value << 16 | value >> 16;
}

inline std::uint64_t Reversed(std::uint64_t value)
{
  const auto low = static_cast<std::uint32_t>(value);
  const auto high = static_cast<std::uint32_t>(value >> 32);
  return static_cast<std::uint64_t>(Reversed(low)) << 32 | Reversed(high);
}

template <typename Word>
void SwapWords(unsigned char* bytes, std::size_t count)
{
  for (std::size_t i = 0; i < count; ++i)
  {
    Word word;
    std::memcpy(&word, bytes + i * sizeof(Word), sizeof(Word));
    word = Reversed(word);
    std::memcpy(bytes + i * sizeof(Word), &word, sizeof(Word));
  }
}

}

void SwapSampleBytes(ScalarType type, void* samples, std::size_t count)
{
  auto* bytes = static_cast<unsigned char*>(samples);
  switch (SizeOf(type))
  {
    case 2:
      SwapWords<std::uint16_t>(bytes, count);
      break;
    case 4:
      SwapWords<std::uint32_t>(bytes, count);
      break;
    case 8:
      SwapWords<std::uint64_t>(bytes, count);
      break;
    default:
      break;
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
