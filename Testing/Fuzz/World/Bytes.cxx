// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "World/Bytes.h"

#include <cfloat>
#include <climits>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <utility>

namespace Fuzz
{

Bytes::Bytes(std::vector<std::uint8_t> bytes)
  : All(std::move(bytes))
{
}

std::vector<std::uint8_t> Bytes::FromSeed(std::uint64_t seed, std::size_t size)
{
  std::mt19937_64 engine(seed);
  std::vector<std::uint8_t> bytes(size);
  for (std::uint8_t& byte : bytes)
  {
    byte = static_cast<std::uint8_t>(engine() >> 56);
  }
  return bytes;
}

std::uint8_t Bytes::Next()
{
  return this->IsUsedUp() ? std::uint8_t(0) : this->All[this->At++];
}

int Bytes::Pick(int n)
{
  if (n <= 1)
  {
    return 0;
  }
  std::uint32_t value = this->Next();
  for (std::uint32_t reached = 256; reached < static_cast<std::uint32_t>(n) && reached != 0;
       reached <<= 8)
  {
    value = value << 8 | this->Next();
  }
  return static_cast<int>(value % static_cast<std::uint32_t>(n));
}

double Bytes::Between(double low, double high)
{
  return low + (high - low) * this->Pick(1 << 16) / ((1 << 16) - 1.0);
}

double Bytes::Wild()
{
  using Limits = std::numeric_limits<double>;
  static const double special[] = { 0.0, -0.0, 1.0, -1.0, Limits::quiet_NaN(), Limits::infinity(),
    -Limits::infinity(), DBL_MIN, -DBL_MIN, Limits::denorm_min(), -Limits::denorm_min(), DBL_MAX,
    -DBL_MAX, 1e300, -1e300, 1e-300, 1e154, 1e155, FLT_MAX, -FLT_MAX, 2.0 * FLT_MAX, FLT_MIN,
    static_cast<double>(std::numeric_limits<float>::denorm_min()), 1e-45, 1e-46, INT_MAX, INT_MIN,
    4294967296.0, 9007199254740992.0, 9007199254740993.0, 9223372036854775808.0,
    18446744073709551616.0, 127.0, 128.0, 255.0, 256.0, 32767.0, 65535.0, 65536.0, 0.5,
    1.0 + DBL_EPSILON, 1.0 - DBL_EPSILON, 1e-12, 1e-6, 1e6, 1e12, 1e20, -1e20, 1e-20, 180.0, 90.0 };
  constexpr int Many = static_cast<int>(sizeof(special) / sizeof(special[0]));
  const int choice = this->Pick(Many + 6);
  if (choice < Many)
  {
    return special[choice];
  }
  if (choice < Many + 4)
  {
    // Of any magnitude.
    const double mantissa = this->Between(-2.0, 2.0);
    return std::ldexp(mantissa, this->Pick(2200) - 1100);
  }
  std::uint8_t bits[8];
  for (std::uint8_t& byte : bits)
  {
    byte = this->Next();
  }
  double value;
  std::memcpy(&value, bits, sizeof(value));
  return value;
}

int Bytes::WildInt()
{
  static const int special[] = { 0, -1, 1, INT_MAX, INT_MIN, INT_MAX - 1, 2, 3, 4, 64, 65, 255, 256,
    32767, 65536, 1 << 20, 1 << 30, 0x7ffffff, 0x8000000 };
  constexpr int Many = static_cast<int>(sizeof(special) / sizeof(special[0]));
  const int choice = this->Pick(Many + 4);
  return choice < Many ? special[choice] : static_cast<int>(this->Pick(INT_MAX)) - (1 << 30);
}

double Bytes::Number(double low, double high)
{
  return this->IsWild() ? this->Wild() : this->Between(low, high);
}

}
