// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Blending/KernelsEmission.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Blending/KernelsEmission.cxx"
#include <hwy/foreach_target.h>

#include "Blending/KernelsCubic-inl.h"
#include "Blending/KernelsLight-inl.h"
#include "Shade/KernelsPacked-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace EmissionKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::CappedTag<float, WidestVector>;
using Integers = hn::Rebind<std::int32_t, Floats>;
using V = hn::Vec<Floats>;
using I = hn::Vec<Integers>;
using M = hn::Mask<Floats>;
using Line = Cubics::HWY_NAMESPACE::Cubic<V>;

/// A segment is cut into steps of no more optical depth, unless there are too many.
constexpr float MostDepthOfStep = 0.5f, MostSteps = 16.0f;

/// Steps for each unit by which a gradient turns (TurnOf).
constexpr float StepsOfTurn = 8.0f;

/// exp(-x) for x >= 0.
HWY_INLINE V ExpOfMinus(V x)
{
  const Floats d;
  const Integers di;
  const V bounded = hn::Min(x, hn::Set(d, 80.0f));
  const V whole = hn::Floor(hn::Add(hn::Mul(bounded, hn::Set(d, 1.44269504f)), hn::Set(d, 0.5f)));
  // What is left lies in [-ln 2 / 2, ln 2 / 2]. ln 2 is split, so that its product is exact.
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

/// Loads the samples around a vector of cells.
struct ArrayLoader
{
  HWY_INLINE void Four(std::size_t row, V out[4]) const
  {
    for (std::size_t x = 0; x < 4; ++x)
    {
      out[x] = hn::LoadU(Floats(), &this->Around.Along[row][x][this->At]);
    }
  }
  HWY_INLINE void Two(std::size_t row, V out[2]) const
  {
    for (std::size_t x = 0; x < 2; ++x)
    {
      out[x] = hn::LoadU(Floats(), &this->Around.Beside[row][x][this->At]);
    }
  }
  HWY_INLINE V Minus(V a, V b) const { return hn::Sub(a, b); }

  const SamplesAround& Around;
  std::size_t At;
};

template <typename T>
struct GatheringLoader : PackedSamples::HWY_NAMESPACE::GatheredRows<T>
{
  using Rows = PackedSamples::HWY_NAMESPACE::GatheredRows<T>;
  using S = typename Rows::V;

  HWY_INLINE GatheringLoader(const NarrowSamples<T>& samples, const I cell[3], float perValue)
    : Rows(samples, cell)
    , PerValue(perValue)
  {
  }
  HWY_INLINE void Four(std::size_t row, S out[4]) const
  {
    Rows::Four(static_cast<int>(row & 1u), static_cast<int>(row >> 1u), out);
  }
  HWY_INLINE void Two(std::size_t row, S out[2]) const
  {
    const int across = (row & 2u) != 0 ? 2 : -1, end = static_cast<int>(row & 1u);
    Rows::Two(row < 4 ? across : end, row < 4 ? end : across, out);
  }
  HWY_INLINE V Minus(S a, S b) const
  {
    return hn::Mul(Rows::AsFloats(hn::Sub(a, b)), hn::Set(Floats(), this->PerValue));
  }

  float PerValue;
};

/// Twice the gradients along lines through cells, by axis: differences of samples two steps apart.
template <typename S, typename Loader>
HWY_INLINE void FindGradients(
  const Loader& loader, const V begin[3], const V across[3], Line gradients[3])
{
  S corner[8], row[4], before[2], behind[2];
  V at[8];
  for (std::size_t yz = 0; yz < 4; ++yz)
  {
    loader.Four(yz, row);
    corner[2 * yz] = row[1];
    corner[2 * yz + 1] = row[2];
    at[2 * yz] = loader.Minus(row[2], row[0]);
    at[2 * yz + 1] = loader.Minus(row[3], row[1]);
  }
  gradients[0] = Cubics::HWY_NAMESPACE::CubicAlong(at, begin, across);
  for (std::size_t z = 0; z < 2; ++z)
  {
    loader.Two(z, before);
    loader.Two(2 + z, behind);
    for (std::size_t x = 0; x < 2; ++x)
    {
      at[4 * z + x] = loader.Minus(corner[4 * z + 2 + x], before[x]);
      at[4 * z + 2 + x] = loader.Minus(behind[x], corner[4 * z + x]);
    }
  }
  gradients[1] = Cubics::HWY_NAMESPACE::CubicAlong(at, begin, across);
  for (std::size_t y = 0; y < 2; ++y)
  {
    loader.Two(4 + y, before);
    loader.Two(6 + y, behind);
    for (std::size_t x = 0; x < 2; ++x)
    {
      at[2 * y + x] = loader.Minus(corner[4 + 2 * y + x], before[x]);
      at[4 + 2 * y + x] = loader.Minus(behind[x], corner[2 * y + x]);
    }
  }
  gradients[2] = Cubics::HWY_NAMESPACE::CubicAlong(at, begin, across);
}

/// Emission at a value: its integral up to there, and its mean in the bin.
struct EmissionAt
{
  V Sum[4], Mean[4];
};

/// What a vector of segments adds to its rays.
class SegmentVector
{
public:
  HWY_INLINE SegmentVector(const EmittingVolume& volume, const LitRays& rays,
    const VolumeSegments& segments, std::size_t first, BlendedRays& seen)
    : Volume(volume)
    , Rays(rays)
    , Seen(seen)
    , IsSegment(hn::FirstN(Floats(), static_cast<std::size_t>(segments.Count) - first))
  {
    const Floats d;
    const auto load = [&](const VolumeSegments::Array<float>& array) HWY_ATTR
    { return hn::IfThenElseZero(this->IsSegment, hn::LoadU(d, &array[first])); };
    this->Ray = hn::IfThenElseZero(
      hn::RebindMask(Integers(), this->IsSegment), hn::LoadU(Integers(), &segments.Ray[first]));
    this->Enter = load(segments.Enter);
    this->Length = load(segments.Length);
    for (std::size_t power = 0; power < 4; ++power)
    {
      this->Values.C[power] = load(segments.Cubic[power]);
    }
    this->Middle = load(segments.Middle);
    this->Bend = load(segments.Bend);
    this->Passed = hn::GatherIndex(d, seen.Passed.data(), this->Ray);
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Color[a] = hn::Zero(d);
    }
  }

  /// \param gradients twice those along the segments, if the volume has any
  HWY_INLINE void Add(const Line gradients[3])
  {
    const Floats d;
    const V one = hn::Set(d, 1.0f);
    V value = this->Values.C[0];
    const V atEnd = this->Values.At(one);
    EmissionAt last, end;
    this->LookUp(value, last);
    this->LookUp(atEnd, end);
    this->SetSteps(last, atEnd, end, gradients);
    const V length = hn::Mul(this->Length, this->Share);
    const float most = hn::GetLane(hn::MaxOfLanes(d, this->Steps));
    for (float step = 0.0f; step < most; step += 1.0f)
    {
      const V begin = hn::Mul(hn::Set(d, step), this->Share);
      const V steps = hn::Set(d, step + 1.0f);
      const M isStep = hn::Le(steps, this->Steps);
      V next = atEnd;
      EmissionAt there = end;
      if (!hn::AllFalse(d, hn::Lt(steps, this->Steps)))
      {
        next = this->Values.At(hn::Mul(steps, this->Share));
        this->LookUp(next, there);
      }
      V mean[4];
      MeanBetween(value, last, next, there, mean);
      const V depth = hn::IfThenElseZero(isStep, hn::Mul(mean[0], length));
      if (!hn::AllFalse(d, hn::Gt(depth, hn::Zero(d))))
      {
        const V centre = CentreOf(last.Mean[0], there.Mean[0], depth);
        this->AddStep(hn::Add(begin, hn::Mul(centre, this->Share)), depth, mean, gradients);
      }
      value = next;
      last = there;
    }
  }

  /// Store what the rays have seen.
  HWY_INLINE void Finish() const
  {
    const Floats d;
    const auto store = [&](V value, RayBatch::Array<float>& array) HWY_ATTR
    {
      float values[WidestVector];
      std::int32_t rays[WidestVector];
      hn::StoreU(value, d, values);
      hn::StoreU(this->Ray, Integers(), rays);
      const std::size_t count = hn::CountTrue(d, this->IsSegment);
      for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
      {
        if (lane < count)
        {
          array[static_cast<std::size_t>(rays[lane])] = values[lane];
        }
      }
    };
    store(this->Passed, this->Seen.Passed);
    for (std::size_t a = 0; a < 3; ++a)
    {
      const V before = hn::GatherIndex(d, this->Seen.Color[a].data(), this->Ray);
      store(hn::Add(before, this->Color[a]), this->Seen.Color[a]);
    }
  }

private:
  /// Cut segments into steps of equal length.
  HWY_INLINE void SetSteps(
    const EmissionAt& begin, V valueAtEnd, const EmissionAt& end, const Line gradients[3])
  {
    const Floats d;
    const V one = hn::Set(d, 1.0f);
    const TransferTables& tables = this->Volume.Tables;
    const V blocks = hn::Set(d, static_cast<float>(tables.Steepness.size() - 1));
    const V block =
      hn::Min(hn::Max(hn::Mul(this->Middle, hn::Set(d, 1.0f / (1 << TransferTables::BlockBits))),
                hn::Zero(d)),
        blocks);
    const V steepness =
      hn::GatherIndex(d, tables.Steepness.data(), hn::ConvertTo(Integers(), block));
    // A chord of a parabola is off by its bend, which falls with the square of the steps.
    const V error = hn::Mul(hn::Mul(steepness, hn::Mul(this->Bend, this->Length)),
      hn::Set(d, 1.0f / this->Volume.Tolerance));
    V mean[4];
    MeanBetween(this->Values.C[0], begin, valueAtEnd, end, mean);
    const V depth = hn::Mul(mean[0], this->Length);
    V steps = hn::Max(hn::Sqrt(error), hn::Mul(depth, hn::Set(d, 1.0f / MostDepthOfStep)));
    if (this->Volume.Surface.Shade)
    {
      const V turn = TurnOf(gradients);
      steps = hn::Max(steps, hn::Mul(turn, hn::Set(d, StepsOfTurn)));
    }
    this->Steps = hn::IfThenElseZero(
      this->IsSegment, hn::Min(hn::Max(hn::Ceil(steps), one), hn::Set(d, MostSteps)));
    this->Share = hn::Div(one, hn::Max(this->Steps, one));
  }

  /// How far gradients turn along segments: 1 - the cosine between their ends.
  static HWY_INLINE V TurnOf(const Line gradients[3])
  {
    const Floats d;
    const V one = hn::Set(d, 1.0f), least = hn::Set(d, 1e-20f);
    const V first[3] = { gradients[0].C[0], gradients[1].C[0], gradients[2].C[0] };
    const V last[3] = { gradients[0].At(one), gradients[1].At(one), gradients[2].At(one) };
    const V square = hn::Mul(hn::Max(Dot(first, first), least), hn::Max(Dot(last, last), least));
    return hn::Sub(one, hn::Div(Dot(first, last), hn::Sqrt(square)));
  }

  /// The mean place of what is emitted in a step, whose ends have these extinctions.
  static HWY_INLINE V CentreOf(V first, V last, V depth)
  {
    const Floats d;
    const V sum = hn::Add(first, last);
    const V isEmpty = hn::Set(d, 1e-20f);
    const V third = hn::Set(d, 1.0f / 3.0f);
    const V linear =
      hn::Mul(third, hn::Add(hn::Set(d, 1.0f), hn::Div(last, hn::Max(sum, isEmpty))));
    const V pulled = hn::Mul(hn::Min(depth, hn::Set(d, 3.0f)), hn::Set(d, 1.0f / 12.0f));
    return hn::Sub(hn::IfThenElse(hn::Gt(sum, isEmpty), linear, hn::Set(d, 0.5f)), pulled);
  }

  HWY_INLINE void LookUp(V value, EmissionAt& at) const
  {
    const Floats d;
    const Integers di;
    const TransferTables& tables = this->Volume.Tables;
    const V last = hn::Set(d, static_cast<float>(tables.Bins));
    const V bin = hn::Min(hn::Max(hn::Floor(value), hn::Set(d, -1.0f)), last);
    const V behind = hn::Sub(value, hn::Max(bin, hn::Zero(d)));
    std::int32_t bins[WidestVector];
    hn::StoreU(hn::Add(hn::ConvertTo(di, bin), hn::Set(di, 1)), di, bins);
    // Four numbers lie side by side: copies of all of them are faster than gathering each.
    HWY_ALIGN float means[4 * WidestVector], sums[4 * WidestVector];
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
    {
      const BinOfEmission& from = tables.All[static_cast<std::size_t>(bins[lane])];
      std::memcpy(means + 4 * lane, from.Mean.data(), sizeof(from.Mean));
      std::memcpy(sums + 4 * lane, from.Sum.data(), sizeof(from.Sum));
    }
    hn::LoadInterleaved4(d, means, at.Mean[0], at.Mean[1], at.Mean[2], at.Mean[3]);
    hn::LoadInterleaved4(d, sums, at.Sum[0], at.Sum[1], at.Sum[2], at.Sum[3]);
    for (std::size_t i = 0; i < 4; ++i)
    {
      at.Sum[i] = hn::Add(at.Sum[i], hn::Mul(behind, at.Mean[i]));
    }
  }

  /// The mean emission of a stretch on which values go from one to another.
  static HWY_INLINE void MeanBetween(
    V a, const EmissionAt& atA, V b, const EmissionAt& atB, V mean[4])
  {
    const Floats d;
    const V difference = hn::Sub(b, a);
    // The difference of sums loses its digits where these are close together.
    const M isClose = hn::Lt(hn::Abs(difference), hn::Set(d, 4.0f));
    const V perBin =
      hn::Div(hn::Set(d, 1.0f), hn::IfThenElse(isClose, hn::Set(d, 1.0f), difference));
    for (std::size_t i = 0; i < 4; ++i)
    {
      const V far = hn::Mul(hn::Sub(atB.Sum[i], atA.Sum[i]), perBin);
      const V close = hn::Mul(hn::Set(d, 0.5f), hn::Add(atA.Mean[i], atB.Mean[i]));
      mean[i] = hn::Max(hn::IfThenElse(isClose, close, far), hn::Zero(d));
    }
  }

  /// Composite a step behind what has been seen.
  HWY_INLINE void AddStep(V at, V depth, const V mean[4], const Line gradients[3])
  {
    const Floats d;
    const V one = hn::Set(d, 1.0f);
    V color[3];
    const V perMean = hn::Div(one, hn::Max(mean[0], hn::Set(d, 1e-30f)));
    for (std::size_t a = 0; a < 3; ++a)
    {
      color[a] = hn::Mul(mean[a + 1], perMean);
    }
    if (this->Volume.HasGradients())
    {
      const V gradient[3] = { gradients[0].At(at), gradients[1].At(at), gradients[2].At(at) };
      depth = hn::Mul(depth, this->OpacityOf(gradient));
      if (this->Volume.Surface.Shade)
      {
        this->Light(at, gradient, color);
      }
    }
    const V left = hn::Mul(this->Passed, ExpOfMinus(depth));
    const V emitted = hn::Sub(this->Passed, left);
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Color[a] = hn::Add(this->Color[a], hn::Mul(emitted, color[a]));
    }
    this->NoteFirst(hn::Gt(depth, hn::Set(d, 1e-4f)), at);
    this->Passed = left;
  }

  /// Note where rays first see anything.
  HWY_INLINE void NoteFirst(M isSeen, V at) const
  {
    const Floats d;
    const M isFirst = hn::And(isSeen, hn::Eq(this->Passed, hn::Set(d, 1.0f)));
    if (hn::AllFalse(d, isFirst))
    {
      return;
    }
    float distances[WidestVector];
    std::int32_t rays[WidestVector];
    std::uint8_t bits[8] = {};
    hn::StoreU(hn::Add(this->Enter, hn::Mul(at, this->Length)), d, distances);
    hn::StoreU(this->Ray, Integers(), rays);
    hn::StoreMaskBits(d, isFirst, bits);
    for (std::uint32_t left = bits[0] | static_cast<std::uint32_t>(bits[1]) << 8; left != 0;
         left &= left - 1)
    {
      const std::size_t lane = hwy::Num0BitsBelowLS1Bit_Nonzero32(left);
      double& first = this->Seen.First[static_cast<std::size_t>(rays[lane])];
      first = std::min(first, static_cast<double>(distances[lane]));
    }
  }

  HWY_INLINE V OpacityOf(const V gradient[3]) const
  {
    const Floats d;
    const Integers di;
    const GradientTable& table = this->Volume.ByGradient;
    if (table.Opacities.empty())
    {
      return hn::Set(d, 1.0f);
    }
    V square = hn::Zero(d);
    for (std::size_t a = 0; a < 3; ++a)
    {
      const V scaled = hn::Mul(gradient[a], hn::Set(d, this->Volume.PerStep[static_cast<int>(a)]));
      square = hn::Add(square, hn::Mul(scaled, scaled));
    }
    const V entry = hn::Mul(hn::Sub(hn::Sqrt(square), hn::Set(d, static_cast<float>(table.Low))),
      hn::Set(d, static_cast<float>(table.PerMagnitude)));
    const V last = hn::Set(d, static_cast<float>(table.Opacities.size() - 2));
    const V clamped = hn::Min(hn::Max(entry, hn::Zero(d)), hn::Add(last, hn::Set(d, 1.0f)));
    const V place = hn::Min(hn::Floor(clamped), last);
    const V share = hn::Sub(clamped, place);
    const I index = hn::ConvertTo(di, place);
    const V low = hn::GatherIndex(d, table.Opacities.data(), index);
    const V high = hn::GatherIndex(d, table.Opacities.data() + 1, index);
    return hn::Add(low, hn::Mul(share, hn::Sub(high, low)));
  }

  HWY_INLINE void Light(V at, const V gradient[3], V color[3]) const
  {
    const Floats d;
    V normal[3], direction[3], point[3];
    FindNormals(this->Volume.WorldFromGradient, gradient, normal);
    const V t = hn::Add(this->Enter, hn::Mul(at, this->Length));
    for (std::size_t a = 0; a < 3; ++a)
    {
      direction[a] = hn::GatherIndex(d, this->Rays.Direction[a].data(), this->Ray);
      point[a] = hn::Add(
        hn::GatherIndex(d, this->Rays.Begin[a].data(), this->Ray), hn::Mul(t, direction[a]));
    }
    LightColors(this->Volume.Lights, this->Volume.Surface, { normal, direction, point }, color);
  }

  const EmittingVolume& Volume;
  const LitRays& Rays;
  BlendedRays& Seen;
  M IsSegment;
  I Ray;
  V Enter, Length, Middle, Bend, Steps, Share;
  Line Values;
  V Passed, Color[3];
};

/// \param gradientsOf finds the gradients of the segments from one on
template <typename GradientsOf>
HWY_INLINE void AddAll(const EmittingVolume& volume, const LitRays& rays,
  const VolumeSegments& segments, const GradientsOf& gradientsOf, BlendedRays& seen)
{
  const Floats d;
  for (std::size_t i = 0; i < static_cast<std::size_t>(segments.Count); i += hn::Lanes(d))
  {
    Line gradients[3];
    if (volume.HasGradients())
    {
      V begin[3], across[3];
      for (std::size_t a = 0; a < 3; ++a)
      {
        begin[a] = hn::LoadU(d, &segments.Begin[a][i]);
        across[a] = hn::LoadU(d, &segments.Across[a][i]);
      }
      gradientsOf(i, begin, across, gradients);
    }
    else
    {
      const V zero = hn::Zero(d);
      std::fill_n(gradients, 3, Line{ { zero, zero, zero, zero } });
    }
    SegmentVector vector(volume, rays, segments, i, seen);
    vector.Add(gradients);
    vector.Finish();
  }
}

void AddOfValues(const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& segments,
  const SamplesAround& around, BlendedRays& seen)
{
  AddAll(
    volume, rays, segments,
    [&](std::size_t i, const V begin[3], const V across[3], Line gradients[3]) HWY_ATTR {
      FindGradients<V>(ArrayLoader{ around, i }, begin, across, gradients);
    },
    seen);
}

template <typename T>
HWY_INLINE void AddOfSamples(const EmittingVolume& volume, const LitRays& rays,
  const VolumeSegments& segments, const NarrowSamples<T>& samples, float perValue,
  BlendedRays& seen)
{
  AddAll(
    volume, rays, segments,
    [&](std::size_t i, const V begin[3], const V across[3], Line gradients[3]) HWY_ATTR
    {
      const Integers di;
      // Lanes behind the last segment read the cell of the first one.
      const auto isSegment = hn::FirstN(di, static_cast<std::size_t>(segments.Count) - i);
      I cell[3];
      for (std::size_t a = 0; a < 3; ++a)
      {
        cell[a] = hn::IfThenElse(
          isSegment, hn::LoadU(di, &segments.Cell[a][i]), hn::Set(di, segments.Cell[a][0]));
      }
      using Loader = GatheringLoader<T>;
      FindGradients<typename Loader::S>(Loader(samples, cell, perValue), begin, across, gradients);
    },
    seen);
}

void AddOfUInt8(const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& segments,
  const NarrowSamples<std::uint8_t>& samples, float perValue, BlendedRays& seen)
{
  AddOfSamples(volume, rays, segments, samples, perValue, seen);
}

void AddOfInt8(const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& segments,
  const NarrowSamples<std::int8_t>& samples, float perValue, BlendedRays& seen)
{
  AddOfSamples(volume, rays, segments, samples, perValue, seen);
}

void AddOfUInt16(const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& segments,
  const NarrowSamples<std::uint16_t>& samples, float perValue, BlendedRays& seen)
{
  AddOfSamples(volume, rays, segments, samples, perValue, seen);
}

void AddOfInt16(const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& segments,
  const NarrowSamples<std::int16_t>& samples, float perValue, BlendedRays& seen)
{
  AddOfSamples(volume, rays, segments, samples, perValue, seen);
}

}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{
namespace EmissionKernels
{

HWY_EXPORT(AddOfValues);
HWY_EXPORT(AddOfUInt8);
HWY_EXPORT(AddOfInt8);
HWY_EXPORT(AddOfUInt16);
HWY_EXPORT(AddOfInt16);

void AddSegments(const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& segments,
  const SamplesAround& around, BlendedRays& seen)
{
  HWY_DYNAMIC_DISPATCH(AddOfValues)(volume, rays, segments, around, seen);
}

void AddSegments(const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& segments,
  const NarrowSamples<std::uint8_t>& samples, float perValue, BlendedRays& seen)
{
  HWY_DYNAMIC_DISPATCH(AddOfUInt8)(volume, rays, segments, samples, perValue, seen);
}

void AddSegments(const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& segments,
  const NarrowSamples<std::int8_t>& samples, float perValue, BlendedRays& seen)
{
  HWY_DYNAMIC_DISPATCH(AddOfInt8)(volume, rays, segments, samples, perValue, seen);
}

void AddSegments(const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& segments,
  const NarrowSamples<std::uint16_t>& samples, float perValue, BlendedRays& seen)
{
  HWY_DYNAMIC_DISPATCH(AddOfUInt16)(volume, rays, segments, samples, perValue, seen);
}

void AddSegments(const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& segments,
  const NarrowSamples<std::int16_t>& samples, float perValue, BlendedRays& seen)
{
  HWY_DYNAMIC_DISPATCH(AddOfInt16)(volume, rays, segments, samples, perValue, seen);
}

}
}
#endif
