// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OutOfCore/StreamedRanges.h"

#include "Acceleration/RangeScan.h"
#include "OutOfCore/ChunkBricks.h"
#include "Scene/CellBlocks.h"
#include "Scene/Field.h"
#include "Scene/Parallel.h"

#include <algorithm>
#include <atomic>
#include <new>
#include <vector>

namespace TemporalCoherence
{
namespace
{

constexpr int NodeSize = CellBlocks::NodeSize;

/// The bytes of a slab of samples; one row of nodes may need more.
constexpr std::int64_t MostBytes = std::int64_t(1) << 26;

/// A field of the whole volume, some of whose samples lie in a box in memory. No other sample may
/// be read.
Field FieldOfBox(ScalarType type, const glm::ivec3& dimensions, const std::byte* samples,
  const glm::ivec3& first, const glm::i64vec3& strides)
{
  Field field;
  field.Type = type;
  field.Dimensions = dimensions;
  field.Strides = strides;
  const std::int64_t before = first.x * strides.x + first.y * strides.y + first.z * strides.z;
  // As a number: the first sample of the field lies before the box.
  field.Samples = reinterpret_cast<const void*>(
    reinterpret_cast<std::uintptr_t>(samples) - static_cast<std::uintptr_t>(before) * SizeOf(type));
  return field;
}

/// Reads slabs of whole rows of nodes along x. Each ends with the samples at the beginning of the
/// next nodes. Slabs follow each other along z, and then backwards along y, so that those samples
/// are known along y from before, and are in the cache along z.
class SlabReader
{
public:
  SlabReader(ChunkCache& chunks, ScalarType type)
    : Chunks(chunks)
    , Type(type)
    , Size(chunks.Level().Dimensions)
    , Nodes(CellBlocks::NodesFor(this->Size))
    , Bytes(SizeOf(type))
  {
    // As many nodes as a chunk has; fewer of large chunks.
    const glm::ivec3& chunk = chunks.Level().Chunk;
    const std::int64_t ofRow =
      static_cast<std::int64_t>(this->Size.x) * NodeSize * NodeSize * std::int64_t(this->Bytes);
    const auto most = static_cast<int>(std::clamp<std::int64_t>(MostBytes / ofRow, 1, 1 << 20));
    this->Rows.y = std::clamp(chunk.z / NodeSize, 1, std::min(most, this->Nodes.z));
    this->Rows.x = std::clamp(
      std::max(chunk.y / NodeSize, 1), 1, std::clamp(most / this->Rows.y, 1, this->Nodes.y));
    const auto room = [&](std::int64_t y, std::int64_t z)
    { return static_cast<std::size_t>(this->Size.x * y * z) * this->Bytes; };
    this->Slab.resize(room(NodeSize * this->Rows.x + 1, NodeSize * this->Rows.y + 1));
    this->Beyond.resize(room(1, this->Size.z));
  }

  /// Rows of nodes along y and z in a slab; fewer at the ends.
  const glm::ivec2& RowsOfSlab() const { return this->Rows; }
  const glm::ivec3& NumberOfNodes() const { return this->Nodes; }

  /// Read a slab.
  /// \param first y and z of its first row of nodes
  /// \return the field, of which the slab may be read
  Field Read(const glm::ivec2& first, const glm::ivec2& count)
  {
    const glm::ivec3 begin(0, NodeSize * first.x, NodeSize * first.y);
    // The last nodes also have the last samples.
    const bool isLast = first.x + count.x == this->Nodes.y;
    const bool isLastSlice = first.y + count.y == this->Nodes.z;
    const int endOfRows = isLast ? this->Size.y : begin.y + NodeSize * count.x;
    const int end = isLastSlice ? this->Size.z : begin.z + NodeSize * count.y + 1;
    const glm::ivec3 read(this->Size.x, endOfRows - begin.y, end - begin.z);
    const int rows = read.y + (isLast ? 0 : 1);
    const glm::i64vec3 strides(1, this->Size.x, static_cast<std::int64_t>(this->Size.x) * rows);
    this->ReadChunks(begin, read, { strides.y, strides.z });
    const std::size_t row = static_cast<std::size_t>(this->Size.x) * this->Bytes;
    for (int z = 0; z < read.z; ++z)
    {
      std::byte* const slice = this->Slab.data() + static_cast<std::size_t>(z * rows) * row;
      std::byte* const beyond = this->Beyond.data() + static_cast<std::size_t>(begin.z + z) * row;
      if (!isLast)
      {
        std::copy_n(beyond, row, slice + static_cast<std::size_t>(read.y) * row);
      }
      // The last slice also belongs to the next slab, which needs the old row.
      if (z < NodeSize * count.y || isLastSlice)
      {
        std::copy_n(slice, row, beyond);
      }
    }
    return FieldOfBox(this->Type, this->Size, this->Slab.data(), begin, strides);
  }

private:
  /// Read a box in parallel, one chunk after the other along x.
  void ReadChunks(const glm::ivec3& first, const glm::ivec3& size, const glm::i64vec2& strides)
  {
    const ChunkBricks bricks(this->Chunks, this->Bytes);
    const glm::ivec3& chunk = this->Chunks.Level().Chunk;
    const glm::ivec3 begin = first / chunk;
    const glm::ivec3 count = (first + size - 1) / chunk - begin + 1;
    std::atomic<bool> isOutOfMemory{ false };
    const auto readOne = [&](std::int64_t i)
    {
      const glm::ivec3 place =
        begin + glm::ivec3(i % count.x, i / count.x % count.y, i / count.x / count.y);
      const glm::ivec3 low = glm::max(first, chunk * place);
      const glm::ivec3 part = glm::min(first + size, chunk * (place + 1)) - low;
      const glm::i64vec3 at(low - first);
      bricks.Read(low, part,
        this->Slab.data() +
          (at.x + strides.x * at.y + strides.y * at.z) * static_cast<std::int64_t>(this->Bytes),
        strides);
    };
    ParallelFor(static_cast<std::int64_t>(count.x) * count.y * count.z, 1,
      [&](std::int64_t i)
      {
        try
        {
          readOne(i);
        }
        catch (const std::bad_alloc&)
        {
          isOutOfMemory = true; // not every kind of threads passes exceptions on
        }
      });
    if (isOutOfMemory)
    {
      throw std::bad_alloc();
    }
  }

  ChunkCache& Chunks;
  ScalarType Type;
  glm::ivec3 Size, Nodes;
  std::size_t Bytes;
  glm::ivec2 Rows;
  std::vector<std::byte> Slab;
  std::vector<std::byte> Beyond; ///< of each slice: the row behind the slabs that are to be read
};

}

std::optional<KnownRanges> FindRangesOf(ChunkCache& chunks, ScalarType type,
  const std::shared_ptr<std::byte>& room, const ReportProgress& report)
{
  RangeScan scan(type, chunks.Level().Dimensions, room);
  SlabReader slabs(chunks, type);
  const glm::ivec2 nodes(slabs.NumberOfNodes().y, slabs.NumberOfNodes().z);
  const glm::ivec2 rows = slabs.RowsOfSlab(), count = (nodes - 1) / rows + 1;
  for (int i = 0; i < count.x * count.y; ++i)
  {
    if (report && !report(static_cast<double>(i) / (static_cast<double>(count.x) * count.y)))
    {
      return std::nullopt;
    }
    const glm::ivec2 first = rows * glm::ivec2(count.x - 1 - i / count.y, i % count.y);
    const glm::ivec2 here = glm::min(rows, nodes - first);
    scan.Scan(slabs.Read(first, here), first, here);
  }
  return scan.Finish();
}

std::optional<KnownRanges> FindRangesOf(const void* samples, ScalarType type,
  const glm::ivec3& dimensions, const std::shared_ptr<std::byte>& room,
  const ReportProgress& report)
{
  RangeScan scan(type, dimensions, room);
  const glm::i64vec3 strides(
    1, dimensions.x, static_cast<std::int64_t>(dimensions.x) * dimensions.y);
  const Field field =
    FieldOfBox(type, dimensions, static_cast<const std::byte*>(samples), glm::ivec3(0), strides);
  const glm::ivec3 nodes = CellBlocks::NodesFor(dimensions);
  for (int z = 0; z < nodes.z; ++z)
  {
    if (report && !report(static_cast<double>(z) / nodes.z))
    {
      return std::nullopt;
    }
    scan.Scan(field, { 0, z }, { nodes.y, 1 });
  }
  return scan.Finish();
}

}
