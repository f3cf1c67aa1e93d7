// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ZlibBytes_h
#define TemporalCoherence_ZlibBytes_h

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace TemporalCoherence
{

/// A zlib stream of bytes.
/// \throws std::bad_alloc
std::vector<std::uint8_t> Deflate(const std::vector<std::uint8_t>& bytes);

/// Unpack a zlib stream.
/// \param unpacked size that it must have
/// \return false if it has another size, or is damaged
bool Inflate(const std::uint8_t* packed, std::size_t size, std::size_t unpacked,
  std::vector<std::uint8_t>& bytes);

/// The CRC-32 of a text.
std::uint32_t Checksum(const std::string& text);

}

#endif
