// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_EmissionArcs_h
#define TemporalCoherence_EmissionArcs_h

#include "Volumes/Medium/TransferTables.h"

#include <array>
#include <cstddef>
#include <vector>

namespace TemporalCoherence
{

struct EmissionArc;

/// A transfer function cut into arcs: ranges of values over which cubic polynomials approximate
/// extinction and colours within a visible tolerance. Within an arc, a few quadrature points give
/// the integral along a ray. Each arc is as long as its cubics fit, so that arcs end where the
/// function bends.
///
/// Values are counted in bins (TransferTables). In an arc, extinction (channel 0) and the colours
/// that it emits (channels 1 to 3) are sums of Powers[channel][i] x^i, where x = (value - Middle) *
/// PerValue goes from -1 to 1.
struct EmissionArcs
{
  /// \param tolerance error of small extinctions, per world distance
  /// \throws std::bad_alloc
  EmissionArcs(const TransferTables& tables, double tolerance);

  /// The arc that contains a value.
  /// \pre the value is not NaN
  std::size_t ArcOf(float value) const;

  /// True if an arc from first to last is rough: no polynomial fits it.
  bool AreRough(std::size_t first, std::size_t last) const
  {
    return this->RoughBefore[last + 1] != this->RoughBefore[first];
  }

  std::size_t Count = 0;

  /// One number for each arc, by ascending values. Zeros pad a column to two of the widest vectors,
  /// which kernels load.
  using Column = std::vector<float>;
  Column Low, High; ///< ends of the arcs; the first and the last arc are unbounded
  Column Precision; ///< tolerance of the value where a ray leaves an arc
  Column Middle, PerValue;
  std::array<std::array<Column, 4>, 4> Powers; ///< [channel][power]
  Column AreEmpty;                             ///< 1 where nothing is emitted, else 0

private:
  void Add(const EmissionArc& arc);
  /// Find Precision and pad the columns, after the last Add.
  void Finish();

  std::vector<int> RoughBefore{ 0 }; ///< number of rough arcs before each arc
};

}

#endif
