// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Beams/EmissionArcs.h"

#include "Scene/RayBatch.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace TemporalCoherence
{

using Polynomial = std::array<double, 4>;

/// One arc, before EmissionArcs stores it in columns.
struct EmissionArc
{
  float Low, High;
  double Middle, PerValue;
  std::array<Polynomial, 4> Channels;
  bool IsEmpty, IsRough;
};

namespace
{

/// Stands for infinity at the ends of unbounded arcs.
constexpr float Beyond = 1e35f;

/// Relative error of extinction, where it exceeds the absolute tolerance: opacities err by less
/// than 0.4 of it. The error of colours is smaller, as one colour may fill a picture.
constexpr double ShareOff = 1.0 / 128.0, ColorOff = 1.0 / 400.0;

/// Small extinctions reduce the tolerance to this share of the extinction, but at most to a
/// sixteenth of the tolerance.
constexpr double ShareOffThin = 1.0 / 24.0;

/// Error of a ray's value at the end of an arc, as a share of the narrowest of the arc and its
/// neighbours.
constexpr float PrecisionOfArc = 0.02f;

/// Arcs of a transfer function, at most. The range behind the last arc counts as rough.
constexpr std::size_t MostArcsOfFunction = 256;

/// Samples of an arc in the first, coarse test of its fit.
constexpr int FewSamples = 16;

/// Chebyshev nodes, where arcs interpolate the function: they spread the error evenly.
constexpr std::array<double, 4> MeetingPlaces = { -0.92387953251, -0.38268343236, 0.38268343236,
  0.92387953251 };

/// The cubic with these values at the meeting places.
Polynomial PolynomialThrough(const std::array<double, 4>& values)
{
  std::array<double, 4> differences = values;
  for (std::size_t order = 1; order < 4; ++order)
  {
    for (std::size_t i = 3; i >= order; --i)
    {
      differences[i] =
        (differences[i] - differences[i - 1]) / (MeetingPlaces[i] - MeetingPlaces[i - order]);
    }
  }
  // From Newton's form to powers.
  Polynomial made{};
  for (std::size_t i = 4; i-- > 0;)
  {
    for (std::size_t power = 3; power > 0; --power)
    {
      made[power] = made[power - 1] - MeetingPlaces[i] * made[power];
    }
    made[0] = differences[i] - MeetingPlaces[i] * made[0];
  }
  return made;
}

double ValueOf(const Polynomial& of, double x)
{
  return of[0] + x * (of[1] + x * (of[2] + x * of[3]));
}

/// A value: a bin, and a share of this bin.
struct PlaceInBin
{
  int Bin;
  double Share;
};

/// Emission over bins.
class BinnedEmission
{
public:
  explicit BinnedEmission(const TransferTables& tables)
    : Tables(tables)
  {
  }

  /// Extinction, or the colour of a channel.
  double At(const PlaceInBin& place, std::size_t channel) const
  {
    const EmissionBin& in = this->Of(place.Bin);
    const auto at = [&](std::size_t i)
    { return static_cast<double>(in.Value[i]) + place.Share * static_cast<double>(in.Rise[i]); };
    const double extinction = at(0), rise = static_cast<double>(in.Rise[0]);
    if (channel == 0)
    {
      return extinction;
    }
    // At the foot of a ramp, take the limit of the colour.
    return extinction > 0.0 ? at(channel) / extinction
      : rise > 0.0          ? static_cast<double>(in.Rise[channel]) / rise
                            : 0.0;
  }

  bool IsEmpty(int bin) const
  {
    const EmissionBin& in = this->Of(bin);
    return in.Value[0] == 0.0f && in.Rise[0] == 0.0f;
  }

  /// True if a bin holds an opaque value.
  bool IsRough(int bin) const { return this->Tables.IsOpaqueIn(static_cast<std::size_t>(bin)); }

private:
  const EmissionBin& Of(int bin) const { return this->Tables.All[static_cast<std::size_t>(bin)]; }

  const TransferTables& Tables;
};

/// Fits the longest possible arcs to the emission.
class ArcFitter
{
public:
  ArcFitter(const BinnedEmission& emission, int bins, double tolerance)
    : Emission(emission)
    , Bins(bins)
    , Tolerance(tolerance)
  {
  }

  /// The longest arc that begins with a bin.
  EmissionArc LongestFrom(int begin) const
  {
    const bool isEmpty = this->Emission.IsEmpty(begin), isRough = this->Emission.IsRough(begin);
    if (isEmpty || isRough)
    {
      int end = begin + 1;
      while (end < this->Bins && this->Emission.IsEmpty(end) == isEmpty &&
        this->Emission.IsRough(end) == isRough)
      {
        ++end;
      }
      return this->ArcOver(begin, end);
    }
    // Search the longest arc by the coarse test, then shrink it until every bin fits. A single bin
    // always fits.
    int fits = 1, fails = this->Bins - begin + 1;
    while (fits + 1 < fails)
    {
      const int length = std::min(2 * fits, (fits + fails) / 2);
      const bool isGood =
        this->Fits(this->ArcOver(begin, begin + length), std::max(length / FewSamples, 1));
      (isGood ? fits : fails) = length;
    }
    while (fits > 1 && !this->Fits(this->ArcOver(begin, begin + fits), 1))
    {
      fits = std::max(fits * 3 / 4, 1);
    }
    return this->ArcOver(begin, begin + fits);
  }

  /// The constant arc below the first bin, or above the last one.
  EmissionArc ConstantAt(int bin, float low, float high) const
  {
    EmissionArc arc{};
    arc.Low = low;
    arc.High = high;
    for (std::size_t channel = 0; channel < 4; ++channel)
    {
      arc.Channels[channel][0] = this->Emission.At({ bin, 0.0 }, channel);
    }
    arc.IsEmpty = arc.Channels[0][0] == 0.0;
    arc.IsRough = this->Emission.IsRough(bin);
    return arc;
  }

private:
  EmissionArc ArcOver(int begin, int end) const
  {
    EmissionArc arc{};
    arc.Low = static_cast<float>(begin);
    arc.High = static_cast<float>(end);
    arc.Middle = 0.5 * (begin + end);
    arc.PerValue = 2.0 / (end - begin);
    arc.IsEmpty = this->Emission.IsEmpty(begin);
    arc.IsRough = this->Emission.IsRough(begin);
    for (std::size_t channel = 0; channel < 4; ++channel)
    {
      std::array<double, 4> values{};
      for (std::size_t i = 0; i < 4; ++i)
      {
        const double at = arc.Middle + MeetingPlaces[i] / arc.PerValue;
        const int bin = std::clamp(static_cast<int>(at), begin, end - 1);
        values[i] = this->Emission.At({ bin, at - bin }, channel);
      }
      arc.Channels[channel] = PolynomialThrough(values);
    }
    return arc;
  }

  /// \param stride from one tested bin to the next
  bool Fits(const EmissionArc& arc, int stride) const
  {
    const int begin = static_cast<int>(arc.Low), end = static_cast<int>(arc.High);
    for (int bin = begin; bin < end; bin += stride)
    {
      if (this->Emission.IsEmpty(bin) || this->Emission.IsRough(bin))
      {
        return false;
      }
      if (!this->FitsAt(arc, { bin, 0.0 }) || !this->FitsAt(arc, { bin, 0.5 }))
      {
        return false;
      }
    }
    return this->FitsAt(arc, { end - 1, 1.0 });
  }

  bool FitsAt(const EmissionArc& arc, const PlaceInBin& place) const
  {
    const double x = (place.Bin + place.Share - arc.Middle) * arc.PerValue;
    const double extinction = this->Emission.At(place, 0);
    for (std::size_t channel = 0; channel < 4; ++channel)
    {
      // Thin fog adds up along a ray.
      const double thin =
        std::clamp(ShareOffThin * extinction, this->Tolerance / 16.0, this->Tolerance);
      const double most = channel > 0 ? ColorOff : std::max(thin, ShareOff * extinction);
      const double off = ValueOf(arc.Channels[channel], x) - this->Emission.At(place, channel);
      if (!(std::abs(off) <= most))
      {
        return false;
      }
    }
    return true;
  }

  const BinnedEmission& Emission;
  int Bins;
  double Tolerance;
};

}

EmissionArcs::EmissionArcs(const TransferTables& tables, double tolerance)
{
  const BinnedEmission emission(tables);
  const ArcFitter fitter(emission, tables.Bins, tolerance);
  // Merge neighbours that are both empty, or both rough.
  EmissionArc last = fitter.ConstantAt(0, -Beyond, 0.0f);
  const auto add = [&](const EmissionArc& arc)
  {
    if ((arc.IsEmpty && last.IsEmpty) || (arc.IsRough && last.IsRough))
    {
      last.High = arc.High;
      return;
    }
    this->Add(last);
    last = arc;
  };
  int begin = 0;
  while (begin < tables.Bins && this->Count < MostArcsOfFunction)
  {
    const EmissionArc arc = fitter.LongestFrom(begin);
    add(arc);
    begin = static_cast<int>(arc.High);
  }
  EmissionArc above = fitter.ConstantAt(tables.Bins, static_cast<float>(begin), Beyond);
  if (begin < tables.Bins)
  {
    above.IsEmpty = false;
    above.IsRough = true;
  }
  add(above);
  this->Add(last);
  this->Finish();
}

void EmissionArcs::Add(const EmissionArc& arc)
{
  ++this->Count;
  this->Low.push_back(arc.Low);
  this->High.push_back(arc.High);
  this->Middle.push_back(static_cast<float>(arc.Middle));
  this->PerValue.push_back(static_cast<float>(arc.PerValue));
  for (std::size_t channel = 0; channel < 4; ++channel)
  {
    for (std::size_t power = 0; power < 4; ++power)
    {
      const double factor = arc.Channels[channel][power];
      this->Powers[channel][power].push_back(static_cast<float>(factor));
    }
  }
  this->AreEmpty.push_back(arc.IsEmpty ? 1.0f : 0.0f);
  this->RoughBefore.push_back(this->RoughBefore.back() + (arc.IsRough ? 1 : 0));
}

void EmissionArcs::Finish()
{
  for (std::size_t arc = 0; arc < this->Count; ++arc)
  {
    float narrowest = Beyond;
    for (std::size_t i = arc > 0 ? arc - 1 : 0; i < std::min(arc + 2, this->Count); ++i)
    {
      narrowest = std::min(narrowest, this->High[i] - this->Low[i]);
    }
    this->Precision.push_back(PrecisionOfArc * narrowest);
  }
  const std::size_t size = std::max(this->Count, 2 * WidestVector);
  for (Column* const column :
    { &this->Low, &this->High, &this->Precision, &this->Middle, &this->PerValue, &this->AreEmpty })
  {
    column->resize(size, 0.0f);
  }
  for (auto& channel : this->Powers)
  {
    for (Column& column : channel)
    {
      column.resize(size, 0.0f);
    }
  }
}

std::size_t EmissionArcs::ArcOf(float value) const
{
  const auto first = this->Low.begin();
  const auto above =
    std::upper_bound(first + 1, first + static_cast<std::ptrdiff_t>(this->Count), value);
  return static_cast<std::size_t>(above - first) - 1;
}

}
