// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KnotChunk_h
#define TemporalCoherence_KnotChunk_h

#include "Isomap/KnotImage.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace TemporalCoherence
{

/// Rows of an image, from the bottom.
struct RowRange
{
  int First, Count;
};

/// The unpacked bytes of a chunk (Documentation/ViewFile.md): knots of some rows, as differences
/// from what the pixels to the left and below let expect.
/// \param width in pixels
std::vector<std::uint8_t> EncodeKnots(const PixelKnots& knots, int width, const RowRange& rows);

/// Read the knots of some rows. Begin of `knots` counts from the first row.
/// \param bytes   as EncodeKnots makes them, or anything else
/// \param count   of knots that there have to be
/// \param largest progress
/// \return what is wrong; empty if nothing is
std::string DecodeKnots(const std::vector<std::uint8_t>& bytes, int width, int rows,
  std::size_t count, std::uint16_t largest, PixelKnots& knots);

}

#endif
