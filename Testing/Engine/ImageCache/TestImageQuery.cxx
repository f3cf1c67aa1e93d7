// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Grid.h"
#include "ImageCache/ImageQuery.h"
#include "Render/FrameRenderer.h"
#include "Trace/RaySource.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{

using namespace TemporalCoherence;

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double Radius = 12.0;

/// Images whose rays walk, so that pictures have what BOUNDED starts from.
class WalkedImages final : public FieldKind
{
public:
  FieldAbilities Abilities() const override { return this->Images->Abilities(); }

  std::shared_ptr<const SurfaceTracer> MakeTracer(const TraceScene& scene) const override
  {
    TraceScene walked = scene;
    walked.By = Traversal::Walks;
    return this->Images->MakeTracer(walked);
  }

  void FindGradients(const GradientQuery& query, const GradientTile& tile) const override
  {
    this->Images->FindGradients(query, tile);
  }

private:
  std::shared_ptr<const FieldKind> Images = UniformKind();
};

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
    this->Key.Isosurfaces.Isovalues = { 0.0 };
    this->Key.Appearance.Colors = { glm::dvec3(1.0) };
  }

  CachedImage PictureOf(const View& view)
  {
    this->Key.View = view;
    FrameRenderer renderer;
    FrameRenderer::Options bounded;
    bounded.Accuracy = ReuseAccuracy::Bounded;
    FrameKey walked = this->Key;
    walked.Samples.Kind = std::make_shared<WalkedImages>();
    renderer.Render(walked, bounded);
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
    double Misses = 0.0, Hits = 0.0, Possible = 0.0;
  };

  /// Ask about all rays of a view; `check` sees each answer and the true hit.
  template <typename Check>
  Shares AskAll(CachedImage& image, const View& next, ReuseAccuracy accuracy, const Check& check)
  {
    FrameKey key = this->Key;
    key.View = next;
    EXPECT_TRUE(ImageQuery::CanAsk(image.Key, accuracy));
    const ImageQuery query(image, key, accuracy);
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
        check(rays, known, i, this->HitOf(rays, i));
      }
    }
    return shares;
  }

  /// Of a convex body nothing may be believed free that is not.
  Shares ExpectFree(CachedImage& image, const View& next)
  {
    return this->AskAll(image, next, ReuseAccuracy::Bounded,
      [&](const RayBatch& rays, const KnownRays& known, std::size_t i, double hit)
      {
        EXPECT_NE(known.Answers[i], Answer::DefiniteHit);
        if (known.Answers[i] == Answer::DefiniteMiss)
        {
          EXPECT_EQ(hit, Infinity);
        }
        else
        {
          EXPECT_GE(known.Free[i], rays.WalkBegin[i]);
          EXPECT_LE(known.Free[i], std::max(hit, rays.WalkBegin[i]) + 1e-6);
        }
      });
  }

  View ViewAlong(const glm::dvec3& direction, bool parallel = false, int size = 160) const
  {
    return LookAt(this->Samples.Field.Dimensions, direction, { size, size }, parallel);
  }

  Grid<float> Samples;
  glm::dvec3 Centre;
  FrameKey Key;
};

TEST_F(ImageQueryTest, FreeSpaceIsFree)
{
  const glm::dvec3 directions[] = { { 1.0, 0.0, 0.0 }, { 1.0, 0.02, 0.01 }, { 1.0, 0.5, 0.2 },
    { 0.0, 1.0, 0.3 }, { -1.0, 0.1, 0.0 } };
  for (const bool fromParallel : { false, true })
  {
    CachedImage image = this->PictureOf(this->ViewAlong(directions[0], fromParallel));
    for (const bool toParallel : { false, true })
    {
      for (const glm::dvec3& direction : directions)
      {
        this->ExpectFree(image, this->ViewAlong(direction, toParallel));
      }
      this->ExpectFree(image, this->ViewAlong(directions[1], toParallel, 75));
      this->ExpectFree(image, this->ViewAlong(directions[1], toParallel, 320));
    }
  }
}

TEST_F(ImageQueryTest, ASmallTurnLeavesLittleToLookFor)
{
  CachedImage image = this->PictureOf(this->ViewAlong({ 1.0, 0.0, 0.0 }));
  int near = 0, hits = 0;
  const View next = this->ViewAlong({ 1.0, 0.03, 0.0 });
  const Shares shares = this->AskAll(image, next, ReuseAccuracy::Bounded,
    [&](const RayBatch&, const KnownRays& known, std::size_t i, double hit)
    {
      hits += hit < Infinity;
      near += hit < Infinity && hit - known.Free[i] < 2.5;
    });
  EXPECT_GT(near, 0.75 * hits) << "starts are within two and a half voxels of the hits";
  // About a voxel around the silhouette is left open: first entries tell what is free.
  EXPECT_LT(shares.Possible, 1.35 * hits) << "most misses are known";
}

TEST_F(ImageQueryTest, FromInsideAndBehindNothingIsKnown)
{
  CachedImage image = this->PictureOf(this->ViewAlong({ 1.0, 0.0, 0.0 }));
  View inside, opposite;
  const glm::dmat4 lens = glm::perspective(1.2, 1.0, 0.01, 200.0);
  ASSERT_TRUE(MakeView(glm::lookAt(glm::dvec3(20.0, 30.0, 22.0), glm::dvec3(0.0), { 0, 0, 1 }),
    lens, { 0.01, 200.0 }, { 90, 90 }, inside));
  this->ExpectFree(image, inside);

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
  CachedImage image = this->PictureOf(narrow);
  const Shares shares = this->ExpectFree(image, this->ViewAlong({ 1.0, 0.0, 0.0 }));
  EXPECT_GT(shares.Possible, 0.3 * 160 * 160);
}

TEST_F(ImageQueryTest, PaperFindsTheHitsOfASmoothSurface)
{
  CachedImage image = this->PictureOf(this->ViewAlong({ 1.0, 0.0, 0.0 }));
  int hits = 0, wrong = 0, near = 0;
  const Shares shares =
    this->AskAll(image, this->ViewAlong({ 1.0, 0.03, 0.0 }), ReuseAccuracy::Paper,
      [&](const RayBatch&, const KnownRays& known, std::size_t i, double hit)
      {
        hits += hit < Infinity;
        wrong += hit < Infinity && known.Answers[i] == Answer::DefiniteMiss;
        near += known.Answers[i] == Answer::DefiniteHit && std::abs(known.Hit[i] - hit) < 1.0;
      });
  EXPECT_GT(near, 0.9 * shares.Hits);
  EXPECT_GT(shares.Hits, 0.85 * hits);
  EXPECT_LT(wrong, 0.01 * hits) << "the silhouette may erode, by fractions of a pixel";
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
  const Shares shares = this->AskAll(image, next, ReuseAccuracy::Paper,
    [](const RayBatch&, const KnownRays&, std::size_t, double) {});
  EXPECT_GT(shares.Possible, 100.0);
  EXPECT_GT(shares.Hits, 3000.0);
}

TEST_F(ImageQueryTest, CoarseImagesAreNotAsked)
{
  const CachedImage image = this->PictureOf(this->ViewAlong({ 1.0, 0.0, 0.0 }, false, 12));
  EXPECT_FALSE(ImageQuery::CanAsk(image.Key, ReuseAccuracy::Bounded));
  EXPECT_TRUE(ImageQuery::CanAsk(image.Key, ReuseAccuracy::Paper));
}

}
