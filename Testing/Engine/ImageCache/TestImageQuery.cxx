// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// What a cached picture of a sphere tells about the rays of other views is right, and nothing is
// known of rays that it does not show.

#include "Checks/Infinity.h"
#include "Grid.h"
#include "ImageCache/ImageQuery.h"
#include "Lattice/RaySource.h"
#include "Render/FrameRenderer.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

using namespace TemporalCoherence;

constexpr double Radius = 12.0;

/// A sphere in the middle of a field, and pictures of it.
class ImageQueryTest : public ::testing::Test
{
protected:
  ImageQueryTest()
    : Samples(glm::ivec3(48))
    , Centre(23.5)
  {
    this->Samples.Fill([this](int i, int j, int k)
      { return Radius - glm::distance(glm::dvec3(i, j, k), this->Centre); });
    this->Key.Samples = this->Samples.Field;
    this->Key.EditIsosurfaces().Isovalues = { 0.0 };
    this->Key.Appearance.Colors = { glm::dvec3(1.0) };
  }

  CachedImage PictureOf(const View& view)
  {
    this->Key.View = view;
    FrameRenderer renderer;
    FrameRenderer::Options paper;
    paper.Accuracy = ReuseAccuracy::Paper;
    renderer.Render(this->Key, paper);
    CachedImage image;
    image.Key = this->Key;
    image.Picture = renderer.LastFrame();
    return image;
  }

  /// t where a ray meets the sphere, or infinity.
  double HitOf(const RayBatch& rays, std::size_t i) const
  {
    const glm::dvec3 o(rays.Origin[0][i], rays.Origin[1][i], rays.Origin[2][i]);
    const glm::dvec3 d(rays.Direction[0][i], rays.Direction[1][i], rays.Direction[2][i]);
    const double b = glm::dot(o - this->Centre, d);
    const double root = b * b - glm::dot(o - this->Centre, o - this->Centre) + Radius * Radius;
    const double t = -b - std::sqrt(std::max(root, 0.0));
    return root > 0.0 && t > 0.0 ? t : Infinity;
  }

  struct Shares
  {
    double Misses = 0.0, Hits = 0.0, Possible = 0.0; ///< answers
    double Surfaces = 0.0;                           ///< rays that meet the sphere
  };

  /// Ask about all rays of a view; `check` sees each answer and the true hit.
  template <typename Check>
  Shares AskAll(const CachedImage& image, const View& next, const Check& check)
  {
    FrameKey key = this->Key;
    key.View = next;
    EXPECT_TRUE(ImageQuery::CanAsk(image.Key));
    const ImageQuery query(image, key);
    const RaySource source(next, key.Transform, key.Samples.Dimensions);
    Shares shares;
    for (std::int64_t tile = 0; tile < NumberOfTiles(next.Size); ++tile)
    {
      const PixelRect part = PixelsOfTile(next.Size, tile);
      RayBatch rays;
      KnownRays known;
      source.SetUp(part.First, part.Size, rays);
      query.Ask(rays, known);
      for (std::size_t i = 0; i < static_cast<std::size_t>(rays.Count); ++i)
      {
        shares.Misses += known.Answers[i] == Answer::DefiniteMiss;
        shares.Hits += known.Answers[i] == Answer::DefiniteHit;
        shares.Possible += known.Answers[i] == Answer::PossibleHit;
        shares.Surfaces += this->HitOf(rays, i) < Infinity;
        check(rays, known, i, this->HitOf(rays, i));
      }
    }
    return shares;
  }

  /// Rays rarely begin behind a surface of a convex body, and known hits are near the true ones.
  /// \param eroded the largest share of surfaces that rays begin behind
  Shares ExpectFree(const CachedImage& image, const View& next, double eroded = 0.02)
  {
    constexpr double Voxel = 1.0;
    int missed = 0, passed = 0, far = 0;
    const Shares shares = this->AskAll(image, next,
      [&](const RayBatch& rays, const KnownRays& known, std::size_t i, double hit)
      {
        switch (known.Answers[i])
        {
          case Answer::DefiniteMiss:
            missed += hit < Infinity;
            break;
          case Answer::DefiniteHit:
            far += !(std::abs(known.Hit[i] - hit) < Voxel);
            break;
          case Answer::PossibleHit:
            EXPECT_GE(known.Free[i], rays.WalkBegin[i]);
            passed += known.Free[i] > std::max(hit, rays.WalkBegin[i]) + 1e-6;
            break;
        }
      });
    EXPECT_LE(missed, 0.01 * shares.Surfaces);
    EXPECT_LE(passed, eroded * shares.Surfaces);
    EXPECT_LE(far, 0.1 * shares.Hits);
    return shares;
  }

  /// Nothing is known of a ray.
  static void ExpectUnknown(
    const RayBatch& rays, const KnownRays& known, std::size_t i, double /*hit*/)
  {
    EXPECT_EQ(known.Answers[i], Answer::PossibleHit);
    EXPECT_EQ(known.Free[i], rays.WalkBegin[i]);
  }

  View ViewAlong(const glm::dvec3& direction, bool parallel = false, int size = 160) const
  {
    return LookAt(this->Samples.Field.Dimensions, direction, { size, size }, parallel);
  }

  Grid<float> Samples;
  glm::dvec3 Centre;
  FrameKey Key;
};

/// The published rule looks at depths alone: where the other view shows sides of the body that the
/// image does not, rays begin behind them.
TEST_F(ImageQueryTest, OnlySilhouettesErode)
{
  constexpr double Eroded = 0.2;
  const glm::dvec3 directions[] = { { 1.0, 0.0, 0.0 }, { 1.0, 0.02, 0.01 }, { 1.0, 0.5, 0.2 },
    { 0.0, 1.0, 0.3 }, { -1.0, 0.1, 0.0 } };
  for (const bool fromParallel : { false, true })
  {
    const CachedImage image = this->PictureOf(this->ViewAlong(directions[0], fromParallel));
    for (const bool toParallel : { false, true })
    {
      for (const glm::dvec3& direction : directions)
      {
        this->ExpectFree(image, this->ViewAlong(direction, toParallel), Eroded);
      }
      this->ExpectFree(image, this->ViewAlong(directions[1], toParallel, 75), Eroded);
      this->ExpectFree(image, this->ViewAlong(directions[1], toParallel, 320), Eroded);
    }
  }
}

TEST_F(ImageQueryTest, ASmallTurnLeavesLittleToLookFor)
{
  const CachedImage image = this->PictureOf(this->ViewAlong({ 1.0, 0.0, 0.0 }));
  const Shares shares = this->ExpectFree(image, this->ViewAlong({ 1.0, 0.03, 0.0 }));
  EXPECT_GT(shares.Hits, 0.85 * shares.Surfaces);
  EXPECT_LT(shares.Possible, 0.15 * shares.Surfaces);
}

TEST_F(ImageQueryTest, FromInsideAndBehindNothingIsKnown)
{
  const CachedImage image = this->PictureOf(this->ViewAlong({ 1.0, 0.0, 0.0 }));
  View inside, opposite;
  const glm::dmat4 lens = glm::perspective(1.2, 1.0, 0.01, 200.0);
  ASSERT_TRUE(MakeView(glm::lookAt(glm::dvec3(20.0, 30.0, 22.0), glm::dvec3(0.0), { 0, 0, 1 }),
    lens, { 0.01, 200.0 }, { 90, 90 }, inside));
  const Shares shares = this->AskAll(image, inside, ExpectUnknown);
  EXPECT_EQ(shares.Possible, 90.0 * 90.0);

  // Looking back from where the old eye was: all of it is behind the old eye.
  const glm::dvec3 eye = image.Key.View.Position;
  ASSERT_TRUE(MakeView(glm::lookAt(eye, eye + glm::dvec3(1.0, 0.0, 0.0), { 0, 0, 1 }), lens,
    { 0.01, 200.0 }, { 90, 90 }, opposite));
  this->ExpectFree(image, opposite);
}

TEST_F(ImageQueryTest, RaysThatBeginOutsideTheImageStartThere)
{
  // An image of the middle of the sphere only.
  View narrow;
  const glm::dvec3 eye = this->Centre + glm::dvec3(100.0, 0.0, 0.0);
  ASSERT_TRUE(MakeView(glm::lookAt(eye, this->Centre, { 0, 0, 1 }),
    glm::perspective(0.06, 1.0, 20.0, 200.0), { 20.0, 200.0 }, { 160, 160 }, narrow));
  const CachedImage image = this->PictureOf(narrow);
  const View next = this->ViewAlong({ 1.0, 0.0, 0.0 });
  const Shares shares = this->ExpectFree(image, next);
  EXPECT_GT(shares.Possible, 0.3 * 160 * 160);
  int outside = 0;
  this->AskAll(image, next,
    [&](const RayBatch& rays, const KnownRays& known, std::size_t i, double hit)
    {
      const glm::dvec3 begin = glm::dvec3(rays.Origin[0][i], rays.Origin[1][i], rays.Origin[2][i]) +
        rays.WalkBegin[i] *
          glm::dvec3(rays.Direction[0][i], rays.Direction[1][i], rays.Direction[2][i]);
      const glm::dvec4 clip = image.Key.View.ClipFromWorld * glm::dvec4(begin, 1.0);
      if (rays.HasWalk(i) && glm::max(std::abs(clip.x), std::abs(clip.y)) > clip.w)
      {
        ExpectUnknown(rays, known, i, hit);
        ++outside;
      }
    });
  EXPECT_GT(outside, 0.3 * 160 * 160);
}

TEST_F(ImageQueryTest, ConcavityIsAPossibleHit)
{
  // Two plates, one behind the other's edge: passing behind the edge is no hit.
  this->Samples.Fill(
    [](int i, int j, int)
    {
      const double front = std::min(2.0 - std::abs(i - 36.0), 22.0 - j);
      return static_cast<float>(std::max(front, 2.0 - std::abs(i - 10.0)));
    });
  this->Key.Samples.Stamp = 2;
  CachedImage image = this->PictureOf(this->ViewAlong({ 1.0, 0.0, 0.0 }));
  const View next = this->ViewAlong({ 1.0, -0.25, 0.0 });
  const Shares shares =
    this->AskAll(image, next, [](const RayBatch&, const KnownRays&, std::size_t, double) {});
  EXPECT_GT(shares.Possible, 100.0);
  EXPECT_GT(shares.Hits, 3000.0);
}

}
