// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewFile/ZlibBytes.h"

#include <new>

#include <zlib.h>

namespace TemporalCoherence
{

std::vector<std::uint8_t> Deflate(const std::vector<std::uint8_t>& bytes)
{
  constexpr int level = 6;
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  std::vector<std::uint8_t> packed(size);
  if (compress2(packed.data(), &size, bytes.data(), static_cast<uLong>(bytes.size()), level) !=
    Z_OK)
  {
    throw std::bad_alloc();
  }
  packed.resize(size);
  return packed;
}

bool Inflate(const std::uint8_t* packed, std::size_t size, std::size_t unpacked,
  std::vector<std::uint8_t>& bytes)
{
  bytes.resize(unpacked);
  uLongf length = static_cast<uLongf>(unpacked);
  uLong read = static_cast<uLong>(size);
  return uncompress2(bytes.data(), &length, packed, &read) == Z_OK && length == unpacked &&
    read == size;
}

std::uint32_t Checksum(const std::string& text)
{
  return static_cast<std::uint32_t>(
    crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size())));
}

}
