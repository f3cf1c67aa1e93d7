// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// What changed since the last frame and what is held decide the route.

#include "ImageCache/ImageCache.h"
#include "Render/ReusePlan.h"
#include "Scene/LabelSets.h"

#include <gtest/gtest.h>

namespace
{

using namespace TemporalCoherence;

FrameKey BaseKey()
{
  FrameKey key;
  key.Samples.Dimensions = glm::ivec3(10);
  key.Samples.Stamp = 1;
  key.View.Size = glm::ivec2(100);
  key.EditIsosurfaces().Isovalues = { 5.0 };
  key.Appearance.Colors = { glm::dvec3(1.0) };
  return key;
}

Route Plan(const FrameKey& next, const ReuseSwitches& switches = {}, const HeldForReuse& held = {})
{
  return PlanRoute(BaseKey(), next, switches, held);
}

TEST(ReusePlan, NothingChanged)
{
  EXPECT_EQ(Plan(BaseKey()), Route::Redisplay);
}

TEST(ReusePlan, FewerRaysReplaceFramesThatTraceAll)
{
  ReuseSwitches fewer;
  fewer.FewerRays = true;
  FrameKey key = BaseKey();
  key.View.ClipFromWorld[0][0] = 2.0;
  EXPECT_EQ(Plan(key, fewer), Route::FewerRays);
  EXPECT_EQ(Plan(BaseKey(), fewer), Route::Redisplay);
  key = BaseKey();
  key.EditIsosurfaces().Isovalues = { 6.0 };
  EXPECT_EQ(Plan(key, fewer), Route::IsomapBuild);
  key.EditIsosurfaces().Opacities = { 0.5 };
  FrameKey last = BaseKey();
  last.EditIsosurfaces().Opacities = { 0.5 };
  EXPECT_EQ(PlanRoute(last, key, {}, {}), Route::IsomapBuild);
  EXPECT_EQ(PlanRoute(last, key, fewer, {}), Route::FewerRays) << "an isomap saves no layers";
}

TEST(ReusePlan, PixelsBetweenRaysAreRefined)
{
  HeldForReuse held;
  held.IsExact = false;
  held.IsLightFinal = false;
  held.IsBetweenRays = true;
  EXPECT_EQ(Plan(BaseKey(), {}, held), Route::Refine);
  ReuseSwitches switches;
  switches.Frames = switches.Isomap = switches.RefineWhenStill = false;
  EXPECT_EQ(Plan(BaseKey(), switches, held), Route::Refine);
  switches.FewerRays = true;
  EXPECT_EQ(Plan(BaseKey(), switches, held), Route::Refine);
  FrameKey key = BaseKey();
  key.Appearance.Ambient += 0.1;
  EXPECT_EQ(Plan(key, {}, held), Route::Cold);
  EXPECT_EQ(Plan(key, switches, held), Route::FewerRays);
}

TEST(ReusePlan, ChangedSurfacesDarkenOthers)
{
  FrameKey before = BaseKey();
  before.Appearance.Shade = true;
  before.Appearance.Occlusion.Radius = 1.0;
  FrameKey key = before;
  key.Samples.Stamp = 2;
  HeldForReuse held;
  held.ShareToTrace = 0.1;
  EXPECT_EQ(PlanRoute(before, key, {}, held), Route::Cold);
}

TEST(ReusePlan, LightGoesOn)
{
  HeldForReuse held;
  held.IsLightFinal = false;
  EXPECT_EQ(Plan(BaseKey(), {}, held), Route::Reshade);
  FrameKey key = BaseKey();
  key.Samples.Stamp = 2;
  EXPECT_EQ(Plan(key, {}, held), Route::Cold);
}

TEST(ReusePlan, EdgesGetMoreRays)
{
  HeldForReuse held;
  held.IsSmooth = false;
  EXPECT_EQ(Plan(BaseKey(), {}, held), Route::Antialias);
  FrameKey key = BaseKey();
  key.Appearance.Shade = true;
  EXPECT_EQ(Plan(key, {}, held), Route::Reshade) << "colours come first";
  held.IsLightFinal = false;
  EXPECT_EQ(Plan(BaseKey(), {}, held), Route::Reshade) << "light comes first";
  held.IsLightFinal = true;
  held.IsExact = false;
  EXPECT_EQ(Plan(BaseKey(), {}, held), Route::Cold) << "exactness comes first";
  FrameKey blended = BaseKey();
  blended.Shown = Blending();
  held.IsExact = true;
  EXPECT_EQ(PlanRoute(blended, blended, {}, held), Route::Antialias);
}

TEST(ReusePlan, AppearanceChanged)
{
  FrameKey key = BaseKey();
  key.Appearance.Colors[0].x = 0.5;
  EXPECT_EQ(Plan(key), Route::Reshade);
  key = BaseKey();
  key.Appearance.Shade = true;
  EXPECT_EQ(Plan(key), Route::Reshade);
  key = BaseKey();
  key.Appearance.Lights.push_back(Light());
  EXPECT_EQ(Plan(key), Route::Reshade);
  key = BaseKey();
  key.Appearance.TwoSided = false;
  EXPECT_EQ(Plan(key), Route::Reshade);
}

TEST(ReusePlan, DataChanged)
{
  FrameKey key = BaseKey();
  key.Samples.Stamp = 2;
  EXPECT_EQ(Plan(key), Route::Cold);
  key = BaseKey();
  key.Samples.Between = Interpolation::Nearest;
  EXPECT_EQ(Plan(key), Route::Cold);
  key = BaseKey();
  key.Transform.WorldFromIndex[3][0] = 1.0;
  EXPECT_EQ(Plan(key), Route::Cold);
}

TEST(ReusePlan, IsovalueChangedInTheSameView)
{
  FrameKey key = BaseKey();
  key.EditIsosurfaces().Isovalues[0] = 4.0;
  HeldForReuse held;
  EXPECT_EQ(Plan(key, {}, held), Route::IsomapBuild);
  held.Isomap = true;
  EXPECT_EQ(Plan(key, {}, held), Route::IsomapLookup);
  ReuseSwitches noIsomap;
  noIsomap.Isomap = false;
  EXPECT_EQ(Plan(key, noIsomap), Route::Cold);
  held.Isomap = held.CanBuildIsomap = false;
  EXPECT_EQ(Plan(key, {}, held), Route::Cold);
  key.EditIsosurfaces().Mode = SurfaceMode::Threshold;
  EXPECT_EQ(Plan(key), Route::Cold);
  key = BaseKey();
  key.EditIsosurfaces().Isovalues.clear();
  EXPECT_EQ(Plan(key), Route::Cold);
}

TEST(ReusePlan, OpacityChanged)
{
  FrameKey key = BaseKey();
  key.EditIsosurfaces().Opacities = { 0.5 };
  EXPECT_EQ(Plan(key), Route::Recomposite);
  key.Appearance.Shade = true;
  EXPECT_EQ(Plan(key), Route::Recomposite) << "and the appearance";
  HeldForReuse held;
  held.Isomap = held.Image = true;
  EXPECT_EQ(Plan(key, {}, held), Route::Recomposite) << "whatever an isomap holds";
  ReuseSwitches noCache;
  noCache.Frames = false;
  EXPECT_EQ(Plan(key, noCache), Route::Cold);
  held.IsExact = false;
  EXPECT_EQ(Plan(key, {}, held), Route::IsomapLookup) << "the last frame shows what is not there";
  held.Isomap = false;
  EXPECT_EQ(Plan(key, {}, held), Route::Cold);
  key = BaseKey();
  key.EditIsosurfaces().ByGradient.Nodes = { { 1.0, 0.5 } };
  EXPECT_EQ(Plan(key), Route::Recomposite) << "by gradient magnitude";
}

TEST(ReusePlan, SomeOfSeveralIsovaluesChanged)
{
  FrameKey last = BaseKey();
  last.EditIsosurfaces().Isovalues = { 3.0, 5.0 };
  last.EditIsosurfaces().Opacities = { 0.5, 0.5 };
  FrameKey key = last;
  key.EditIsosurfaces().Isovalues = { 3.0, 4.0 };
  HeldForReuse held;
  const auto plan = [&](const ReuseSwitches& switches = {})
  { return PlanRoute(last, key, switches, held); };
  EXPECT_EQ(plan(), Route::IsomapBuild);
  key.EditIsosurfaces().Isovalues = { 7.0, 1.0, 5.0 };
  key.EditIsosurfaces().Opacities = { 0.1, 0.2, 1.0 };
  key.Appearance.Shade = true;
  EXPECT_EQ(plan(), Route::IsomapBuild) << "and opacities, and the appearance";
  key.EditIsosurfaces().Isovalues = { 3.0, 4.0 };
  key.EditIsosurfaces().Opacities = last.Isosurfaces().Opacities;
  ReuseSwitches noCache;
  noCache.Frames = false;
  EXPECT_EQ(plan(noCache), Route::IsomapBuild);
  held.Isomap = true;
  EXPECT_EQ(plan(), Route::IsomapLookup) << "an isomap holds the new ones, too";
  held = {};
  held.IsExact = false;
  EXPECT_EQ(plan(), Route::IsomapBuild) << "the last frame shows what is not there";
  held = {};
  key.EditIsosurfaces().Opacities.clear();
  EXPECT_EQ(plan(), Route::IsomapBuild) << "opaque surfaces";
  key.EditIsosurfaces() = { { 7.0, 8.0 }, SurfaceMode::Crossing, { 0.5, 0.5 } };
  EXPECT_EQ(plan(), Route::IsomapBuild) << "none is kept";
  key.EditIsosurfaces() = { { 3.0, 8.0 }, SurfaceMode::Threshold, { 0.5, 0.5 } };
  EXPECT_EQ(plan(), Route::Cold) << "another mode";
  key.EditIsosurfaces().Mode = SurfaceMode::Crossing;
  key.View.ClipFromWorld[0][0] = 2.0;
  EXPECT_EQ(plan(), Route::Cold) << "another view";
}

TEST(ReusePlan, OpacityAndMoreChanged)
{
  FrameKey translucent = BaseKey();
  translucent.EditIsosurfaces().Opacities = { 0.5 };
  FrameKey key = translucent;
  key.EditIsosurfaces().Isovalues[0] = 4.0;
  EXPECT_EQ(Plan(key), Route::IsomapBuild);
  key = translucent;
  key.EditIsosurfaces().Mode = SurfaceMode::Threshold;
  EXPECT_EQ(Plan(key), Route::Cold);
  key = translucent;
  key.View.ClipFromWorld[0][0] = 2.0;
  EXPECT_EQ(Plan(key), Route::Cold);
  key = translucent;
  key.Samples.Stamp = 2;
  HeldForReuse fewTiles;
  fewTiles.ShareToTrace = 0.1;
  EXPECT_EQ(Plan(key, {}, fewTiles), Route::Cold);
}

TEST(ReusePlan, ViewChanged)
{
  FrameKey key = BaseKey();
  key.View.ClipFromWorld[0][0] = 2.0;
  HeldForReuse held;
  EXPECT_EQ(Plan(key, {}, held), Route::Cold) << "no image";
  held.Image = true;
  EXPECT_EQ(Plan(key, {}, held), Route::ImageCache);
  ReuseSwitches noCache;
  noCache.Frames = false;
  EXPECT_EQ(Plan(key, noCache, held), Route::Cold);
}

TEST(ReusePlan, AnIsomapServesWhateverTheLastFrameWas)
{
  HeldForReuse held;
  held.Isomap = held.Image = true;
  FrameKey key = BaseKey();
  key.View.ClipFromWorld[0][0] = 2.0;
  EXPECT_EQ(Plan(key, {}, held), Route::IsomapLookup) << "back in its view";
  held.IsExact = false;
  EXPECT_EQ(Plan(BaseKey(), {}, held), Route::IsomapLookup) << "to complete a repeated view";
}

TEST(ReusePlan, WhatAnImageCanServe)
{
  FrameKey key = BaseKey();
  key.View.ClipFromWorld[0][0] = 2.0;
  EXPECT_TRUE(CanServe(BaseKey(), key));
  key.Appearance.Shade = true;
  EXPECT_TRUE(CanServe(BaseKey(), key));
  key.EditIsosurfaces().Isovalues[0] = 6.0;
  EXPECT_FALSE(CanServe(BaseKey(), key)) << "another isovalue";
  key = BaseKey();
  key.EditIsosurfaces().Mode = SurfaceMode::Threshold;
  EXPECT_FALSE(CanServe(BaseKey(), key));
  key = BaseKey();
  key.Samples.Stamp = 2;
  EXPECT_FALSE(CanServe(BaseKey(), key));
  key = BaseKey();
  key.Transform.WorldFromIndex[0][0] = 2.0;
  EXPECT_FALSE(CanServe(BaseKey(), key));
}

TEST(ReusePlan, RepeatedViewIsCompleted)
{
  HeldForReuse held;
  held.IsExact = false;
  FrameKey key = BaseKey();
  EXPECT_EQ(Plan(key, {}, held), Route::Cold);
  key.Appearance.Shade = true;
  EXPECT_EQ(Plan(key, {}, held), Route::Cold);
  ReuseSwitches asItIs;
  asItIs.RefineWhenStill = false;
  EXPECT_EQ(Plan(key, asItIs, held), Route::Reshade);
  EXPECT_EQ(Plan(BaseKey(), asItIs, held), Route::Redisplay);
}

TEST(ReusePlan, OtherSamplesThatFewTilesCanSee)
{
  FrameKey key = BaseKey();
  key.Samples.Stamp = 2;
  HeldForReuse held;
  held.ShareToTrace = 0.5;
  EXPECT_TRUE(CompareFrames(BaseKey(), key).Samples);
  EXPECT_EQ(Plan(key, {}, held), Route::TimeStep);
  EXPECT_FALSE(CanServe(BaseKey(), key)) << "to start rays from";
  held.ShareToTrace = 0.51;
  EXPECT_EQ(Plan(key, {}, held), Route::Cold) << "too many tiles";
  held.ShareToTrace = 0.0;
  ReuseSwitches noCache;
  noCache.Frames = false;
  EXPECT_EQ(Plan(key, noCache, held), Route::Cold);
  held.IsExact = false;
  EXPECT_EQ(Plan(key, {}, held), Route::Cold) << "what is copied must be exact";
  held.IsExact = true;
  const auto expectCold = [&](const FrameKey& next, const char* what)
  { EXPECT_EQ(Plan(next, {}, held), Route::Cold) << what; };
  FrameKey other = key;
  other.View.ClipFromWorld[0][0] = 2.0;
  expectCold(other, "view");
  other = key;
  other.EditIsosurfaces().Isovalues[0] = 6.0;
  expectCold(other, "surfaces");
  other = key;
  other.EditIsosurfaces().Opacities = { 0.5 };
  expectCold(other, "opacity");
  other = key;
  other.Appearance.Shade = true;
  expectCold(other, "appearance");
  other = key;
  other.Transform.WorldFromIndex[3][0] = 1.0;
  expectCold(other, "transform");
  other = key;
  other.Samples.Between = Interpolation::Nearest;
  expectCold(other, "interpolation");
  other = key;
  other.Samples.Dimensions.x = 11;
  expectCold(other, "dimensions");
  FrameKey last = BaseKey();
  last.Appearance.ColorByAnswer = key.Appearance.ColorByAnswer = true;
  EXPECT_EQ(PlanRoute(last, key, {}, held), Route::Cold) << "colours of answers";
}

TEST(ReusePlan, OtherColorsOfAProjection)
{
  FrameKey last, key;
  for (FrameKey* frame : { &last, &key })
  {
    Blending& blending = frame->Shown.emplace<Blending>();
    blending.Mode = BlendMode::Maximum;
    blending.Looks.resize(1);
  }
  HeldForReuse held;
  held.Values = true;
  EXPECT_EQ(PlanRoute(last, key, {}, held), Route::Redisplay);
  key.Appearance.ColorScale = 0.5;
  EXPECT_EQ(PlanRoute(last, key, {}, held), Route::KeepValues);
  key.Blended().Looks[0].Transfer.Nodes = { { 0.0, 0.0, 0.0, 0.1 }, { 1.0, 1.0, 1.0, 0.2 } };
  EXPECT_EQ(PlanRoute(last, key, {}, held), Route::KeepValues);
  EXPECT_EQ(PlanRoute(last, key, {}, {}), Route::Cold) << "nothing is kept";
  ReuseSwitches off;
  off.Frames = false;
  EXPECT_EQ(PlanRoute(last, key, off, held), Route::Cold);
  last.Blended().Mode = key.Blended().Mode = BlendMode::Average;
  EXPECT_EQ(PlanRoute(last, key, {}, held), Route::Cold) << "opacities are averaged";
  last.Blended().Looks = key.Blended().Looks;
  key.Blended().Looks[0].Transfer.Nodes[0].x = 0.7;
  EXPECT_EQ(PlanRoute(last, key, {}, held), Route::KeepValues);
  FrameKey other = key;
  other.Blended().AverageRange.x = -1.0;
  EXPECT_EQ(PlanRoute(last, other, {}, held), Route::Cold);
  other = key;
  other.View.Parallel = !other.View.Parallel;
  EXPECT_EQ(PlanRoute(last, other, {}, held), Route::Cold);
  other = key;
  other.Blended().Mode = BlendMode::Additive;
  EXPECT_EQ(PlanRoute(last, other, {}, held), Route::Cold);
}

TEST(ReusePlan, OtherLabelsAreDrawn)
{
  FrameKey last = BaseKey();
  last.Samples.Labels = std::make_shared<const LabelSets>();
  FrameKey key = last;
  key.EditIsosurfaces().Isovalues = { 5.0, 6.0 };
  EXPECT_EQ(PlanRoute(last, key, {}, {}), Route::KeepLabels);
  EXPECT_EQ(PlanRoute(key, last, {}, {}), Route::KeepLabels);
  ReuseSwitches switches;
  switches.FewerRays = true;
  EXPECT_EQ(PlanRoute(last, key, switches, {}), Route::FewerRays) << "it may trace all";
  switches = {};
  switches.Frames = switches.Isomap = false;
  EXPECT_EQ(PlanRoute(last, key, switches, {}), Route::Cold);
  HeldForReuse held;
  held.CanBuildIsomap = false;
  const auto expectCold = [&](const FrameKey& before, const FrameKey& next, const char* what)
  { EXPECT_EQ(PlanRoute(before, next, {}, held), Route::Cold) << what; };
  FrameKey other = key;
  other.View.Parallel = !other.View.Parallel;
  expectCold(last, other, "another view");
  other = key;
  other.EditIsosurfaces().Opacities = { 0.5, 1.0 };
  expectCold(last, other, "translucent labels");
  expectCold(other, last, "translucent labels");
  other = key;
  other.EditIsosurfaces().Isovalues.clear();
  expectCold(last, other, "no labels");
  held.IsExact = false;
  expectCold(last, key, "a picture that is not exact");
}

TEST(ReusePlan, RoutesHaveTheirNames)
{
  EXPECT_STREQ(NameOf(Route::Cold), "Cold");
  EXPECT_STREQ(NameOf(Route::ImageCache), "ImageCache");
  EXPECT_STREQ(NameOf(Route::TimeStep), "TimeStep");
  EXPECT_STREQ(NameOf(Route::Recomposite), "Recomposite");
  EXPECT_STREQ(NameOf(Route::KeepValues), "KeepValues");
  EXPECT_STREQ(NameOf(Route::FewerRays), "FewerRays");
  EXPECT_STREQ(NameOf(Route::Refine), "Refine");
  EXPECT_STREQ(NameOf(Route::KeepLabels), "KeepLabels");
}

}
