// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_EmissionArcs_h
#define TemporalCoherence_EmissionArcs_h

#include "Blending/TransferTables.h"

#include <array>
#include <cstddef>
#include <vector>

namespace TemporalCoherence
{

struct EmissionArc;

/// The emission of a transfer function, cut into arcs: ranges of values over which
/// extinction and colours are cubic polynomials, as far as can be seen. Within an arc, a few places
/// of a ray tell the integral along it. Each arc reaches as far as it fits, so that its ends lie
/// where the function bends.
///
/// Values are counted in bins (TransferTables). In an arc, extinction (channel 0) and the colours
/// that it emits (channels 1 to 3) are sums of Powers[channel][i] x^i, where x = (value - Middle) *
/// PerValue goes from -1 to 1.
struct EmissionArcs
{
  /// \param tolerance how far extinction may be off where there is little of it, per world distance
  /// \throws std::bad_alloc
  EmissionArcs(const TransferTables& tables, double tolerance);

  /// The arc of a value, which is a number.
  std::size_t ArcOf(float value) const;

  /// True if something is opaque at once in these arcs: no polynomial tells what they look like.
  bool AreRough(std::size_t first, std::size_t last) const
  {
    return this->RoughBefore[last + 1] != this->RoughBefore[first];
  }

  std::size_t Count = 0;

  /// One number for each arc, by ascending values, and zeros behind them: kernels load two of their
  /// widest vectors.
  using Column = std::vector<float>;
  Column Low, High; ///< their ends; the first and the last arc have none
  Column Precision; ///< how far a value may be off their end where a ray is taken to leave them
  Column Middle, PerValue;
  std::array<std::array<Column, 4>, 4> Powers; ///< [channel][power]
  Column AreEmpty;                             ///< 1 where nothing is emitted, else 0

private:
  void Add(const EmissionArc& arc);
  /// Once all are added.
  void Finish();

  std::vector<int> RoughBefore{ 0 }; ///< how many arcs before each are rough
};

}

#endif
