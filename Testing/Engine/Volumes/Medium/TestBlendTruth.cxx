// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The integral that other tests compare with is right where formulas tell it, and is the limit of
// VTK's samples.

#include "Grid.h"
#include "Integral/BlendTruth.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{

using namespace TemporalCoherence;

/// A volume that can be integrated by hand: 5 x 5 x 5 samples, seen along z by parallel rays.
class BlendTruthTest : public ::testing::Test
{
protected:
  BlendTruthTest()
    : Samples(glm::ivec3(5))
  {
    this->Key.Samples = this->Samples.Field;
    this->Key.View = LookAt(glm::ivec3(5), { 0.0, 0.0, 1.0 }, { 9, 9 }, true);
    this->Key.Shown.emplace<Blending>().Mode = BlendMode::Composite;
    ComponentLook look;
    look.Transfer.Range = { 0.0, 100.0 };
    look.Transfer.Nodes = { { 0.5, 0.5, 0.5, 0.0 }, { 0.5, 0.5, 0.5, 1.0 } };
    this->Key.Blended().Looks = { look };
    this->Key.Blended().ScalarRanges = { { 0.0, 100.0 } };
    this->Key.Blended().AverageRange = { 0.0, 100.0 };
  }

  /// The pixel in the middle: its ray passes 4 voxels.
  glm::dvec4 Middle() const { return BlendTruth(this->Key).At(4, 4); }

  Grid<float> Samples;
  FrameKey Key;
};

TEST_F(BlendTruthTest, AConstantFieldAbsorbsByBeersLaw)
{
  this->Samples.Fill([](int, int, int) { return 30.0; });
  this->Key.Blended().Looks[0].UnitDistance = 2.0;
  const double alpha = 1.0 - std::pow(0.7, 2.0);
  EXPECT_NEAR(this->Middle().w, alpha, 1e-9);
  EXPECT_NEAR(this->Middle().x, 0.5 * alpha, 1e-9);
  EXPECT_EQ(BlendTruth(this->Key).At(0, 0), glm::dvec4(0.0)) << "beside the volume";
}

TEST_F(BlendTruthTest, ARampIsIntegrated)
{
  this->Samples.Fill([](int, int, int k) { return 20.0 * k; });
  // The integral of -ln(1 - x) from 0 to 0.8 is 0.8 + 0.2 ln 0.2, over 5 voxels for each 1.
  EXPECT_NEAR(this->Middle().w, 1.0 - std::exp(-5.0 * (0.8 + 0.2 * std::log(0.2))), 1e-6);
}

TEST_F(BlendTruthTest, OpacityOneIsOpaqueAtOnce)
{
  this->Samples.Fill([](int, int, int k) { return 50.0 * k; });
  // From above: opaque in the upper half.
  EXPECT_NEAR(this->Middle().w, 1.0, 1e-12);
  EXPECT_NEAR(this->Middle().x, 0.5, 1e-12);
}

TEST_F(BlendTruthTest, AThinPeakIsNotSteppedOver)
{
  this->Samples.Fill([](int, int, int k) { return 25.0 * k; });
  auto& nodes = this->Key.Blended().Looks[0].Transfer.Nodes;
  nodes.assign(10001, { 1.0, 1.0, 1.0, 0.0 });
  nodes[6123].w = 0.5;
  // A triangle 0.02 values wide: 0.0008 voxels.
  const double side = 0.0004 * (1.0 - std::log(2.0));
  EXPECT_NEAR(this->Middle().w, 1.0 - std::exp(-2.0 * side), 1e-9);
}

TEST_F(BlendTruthTest, ExtremesInsideOfCellsAreFound)
{
  // In the cell in the middle, the field along a diagonal is highest in between.
  this->Samples.Fill([](int i, int j, int) { return (i + j) % 2 ? 80.0 : 10.0; });
  this->Key.View = LookAt(glm::ivec3(5), { 1.0, 1.0, 0.0 }, { 9, 9 }, true);
  this->Key.Blended().Mode = BlendMode::Maximum;
  EXPECT_NEAR(this->Middle().w, 0.45, 1e-9) << "half way along the diagonals of faces";
  this->Key.Blended().Mode = BlendMode::Minimum;
  EXPECT_NEAR(this->Middle().w, 0.1, 1e-9);
}

TEST_F(BlendTruthTest, SumsAndMeansAreVtks)
{
  this->Samples.Fill([](int, int, int k) { return 25.0 * k; });
  this->Key.Blended().Mode = BlendMode::Average;
  EXPECT_NEAR(this->Middle().x, 1.0 / 3.0, 1e-12) << "the mean of x^2";
  EXPECT_EQ(this->Middle().w, 1.0);
  this->Key.Blended().AverageRange = { 50.0, 100.0 };
  EXPECT_NEAR(this->Middle().x, 7.0 / 12.0, 1e-12);
  this->Key.Blended().AverageRange = { 101.0, 102.0 };
  EXPECT_EQ(this->Middle(), glm::dvec4(0.0));
  this->Key.Blended().Mode = BlendMode::Additive;
  this->Key.Blended().Looks[0].UnitDistance = 8.0;
  EXPECT_NEAR(this->Middle().x, 4.0 / 3.0 / 8.0, 1e-12);
}

TEST_F(BlendTruthTest, IsTheLimitOfVtksSamples)
{
  this->Samples.FillRandomly(0.0, 100.0, 5);
  this->Key.View = LookAt(glm::ivec3(5), { 1.0, 0.7, 0.4 }, { 9, 9 });
  ComponentLook& look = this->Key.Blended().Looks[0];
  look.Transfer.Nodes = { { 1.0, 0.2, 0.1, 0.0 }, { 0.1, 0.6, 0.1, 0.9 }, { 0.3, 0.2, 1.0, 0.1 },
    { 0.9, 0.9, 0.4, 0.4 } };
  look.Material.Shade = true;
  look.ByGradient.Nodes = { { 5.0, 0.2 }, { 60.0, 1.0 } };
  Light light;
  light.Direction = glm::normalize(glm::dvec3(-1.0, -0.3, -0.5));
  this->Key.Appearance.Lights = { light };
  for (const BlendMode mode : { BlendMode::Composite, BlendMode::Maximum, BlendMode::Minimum,
         BlendMode::Average, BlendMode::Additive })
  {
    this->Key.Blended().Mode = mode;
    FrameKey sampled = this->Key;
    sampled.Blended().SampleDistance = 0.0005; // times a slope of about 3 in opacity
    const BlendTruth exact(this->Key), steps(sampled);
    for (int pixel = 0; pixel < 81; pixel += 4)
    {
      const glm::dvec4 difference =
        glm::abs(exact.At(pixel % 9, pixel / 9) - steps.At(pixel % 9, pixel / 9));
      EXPECT_LT(std::max({ difference.x, difference.y, difference.z, difference.w }), 2e-3)
        << static_cast<int>(mode) << " " << pixel;
    }
  }
}

}
