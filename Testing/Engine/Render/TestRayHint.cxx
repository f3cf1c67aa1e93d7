// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A hint that the engine does not know saves work and changes no hit. Where it is wrong, rays are
// traced once more.

#include "Grid.h"
#include "Lattice/BallHint.h"
#include "Render/FrameStructures.h"
#include "Render/TileTracer.h"

#include <gtest/gtest.h>

#include <memory>

namespace
{

using namespace TemporalCoherence;

class HintedTiles : public ::testing::Test
{
protected:
  HintedTiles()
    : Samples(glm::ivec3(40))
  {
    // A ball, and a smaller one behind it as seen along x.
    this->Samples.Fill(
      [](int i, int j, int k)
      {
        const glm::dvec3 point(i, j, k);
        return std::max(12.0 - glm::distance(point, { 14.0, 20.0, 20.0 }),
          5.0 - glm::distance(point, { 33.0, 33.0, 20.0 }));
      });
    this->Key.Samples = this->Samples.Field;
    this->Key.View = LookAt(this->Key.Samples.Dimensions, { -1.0, 0.1, 0.2 }, { 61, 53 });
    this->Key.EditIsosurfaces().Isovalues = { 2.0 };
    this->Structures.PrepareRanges(this->Key);
    this->Structures.PrepareActiveCells(this->Key);
  }

  /// Trace all tiles of a picture.
  /// \param hint or null
  TraceCounts Trace(const RayHint* hint, bool leaps, Frame& frame) const
  {
    const LeapedSpace space = this->Structures.SpaceToLeap(leaps);
    const TileTracer tracer(
      { this->Key, space.Active, space.Bounds, this->Structures.Pyramid().FiniteRange(), hint });
    frame.Resize(this->Key.View.Size);
    TraceCounts counts;
    for (std::int64_t tile = 0; tile < NumberOfTiles(frame.Size); ++tile)
    {
      TileHits found;
      counts += tracer.Trace(tile, PixelsOfTile(frame.Size, tile), frame, found);
    }
    return counts;
  }

  Grid<float> Samples;
  FrameKey Key;
  FrameStructures Structures{ std::make_shared<FieldStructures>() };
};

TEST_F(HintedTiles, HitsAreThoseOfTheColdPicture)
{
  Frame cold, hinted;
  for (const bool leaps : { true, false })
  {
    const TraceCounts plain = this->Trace(nullptr, leaps, cold);
    // What is before the first ball holds for all; what is behind it is wrong for the second.
    const BallHint hint({ 14.0, 20.0, 20.0 }, 13.0);
    const TraceCounts counts = this->Trace(&hint, leaps, hinted);
    EXPECT_EQ(hinted.Depth, cold.Depth);
    EXPECT_EQ(hinted.Isovalues, cold.Isovalues);
    EXPECT_EQ(hinted.Kinds, cold.Kinds);
    const auto hits = cold.Depth.size() -
      static_cast<std::size_t>(
        std::count(cold.Isovalues.begin(), cold.Isovalues.end(), Frame::NoSurface));
    EXPECT_GT(hits, cold.Depth.size() / 20);
    if (!leaps)
    {
      EXPECT_LT(counts.CellsRead, plain.CellsRead) << "walks are shorter";
    }
  }
}

}
