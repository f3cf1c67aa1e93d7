// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ChunkCodec_h
#define TemporalCoherence_ChunkCodec_h

#include <cstddef>
#include <cstdint>
#include <string>

namespace TemporalCoherence
{

/// How the bytes of a chunk are compressed.
enum class ChunkCompression : std::uint8_t
{
  None,
  Blosc, ///< its header says which inner compressor, and how bytes are shuffled
  Zstd,
  Zlib ///< with the header of zlib or of gzip
};

/// How a chunk's samples become bytes of a file.
struct ChunkCodec
{
  ChunkCompression Compression = ChunkCompression::None;
  bool SwapBytes = false;   ///< the file has the other byte order than this machine
  bool HasChecksum = false; ///< the last four bytes are the CRC-32C of the others
};

/// The most bytes that a sensible compressed chunk may have. Some compressors make incompressible
/// samples slightly longer.
std::uint64_t LargestCompressedSize(std::uint64_t decodedBytes);

/// Decompress a chunk. The byte order stays that of the file.
/// \param from   the compressed bytes
/// \param size   their number
/// \param to     room for `bytes` bytes
/// \param bytes  what the chunk must have after decompression
/// \param defect receives what is wrong with the chunk; "The chunk" is the sentence's subject
/// \return false if the bytes are damaged, or are of another size
bool Decompress(const ChunkCodec& codec, const unsigned char* from, std::size_t size, void* to,
  std::size_t bytes, std::string& defect);

/// The CRC-32C (Castagnoli) of bytes.
std::uint32_t Crc32c(const unsigned char* bytes, std::size_t size);

}

#endif
