// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Kernels that find crossings and value ranges give the bits of the one-by-one reference on every
// kind of vectors, and so do whole frames.

#include "EachTarget.h"
#include "Grid.h"
#include "Lattice/CellRoot.h"
#include "Lattice/CellSegment.h"
#include "Lattice/KernelsCrossing.h"
#include "Lattice/KernelsRange.h"
#include "Render/FrameRenderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace
{

using namespace TemporalCoherence;

/// Segments of random rays through random cells, many of them with samples equal to the isovalue or
/// with paths along faces.
template <typename Real>
SegmentBatch<Real> RandomSegments(int count, std::mt19937& engine)
{
  std::uniform_real_distribution<double> inCell(0.0, 1.0), around(-1.0, 1.0);
  std::uniform_int_distribution<int> small(-3, 3), place(0, 50);
  SegmentBatch<Real> segments;
  segments.Count = count;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      const bool isAlongFace = small(engine) == 0;
      const double cell = place(engine);
      const double direction = isAlongFace ? 1e-15 : around(engine);
      segments.Cell[a][i] = cell;
      segments.Direction[a][i] = direction;
      segments.Inverse[a][i] = 1.0 / direction;
      segments.Origin[a][i] = cell + (isAlongFace ? 0.0 : inCell(engine) - 10.0 * direction);
    }
    segments.Begin[i] = small(engine) == 0 ? 10.1 : 0.0;
    segments.End[i] = small(engine) == 0 ? 10.2 : 100.0;
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      segments.Corners[corner][i] =
        small(engine) == 0 ? Real(small(engine)) : static_cast<Real>(around(engine));
    }
  }
  return segments;
}

/// What FindRanges finds, segment by segment.
template <typename Real>
void FindRangesOneByOne(SegmentBatch<Real>& in, RangeBatch<Real>& out)
{
  for (std::size_t i = 0; i < static_cast<std::size_t>(in.Count); ++i)
  {
    const CellSegment<Real> segment(in, i);
    const Cubic<Real> cubic = CubicAlong(segment.Values, segment.Path);
    in.Enter[i] = segment.Enter;
    out.Leave[i] = segment.Leave;
    const std::array<Real, 2> range = RangeOf(cubic);
    out.Lowest[i] = range[0];
    out.Highest[i] = range[1];
    for (std::size_t c = 0; c < 4; ++c)
    {
      out.Cubic[c][i] = cubic[c];
    }
  }
}

class KernelsCrossing : public EachTarget
{
protected:
  template <typename Real>
  void Compare()
  {
    std::mt19937 engine(11);
    int found = 0;
    for (int batch = 0; batch < 300; ++batch)
    {
      const int count = 1 + batch % RayBatch::Capacity;
      const bool isSolid = batch % 3 == 0;
      const SegmentBatch<Real> segments = RandomSegments<Real>(count, engine);
      SegmentBatch<Real> reference = segments;
      FindCrossingsOneByOne(reference, isSolid);
      this->ForEachTarget(
        [&](const char* target)
        {
          SegmentBatch<Real> vectors = segments;
          FindCrossings(vectors, isSolid);
          EXPECT_TRUE(AreIdentical(vectors.Distance, reference.Distance, count)) << target;
          EXPECT_TRUE(AreIdentical(vectors.Enter, reference.Enter, count)) << target;
          EXPECT_TRUE(AreIdentical(vectors.AtEntry, reference.AtEntry, count)) << target;
        });
      for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
      {
        found += std::isfinite(reference.Distance[i]);
      }
    }
    EXPECT_GT(found, 1000);
  }
};

class KernelsRange : public EachTarget
{
protected:
  template <typename Real>
  void Compare()
  {
    std::mt19937 engine(12);
    for (int batch = 0; batch < 200; ++batch)
    {
      const int count = 1 + batch % RayBatch::Capacity;
      const SegmentBatch<Real> segments = RandomSegments<Real>(count, engine);
      SegmentBatch<Real> expected = segments;
      RangeBatch<Real> reference;
      FindRangesOneByOne(expected, reference);
      this->ForEachTarget(
        [&](const char* target)
        {
          SegmentBatch<Real> vectors = segments;
          RangeBatch<Real> ranges;
          FindRanges(vectors, ranges);
          EXPECT_TRUE(AreIdentical(vectors.Enter, expected.Enter, count)) << target;
          EXPECT_TRUE(AreIdentical(ranges.Leave, reference.Leave, count)) << target;
          EXPECT_TRUE(AreIdentical(ranges.Lowest, reference.Lowest, count)) << target;
          EXPECT_TRUE(AreIdentical(ranges.Highest, reference.Highest, count)) << target;
          for (std::size_t c = 0; c < 4; ++c)
          {
            EXPECT_TRUE(AreIdentical(ranges.Cubic[c], reference.Cubic[c], count)) << target;
          }
        });
      for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
      {
        ExpectRange(reference, i);
      }
    }
  }

private:
  /// The range is that of many points on the cubic.
  template <typename Real>
  static void ExpectRange(const RangeBatch<Real>& ranges, std::size_t i)
  {
    const Cubic<Real> cubic = { ranges.Cubic[0][i], ranges.Cubic[1][i], ranges.Cubic[2][i],
      ranges.Cubic[3][i] };
    Real lowest = cubic[0], highest = cubic[0];
    for (int step = 0; step <= 1000; ++step)
    {
      const Real value = Evaluate(cubic, static_cast<Real>(step) / Real(1000));
      lowest = std::min(lowest, value);
      highest = std::max(highest, value);
    }
    EXPECT_GE(lowest, ranges.Lowest[i] - Real(1e-5));
    EXPECT_LE(highest, ranges.Highest[i] + Real(1e-5));
    EXPECT_NEAR(lowest, ranges.Lowest[i], 1e-4);
    EXPECT_NEAR(highest, ranges.Highest[i], 1e-4);
  }
};

TEST_F(KernelsRange, VectorsGiveTheBitsOfTheReference)
{
  this->Compare<float>();
  this->Compare<double>();
}

TEST_F(KernelsCrossing, VectorsFindTheSameBitsAsOneByOneFloat)
{
  this->Compare<float>();
}

TEST_F(KernelsCrossing, VectorsFindTheSameBitsAsOneByOneDouble)
{
  this->Compare<double>();
}

TEST_F(KernelsCrossing, CrossingsAreZeros)
{
  std::mt19937 engine(12);
  SegmentBatch<double> segments = RandomSegments<double>(RayBatch::Capacity, engine);
  FindCrossings(segments, false);
  for (std::size_t i = 0; i < RayBatch::Capacity; ++i)
  {
    if (!std::isfinite(segments.Distance[i]))
    {
      continue;
    }
    Corners<double> corners;
    CellPath<double> at;
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      corners[corner] = segments.Corners[corner][i];
    }
    for (std::size_t a = 0; a < 3; ++a)
    {
      at.Begin[a] = at.End[a] = segments.Origin[a][i] +
        segments.Distance[i] * segments.Direction[a][i] - segments.Cell[a][i];
    }
    EXPECT_NEAR(CubicAlong(corners, at)[0], 0.0, 1e-9);
  }
}

/// All kernels together.
class KernelsFrame : public EachTarget
{
protected:
  /// \param asBlocks samples are interpolated by the nearest one
  void Compare(const std::vector<double>& isovalues, bool asBlocks);
};

void KernelsFrame::Compare(const std::vector<double>& isovalues, bool asBlocks)
{
  Grid<std::uint16_t> grid(glm::ivec3(40, 45, 50));
  grid.Fill([](int i, int j, int k)
    { return 1000.0 + 900.0 * std::sin(0.3 * i) * std::cos(0.2 * j) * std::sin(0.25 * k); });
  FrameKey key;
  key.Samples = grid.Field;
  FrameRenderer::Options options;
  options.Accuracy = ReuseAccuracy::Paper;
  key.Samples.Between = asBlocks ? Interpolation::Nearest : Interpolation::Linear;
  key.EditIsosurfaces().Isovalues = isovalues;
  key.Appearance.Colors = { glm::dvec3(1.0, 0.5, 0.2), glm::dvec3(0.2, 0.5, 1.0) };
  key.Appearance.Shade = true;
  key.Appearance.Lights = { Light() };
  Frame first[2];
  this->ForEachTarget(
    [&](const char* target)
    {
      FrameRenderer renderer;
      for (int frame = 0; frame < 2; ++frame)
      {
        // The second one is made from the first.
        key.View = LookAt(grid.Field.Dimensions, { 1.0, 0.7 + 0.02 * frame, 0.4 }, { 150, 130 });
        renderer.Render(key, options);
        const Frame& made = renderer.LastFrame();
        if (first[frame].IsEmpty())
        {
          first[frame] = made;
        }
        const int pixels = 150 * 130;
        EXPECT_TRUE(AreIdentical(made.Depth, first[frame].Depth, pixels)) << target;
        EXPECT_TRUE(AreIdentical(made.Normals, first[frame].Normals, pixels)) << target;
        EXPECT_TRUE(AreIdentical(made.Colors, first[frame].Colors, pixels)) << target;
        EXPECT_TRUE(AreIdentical(made.Answers, first[frame].Answers, pixels)) << target;
      }
      EXPECT_EQ(renderer.Statistics().Made, Route::ImageCache);
    });
}

TEST_F(KernelsFrame, EveryTargetMakesTheSameFrames)
{
  this->Compare({ 1300.0 }, false);
  this->Compare({ 1300.0 }, true);
}

TEST_F(KernelsFrame, EveryTargetMakesTheSameFramesOfSeveralIsovalues)
{
  this->Compare({ 1300.0, 800.0 }, false);
  this->Compare({ 1300.0, 800.0 }, true);
}

}
