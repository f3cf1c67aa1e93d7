// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_WaveField_h
#define Benchmarks_WaveField_h

#include <glm/glm.hpp>

#include <cstddef>
#include <vector>

/// Plane waves whose wavelengths are similar.
struct Octave
{
  double Low, High; ///< the range of numbers of waves along an edge of the unit cube
  int Waves;        ///< their number; directions and phases are random, but always the same
  double Deviation; ///< standard deviation of their sum
};

/// A sum of plane waves in the unit cube, periodic in x and y, at the centres of cells.
///
/// In a row, waves with the same frequency along x are one sine and one cosine. A row thus costs
/// few multiplications for each sample, however many waves there are, as the sines along each axis
/// lie in tables.
class WaveField
{
public:
  /// \param dimensions  cells along each axis
  /// \param frequencies along x that waves may have; other waves get the nearest of these
  /// \param seed        of random numbers
  WaveField(const glm::ivec3& dimensions, const std::vector<int>& frequencies,
    const std::vector<Octave>& octaves, unsigned int seed);

  /// Numbers that Factors() writes: a multiple of four.
  std::size_t NumberOfFactors() const { return 2 * this->Frequencies; }

  /// Factors of the tables along x, for the row at y and z.
  void Factors(int y, int z, float* factors) const;

  /// Sum up a part of a row.
  /// \param factors of the row
  /// \param first   position of the part's first sample
  /// \param count   samples of the part
  void Sum(const float* factors, std::size_t first, std::size_t count, float* sums) const;

private:
  std::size_t Frequencies = 0; ///< their number; even
  std::size_t Waves = 0;
  std::size_t Cells = 0;              ///< along x
  std::vector<std::size_t> FirstWave; ///< of each frequency, and the end
  std::vector<float> AlongX;          ///< cosine and sine of each frequency, `Cells` samples each
  std::vector<float> AlongY, AlongZ;  ///< for each cell: cosines of all waves, then sines
};

#endif
