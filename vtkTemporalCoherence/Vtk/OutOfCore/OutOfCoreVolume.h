// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_OutOfCoreVolume_h
#define TemporalCoherence_OutOfCoreVolume_h

#include "Bricks/BrickCache.h"
#include "OutOfCore/ChunkCache.h"
#include "OutOfCore/ReadAhead.h"
#include "Scene/KnownRanges.h"
#include "Scene/Progress.h"
#include "Scene/StandIn.h"
#include "VolumeFiles/MappedFile.h"
#include "VolumeFiles/VolumeFile.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace TemporalCoherence
{

/// How a volume is read.
struct OutOfCoreOptions
{
  std::size_t Level = 0;       ///< of resolution, 0: the finest
  std::size_t MemoryLimit = 0; ///< bytes for samples
  /// Where the file with value ranges may be, the best place first; none: they stay in memory.
  std::vector<std::string> RangesPaths;
};

/// A level of a volume whose samples are read when they are needed: mapped, or in bricks.
class OutOfCoreVolume
{
public:
  /// Open a volume. Its value ranges are read from their file, or else found by reading the volume
  /// once.
  /// \param error receives what is wrong; empty if the report stopped it
  /// \return null on error
  /// \throws std::bad_alloc
  static std::shared_ptr<OutOfCoreVolume> Open(std::shared_ptr<const VolumeFile> file,
    const OutOfCoreOptions& options, const ReportProgress& report, std::string& error);

  /// Frees the memory of bricks, even if pictures made from them are kept.
  ~OutOfCoreVolume();
  OutOfCoreVolume(const OutOfCoreVolume&) = delete;
  OutOfCoreVolume& operator=(const OutOfCoreVolume&) = delete;

  const VolumeFile& File() const { return *this->Source; }
  const VolumeLevel& Level() const { return this->Source->Levels()[this->LevelNumber]; }

  /// The address of the first sample if all samples are mapped; else null.
  const void* Mapped() const { return this->Source->MappedSamples(this->LevelNumber); }

  /// The samples in bricks; null if they are mapped.
  const std::shared_ptr<const BrickCache>& Bricks() const { return this->Cache; }

  const std::shared_ptr<const KnownRanges>& Ranges() const { return this->Known; }

  /// What is shown until samples in bricks are read; null if there is nothing.
  const std::shared_ptr<const StandIn>& Coarse() const { return this->Stand; }

  /// True if the value ranges came from their file.
  bool HadRanges() const { return this->WereKnown; }

  void SetMemoryLimit(std::size_t bytes) const;

  /// A frame begins that uses the samples.
  void BeginFrame() const;

  /// The frame is over. Read ahead what the next one may need: bricks beside those that this one
  /// waited for.
  /// \param isovalues only bricks that these pass through
  void EndFrame(const std::vector<double>& isovalues) const;

  /// Read all samples of a volume in bricks.
  /// \param samples room for them, x fastest
  /// \throws std::bad_alloc
  void ReadAll(void* samples) const;

  /// The mistakes in reading until now; empty: no mistakes.
  std::string Mistake() const;

  /// Bytes of samples in memory that this volume holds. Mapped ones do not count.
  std::size_t MemoryInBytes() const;

private:
  OutOfCoreVolume() = default;
  bool FindRanges(const OutOfCoreOptions& options, const ReportProgress& report);
  bool MayHold(std::int64_t brick, const std::vector<double>& isovalues) const;

  std::shared_ptr<const VolumeFile> Source;
  std::size_t LevelNumber = 0;
  std::shared_ptr<ChunkCache> Chunks;
  std::shared_ptr<const BrickCache> Cache;
  std::shared_ptr<const KnownRanges> Known;
  std::shared_ptr<const StandIn> Stand;
  bool WereKnown = false;
  std::shared_ptr<const MappedFile> RangesInFile; ///< null: the ranges are in memory
  std::unique_ptr<ReadAhead> Ahead;
};

}

#endif
