// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Fuzz_Bytes_h
#define Fuzz_Bytes_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace Fuzz
{

/// A stream of bytes, read as choices and numbers. Where it has ended, every choice is the first
/// and every number the smallest: the dullest ones.
class Bytes
{
public:
  explicit Bytes(std::vector<std::uint8_t> bytes);

  /// As many bytes as are asked for, the same for the same seed on every machine.
  static std::vector<std::uint8_t> FromSeed(std::uint64_t seed, std::size_t size);

  bool IsUsedUp() const { return this->At >= this->All.size(); }
  const std::vector<std::uint8_t>& Whole() const { return this->All; }

  std::uint8_t Next();

  /// 0 to n - 1.
  int Pick(int n);

  /// True once in n times.
  bool OneIn(int n) { return this->Pick(n) == n - 1; }

  /// Any of them.
  template <typename T, std::size_t N>
  const T& OneOf(const T (&choices)[N])
  {
    return choices[this->Pick(static_cast<int>(N))];
  }

  /// A common number.
  double Between(double low, double high);

  /// Zeros, numbers that are none, infinite, huge, tiny, at the edges of types; or any bits.
  double Wild();
  int WildInt();

  /// How often Number() is wild: once in so many times; 0: never.
  int Wildness = 0;
  bool IsWild() { return this->Wildness > 0 && this->OneIn(this->Wildness); }
  double Number(double low, double high);

private:
  std::vector<std::uint8_t> All;
  std::size_t At = 0;
};

}

#endif
