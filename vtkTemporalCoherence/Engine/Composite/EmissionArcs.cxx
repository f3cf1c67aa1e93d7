// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Composite/EmissionArcs.h"

#include "Scene/RayBatch.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace TemporalCoherence
{

using Polynomial = std::array<double, 4>;

/// An arc on its own.
struct EmissionArc
{
  float Low, High;
  double Middle, PerValue;
  std::array<Polynomial, 4> Channels;
  bool IsEmpty, IsRough;
};

namespace
{

/// An end that no value comes to.
constexpr float Beyond = 1e35f;

/// Extinction may be off by this share, if that is more than the tolerance: opacities are then off
/// by less than 0.4 of it. Colours may be off by less, as all of a picture may have one of them.
constexpr double ShareOff = 1.0 / 128.0, ColorOff = 1.0 / 400.0;

/// Where extinction is small, the tolerance is this share of it, but not less than a sixteenth.
constexpr double ShareOffThin = 1.0 / 24.0;

/// The share of an arc that rays may be off where they leave it or the arc behind.
constexpr float PrecisionOfArc = 0.02f;

/// A function with more arcs bends too often for them: all that follows counts as rough.
constexpr std::size_t MostArcsOfFunction = 256;

/// How many samples tell at first whether an arc fits.
constexpr int FewSamples = 16;

/// Where arcs meet the function: the places of Chebyshev, at which errors even out.
constexpr std::array<double, 4> MeetingPlaces = { -0.92387953251, -0.38268343236, 0.38268343236,
  0.92387953251 };

/// The polynomial that has these values at the meeting places.
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

/// A place of a transfer function.
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
    // Where a ramp begins, the colour is that just behind.
    return extinction > 0.0 ? at(channel) / extinction
      : rise > 0.0          ? static_cast<double>(in.Rise[channel]) / rise
                            : 0.0;
  }

  bool IsEmpty(int bin) const
  {
    const EmissionBin& in = this->Of(bin);
    return in.Value[0] == 0.0f && in.Rise[0] == 0.0f;
  }

  /// True where something is opaque at once.
  bool IsRough(int bin) const { return this->Tables.IsOpaqueIn(static_cast<std::size_t>(bin)); }

private:
  const EmissionBin& Of(int bin) const { return this->Tables.All[static_cast<std::size_t>(bin)]; }

  const TransferTables& Tables;
};

/// Finds out how far arcs reach.
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
    // As far as a few samples allow, then less until all do. One bin always fits.
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

  /// What lies beyond the first or the last bin: all as there.
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

  /// \param stride between the bins that are looked at
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
  // Neighbours that are both empty, or both rough, are one arc.
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
