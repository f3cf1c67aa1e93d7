// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ViewHeader_h
#define TemporalCoherence_ViewHeader_h

#include "ViewFile/KnotChunk.h"
#include "ViewFile/ViewDescription.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace TemporalCoherence
{

/// The version of files that are written. Others are not read.
constexpr std::uint32_t ViewFileVersion = 1;

/// A compressed part of a file.
struct FileSection
{
  std::uint64_t Offset = 0; ///< from the end of the header
  std::uint64_t Bytes = 0, Unpacked = 0;
};

/// A section with the knots of some rows.
struct ChunkSection : FileSection
{
  ValueDirection Direction = ValueDirection::Rising;
  RowRange Rows{ 0, 0 };
  std::uint64_t Knots = 0;
};

/// One view of a file: its geometry, and where its knots are.
struct ViewEntry
{
  ViewGeometry Geometry;
  ValueBand Range{ 1.0, 0.0 };
  KnotGrid Grid;
  int NormalSteps = 1;
  std::array<std::uint64_t, NumberOfDirections> Knots{};
  std::vector<ChunkSection> Chunks;
  std::optional<FileSection> Entries, Unknown;
};

/// The header of a file.
struct ViewHeader
{
  ViewDescription Description;
  std::vector<ViewEntry> Views;
};

/// The header as JSON.
std::string TextOf(const ViewHeader& header);

/// Read a header.
/// \param bytes of all sections
/// \return what is wrong, as a sentence without its end; empty if all numbers are possible
std::string ReadHeader(const std::string& text, std::uint64_t bytes, ViewHeader& header);

}

#endif
