// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ViewFile/ZlibBytes.h"

#include <new>

#include <zlib.h>

namespace TemporalCoherence
{

std::vector<std::uint8_t> Deflate(const std::vector<std::uint8_t>& bytes)
{
  // Run lengths and Huffman codes alone: a search for repetitions takes five times as long, and
  // makes files of knots 5 % larger.
  constexpr int level = 6, windowBits = 15, memory = 9, strategy = Z_RLE;
  z_stream stream{};
  if (deflateInit2(&stream, level, Z_DEFLATED, windowBits, memory, strategy) != Z_OK)
  {
    throw std::bad_alloc();
  }
  std::vector<std::uint8_t> packed(deflateBound(&stream, static_cast<uLong>(bytes.size())));
  stream.next_in = const_cast<Bytef*>(bytes.data());
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = packed.data();
  stream.avail_out = static_cast<uInt>(packed.size());
  const bool isWhole = deflate(&stream, Z_FINISH) == Z_STREAM_END;
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  if (!isWhole)
  {
    throw std::bad_alloc();
  }
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
