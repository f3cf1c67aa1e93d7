// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KnotFit_h
#define TemporalCoherence_KnotFit_h

#include "Lattice/CellRoot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace TemporalCoherence
{

/// A point of the function from progress to the distance at which a ray first reaches it.
struct Knot
{
  double Progress, Distance;
};

/// Fits the distance at which one ray first reaches each progress by a piecewise linear function,
/// within a tolerance.
///
/// Two knots with equal progress mark a jump: progress falls behind the first knot, and returns to
/// its value at the second. No piece crosses a jump. Half of the tolerance covers replacing curves
/// by chords, half covers joining chords into longer pieces: a growing piece maintains the cone of
/// slopes that pass all its chord ends closely enough.
///
/// A look-up knows progress only to a resolution. It cannot use points within the resolution,
/// unless their distances are close, too. So a chord that gains less progress than the resolution
/// is not halved: look-ups do not use a long chord of this kind. Hence the resolution bounds the
/// number of knots of a ray, whatever the tolerance.
class KnotFit
{
public:
  /// The requirements of a fit.
  struct Wanted
  {
    double Floor;      ///< the function is not needed below this progress
    double Tolerance;  ///< largest error of a distance
    double Resolution; ///< differences of progress that a look-up cannot distinguish
  };

  /// Continue through a cell.
  /// \param cubic     progress along the way from `enter` to `leave`, by Bernstein coefficients
  /// \param wanted    see Wanted
  /// \param emit      called with each knot that is final
  template <typename Emit>
  void Follow(
    const Cubic<double>& cubic, double enter, double leave, const Wanted& wanted, const Emit& emit)
  {
    const double floor = wanted.Floor;
    if (!this->HasBegun)
    {
      this->Reached = cubic[0];
      this->HasBegun = true;
    }
    int count = 0;
    const std::array<double, 2> turns = TurningPoints(cubic, count);
    double begin = 0.0;
    for (int piece = 0; piece <= count; ++piece)
    {
      const double end = piece < count ? turns[static_cast<std::size_t>(piece)] : 1.0;
      const double highest = Evaluate(cubic, end);
      if (highest > this->Reached)
      {
        // Only the part above the highest progress so far.
        const double lowest = std::max(this->Reached, floor);
        const double from = Evaluate(cubic, begin) < lowest && highest > lowest
          ? CrossingOf(cubic, lowest, begin, end)
          : begin;
        this->Reached = highest;
        if (highest > floor)
        {
          const double length = leave - enter;
          this->Begin({ std::max(lowest, Evaluate(cubic, from)), enter + from * length }, emit);
          this->Add({ cubic, enter, length }, from, end, wanted, MostHalvings, emit);
        }
      }
      begin = end;
    }
  }

  /// The ray has ended.
  template <typename Emit>
  void Finish(const Emit& emit)
  {
    if (this->HasEnd)
    {
      emit(this->End);
    }
    this->HasPiece = this->HasEnd = false;
  }

private:
  /// Most halvings of a way: more of them make no difference in double precision.
  static constexpr int MostHalvings = 40;

  /// Begin a rising way at a knot, unless it continues the present piece.
  template <typename Emit>
  void Begin(const Knot& knot, const Emit& emit)
  {
    const Knot last = this->HasEnd ? this->End : this->First;
    const double slack = 1e-9 * std::abs(knot.Distance);
    if (this->HasPiece && knot.Distance <= last.Distance + slack)
    {
      return;
    }
    const Knot start{ this->HasPiece ? last.Progress : knot.Progress, knot.Distance };
    this->Finish(emit);
    emit(start);
    this->BeginPiece(start);
  }

  void BeginPiece(const Knot& knot)
  {
    this->First = knot;
    this->HasPiece = true;
    this->HasEnd = false;
    this->LowestSlope = -std::numeric_limits<double>::infinity();
    this->HighestSlope = std::numeric_limits<double>::infinity();
  }

  /// A way through a cell.
  struct Way
  {
    const Cubic<double>& Progress;
    double Enter, Length;
  };

  /// Add the rising part [begin, end] of a way, in halves if it is too curved for one chord.
  template <typename Emit>
  void Add(
    const Way& way, double begin, double end, const Wanted& wanted, int halvings, const Emit& emit)
  {
    if (halvings > 0 && IsTooCurved(way, begin, end, wanted))
    {
      const double middle = 0.5 * (begin + end);
      this->Add(way, begin, middle, wanted, halvings - 1, emit);
      this->Add(way, middle, end, wanted, halvings - 1, emit);
      return;
    }
    this->Append(
      { Evaluate(way.Progress, end), way.Enter + end * way.Length }, 0.5 * wanted.Tolerance, emit);
  }

  /// True if a part of a way must be halved.
  static bool IsTooCurved(const Way& way, double begin, double end, const Wanted& wanted)
  {
    const double length = (end - begin) * way.Length;
    if (!(length > 0.5 * wanted.Tolerance))
    {
      return false;
    }
    const Cubic<double> part = PartOf(way.Progress, begin, end);
    const double gained = part[3] - part[0];
    // Joined with others, a shorter chord may become part of a piece steep enough to be used.
    const bool isOfUse = gained > wanted.Resolution || length < 2.0 * wanted.Tolerance;
    return isOfUse && ErrorOfChord(part, gained, length) > 0.5 * wanted.Tolerance;
  }

  /// Append the end of a chord to the present piece, or to a new one if the piece would bend too
  /// much.
  template <typename Emit>
  void Append(const Knot& knot, double tolerance, const Emit& emit)
  {
    double gained = knot.Progress - this->First.Progress;
    double slope = (knot.Distance - this->First.Distance) / gained;
    const bool isStraight =
      gained > 0.0 && this->LowestSlope <= slope && slope <= this->HighestSlope;
    if (!isStraight && this->HasEnd)
    {
      emit(this->End);
      this->BeginPiece(this->End);
      gained = knot.Progress - this->First.Progress;
    }
    if (gained > 0.0)
    {
      const double way = knot.Distance - this->First.Distance;
      this->LowestSlope = std::max(this->LowestSlope, (way - tolerance) / gained);
      this->HighestSlope = std::min(this->HighestSlope, (way + tolerance) / gained);
    }
    this->End = knot;
    this->HasEnd = true;
  }

  /// Bound of the distance between a cubic and the chord of its ends. Their difference is also a
  /// cubic, and lies within the range of its coefficients.
  static double ErrorOfChord(const Cubic<double>& part, double gained, double length)
  {
    if (!(gained > 0.0))
    {
      return length;
    }
    const double first = 1.0 / 3.0 - (part[1] - part[0]) / gained;
    const double second = 2.0 / 3.0 - (part[2] - part[0]) / gained;
    return std::max(std::abs(first), std::abs(second)) * length;
  }

  /// A part of a cubic, by its polar form.
  static Cubic<double> PartOf(const Cubic<double>& b, double begin, double end)
  {
    const auto polar = [&b](double u, double v, double w)
    {
      const double q0 = Mix(b[0], b[1], u), q1 = Mix(b[1], b[2], u), q2 = Mix(b[2], b[3], u);
      return Mix(Mix(q0, q1, v), Mix(q1, q2, v), w);
    };
    return { polar(begin, begin, begin), polar(begin, begin, end), polar(begin, end, end),
      polar(end, end, end) };
  }

  /// Where a rising part of a cubic reaches a value.
  static double CrossingOf(const Cubic<double>& cubic, double value, double begin, double end)
  {
    const Cubic<double> above = { cubic[0] - value, cubic[1] - value, cubic[2] - value,
      cubic[3] - value };
    return RefineCrossing(above, begin, end);
  }

  bool HasBegun = false;
  double Reached = 0.0; ///< highest progress so far
  Knot First{};         ///< of the present piece
  Knot End{};           ///< end of the present piece so far, if it has one
  bool HasPiece = false, HasEnd = false;
  double LowestSlope = 0.0, HighestSlope = 0.0; ///< of distance over progress
};

}

#endif
