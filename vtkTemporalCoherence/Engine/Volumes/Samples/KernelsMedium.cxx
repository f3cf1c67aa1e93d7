// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Samples/KernelsMedium.h"

#include <algorithm>
#include <limits>

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Volumes/Samples/KernelsMedium.cxx"
#include <hwy/foreach_target.h>

#include "Volumes/Medium/KernelsLight-inl.h"
#include "Volumes/Medium/KernelsStretch-inl.h"
#include "Volumes/Medium/KernelsVectors-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace MediumKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;
namespace light = EmissionKernels::HWY_NAMESPACE;

using light::Floats;
using light::Integers;
using light::M;
using light::V;

/// A vector of places.
class PlaceVector
{
public:
  HWY_INLINE PlaceVector(const MediumLook& look, const MediumSegments& segments,
    const MediumPlaces& places, std::size_t first, std::size_t count)
    : Look(look)
    , Segments(segments)
  {
    const Floats d;
    this->Share = hn::LoadU(d, &places.Share[first]);
    const auto stride = static_cast<std::int32_t>(4 * look.RowsOfSegment);
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
    {
      this->Which[lane] = places.Segment[first + std::min(lane, count - 1)];
      this->Rows[lane] = stride * this->Which[lane];
    }
  }

  HWY_INLINE void Find(V& extinction, V emission[3]) const
  {
    const Floats d;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f), least = hn::Set(d, 1e-30f);
    V squares = zero, weighed = zero;
    V opaque[3] = { zero, zero, zero };
    M isOpaque = hn::Lt(one, zero);
    emission[0] = emission[1] = emission[2] = zero;
    for (const PartLook& part : this->Look.Parts)
    {
      V found[4]; // opacity and colour
      this->LookUp(part, found);
      if (hn::AllFalse(d, hn::Gt(found[0], zero)))
      {
        continue;
      }
      V share = one;
      if (part.ByGradient || part.Lights)
      {
        share = this->Shade(part, found);
      }
      const M isSeen = hn::And(hn::Gt(share, zero), hn::Gt(found[0], zero));
      const M isSolid = hn::And(isSeen, hn::Ge(found[0], one));
      isOpaque = hn::Or(isOpaque, isSolid);
      const V weight = hn::Set(d, part.Weight);
      const V taken = hn::IfThenElseZero(
        isSeen, hn::Mul(hn::Mul(DepthOf(found[0]), hn::Set(d, part.PerEdge)), share));
      const V counted = hn::Mul(weight, taken);
      squares = hn::Add(squares, hn::Mul(taken, taken));
      weighed = hn::Add(weighed, counted);
      for (std::size_t a = 0; a < 3; ++a)
      {
        emission[a] = hn::Add(emission[a], hn::Mul(counted, found[a + 1]));
        opaque[a] = hn::Add(opaque[a], hn::IfThenElseZero(isSolid, hn::Mul(weight, found[a + 1])));
      }
    }
    const V whole = this->Look.Parts.size() == 1 && this->Look.Parts.front().Weight == 1.0f
      ? weighed
      : hn::IfThenElseZero(hn::Gt(weighed, least), hn::Div(squares, hn::Max(weighed, least)));
    extinction = hn::IfThenElse(isOpaque, hn::Neg(whole), whole);
    for (std::size_t a = 0; a < 3; ++a)
    {
      emission[a] = hn::IfThenElse(isOpaque, opaque[a], emission[a]);
    }
  }

private:
  /// The optical depth of an opacity: -ln(1 - x).
  static HWY_INLINE V DepthOf(V opacity)
  {
    const Floats d;
    const Integers di;
    const V one = hn::Set(d, 1.0f);
    // 1 - x has too few digits for a small x.
    const V x = hn::Min(opacity, hn::Set(d, 0.03125f));
    V series = hn::Set(d, 0.2f);
    for (const float factor : { 0.25f, 1.0f / 3.0f, 0.5f, 1.0f })
    {
      series = hn::Add(hn::Mul(series, x), hn::Set(d, factor));
    }
    // 1 - x = m 2^e with m in [sqrt(1/2), sqrt(2)], and ln m = 2 artanh((m - 1) / (m + 1)).
    const V rest = hn::Max(hn::Sub(one, opacity), hn::Set(d, 1e-8f));
    const auto bits = hn::BitCast(di, rest);
    const auto exponent = hn::ShiftRight<23>(hn::Sub(bits, hn::Set(di, 0x3F3504F3)));
    const V m = hn::BitCast(d, hn::Sub(bits, hn::ShiftLeft<23>(exponent)));
    const V ratio = hn::Div(hn::Sub(m, one), hn::Add(m, one)), square = hn::Mul(ratio, ratio);
    V sum = hn::Set(d, 2.0f / 9.0f);
    for (const float factor : { 2.0f / 7.0f, 2.0f / 5.0f, 2.0f / 3.0f, 2.0f })
    {
      sum = hn::Add(hn::Mul(sum, square), hn::Set(d, factor));
    }
    const V logarithm =
      hn::Add(hn::Mul(ratio, sum), hn::Mul(hn::ConvertTo(d, exponent), hn::Set(d, 0.693147181f)));
    return hn::IfThenElse(hn::Eq(x, opacity), hn::Mul(series, x), hn::Sub(hn::Zero(d), logarithm));
  }

  /// The value of a row of the segments.
  HWY_INLINE V At(std::size_t row) const
  {
    V c[4];
    light::LoadRows(this->Segments.Rows[row].data(), this->Rows, c);
    return this->Evaluate(c);
  }

  HWY_INLINE V Evaluate(const V c[4]) const
  {
    const V first = hn::Add(hn::Mul(c[3], this->Share), c[2]);
    return hn::Add(hn::Mul(hn::Add(hn::Mul(first, this->Share), c[1]), this->Share), c[0]);
  }

  /// Look up the value of a row in a table.
  HWY_INLINE void LookUpBin(const MediumTable& table, std::size_t row, V found[4]) const
  {
    V c[4];
    light::LoadRows(this->Segments.Rows[row].data(), this->Rows, c);
    const V value = this->Evaluate(c);
    const Floats d;
    const Integers di;
    const V last = hn::Set(d, static_cast<float>(table.Bins.size() - 1));
    const V within = hn::Min(hn::Max(value, hn::Zero(d)), last);
    const V bin = hn::Floor(within);
    const V share = hn::Sub(within, bin);
    std::int32_t places[WidestVector];
    constexpr std::int32_t numbers = sizeof(MediumBin) / sizeof(float);
    hn::StoreU(hn::Mul(hn::ConvertTo(di, bin), hn::Set(di, numbers)), di, places);
    V rise[4];
    light::LoadRows(table.Bins.front().Value.data(), places, found);
    light::LoadRows(table.Bins.front().Rise.data(), places, rise);
    for (std::size_t i = 0; i < 4; ++i)
    {
      found[i] = hn::Add(found[i], hn::Mul(share, rise[i]));
    }
  }

  /// Opacity and unlit colour of a part.
  HWY_INLINE void LookUp(const PartLook& part, V found[4]) const
  {
    if (this->Look.AreEven)
    {
      light::LoadRows(this->Segments.Rows[part.Opacity].data(), this->Rows, found);
      return;
    }
    this->LookUpBin(*part.Table, part.Opacity, found);
    if (this->Look.Use == ComponentUse::ColorOpacity)
    {
      V color[4];
      this->LookUpBin(*part.Table, 0, color);
      found[1] = color[1];
      found[2] = color[2];
      found[3] = color[3];
    }
    else if (this->Look.Use == ComponentUse::RgbOpacity)
    {
      const Floats d;
      for (std::size_t a = 0; a < 3; ++a)
      {
        found[a + 1] = hn::Min(hn::Max(this->At(a), hn::Zero(d)), hn::Set(d, 1.0f));
      }
    }
  }

  /// Light a part.
  /// \return the gradient opacity
  HWY_INLINE V Shade(const PartLook& part, V found[4]) const
  {
    const Floats d;
    V gradient[3], share = hn::Set(d, 1.0f);
    for (std::size_t a = 0; a < 3; ++a)
    {
      gradient[a] = this->At(part.Gradient + a);
    }
    if (part.ByGradient)
    {
      V step[3];
      for (int a = 0; a < 3; ++a)
      {
        step[a] = hn::Mul(gradient[a], hn::Set(d, part.PerStep[a]));
      }
      // Differences beyond single precision may give NaN: take the largest float.
      const V steepness = hn::Sqrt(light::Dot(step, step));
      const V largest = hn::Set(d, std::numeric_limits<float>::max());
      share = light::OpacityOf(
        *part.ByGradient, hn::IfThenElse(hn::Eq(steepness, steepness), steepness, largest));
    }
    if (part.Lights)
    {
      if (part.Lights->AreWhite)
      {
        this->LightUp<1>(*part.Lights, gradient, found);
      }
      else
      {
        this->LightUp<3>(*part.Lights, gradient, found);
      }
    }
    return share;
  }

  template <std::size_t Colors>
  HWY_INLINE void LightUp(const VolumeLights& lights, const V gradient[3], V found[4]) const
  {
    const Floats d;
    V normal[3], direction[3], point[3];
    light::FindNormals(this->Look.WorldFromGradient, gradient, normal);
    const V t = this->DistanceAt();
    for (int a = 0; a < 3; ++a)
    {
      direction[a] = hn::Set(d, this->Segments.Direction[a]);
      point[a] = hn::Add(hn::Set(d, this->Segments.Begin[a]), hn::Mul(t, direction[a]));
    }
    const auto reflected =
      light::Reflect<Colors, V>(lights, light::LitPoints{ normal, direction, point });
    for (std::size_t a = 0; a < 3; ++a)
    {
      const std::size_t channel = Colors == 1 ? 0 : a;
      const V shown =
        hn::Add(hn::Mul(found[a + 1], reflected.Matt[channel]), reflected.Shine[channel]);
      found[a + 1] = hn::Min(hn::Max(shown, hn::Zero(d)), hn::Set(d, 1.0f));
    }
  }

  /// World distances from the begin of the ray.
  HWY_INLINE V DistanceAt() const
  {
    const Floats d;
    float enter[WidestVector], length[WidestVector];
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
    {
      enter[lane] = this->Segments.Enter[static_cast<std::size_t>(this->Which[lane])];
      length[lane] = this->Segments.Length[static_cast<std::size_t>(this->Which[lane])];
    }
    return hn::Add(hn::LoadU(d, enter), hn::Mul(this->Share, hn::LoadU(d, length)));
  }

  const MediumLook& Look;
  const MediumSegments& Segments;
  V Share;
  std::int32_t Which[WidestVector], Rows[WidestVector];
};

void Find(
  const MediumLook& look, const MediumSegments& segments, std::size_t from, MediumPlaces& places)
{
  const Floats d;
  const std::size_t lanes = hn::Lanes(d);
  std::fill_n(places.Share.begin() + static_cast<std::ptrdiff_t>(places.Count), lanes, 0.0f);
  for (std::size_t i = from; i < places.Count; i += lanes)
  {
    const PlaceVector vector(look, segments, places, i, std::min(lanes, places.Count - i));
    V extinction, emission[3];
    vector.Find(extinction, emission);
    hn::StoreU(extinction, d, &places.Extinction[i]);
    for (std::size_t a = 0; a < 3; ++a)
    {
      hn::StoreU(emission[a], d, &places.Emission[a][i]);
    }
  }
}

}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{
namespace MediumKernels
{

HWY_EXPORT(Find);

void FindMedium(
  const MediumLook& look, const MediumSegments& segments, std::size_t from, MediumPlaces& places)
{
  HWY_DYNAMIC_DISPATCH(Find)(look, segments, from, places);
}

}
}
#endif
