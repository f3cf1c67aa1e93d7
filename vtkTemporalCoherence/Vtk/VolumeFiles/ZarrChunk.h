// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ZarrChunk_h
#define TemporalCoherence_ZarrChunk_h

#include "VolumeFiles/ZarrLevel.h"

namespace TemporalCoherence
{

/// Read and decode a chunk of the chosen volume. Thread-safe.
/// \param root    contains the level's folder
/// \param chunk   position in the grid of chunks
/// \param samples room for all samples of the volume in a chunk
/// \param error   receives what is wrong, in one sentence
bool ReadZarrChunk(const ContainedFolder& root, const ZarrLevel& level, const glm::ivec3& chunk,
  void* samples, std::string& error);

}

#endif
