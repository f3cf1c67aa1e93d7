// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// Emission of stretches of rays with linear values. Kernels include this file once for each kind of
// vectors, hence the toggling guard.
#if defined(TemporalCoherence_KernelsStretch_inl_h) == defined(HWY_TARGET_TOGGLE)
#ifdef TemporalCoherence_KernelsStretch_inl_h
#undef TemporalCoherence_KernelsStretch_inl_h
#else
#define TemporalCoherence_KernelsStretch_inl_h
#endif

#include "Volumes/Medium/KernelsVectors-inl.h"
#include "Volumes/Medium/TransferTables.h"

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace EmissionKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// exp(-x) for x >= 0.
HWY_INLINE V ExpOfMinus(V x)
{
  const Floats d;
  const Integers di;
  const V bounded = hn::Min(x, hn::Set(d, 80.0f));
  const V whole = hn::Floor(hn::Add(hn::Mul(bounded, hn::Set(d, 1.44269504f)), hn::Set(d, 0.5f)));
  // The rest lies in [-ln 2 / 2, ln 2 / 2]. ln 2 is split, so that its product is exact.
  const V rest = hn::Sub(hn::Sub(hn::Mul(whole, hn::Set(d, 0.693359375f)), bounded),
    hn::Mul(whole, hn::Set(d, 2.12194440e-4f)));
  V sum = hn::Set(d, 1.0f / 720.0f);
  const float factors[] = { 1.0f / 120.0f, 1.0f / 24.0f, 1.0f / 6.0f, 0.5f, 1.0f, 1.0f };
  for (const float factor : factors)
  {
    sum = hn::Add(hn::Mul(sum, rest), hn::Set(d, factor));
  }
  const I exponent = hn::Sub(hn::Set(di, 127), hn::ConvertTo(di, whole));
  return hn::Mul(sum, hn::BitCast(d, hn::ShiftLeft<23>(exponent)));
}

/// exp(-x) for x in [0, 2], to six digits where x is small.
HWY_INLINE V ExpOfLittle(V x)
{
  const Floats d;
  const V quarter = hn::Mul(x, hn::Set(d, -0.25f));
  V sum = hn::Set(d, 1.0f / 120.0f);
  const float factors[] = { 1.0f / 24.0f, 1.0f / 6.0f, 0.5f, 1.0f, 1.0f };
  for (const float factor : factors)
  {
    sum = hn::Add(hn::Mul(sum, quarter), hn::Set(d, factor));
  }
  const V square = hn::Mul(sum, sum);
  return hn::Mul(square, square);
}

/// Emission at a value, and the integral of emission up to this value.
struct EmissionAt
{
  HWY_INLINE void Clear()
  {
    std::fill_n(this->Value, 4, hn::Zero(Floats()));
    std::fill_n(this->Sum, 4, hn::Zero(Floats()));
    std::fill_n(this->Order, 3, hn::Zero(Floats()));
    this->Moment = this->Boost = this->Walls = hn::Zero(Floats());
  }

  /// Take some lanes of another.
  HWY_INLINE void Take(M which, const EmissionAt& other)
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      this->Value[i] = hn::IfThenElse(which, other.Value[i], this->Value[i]);
      this->Sum[i] = hn::IfThenElse(which, other.Sum[i], this->Sum[i]);
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->Order[i] = hn::IfThenElse(which, other.Order[i], this->Order[i]);
    }
    this->Moment = hn::IfThenElse(which, other.Moment, this->Moment);
    this->Boost = hn::IfThenElse(which, other.Boost, this->Boost);
    this->Walls = hn::IfThenElse(which, other.Walls, this->Walls);
  }

  V Value[4], Sum[4], Moment, Order[3]; ///< see EmissionBin
  V Boost;                              ///< factor of Value for a stretch that stays at the value
  V Walls;                              ///< OpaqueBin::Walls
};

/// Look up Boost and Walls of a value.
/// \param isNode true where the value is the beginning of its bin
HWY_INLINE void LookUpOpaque(const TransferTables& tables, V bin, M isNode, EmissionAt& at)
{
  const Floats d;
  const Integers di;
  std::int32_t bins[WidestVector];
  float boosts[WidestVector], walls[WidestVector];
  hn::StoreU(hn::ConvertTo(di, bin), di, bins);
  for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
  {
    const OpaqueBin& opaque = tables.Opaque[static_cast<std::size_t>(bins[lane])];
    boosts[lane] = opaque.Boost;
    walls[lane] = opaque.Walls;
  }
  const V boost = hn::LoadU(d, boosts);
  at.Boost = hn::IfThenElse(isNode, boost, hn::Set(d, 1.0f));
  at.Walls = hn::LoadU(d, walls);
}

HWY_INLINE void LookUp(const TransferTables& tables, V value, EmissionAt& at)
{
  const Floats d;
  const Integers di;
  const V zero = hn::Zero(d), one = hn::Set(d, 1.0f), half = hn::Set(d, 0.5f);
  const V last = hn::Set(d, static_cast<float>(tables.Bins));
  const V bin = hn::Min(hn::Max(hn::Floor(value), zero), last);
  // The bin above the range has no width.
  const V inBin = hn::IfThenElseZero(hn::Lt(bin, last), hn::Sub(value, bin));
  const V share = hn::Min(hn::Max(inBin, zero), one);
  const V beyond = hn::Sub(hn::Sub(value, bin), share);
  constexpr std::int32_t row = 4, rows = sizeof(EmissionBin) / (row * sizeof(float));
  std::int32_t places[WidestVector];
  hn::StoreU(hn::Mul(hn::ConvertTo(di, bin), hn::Set(di, rows * row)), di, places);
  const float* const from = tables.All.front().Value.data();
  V rise[4], more[4];
  LoadRows(from, places, at.Value);
  LoadRows(from + row, places, rise);
  LoadRows(from + 2 * row, places, at.Sum);
  LoadRows(from + 3 * row, places, more);
  // Take the emission from the node to the value as concentrated half way.
  const V past = hn::Add(share, beyond);
  const V middle = hn::Add(bin, hn::Mul(half, past));
  at.Boost = one;
  at.Walls = zero;
  if (tables.AreOpaqueAnywhere)
  {
    LookUpOpaque(tables, bin, hn::Eq(share, zero), at);
  }
  // Values beyond the range look like its end. Smaller distances from the range may be rounding
  // errors.
  const V far = hn::Set(d, tables.Beyond);
  const V boost = hn::IfThenElse(hn::Gt(hn::Abs(beyond), far), at.Boost, one);
  V passed = zero;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const V mean = hn::Add(at.Value[i], hn::Mul(hn::Mul(half, share), rise[i]));
    const V here = hn::Mul(boost, hn::Add(at.Value[i], hn::Mul(share, rise[i])));
    const V emitted = hn::Mul(past, mean);
    if (i == 0)
    {
      at.Moment = hn::Add(more[0], hn::Mul(middle, emitted));
      passed = hn::Add(at.Sum[0], hn::Mul(half, emitted));
    }
    else
    {
      at.Order[i - 1] = hn::Add(more[i], hn::Mul(passed, emitted));
    }
    at.Value[i] = here;
    at.Sum[i] = hn::Add(at.Sum[i], hn::Add(hn::Mul(share, mean), hn::Mul(beyond, here)));
  }
}

/// The mean emission of a stretch with values from a to b.
/// \param lift mean value of the stretch minus the mean of a and b
HWY_INLINE void MeanBetween(const TransferTables& tables, V a, const EmissionAt& atA, V b,
  const EmissionAt& atB, V lift, V mean[4])
{
  const Floats d;
  const V one = hn::Set(d, 1.0f);
  const V difference = hn::Sub(b, a);
  // An opaque range between the values hides the rest, however fast values pass it.
  const M isBehind = hn::Ne(atA.Walls, atB.Walls);
  // The difference of close sums loses its digits.
  const M isClose = hn::AndNot(isBehind, hn::Lt(hn::Abs(difference), hn::Set(d, tables.Closest)));
  // Sums count opaque ranges only in part.
  const M isOpaque = hn::Gt(hn::Max(atA.Value[0], atB.Value[0]), hn::Set(d, tables.MostCounted));
  const V perBin = hn::Div(one, hn::IfThenElse(isClose, one, difference));
  const V lifted = hn::IfThenElseZero(hn::Not(isClose), lift);
  for (std::size_t i = 0; i < 4; ++i)
  {
    // Take the sums along the straight line with the same mean value.
    const V more = hn::Mul(lifted, hn::Sub(atB.Value[i], atA.Value[i]));
    const V far = hn::Mul(hn::Add(hn::Sub(atB.Sum[i], atA.Sum[i]), more), perBin);
    const V close = hn::Mul(hn::Set(d, 0.5f), hn::Add(atA.Value[i], atB.Value[i]));
    mean[i] = hn::Max(hn::IfThenElse(hn::Or(isClose, isOpaque), close, far), hn::Zero(d));
  }
  // A stretch that stays at a peak is opaque; a mere touch is not.
  const M stays = hn::And(hn::And(hn::Eq(a, b), hn::Eq(lift, hn::Zero(d))), hn::Not(isOpaque));
  V scale = hn::IfThenElse(stays, atA.Boost, one);
  const V toMost = hn::Div(hn::Set(d, tables.MostExtinction), hn::Max(mean[0], hn::Set(d, 1e-20f)));
  scale = hn::IfThenElse(isBehind, hn::Max(one, toMost), scale);
  for (std::size_t i = 0; i < 4; ++i)
  {
    mean[i] = hn::Mul(mean[i], scale);
  }
}

/// The standard deviation of the place of emission in a step, as a share of the step, for linear
/// extinction.
HWY_INLINE V SpreadOf(const EmissionAt& atA, const EmissionAt& atB)
{
  const Floats d;
  const V sum = hn::Add(hn::Add(atA.Value[0], atB.Value[0]), hn::Set(d, 1e-20f));
  const V slope = hn::Div(hn::Sub(atB.Value[0], atA.Value[0]), sum);
  return hn::Sqrt(
    hn::Sub(hn::Set(d, 1.0f / 12.0f), hn::Mul(hn::Mul(slope, slope), hn::Set(d, 1.0f / 36.0f))));
}

/// Differences of Moment and Order have too few digits for values that are fewer bins apart.
constexpr float FewestBinsApart = 4.0f;

/// The mean place of emission in a step, as a share of the step.
/// \param spread see SpreadOf
HWY_INLINE V CentreOf(V a, const EmissionAt& atA, V b, const EmissionAt& atB, V depth, V spread)
{
  const Floats d;
  const V one = hn::Set(d, 1.0f), least = hn::Set(d, 1e-20f);
  const V difference = hn::Sub(b, a), sum = hn::Sub(atB.Sum[0], atA.Sum[0]);
  const V product = hn::Mul(difference, sum);
  const M isFar = hn::And(
    hn::Ge(hn::Abs(difference), hn::Set(d, FewestBinsApart)), hn::Gt(hn::Abs(product), least));
  const V moment = hn::Sub(hn::Sub(atB.Moment, atA.Moment), hn::Mul(a, sum));
  const V ends = hn::Add(hn::Add(atA.Value[0], atB.Value[0]), least);
  // Take extinction as linear between close values.
  const V above =
    hn::IfThenElse(isFar, moment, hn::Mul(hn::Set(d, 1.0f / 3.0f), hn::Add(ends, atB.Value[0])));
  const V share = hn::Div(above, hn::IfThenElse(isFar, product, ends));
  // The step absorbs less light from its front, so that the centre moves forward.
  const V pulled = hn::Mul(hn::Min(depth, hn::Set(d, 3.0f)), hn::Mul(spread, spread));
  return hn::Min(hn::Max(hn::Sub(share, pulled), hn::Zero(d)), one);
}

/// A step absorbs more of the light from its end than from its beginning: subtract the covariance
/// of colours with the optical depth in front of them from the mean. This is exact for a small
/// depth if the values are far enough apart. Else colours are linear in between, if both ends emit.
HWY_INLINE void PullColors(const TransferTables& tables, V a, const EmissionAt& atA, V b,
  const EmissionAt& atB, V depth, V mean[4])
{
  const Floats d;
  const V one = hn::Set(d, 1.0f), half = hn::Set(d, 0.5f), least = hn::Set(d, 1e-20f);
  const V larger = hn::Max(atA.Value[0], atB.Value[0]);
  const V smaller = hn::Min(atA.Value[0], atB.Value[0]);
  const V sum = hn::Sub(atB.Sum[0], atA.Sum[0]);
  // An opaque range in between has its own colour, and sums count opaque ranges only in part.
  const M isOpen = hn::Eq(atA.Walls, atB.Walls);
  const M isCounted = hn::And(isOpen, hn::Le(larger, hn::Set(d, tables.MostCounted)));
  const M isFar = hn::And(isCounted,
    hn::And(hn::Ge(hn::Abs(hn::Sub(b, a)), hn::Set(d, FewestBinsApart)),
      hn::Gt(hn::Abs(sum), hn::Max(hn::Set(d, tables.LeastOrdered), least))));
  const M isEven =
    hn::AndNot(isFar, hn::And(isOpen, hn::Gt(smaller, hn::Mul(hn::Set(d, 1e-3f), larger))));
  const V perSum = hn::Div(one, hn::IfThenElse(isFar, sum, one));
  const V perA = hn::Div(hn::Set(d, 1.0f / 12.0f), hn::Max(atA.Value[0], least));
  const V perB = hn::Div(hn::Set(d, 1.0f / 12.0f), hn::Max(atB.Value[0], least));
  const V pull = hn::Mul(hn::Min(depth, hn::Set(d, 3.0f)), mean[0]);
  for (std::size_t i = 1; i < 4; ++i)
  {
    const V emitted = hn::Sub(atB.Sum[i], atA.Sum[i]);
    const V order =
      hn::Sub(hn::Sub(atB.Order[i - 1], atA.Order[i - 1]), hn::Mul(atA.Sum[0], emitted));
    const V far = hn::Mul(perSum, hn::Sub(hn::Mul(perSum, order), hn::Mul(half, emitted)));
    const V even = hn::Sub(hn::Mul(atB.Value[i], perB), hn::Mul(atA.Value[i], perA));
    const V covariance = hn::IfThenElse(isFar, far, hn::IfThenElseZero(isEven, even));
    mean[i] = hn::Max(hn::Sub(mean[i], hn::Mul(pull, covariance)), hn::Zero(d));
  }
}

/// The opacity at magnitudes of gradients.
HWY_INLINE V OpacityOf(const GradientTable& table, V magnitude)
{
  const Floats d;
  const Integers di;
  const V entry = hn::Mul(hn::Sub(magnitude, hn::Set(d, static_cast<float>(table.Low))),
    hn::Set(d, static_cast<float>(table.PerMagnitude)));
  const V last = hn::Set(d, static_cast<float>(table.Opacities.size() - 2));
  const V clamped = hn::Min(hn::Max(entry, hn::Zero(d)), hn::Add(last, hn::Set(d, 1.0f)));
  const V floor = hn::Min(hn::Floor(clamped), last);
  const I index = hn::ConvertTo(di, floor);
  const V low = hn::GatherIndex(d, table.Opacities.data(), index);
  const V high = hn::GatherIndex(d, table.Opacities.data() + 1, index);
  return hn::Add(low, hn::Mul(hn::Sub(clamped, floor), hn::Sub(high, low)));
}

}
}
}
HWY_AFTER_NAMESPACE();

#endif
