// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ZarrLevel_h
#define TemporalCoherence_ZarrLevel_h

#include "VolumeFiles/VolumeFile.h"
#include "VolumeFiles/ZarrImage.h"
#include "VolumeFiles/ZarrMetadata.h"

namespace TemporalCoherence
{

/// One resolution: an array, and the part of its chunks that belongs to the chosen volume.
///
/// Axes of time and of channels are slower than those of space. So the chosen volume's samples in a
/// chunk are without gaps.
struct ZarrLevel
{
  std::filesystem::path Folder;
  ZarrArray Array;
  std::vector<int> Leading;    ///< positions along the axes before those of space
  std::size_t FirstByte = 0;   ///< of the chosen volume in a decoded chunk
  std::size_t VolumeBytes = 0; ///< of the chosen volume in a decoded chunk
};

/// Where a chunk is stored.
struct ZarrChunkPlace
{
  std::filesystem::path Path; ///< of the file
  std::size_t InFile = 0;     ///< position of the chunk in a file with several ones
};

/// Choose a volume of an array.
/// \param axes     of the array
/// \param level    has its folder and its array; receives what was chosen
/// \param geometry receives sizes of the volume and of its chunks
/// \param error    receives what is wrong, in one sentence
bool ChooseZarrVolume(const std::vector<ZarrAxis>& axes, const VolumeChoice& choice,
  ZarrLevel& level, VolumeLevel& geometry, std::string& error);

/// Find a chunk of the chosen volume.
/// \param chunk position in the grid of chunks
ZarrChunkPlace PlaceOfChunk(const ZarrLevel& level, const glm::ivec3& chunk);

/// Place a level in space, by its metadata or, without such, by its size.
/// \param axes   of the array
/// \param finest the first level
void PlaceZarrLevel(const std::vector<ZarrAxis>& axes, const ZarrImageLevel& from,
  const VolumeLevel& finest, VolumeLevel& geometry);

}

#endif
