// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_BlendFrames_h
#define Testing_BlendFrames_h

#include "Acceleration/ValueRangePyramid.h"
#include "Checks/Sanitized.h"
#include "Integral/BlendTruth.h"
#include "Kinds/FieldKind.h"
#include "Render/FrameRenderer.h"
#include "Volumes/Medium/BlendTracer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>

inline constexpr TemporalCoherence::BlendMode AllBlendModes[] = {
  TemporalCoherence::BlendMode::Composite, TemporalCoherence::BlendMode::Maximum,
  TemporalCoherence::BlendMode::Minimum, TemporalCoherence::BlendMode::Average,
  TemporalCoherence::BlendMode::Additive
};

inline std::string NameOf(TemporalCoherence::BlendMode mode)
{
  constexpr const char* names[] = { "Composite", "Maximum", "Minimum", "Average", "Additive" };
  return names[static_cast<int>(mode)];
}

inline std::string NameOfMode(const ::testing::TestParamInfo<TemporalCoherence::BlendMode>& info)
{
  return NameOf(info.param);
}

/// True if the engine draws a volume of this kind in this mode.
inline bool CanBlend(const TemporalCoherence::FrameKey& key)
{
  TemporalCoherence::ValueRangePyramid ranges;
  ranges.Build(key.Samples);
  return TemporalCoherence::MakeBlendTracer({ key, nullptr, &ranges }) != nullptr;
}

/// Leave a test of a volume that the engine does not draw yet.
#define SKIP_UNLESS_BLENDED(key)                                                                   \
  if (!CanBlend(key))                                                                              \
  {                                                                                                \
    GTEST_SKIP() << "no tracer blends this volume";                                                \
  }                                                                                                \
  static_assert(true)

inline TemporalCoherence::Frame BlendedFrame(
  const TemporalCoherence::FrameKey& key, const TemporalCoherence::FrameOptions& options = {})
{
  TemporalCoherence::FrameRenderer renderer;
  EXPECT_TRUE(renderer.Render(key, options));
  return renderer.LastFrame();
}

/// Of so many pixels one is compared. Under a sanitizer the truth takes ten times as long.
inline constexpr int PixelsForOne = IsMemorySanitized ? 19 : 1;

/// How far pixels are from the truth.
struct BlendErrors
{
  int Compared = 0, Seen = 0, BeyondOne = 0, BeyondThree = 0;
  double Largest = 0.0;
  glm::ivec2 Worst{ 0 };
};

/// Compare some of the pixels of a frame with the truth.
/// \param step only each such pixel
inline BlendErrors CompareWithTruth(const TemporalCoherence::FrameKey& key,
  const TemporalCoherence::Frame& frame, int step = 3,
  const TemporalCoherence::GridCoordinates* coordinates = nullptr)
{
  const BlendTruth truth(key, coordinates);
  BlendErrors errors;
  const glm::ivec2& size = key.View.Size;
  step *= PixelsForOne;
  for (int pixel = 0; pixel < size.x * size.y; pixel += step)
  {
    const int x = pixel % size.x, y = pixel / size.x;
    const glm::dvec4 shown = truth.ShownAt(x, y);
    const auto& color = frame.Colors[static_cast<std::size_t>(pixel)];
    const glm::dvec4 difference =
      glm::abs(shown - glm::dvec4(color[0], color[1], color[2], color[3]));
    const double error = std::max({ difference.x, difference.y, difference.z, difference.w });
    ++errors.Compared;
    errors.Seen += shown.w > 0.5;
    errors.BeyondOne += error > 1.0;
    errors.BeyondThree += error > 3.0;
    errors.Worst = error > errors.Largest ? glm::ivec2(x, y) : errors.Worst;
    errors.Largest = std::max(errors.Largest, error);
  }
  return errors;
}

inline void ExpectSmallErrors(const BlendErrors& errors, const std::string& which)
{
  EXPECT_LE(errors.BeyondOne * 1000, errors.Compared * PixelsForOne)
    << which << "the worst, by " << errors.Largest << ", is (" << errors.Worst.x << ", "
    << errors.Worst.y << ")";
  EXPECT_EQ(errors.BeyondThree, 0) << which << "the worst, by " << errors.Largest << ", is ("
                                   << errors.Worst.x << ", " << errors.Worst.y << ")";
}

/// The same view with pixels so fine that tiles of a composite volume go as beams.
inline TemporalCoherence::FrameKey FineKey(TemporalCoherence::FrameKey key)
{
  key.View.Size *= IsMemorySanitized ? 2 : 4;
  return key;
}

/// At most 0.1 % of the pixels are off by more than 1/255, and none by more than 3/255.
inline void ExpectBlendTruth(const TemporalCoherence::FrameKey& key, int step = 3,
  const TemporalCoherence::GridCoordinates* coordinates = nullptr)
{
  const BlendErrors errors = CompareWithTruth(key, BlendedFrame(key), step, coordinates);
  ExpectSmallErrors(errors, "");
  EXPECT_GT(errors.Seen * 25, errors.Compared) << "there is little to see";
  const TemporalCoherence::Blending& volume = key.Blended();
  if (volume.Mode == TemporalCoherence::BlendMode::Composite && volume.Looks.size() == 1 &&
    volume.SampleDistance == 0.0 && !volume.Ends)
  {
    const TemporalCoherence::FrameKey fine = FineKey(key);
    ExpectSmallErrors(
      CompareWithTruth(fine, BlendedFrame(fine), 17 * step, coordinates), "in fine pixels: ");
  }
}

#endif
