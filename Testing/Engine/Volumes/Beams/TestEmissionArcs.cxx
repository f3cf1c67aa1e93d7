// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Arcs follow each other without a gap, fit extinction and colours, and are few. They tell where
// something is opaque at once, and are given up where they are too many.

#include "Volumes/Beams/EmissionArcs.h"
#include "Volumes/Medium/BlendCase.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace
{

using namespace TemporalCoherence;

constexpr double MostExtinction = 65536.0, Tolerance = 1.0 / 8192.0;

/// Arcs of a look over the values from 0 to 1, and the tables that they are made of.
struct ArcsOf
{
  explicit ArcsOf(const TransferFunction& transfer)
    : Tables(LookOf(transfer), MostExtinction)
    , Arcs(Tables, Tolerance)
  {
  }
  explicit ArcsOf(const std::vector<LookPoint>& points, std::size_t nodes = 4097)
    : ArcsOf(MakeTransfer({ 0.0, 1.0 }, points, nodes))
  {
  }

  static ComponentLook LookOf(const TransferFunction& transfer)
  {
    ComponentLook look;
    look.Transfer = transfer;
    return look;
  }

  /// Extinction or a colour at a value, as kernels find it.
  double ChannelAt(std::size_t channel, float value) const
  {
    const std::size_t arc = this->Arcs.ArcOf(value);
    const double x =
      std::clamp((value - this->Arcs.Middle[arc]) * this->Arcs.PerValue[arc], -1.0f, 1.0f);
    double sum = 0.0;
    for (std::size_t power = 4; power-- > 0;)
    {
      sum = sum * x + static_cast<double>(this->Arcs.Powers[channel][power][arc]);
    }
    return std::max(sum, 0.0);
  }

  TransferTables Tables;
  EmissionArcs Arcs;
};

TEST(EmissionArcs, FollowEachOther)
{
  for (const auto* points : { &BlendLooks::Bone, &BlendLooks::Skin, &BlendLooks::Peaks,
         &BlendLooks::Step, &BlendLooks::OpaqueRanges, &BlendLooks::OpaqueEnds })
  {
    const ArcsOf of(*points);
    EXPECT_LT(of.Arcs.Low[0], -1e30f);
    EXPECT_GT(of.Arcs.High[of.Arcs.Count - 1], 1e30f);
    for (std::size_t arc = 1; arc < of.Arcs.Count; ++arc)
    {
      EXPECT_EQ(of.Arcs.Low[arc], of.Arcs.High[arc - 1]);
      EXPECT_EQ(of.Arcs.ArcOf(of.Arcs.Low[arc]), arc);
      EXPECT_LT(of.Arcs.AreEmpty[arc] + of.Arcs.AreEmpty[arc - 1], 2.0f) << "neighbours are empty";
    }
  }
}

TEST(EmissionArcs, FitTheFunction)
{
  for (const auto* points : { &BlendLooks::Bone, &BlendLooks::Skin, &BlendLooks::Peaks })
  {
    for (const std::size_t nodes : { std::size_t(3), std::size_t(257), std::size_t(65537) })
    {
      const ArcsOf of(*points, nodes);
      EXPECT_FALSE(of.Arcs.AreRough(0, of.Arcs.Count - 1));
      const auto last = static_cast<float>(of.Tables.Bins);
      for (float value = -10.0f; value < last + 10.0f; value += last / 5003.0f)
      {
        const Emission expected = of.Tables.At(value);
        const double extinction = of.ChannelAt(0, value);
        ASSERT_NEAR(extinction, expected[0], std::max(1.1 * Tolerance, 0.008 * extinction))
          << value;
        for (std::size_t channel = 1; channel < 4 && expected[0] > 1e-4f; ++channel)
        {
          ASSERT_NEAR(of.ChannelAt(channel, value), expected[channel] / expected[0], 0.003)
            << value;
        }
      }
    }
  }
}

TEST(EmissionArcs, AreFewAndLong)
{
  EXPECT_LT(ArcsOf(BlendLooks::Bone, 65537).Arcs.Count, 14u);
  EXPECT_LT(ArcsOf(BlendLooks::Skin, 65537).Arcs.Count, 30u);
}

TEST(EmissionArcs, AreRoughWhereSomethingIsOpaqueAtOnce)
{
  const ArcsOf of(BlendLooks::Step, 65537);
  EXPECT_LT(of.Arcs.Count, 8u);
  const auto last = static_cast<float>(of.Tables.Bins);
  const std::size_t below = of.Arcs.ArcOf(0.1f * last), above = of.Arcs.ArcOf(0.9f * last);
  EXPECT_FALSE(of.Arcs.AreRough(below, below));
  EXPECT_TRUE(of.Arcs.AreRough(above, above));
  EXPECT_TRUE(of.Arcs.AreRough(below, above));
}

// A function that bends everywhere takes neither long nor much memory.
TEST(EmissionArcs, AreGivenUpWhereTheyAreTooMany)
{
  TransferFunction noise;
  noise.Range = { 0.0, 1.0 };
  std::minstd_rand random(1);
  std::uniform_real_distribution<double> any(0.0, 0.9);
  for (int node = 0; node < 65537; ++node)
  {
    noise.Nodes.push_back({ any(random), any(random), any(random), any(random) });
  }
  const ArcsOf of(noise);
  EXPECT_LT(of.Arcs.Count, 300u);
  const std::size_t last = of.Arcs.Count - 1;
  EXPECT_TRUE(of.Arcs.AreRough(last, last));
}

}
