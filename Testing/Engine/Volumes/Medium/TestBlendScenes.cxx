// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Every mode in scenes that clip, hide, move or turn a volume, with the errors that TestBlendModes
// allows.

#include "BlendCase.h"
#include "BlendFrames.h"
#include "Kinds/RectilinearKind.h"
#include "Lattice/Coordinates.h"
#include "Scene/HiddenCells.h"

#include <glm/gtc/matrix_transform.hpp>

#include <limits>
#include <memory>

namespace
{

using namespace TemporalCoherence;

/// Every mode in scenes that clip, hide, move or turn a volume.
class BlendScenes : public ::testing::TestWithParam<BlendMode>
{
protected:
  BlendScenes()
    : Volume(BlendSize)
    , Key(MakeBlendKey(
        Volume, GetParam(), GetParam() == BlendMode::Minimum ? BlendLooks::Fog : BlendLooks::Skin))
  {
    this->Key.Blended().Looks[0].Material.Shade = true;
    this->Key.Blended().Looks[0].UnitDistance = GetParam() == BlendMode::Additive ? 20.0 : 1.0;
  }

  BlendVolume<std::uint8_t> Volume;
  FrameKey Key;
};

TEST_P(BlendScenes, ParallelViews)
{
  SKIP_UNLESS_BLENDED(this->Key);
  for (const glm::dvec3& direction : { glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(-1.0, 0.0, 0.0),
         glm::dvec3(1.0, 1.0, 1.0), glm::dvec3(0.3, -1.0, 0.1) })
  {
    this->Key.View = LookAt(BlendSize, direction, { 70, 61 }, true);
    ExpectBlendTruth(this->Key, 7);
  }
}

TEST_P(BlendScenes, PerspectiveViews)
{
  SKIP_UNLESS_BLENDED(this->Key);
  for (const glm::dvec3& direction : { glm::dvec3(0.0, 0.0, -1.0), glm::dvec3(0.0, 1.0, 0.0),
         glm::dvec3(-1.0, 0.7, -1.3), glm::dvec3(1.0, -0.01, 0.02) })
  {
    this->Key.View = LookAt(BlendSize, direction, { 70, 61 });
    ExpectBlendTruth(this->Key, 7);
  }
}

TEST_P(BlendScenes, FromWithin)
{
  SKIP_UNLESS_BLENDED(this->Key);
  const glm::dvec3 eye(18.3, 17.0, 22.9);
  for (const glm::dvec3& direction : { glm::dvec3(1.0, 0.4, 0.2), glm::dvec3(-0.1, -1.0, 0.3) })
  {
    ASSERT_TRUE(MakeView(glm::lookAt(eye, eye + direction, glm::dvec3(0, 0, 1)),
      glm::perspective(1.2, 1.2, 0.01, 200.0), { 0.01, 200.0 }, { 70, 58 }, this->Key.View));
    ExpectBlendTruth(this->Key, 7);
  }
}

TEST_P(BlendScenes, FineAndCoarsePixels)
{
  SKIP_UNLESS_BLENDED(this->Key);
  // Nearly all rays of a tile in one cell.
  const glm::dvec3 eye(-40.0, -30.0, 30.0), centre(20.0, 18.0, 22.0);
  ASSERT_TRUE(MakeView(glm::lookAt(eye, centre, glm::dvec3(0, 0, 1)),
    glm::perspective(0.05, 1.0, 10.0, 300.0), { 10.0, 300.0 }, { 90, 90 }, this->Key.View));
  ExpectBlendTruth(this->Key, 7);
  // Rays of a tile with many cells between them.
  this->Key.View = LookAt(BlendSize, { 1.0, 2.0, 0.7 }, { 13, 11 });
  ExpectBlendTruth(this->Key, 1);
}

TEST_P(BlendScenes, ClippingRange)
{
  SKIP_UNLESS_BLENDED(this->Key);
  const double middle = 3.0 * glm::length(0.5 * glm::dvec3(BlendSize - 1));
  this->Key.View.Near = middle - 6.0;
  this->Key.View.Far = middle + 9.0;
  ExpectBlendTruth(this->Key);
}

TEST_P(BlendScenes, ClippingPlanes)
{
  SKIP_UNLESS_BLENDED(this->Key);
  const glm::dvec3 normal = glm::normalize(glm::dvec3(-0.5, -1.0, 0.4));
  const glm::dvec3 other = glm::normalize(glm::dvec3(0.1, 1.0, 0.1));
  this->Key.Region.Clips = { { normal, -glm::dot(normal, glm::dvec3(20.0, 20.0, 20.0)) },
    { other, -glm::dot(other, glm::dvec3(20.0, 9.0, 20.0)) } };
  ExpectBlendTruth(this->Key);
}

TEST_P(BlendScenes, Cropping)
{
  SKIP_UNLESS_BLENDED(this->Key);
  this->Key.Region.Crops = { glm::dvec2(9.3, 30.1), glm::dvec2(8.0, 24.5), glm::dvec2(11.0, 40.0) };
  constexpr std::uint32_t inside = 1u << 13;
  for (const std::uint32_t boxes : { inside, Region::AllBoxes & ~inside, 0x5a5a5a5u, 0x2aaaaaau })
  {
    this->Key.Region.Boxes = boxes;
    ExpectBlendTruth(this->Key, 7);
  }
}

TEST_P(BlendScenes, OpaqueThingsInside)
{
  SKIP_UNLESS_BLENDED(this->Key);
  const double middle = 3.0 * glm::length(0.5 * glm::dvec3(BlendSize - 1));
  const glm::ivec2& size = this->Key.View.Size;
  auto ends = std::make_shared<std::vector<double>>();
  for (int pixel = 0; pixel < size.x * size.y; ++pixel)
  {
    const int x = pixel % size.x;
    ends->push_back(x % 9 == 0 ? std::numeric_limits<double>::infinity()
                               : middle + 0.5 * (x - 30) + 0.1 * (pixel % 7));
  }
  this->Key.Blended().Ends = ends;
  ExpectBlendTruth(this->Key);
}

TEST_P(BlendScenes, HiddenCells)
{
  std::vector<std::uint8_t> flags;
  for (int cell = 0; cell < (BlendSize.x - 1) * (BlendSize.y - 1) * (BlendSize.z - 1); ++cell)
  {
    const int x = cell % (BlendSize.x - 1), y = cell / (BlendSize.x - 1) % (BlendSize.y - 1);
    flags.push_back((x + y) % 19 < 6 || cell % 37 == 0);
  }
  HidingFlags hiding;
  hiding.OfCells = flags.data();
  hiding.CellMask = 1;
  this->Key.Samples.Flagged = TemporalCoherence::HiddenCells::Make(BlendSize, hiding);
  this->Key.Samples.Hidden = this->Key.Samples.Flagged;
  SKIP_UNLESS_BLENDED(this->Key);
  ExpectBlendTruth(this->Key);
}

TEST_P(BlendScenes, NearestInterpolation)
{
  this->Key.Samples.Between = Interpolation::Nearest;
  SKIP_UNLESS_BLENDED(this->Key);
  ExpectBlendTruth(this->Key);
  this->Key.Blended().Looks[0].Transfer = MakeTransfer(this->Volume.Range, BlendLooks::Step);
  ExpectBlendTruth(this->Key);
}

TEST_P(BlendScenes, TurnedAndStretched)
{
  SKIP_UNLESS_BLENDED(this->Key);
  glm::dmat4 world = glm::translate(glm::dmat4(1.0), glm::dvec3(500.0, -20.0, 7.0));
  world = glm::rotate(world, 0.7, glm::normalize(glm::dvec3(1.0, 2.0, -0.4)));
  world = glm::scale(world, glm::dvec3(0.5, -1.0, 2.0));
  world[1][0] += 0.2; // sheared
  this->Key.Transform = { world, glm::inverse(world) };
  const glm::dvec3 centre(world * glm::dvec4(0.5 * glm::dvec3(BlendSize - 1), 1.0));
  const glm::dvec3 eye = centre + glm::dvec3(150.0, 60.0, 70.0);
  ASSERT_TRUE(MakeView(glm::lookAt(eye, centre, glm::dvec3(0, 0, 1)),
    glm::perspective(0.45, 1.2, 50.0, 400.0), { 50.0, 400.0 }, { 70, 58 }, this->Key.View));
  this->Key.Blended().Looks[0].ByGradient.Nodes = { { 1.0, 0.1 }, { 15.0, 1.0 } };
  this->Key.Blended().Looks[0].ByGradient.PerStep = { 2.2, 1.1, 0.55 };
  ExpectBlendTruth(this->Key, 5);
}

TEST_P(BlendScenes, RectilinearGrids)
{
  auto coordinates = std::make_shared<GridCoordinates>();
  for (std::size_t a = 0; a < 3; ++a)
  {
    const int last = BlendSize[static_cast<int>(a)] - 1;
    for (int i = 0; i <= last; ++i)
    {
      const double share = static_cast<double>(i) / last;
      coordinates->Along[a].push_back(last * (0.3 * share + 0.7 * share * share));
    }
    coordinates->Along[a].back() = last;
  }
  this->Key.Samples.Shape = RectilinearKind(coordinates);
  SKIP_UNLESS_BLENDED(this->Key);
  ExpectBlendTruth(this->Key, 3, coordinates.get());
  this->Key.Samples.Between = Interpolation::Nearest;
  ExpectBlendTruth(this->Key, 7, coordinates.get());
}

TEST_P(BlendScenes, ValuesThatAreNotFinite)
{
  BlendVolume<float> volume(BlendSize);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (int i = 3; i < 41; i += 9)
  {
    volume.At(i, 15, i) = std::numeric_limits<float>::quiet_NaN();
    volume.At(i, 20, 20) = static_cast<float>(infinity);
    volume.At(i, i - 3, 24) = static_cast<float>(-infinity);
  }
  this->Key.Samples = volume.Field;
  SKIP_UNLESS_BLENDED(this->Key);
  for (const bool isShaded : { false, true })
  {
    this->Key.Blended().Looks[0].Material.Shade = isShaded;
    ExpectBlendTruth(this->Key);
  }
  // Gradients of other kinds are read elsewhere.
  const auto coordinates = Stretched(BlendSize, 3.0, 5);
  FrameKey grid = this->Key;
  grid.Samples.Shape = RectilinearKind(coordinates);
  ExpectBlendTruth(grid, 7, coordinates.get());
  this->Key.Samples.Between = Interpolation::Nearest;
  ExpectBlendTruth(this->Key, 7);
}

TEST_P(BlendScenes, WindowAndLevel)
{
  SKIP_UNLESS_BLENDED(this->Key);
  this->Key.Appearance.ColorScale = 1.7;
  this->Key.Appearance.ColorShift = -0.2;
  ExpectBlendTruth(this->Key);
}

TEST_P(BlendScenes, LongStepsAreVtks)
{
  this->Key.Blended().SampleDistance = 0.7;
  SKIP_UNLESS_BLENDED(this->Key);
  ExpectBlendTruth(this->Key);
}

INSTANTIATE_TEST_SUITE_P(Modes, BlendScenes, ::testing::ValuesIn(AllBlendModes), NameOfMode);

}
