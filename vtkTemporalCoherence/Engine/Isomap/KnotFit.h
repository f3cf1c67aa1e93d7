// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KnotFit_h
#define TemporalCoherence_KnotFit_h

#include "Isomap/KnotGrid.h"
#include "Lattice/CellRoot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace TemporalCoherence
{

/// Distances of the function itself, in steps: not rounded, and not fitted.
struct KnotPlaces
{
  double Knot = 0.0;   ///< where it has the progress of a knot
  double Middle = 0.0; ///< half way in progress from the knot before; that of the knot behind jumps
};

/// Fits the distance at which one ray first reaches each progress by a piecewise linear function
/// with knots on a KnotGrid, within the tolerance.
///
/// Two knots with equal progress mark a jump: progress falls behind the first knot, and returns to
/// its value at the second. No piece crosses a jump.
///
/// The curves along a ray become chords first. A piece begins at a knot and takes in the ends of
/// chords as long as a cone of slopes passes all of them closely enough. Then it ends in its last
/// part, at the progress that is divisible by the highest power of two. So knots of neighbouring
/// rays mostly have the same progress, and files of them are small.
///
/// What rises by less progress than a step counts as a jump. So the grid bounds the number of knots
/// of a ray, whatever the tolerance.
class KnotFit
{
public:
  /// Largest distance between the function and its fit, in steps.
  static constexpr double LargestError = 0.9 * KnotGrid::StepsOfTolerance;

  /// Continue through a cell.
  /// \param cubic        progress in steps along the way from `enter` to `leave`, by Bernstein
  ///                     coefficients
  /// \param enter, leave distances from where the ray begins, in steps
  /// \param largest      progress at which the fit ends, in steps
  /// \param emit         called with each knot that is final, and with its KnotPlaces
  template <typename Emit>
  void Follow(
    const Cubic<double>& cubic, double enter, double leave, double largest, const Emit& emit)
  {
    this->Largest = largest;
    if (!this->HasBegun)
    {
      this->Reached = std::max(cubic[0], 0.0);
      this->HasBegun = true;
    }
    int count = 0;
    const std::array<double, 2> turns = TurningPoints(cubic, count);
    double begin = 0.0;
    for (int part = 0; part <= count; ++part)
    {
      const double end = part < count ? turns[static_cast<std::size_t>(part)] : 1.0;
      this->Rise({ cubic, enter, leave - enter }, begin, end, emit);
      begin = end;
    }
  }

  /// The ray has ended.
  template <typename Emit>
  void Finish(const Emit& emit)
  {
    this->EndAtLast(emit);
    if (this->EndsPiece)
    {
      emit(this->Start, this->Places);
    }
  }

private:
  /// Most halvings of a way: more of them make no difference in double precision.
  static constexpr int MostHalvings = 40;
  /// Largest error of a chord, in steps.
  static constexpr double ChordError = 0.2;
  /// Largest error of a piece at the ends of chords. Knots are rounded to whole steps.
  static constexpr double PieceError = LargestError - ChordError - 0.5;
  /// Round progress for a knot is sought in this last part of a piece.
  static constexpr double LastPart = 0.4;

  /// A way through a cell.
  struct Way
  {
    const Cubic<double>& Progress;
    double Enter, Length;

    double At(double share) const { return this->Enter + share * this->Length; }
  };

  /// The end of a chord.
  struct Point
  {
    double Progress, Distance;
  };

  /// Continue through a part of a cell between turning points.
  template <typename Emit>
  void Rise(const Way& way, double begin, double end, const Emit& emit)
  {
    // Only the part above the highest progress so far.
    const double lowest = this->Reached, highest = Evaluate(way.Progress, end);
    if (!(highest > lowest) || lowest >= this->Largest)
    {
      return;
    }
    this->Reached = highest;
    const double first = Evaluate(way.Progress, begin);
    const double from = first < lowest ? CrossingOf(way.Progress, lowest, begin, end) : begin;
    // What is leapt over is not bridged, however large the tolerance: a cell's length ends a piece.
    constexpr double rounding = 0.01;
    const double bridged = std::min(PieceError, std::max(way.Length, rounding));
    this->Begin({ std::max(lowest, first), way.At(from) }, bridged, emit);
    if (first < this->Largest)
    {
      const double to =
        highest > this->Largest ? CrossingOf(way.Progress, this->Largest, from, end) : end;
      this->AddChords(way, from, to, MostHalvings, emit);
    }
  }

  /// Begin a rising way at a point: behind a jump, or going on.
  /// \param bridged largest gap that is no jump
  template <typename Emit>
  void Begin(const Point& point, double bridged, const Emit& emit)
  {
    if (!this->HasStart)
    {
      this->Start = { Nearest(point.Progress), NearestDistance(point.Distance) };
      this->Places = { point.Distance, point.Distance };
      this->HasStart = true;
    }
    else if (point.Distance - this->LastDistance > bridged)
    {
      this->EndAtLast(emit);
      this->Jump(point.Distance, emit);
    }
  }

  /// Add the rising part [begin, end] of a way, in halves if it is too curved for one chord.
  template <typename Emit>
  void AddChords(const Way& way, double begin, double end, int halvings, const Emit& emit)
  {
    if (halvings > 0 && IsTooCurved(way, begin, end))
    {
      const double middle = 0.5 * (begin + end);
      this->AddChords(way, begin, middle, halvings - 1, emit);
      this->AddChords(way, middle, end, halvings - 1, emit);
      return;
    }
    this->LastDistance = way.At(end);
    this->Points.push_back({ Evaluate(way.Progress, end), this->LastDistance });
    while (this->Taken < this->Points.size())
    {
      this->TakeNext(emit);
    }
  }

  /// True if a part of a way must be halved.
  static bool IsTooCurved(const Way& way, double begin, double end)
  {
    const double length = (end - begin) * way.Length;
    if (!(length > ChordError))
    {
      return false;
    }
    const Cubic<double> part = PartOf(way.Progress, begin, end);
    const double gained = part[3] - part[0];
    return gained > 0.5 && ErrorOfChord(part, gained, length) > ChordError;
  }

  /// Take the next point into the present piece, or end the piece before it.
  template <typename Emit>
  void TakeNext(const Emit& emit)
  {
    const Point point = this->Points[this->Taken];
    const double gained = point.Progress - this->Start.Progress;
    const double way = point.Distance - this->Start.Distance;
    if (!(gained > 0.0))
    {
      if (way > PieceError)
      {
        this->Jump(point.Distance, emit);
      }
      ++this->Taken;
      return;
    }
    const double lowest = std::max(this->LowestSlope, (way - PieceError) / gained);
    const double highest = std::min(this->HighestSlope, (way + PieceError) / gained);
    if (lowest <= highest)
    {
      this->LowestSlope = lowest;
      this->HighestSlope = highest;
      ++this->Taken;
      return;
    }
    this->EndBefore(point, emit);
  }

  /// End the present piece before a point that it cannot take in.
  /// \pre it has taken one in that has more progress than its start
  template <typename Emit>
  void EndBefore(const Point& next, const Emit& emit)
  {
    const Point last = this->Points[this->Taken - 1];
    const auto highest = static_cast<std::uint32_t>(last.Progress);
    if (highest <= this->Start.Progress)
    {
      // It rises by less than a step.
      this->Jump(last.Distance, emit);
      this->Drop(this->Taken);
      return;
    }
    // Up to where it is steep, else to a round progress.
    const bool isSteep = next.Progress - last.Progress < 1.0;
    const double share = LastPart * (last.Progress - this->Start.Progress);
    const auto lowest = static_cast<std::uint32_t>(last.Progress - share);
    this->EndAt(isSteep ? highest : Roundest(lowest, highest), emit);
  }

  /// End the present piece at its last point.
  template <typename Emit>
  void EndAtLast(const Emit& emit)
  {
    if (!this->Points.empty())
    {
      this->EndAt(Nearest(this->Points.back().Progress), emit);
    }
    this->Drop(this->Points.size());
  }

  /// End the present piece at a progress. The next one begins there.
  template <typename Emit>
  void EndAt(std::uint32_t progress, const Emit& emit)
  {
    std::size_t behind = 0;
    while (behind < this->Points.size() && this->Points[behind].Progress <= progress)
    {
      ++behind;
    }
    if (progress > this->Start.Progress)
    {
      emit(this->Start, this->Places);
      const double middle = 0.5 * (this->Start.Progress + progress);
      this->Places = { this->PlaceOf(progress), this->PlaceOf(middle) };
      const double slope = std::max(0.5 * (this->LowestSlope + this->HighestSlope), 0.0);
      this->Start = { static_cast<std::uint16_t>(progress),
        NearestDistance(this->Start.Distance + slope * (progress - this->Start.Progress)) };
      this->EndsPiece = true;
    }
    this->Drop(behind);
  }

  /// Where the function has a progress.
  double PlaceOf(double progress) const
  {
    const auto behind = static_cast<std::size_t>(
      std::find_if(this->Points.begin(), this->Points.end(),
        [progress](const Point& point) { return point.Progress > progress; }) -
      this->Points.begin());
    const Point before = behind > 0
      ? this->Points[behind - 1]
      : Point{ static_cast<double>(this->Start.Progress), this->Places.Knot };
    if (behind == this->Points.size())
    {
      return before.Distance;
    }
    const Point& next = this->Points[behind];
    const double share = (progress - before.Progress) / (next.Progress - before.Progress);
    return Mix(before.Distance, next.Distance, share);
  }

  /// The function jumps to a distance at the present start.
  template <typename Emit>
  void Jump(double distance, const Emit& emit)
  {
    if (this->EndsPiece)
    {
      emit(this->Start, this->Places);
      this->EndsPiece = false;
    }
    this->Start.Distance = NearestDistance(distance);
    this->Places = { distance, distance };
  }

  /// Forget the first points, and begin a piece.
  void Drop(std::size_t points)
  {
    this->Points.erase(
      this->Points.begin(), this->Points.begin() + static_cast<std::ptrdiff_t>(points));
    this->Taken = 0;
    this->LowestSlope = -std::numeric_limits<double>::infinity();
    this->HighestSlope = std::numeric_limits<double>::infinity();
  }

  std::uint16_t Nearest(double progress) const
  {
    return static_cast<std::uint16_t>(std::min(std::max(progress, 0.0), this->Largest) + 0.5);
  }
  static std::uint32_t NearestDistance(double distance)
  {
    return static_cast<std::uint32_t>(std::max(distance, 0.0) + 0.5);
  }

  /// The number in lowest + 1 .. highest that the highest power of two divides.
  static std::uint32_t Roundest(std::uint32_t lowest, std::uint32_t highest)
  {
    std::uint32_t number = highest;
    while ((number & (number - 1)) > lowest)
    {
      number &= number - 1;
    }
    return number;
  }

  /// Bound of the distance between a cubic and the chord of its ends. Their difference is also a
  /// cubic, and lies within the range of its coefficients.
  static double ErrorOfChord(const Cubic<double>& part, double gained, double length)
  {
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

  double Largest = 0.0; ///< progress
  bool HasBegun = false;
  double Reached = 0.0; ///< highest progress so far, from 0
  bool HasStart = false;
  Knot Start{}; ///< of the present piece; it is not emitted yet
  KnotPlaces Places;
  bool EndsPiece = false; ///< it ends the piece before, too
  /// Ends of chords behind Start, the first of which are in the present piece.
  std::vector<Point> Points;
  std::size_t Taken = 0;
  double LastDistance = 0.0; ///< of the last chord
  /// Of the lines from Start that pass the taken points, in steps of distance by steps of progress.
  double LowestSlope = -std::numeric_limits<double>::infinity();
  double HighestSlope = std::numeric_limits<double>::infinity();
};

}

#endif
