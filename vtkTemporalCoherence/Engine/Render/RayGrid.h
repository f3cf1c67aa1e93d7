// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RayGrid_h
#define TemporalCoherence_RayGrid_h

#include "Acceleration/TileBounds.h"
#include "Scene/FrameKey.h"
#include "Scene/FramePlanes.h"

#include <array>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// A picture with fewer rays than pixels, and what it tells about the pixels between the rays.
///
/// Colours are interpolated bilinearly between four rays. Depths are interpolated, too, if all four
/// rays hit one surface. Other depths, and all normals, are copied from the nearest ray with a hit.
/// All weights are whole numbers of 256ths.
class RayGrid
{
public:
  /// \param picture with fewer rays; must outlive this, as the key of the whole picture
  RayGrid(const Frame& picture, const FrameKey& key);

  /// How far the pixels of each tile may be off: the mean difference between a ray's colour and the
  /// mean of its four neighbours. More than 0.
  /// \throws std::bad_alloc
  std::vector<float> FindDoubts() const;

  /// Write a tile between rays into the planes of a frame. Thread-safe.
  /// \throws std::bad_alloc
  TraceCounts Fill(std::int64_t tile, const PixelRect& part, Frame& frame) const;

private:
  /// The two rays around a pixel along an axis, and the weight of the second one in 256ths.
  struct Place
  {
    int First, Second, Weight;
  };
  struct Cell;

  static std::vector<Place> PlacesOf(int pixels, int rays);
  static int EndOf(const std::vector<Place>& places, int first, int end);
  PixelRect RaysAround(const PixelRect& part) const;
  bool ShowsAnything(const PixelRect& part) const;
  std::vector<float> FindBends() const;
  Cell CellBetween(const Place& column, const Place& row) const;
  std::uint64_t FillCell(const PixelRect& between, const PixelRect& part, Frame& frame) const;

  const Frame& Picture;
  const FrameKey& Key;
  std::vector<Place> Columns, Rows;
  double Spacing;     ///< of rays in the world, where they begin
  double PerDistance; ///< and what each unit of distance adds
};

}

#endif
