// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OutOfCore/OutOfCoreVolume.h"

#include "Acceleration/NodeRanges.h"
#include "Acceleration/ValuesInBand.h"
#include "OutOfCore/ChunkBricks.h"
#include "OutOfCore/CoarseField.h"
#include "OutOfCore/RangesFile.h"
#include "OutOfCore/SampleHash.h"
#include "OutOfCore/StreamedRanges.h"

#include <algorithm>
#include <utility>

namespace TemporalCoherence
{
namespace
{

/// Share of the memory limit that decoded chunks take, beside the bricks that are made of them.
constexpr std::size_t OneOfChunks = 4;

/// Bricks to read ahead after a frame.
constexpr std::size_t MostAhead = 1024;

/// A reader of bricks, with its chunks.
struct ReaderOfChunks
{
  std::shared_ptr<ChunkCache> Chunks;
  ChunkBricks Bricks;
};

}

std::shared_ptr<OutOfCoreVolume> OutOfCoreVolume::Open(std::shared_ptr<const VolumeFile> file,
  const OutOfCoreOptions& options, const ReportProgress& report, std::string& error)
{
  std::shared_ptr<OutOfCoreVolume> volume(new OutOfCoreVolume);
  volume->Source = std::move(file);
  volume->LevelNumber = options.Level;
  const glm::ivec3& size = volume->Level().Dimensions;
  if (glm::any(glm::lessThan(size, glm::ivec3(2))))
  {
    error = "The volume has " + std::to_string(size.x) + " x " + std::to_string(size.y) + " x " +
      std::to_string(size.z) + " samples; it needs two or more along each axis.";
    return nullptr;
  }
  const std::size_t bytes = SizeOf(volume->Source->Type());
  if (!volume->Mapped())
  {
    volume->Chunks = std::make_shared<ChunkCache>(
      volume->Source, options.Level, options.MemoryLimit / OneOfChunks);
  }
  if (!volume->FindRanges(options, report))
  {
    return nullptr;
  }
  volume->Stand = MakeStandIn(volume->Source, options.Level, *volume->Known);
  if (volume->Chunks)
  {
    const auto reader = std::make_shared<ReaderOfChunks>(
      ReaderOfChunks{ volume->Chunks, ChunkBricks(*volume->Chunks, bytes) });
    volume->Cache = std::make_shared<const BrickCache>(volume->Level().Dimensions, bytes,
      std::shared_ptr<const BrickReader>(reader, &reader->Bricks));
    volume->Ahead = std::make_unique<ReadAhead>(volume->Cache);
    volume->SetMemoryLimit(options.MemoryLimit);
  }
  return volume;
}

OutOfCoreVolume::~OutOfCoreVolume()
{
  this->Ahead.reset();
  this->SetMemoryLimit(0);
}

bool OutOfCoreVolume::FindRanges(const OutOfCoreOptions& options, const ReportProgress& report)
{
  const std::uint64_t hash = HashOf(*this->Source, this->LevelNumber);
  const ScalarType type = this->Source->Type();
  const glm::ivec3& dimensions = this->Level().Dimensions;
  // Two readers without files may have equal hashes: no file keeps their ranges.
  RangesFile file(this->Source->HasIdentity() ? options.RangesPaths : std::vector<std::string>(),
    hash, type, dimensions);
  this->Known = file.Load(this->RangesInFile);
  this->WereKnown = this->Known != nullptr;
  if (this->Known)
  {
    return true;
  }
  const auto room = file.MakeRoom();
  const auto found = this->Mapped() ? FindRangesOf(this->Mapped(), type, dimensions, room, report)
                                    : FindRangesOf(*this->Chunks, type, room, report);
  if (!found)
  {
    return false;
  }
  this->Known = std::make_shared<const KnownRanges>(*found);
  // After a mistake the ranges may be wrong: no file keeps them. Frames tell the mistake.
  if (this->Mistake().empty() && file.Finish(*this->Known))
  {
    // Guarded against a file that becomes shorter.
    const auto kept = file.Load(this->RangesInFile);
    this->Known = kept ? kept : this->Known;
  }
  return true;
}

void OutOfCoreVolume::SetMemoryLimit(std::size_t bytes) const
{
  if (this->Cache)
  {
    this->Chunks->SetLimit(bytes / OneOfChunks);
    this->Cache->SetLimit(bytes - bytes / OneOfChunks);
  }
}

/// True if a surface may pass through a brick.
bool OutOfCoreVolume::MayHold(std::int64_t brick, const std::vector<double>& isovalues) const
{
  static_assert(BrickCache::Cells == 2 * CellBlocks::NodeSize, "a brick has eight nodes");
  const glm::ivec3 nodes = CellBlocks::NodesFor(this->Level().Dimensions);
  const glm::ivec3 first = this->Cache->FirstCellOf(brick) / CellBlocks::NodeSize;
  const glm::ivec3 end = glm::min(first + 2, nodes);
  return DispatchScalarType(this->Source->Type(),
    [&](auto type)
    {
      using T = decltype(type);
      const auto* const ranges = reinterpret_cast<const Range<T>*>(this->Known->Bytes.get()) +
        CountOf(nodes) * CellBlocks::LeavesPerNode;
      Range<T> all = ValueRangePyramid::Empty<T>();
      for (int z = first.z; z < end.z; ++z)
      {
        for (int y = first.y; y < end.y; ++y)
        {
          for (int x = first.x; x < end.x; ++x)
          {
            all = Union(all, ranges[x + nodes.x * (y + static_cast<std::int64_t>(nodes.y) * z)]);
          }
        }
      }
      return std::any_of(isovalues.begin(), isovalues.end(),
        [&](double isovalue)
        {
          return ReachInto(
            { isovalue, isovalue }, static_cast<double>(all.Min), static_cast<double>(all.Max));
        });
    });
}

void OutOfCoreVolume::BeginFrame() const
{
  if (this->Cache)
  {
    this->Cache->BeginFrame();
  }
}

void OutOfCoreVolume::EndFrame(const std::vector<double>& isovalues) const
{
  if (!this->Cache)
  {
    return;
  }
  std::vector<std::int64_t> ahead;
  for (const std::int64_t brick : this->Cache->TakeAwaited())
  {
    for (const std::int64_t beside : this->Cache->Around(brick))
    {
      ahead.push_back(beside);
    }
  }
  std::sort(ahead.begin(), ahead.end());
  ahead.erase(std::unique(ahead.begin(), ahead.end()), ahead.end());
  ahead.erase(std::remove_if(ahead.begin(), ahead.end(),
                [&](std::int64_t brick)
                { return this->Cache->Has(brick) || !this->MayHold(brick, isovalues); }),
    ahead.end());
  ahead.resize(std::min(ahead.size(), MostAhead));
  this->Ahead->Want(std::move(ahead));
}

void OutOfCoreVolume::ReadAll(void* samples) const
{
  ChunkBricks(*this->Chunks, SizeOf(this->Source->Type())).ReadAll(samples);
}

std::string OutOfCoreVolume::Mistake() const
{
  std::string mistake;
  if (this->Source->HasFailed(mistake))
  {
    return mistake;
  }
  if (this->RangesInFile && this->RangesInFile->IsBroken())
  {
    return "The file with value ranges of the volume cannot be read to its end; open the volume "
           "again.";
  }
  const std::size_t count = this->Chunks ? this->Chunks->NumberOfMistakes() : 0;
  return count == 0
    ? mistake
    : this->Chunks->Mistake() + (count > 1 ? " Other chunks cannot be read, either." : "");
}

std::size_t OutOfCoreVolume::MemoryInBytes() const
{
  return this->Cache ? this->Cache->MemoryInBytes() + this->Chunks->MemoryInBytes() : 0;
}

}
