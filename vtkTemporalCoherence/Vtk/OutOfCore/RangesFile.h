// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RangesFile_h
#define TemporalCoherence_RangesFile_h

#include "OutOfCore/FileRoom.h"
#include "Scene/KnownRanges.h"
#include "Scene/ScalarType.h"
#include "VolumeFiles/MappedFile.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace TemporalCoherence
{

/// A file with the value ranges of a volume. It is mapped, so that ranges take no memory of the
/// program's own, and the next opening of the volume need not read the volume.
///
/// The file begins with a page of text: a hash of the volume, its type and size, and the range of
/// all values. Then follow the ranges (KnownRanges::Bytes), and the words of leaves with NaN if
/// there are any. A file of another state of the volume, of another machine's byte order, or with a
/// wrong length or hash is made anew. (The hash covers the text and the ranges of nodes: to check
/// those of all leaves would read the whole file at each opening.)
class RangesFile
{
public:
  /// \param paths where the file may be, the best place first; none: ranges are kept in memory
  /// \param hash of the volume (HashOf)
  RangesFile(std::vector<std::string> paths, std::uint64_t hash, ScalarType type,
    const glm::ivec3& dimensions);

  /// The ranges in the file; null: the file holds no ranges of this volume.
  /// \param mapped receives the mapped file
  /// \throws std::bad_alloc
  std::shared_ptr<const KnownRanges> Load(std::shared_ptr<const MappedFile>& mapped) const;

  /// Room for new ranges: in a file, or in memory if no folder allows a file.
  /// \throws std::bad_alloc
  std::shared_ptr<std::byte> MakeRoom();

  /// Write what is known besides the ranges, and give the file its name.
  /// \return false if there is no file: ranges stay in the room that they have
  bool Finish(const KnownRanges& ranges);

private:
  std::size_t Bytes() const;
  std::uint64_t HashOfRest(
    const std::byte* ranges, const std::vector<std::uint64_t>& withNaN) const;

  std::shared_ptr<const KnownRanges> LoadFrom(
    const std::string& path, std::shared_ptr<const MappedFile>& mapped) const;

  std::vector<std::string> Paths;
  std::uint64_t Hash;
  ScalarType Type;
  glm::ivec3 Dimensions;
  std::shared_ptr<FileRoom> Made; ///< the file that is being written; null if there is none
};

}

#endif
