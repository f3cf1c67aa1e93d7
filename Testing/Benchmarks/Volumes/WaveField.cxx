// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "WaveField.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>

namespace
{

constexpr double TwoPi = 6.283185307179586;

struct Wave
{
  std::size_t Frequency; ///< position in the list of frequencies along x
  double Y, Z;           ///< waves along y and z
  double Phase;
  double Amplitude;
};

/// A random number in [0, 1). Distributions of the standard library differ among systems.
double Uniform(std::mt19937& random)
{
  return static_cast<double>(random()) / 4294967296.0;
}

std::size_t NearestOf(const std::vector<int>& frequencies, double wanted)
{
  const auto distance = [&](int frequency) { return std::abs(frequency - wanted); };
  return static_cast<std::size_t>(std::min_element(frequencies.begin(), frequencies.end(),
                                    [&](int a, int b) { return distance(a) < distance(b); }) -
    frequencies.begin());
}

/// Waves in random directions, in the order of their frequencies along x.
std::vector<Wave> MakeWaves(
  const std::vector<int>& frequencies, const std::vector<Octave>& octaves, unsigned int seed)
{
  std::mt19937 random(seed);
  std::vector<Wave> waves;
  for (const Octave& octave : octaves)
  {
    for (int i = 0; i < octave.Waves; ++i)
    {
      const double length = octave.Low + (octave.High - octave.Low) * Uniform(random);
      const double height = 2.0 * Uniform(random) - 1.0;
      const double angle = TwoPi * Uniform(random);
      const double aside = length * std::sqrt(1.0 - height * height);
      Wave wave;
      wave.Frequency = NearestOf(frequencies, std::abs(aside * std::cos(angle)));
      wave.Y = std::round(aside * std::sin(angle));
      wave.Z = length * height;
      wave.Phase = TwoPi * Uniform(random);
      wave.Amplitude = octave.Deviation * std::sqrt(2.0 / octave.Waves);
      waves.push_back(wave);
    }
  }
  std::stable_sort(waves.begin(), waves.end(),
    [](const Wave& a, const Wave& b) { return a.Frequency < b.Frequency; });
  return waves;
}

double CentreOf(std::size_t cell, std::size_t cells)
{
  return (static_cast<double>(cell) + 0.5) / static_cast<double>(cells);
}

/// Cosines and sines of all waves at all cells of an axis.
/// \param angle    of a wave at a place
/// \param amplitude of a wave
template <typename Angle, typename Amplitude>
std::vector<float> MakeTable(
  const std::vector<Wave>& waves, int cells, const Angle& angle, const Amplitude& amplitude)
{
  const auto count = static_cast<std::size_t>(cells);
  std::vector<float> table(2 * waves.size() * count);
  for (std::size_t cell = 0; cell < count; ++cell)
  {
    float* const cosines = table.data() + 2 * waves.size() * cell;
    float* const sines = cosines + waves.size();
    for (std::size_t i = 0; i < waves.size(); ++i)
    {
      const double at = angle(waves[i], CentreOf(cell, count));
      cosines[i] = static_cast<float>(amplitude(waves[i]) * std::cos(at));
      sines[i] = static_cast<float>(amplitude(waves[i]) * std::sin(at));
    }
  }
  return table;
}

}

WaveField::WaveField(const glm::ivec3& dimensions, const std::vector<int>& frequencies,
  const std::vector<Octave>& octaves, unsigned int seed)
  : Frequencies(frequencies.size() + frequencies.size() % 2)
  , Cells(static_cast<std::size_t>(dimensions.x))
{
  const std::vector<Wave> waves = MakeWaves(frequencies, octaves, seed);
  this->Waves = waves.size();
  for (std::size_t f = 0; f <= this->Frequencies; ++f)
  {
    this->FirstWave.push_back(static_cast<std::size_t>(
      std::count_if(waves.begin(), waves.end(), [&](const Wave& w) { return w.Frequency < f; })));
  }
  this->AlongX.resize(2 * this->Frequencies * this->Cells);
  for (std::size_t f = 0; f < frequencies.size(); ++f)
  {
    float* const cosines = this->AlongX.data() + 2 * f * this->Cells;
    for (std::size_t cell = 0; cell < this->Cells; ++cell)
    {
      const double at = TwoPi * frequencies[f] * CentreOf(cell, this->Cells);
      cosines[cell] = static_cast<float>(std::cos(at));
      cosines[this->Cells + cell] = static_cast<float>(std::sin(at));
    }
  }
  this->AlongY = MakeTable(
    waves, dimensions.y, [](const Wave& w, double y) { return TwoPi * w.Y * y + w.Phase; },
    [](const Wave&) { return 1.0; });
  this->AlongZ = MakeTable(
    waves, dimensions.z, [](const Wave& w, double z) { return TwoPi * w.Z * z; },
    [](const Wave& w) { return w.Amplitude; });
}

void WaveField::Factors(int y, int z, float* factors) const
{
  const float* const cosY = this->AlongY.data() + 2 * this->Waves * static_cast<std::size_t>(y);
  const float* const cosZ = this->AlongZ.data() + 2 * this->Waves * static_cast<std::size_t>(z);
  const float* const sinY = cosY + this->Waves;
  const float* const sinZ = cosZ + this->Waves;
  for (std::size_t f = 0; f < this->Frequencies; ++f)
  {
    // cos(x + (y + z)) = cos x cos(y + z) - sin x sin(y + z)
    float ofCosine = 0.0f, ofSine = 0.0f;
    for (std::size_t i = this->FirstWave[f]; i < this->FirstWave[f + 1]; ++i)
    {
      ofCosine += cosY[i] * cosZ[i] - sinY[i] * sinZ[i];
      ofSine -= sinY[i] * cosZ[i] + cosY[i] * sinZ[i];
    }
    factors[2 * f] = ofCosine;
    factors[2 * f + 1] = ofSine;
  }
}

void WaveField::Sum(const float* factors, std::size_t first, std::size_t count, float* sums) const
{
  std::fill(sums, sums + count, 0.0f);
  // Four tables at once: sums are loaded and stored less often.
  for (std::size_t f = 0; f < 2 * this->Frequencies; f += 4)
  {
    const float a = factors[f], b = factors[f + 1], c = factors[f + 2], d = factors[f + 3];
    const float* const ofA = this->AlongX.data() + f * this->Cells + first;
    const float* const ofB = ofA + this->Cells;
    const float* const ofC = ofB + this->Cells;
    const float* const ofD = ofC + this->Cells;
    for (std::size_t i = 0; i < count; ++i)
    {
      sums[i] += (a * ofA[i] + b * ofB[i]) + (c * ofC[i] + d * ofD[i]);
    }
  }
}
