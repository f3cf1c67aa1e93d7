// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_StreamedRanges_h
#define TemporalCoherence_StreamedRanges_h

#include "OutOfCore/ChunkCache.h"
#include "Scene/KnownRanges.h"
#include "Scene/Progress.h"

#include <cstddef>
#include <memory>
#include <optional>

namespace TemporalCoherence
{

/// Find the value ranges of a level of a volume by reading each chunk once. Little of the volume is
/// in memory at a time: rows of chunks along x, and one slice.
/// \param room for the ranges (RangeScan)
/// \return none if the report stopped it
/// \throws std::bad_alloc
std::optional<KnownRanges> FindRangesOf(ChunkCache& chunks, ScalarType type,
  const std::shared_ptr<std::byte>& room, const ReportProgress& report);

/// Find the value ranges of a volume whose samples lie in a mapped file.
std::optional<KnownRanges> FindRangesOf(const void* samples, ScalarType type,
  const glm::ivec3& dimensions, const std::shared_ptr<std::byte>& room,
  const ReportProgress& report);

}

#endif
