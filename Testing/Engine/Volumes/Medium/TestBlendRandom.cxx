// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Random volumes, looks and views in every mode, with the errors that TestBlendModes allows.

#include "BlendCase.h"
#include "BlendFrames.h"

#include <algorithm>
#include <random>

namespace
{

using namespace TemporalCoherence;

/// A volume, a look and a view that nobody would choose.
template <typename T>
class RandomCase
{
public:
  RandomCase(unsigned int seed, BlendMode mode, double low, double high)
    : Engine(seed)
    , Samples(
        { this->Between(9, 30), this->Between(9, 30), this->Between(9, 30) }, glm::dvec2(low, high))
  {
    if (this->Between(0, 2) > 0)
    {
      this->Samples.FillRandomly(low, high, seed);
    }
    this->Key = MakeBlendKey(this->Samples, mode, this->Points());
    const glm::dvec3 direction(this->Real(-1.0, 1.0), this->Real(-1.0, 1.0), this->Real(-1.0, 1.0));
    this->Key.View =
      LookAt(this->Samples.Field.Dimensions, direction, { 57, 49 }, this->Between(0, 1) == 0);
    ComponentLook& look = this->Key.Blended().Looks[0];
    look.Material.Shade = this->Between(0, 1) == 0;
    look.Material.Specular = this->Real(0.0, 1.0);
    look.Material.Glow = glm::dvec3(this->Real(-0.1, 0.3), 0.0, this->Real(0.0, 0.3));
    look.UnitDistance = std::exp(this->Real(-1.0, 3.0));
    if (this->Between(0, 2) == 0)
    {
      const double bend = this->Real(0.01, 0.2) * (high - low);
      look.ByGradient.Nodes = { { 0.0, this->Real(0.0, 1.0) }, { bend, this->Real(0.0, 1.0) },
        { 3.0 * bend, this->Real(0.0, 1.0) } };
    }
    this->Key.Appearance.TwoSided = this->Between(0, 1) == 0;
  }

  FrameKey Key;

private:
  double Real(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Engine);
  }
  int Between(int low, int high)
  {
    return std::uniform_int_distribution<int>(low, high)(this->Engine);
  }

  std::vector<LookPoint> Points()
  {
    std::vector<double> at{ 0.0, 1.0 };
    for (int bend = this->Between(1, 9); bend > 0; --bend)
    {
      at.push_back(this->Real(0.0, 1.0));
    }
    std::sort(at.begin(), at.end());
    std::vector<LookPoint> points;
    for (const double each : at)
    {
      const int kind = this->Between(0, 5);
      const double opacity = kind < 2 ? 0.0 : kind == 5 ? 1.0 : this->Real(0.0, 1.0);
      points.push_back(
        { each, { this->Real(0.0, 1.0), this->Real(0.0, 1.0), this->Real(0.0, 1.0), opacity } });
    }
    return points;
  }

  std::mt19937 Engine;
  BlendVolume<T> Samples;
};

/// Sum over cases, so that one grazing ray of a small picture does not decide.
class BlendRandom : public ::testing::TestWithParam<BlendMode>
{
protected:
  template <typename T>
  void Check(unsigned int first, double low, double high)
  {
    constexpr unsigned int cases = 12;
    int compared = 0, beyondOne = 0;
    for (unsigned int seed = first; seed < first + cases; ++seed)
    {
      const RandomCase<T> random(seed, GetParam(), low, high);
      SKIP_UNLESS_BLENDED(random.Key);
      const BlendErrors errors = CompareWithTruth(random.Key, BlendedFrame(random.Key), 5);
      compared += errors.Compared;
      beyondOne += errors.BeyondOne;
      EXPECT_EQ(errors.BeyondThree, 0) << "seed " << seed << ": the worst, by " << errors.Largest
                                       << ", is " << errors.Worst.x << ", " << errors.Worst.y;
    }
    EXPECT_LE(beyondOne * 1000, compared * PixelsForOne);
  }
};

TEST_P(BlendRandom, Bytes)
{
  this->Check<std::uint8_t>(1, 0.0, 255.0);
}

TEST_P(BlendRandom, Shorts)
{
  this->Check<std::int16_t>(101, -32000.0, 32000.0);
}

TEST_P(BlendRandom, Floats)
{
  this->Check<float>(201, -1e-3, 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Modes, BlendRandom, ::testing::ValuesIn(AllBlendModes), NameOfMode);

}
