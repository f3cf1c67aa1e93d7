// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Projections/KernelsShares.h"

#include <algorithm>
#include <cstddef>
#include <cstring>

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Volumes/Projections/KernelsShares.cxx"
#include <hwy/foreach_target.h>

#include "Volumes/Medium/KernelsCubic-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace SharesKernels
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

/// Steps of a segment, at most.
constexpr float MostSteps = 64.0f;

/// Squared number of steps per unit of bend by span, for segments that count in part.
constexpr float CutSteps = 10.0f;

/// Distances of values, in bins. Close values use no difference of sums, which would lose digits.
/// Even closer values count as constant.
constexpr float Close = 1.0f / 16.0f, Constant = 1.0f / 1024.0f;

HWY_INLINE V Number(float number)
{
  return hn::Set(Floats(), number);
}

/// The function at a value.
struct ShareAt
{
  V Value, Bin, Opacity, Rise, Share; ///< Opacity, Share: at the bin's node
  I Sum;                              ///< up to the node
  V InBin, Beyond;                    ///< from the node to the value: in the range, and beyond
  V Product;                          ///< opacity times share
};

/// Evaluates the function, and its means.
class ShareFunction
{
public:
  HWY_INLINE explicit ShareFunction(const ShareTable& table)
    : Table(table)
    , Last(Number(static_cast<float>(table.Bins - 1)))
    , PerBin(Number(table.SharePerBin))
  {
  }

  HWY_INLINE ShareAt At(V value) const
  {
    const Floats d;
    const Integers di;
    ShareAt at;
    at.Value = value;
    at.Bin = hn::Min(hn::Max(hn::Floor(value), hn::Zero(d)), this->Last);
    const V from = hn::Sub(value, at.Bin);
    at.InBin = hn::Min(hn::Max(from, hn::Zero(d)), Number(1.0f));
    at.Beyond = hn::Sub(from, at.InBin);
    std::int32_t bins[WidestVector];
    hn::StoreU(hn::ConvertTo(di, at.Bin), di, bins);
    // Copy the four adjacent numbers of each node, which is faster than gathering each.
    HWY_ALIGN float nodes[4 * WidestVector];
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
    {
      std::memcpy(nodes + 4 * lane, &this->Table.Nodes[static_cast<std::size_t>(bins[lane])],
        sizeof(ShareNode));
    }
    V sum;
    hn::LoadInterleaved4(d, nodes, at.Opacity, at.Rise, at.Share, sum);
    at.Sum = hn::BitCast(di, sum);
    at.Product = this->ProductAt(at, at.InBin, hn::Add(at.InBin, at.Beyond));
    return at;
  }

  /// The mean of the function on a stretch with values from a to b.
  /// \param lift mean value of the stretch minus the mean of a and b
  HWY_INLINE V MeanBetween(const ShareAt& a, const ShareAt& b, V lift) const
  {
    const Floats d;
    const V half = Number(0.5f), width = hn::Sub(b.Value, a.Value);
    const M isClose = hn::Lt(hn::Abs(width), Number(Close));
    const V perBin = hn::Div(Number(1.0f), hn::IfThenElse(isClose, Number(1.0f), width));
    const V sums = hn::Mul(hn::ConvertTo(d, hn::Sub(b.Sum, a.Sum)), Number(this->Table.Quantum));
    const V rest = hn::Sub(this->FromNode(b), this->FromNode(a));
    const V ends = hn::Mul(half, hn::Add(a.Product, b.Product));
    const V far = hn::Mul(hn::Add(sums, rest), perBin);
    const V slope =
      hn::IfThenElse(isClose, this->SlopeAt(a), hn::Mul(hn::Sub(b.Product, a.Product), perBin));
    return hn::Add(hn::IfThenElse(isClose, ends, far), hn::Mul(lift, slope));
  }

private:
  /// \param inBin distance from the node, within the bin
  /// \param whole distance from the node
  HWY_INLINE V ProductAt(const ShareAt& at, V inBin, V whole) const
  {
    return hn::Mul(hn::Add(at.Opacity, hn::Mul(inBin, at.Rise)),
      hn::Add(at.Share, hn::Mul(whole, this->PerBin)));
  }

  /// The integral from a node to the value.
  HWY_INLINE V FromNode(const ShareAt& at) const
  {
    const V half = Number(0.5f);
    const V first = hn::Mul(at.Opacity, at.Share);
    const V second =
      hn::Mul(half, hn::Add(hn::Mul(at.Opacity, this->PerBin), hn::Mul(at.Rise, at.Share)));
    const V third = hn::Mul(Number(1.0f / 3.0f), hn::Mul(at.Rise, this->PerBin));
    const V inBin = hn::Mul(
      at.InBin, hn::Add(first, hn::Mul(at.InBin, hn::Add(second, hn::Mul(at.InBin, third)))));
    // Beyond the range only the share changes.
    const V middle = hn::Add(at.InBin, hn::Mul(half, at.Beyond));
    return hn::Add(inBin, hn::Mul(at.Beyond, this->ProductAt(at, at.InBin, middle)));
  }

  HWY_INLINE V SlopeAt(const ShareAt& at) const
  {
    const Floats d;
    const V share = hn::Add(at.Share, hn::Mul(hn::Add(at.InBin, at.Beyond), this->PerBin));
    const V opacity = hn::Add(at.Opacity, hn::Mul(at.InBin, at.Rise));
    const V rise = hn::IfThenElseZero(hn::Eq(at.Beyond, hn::Zero(d)), at.Rise);
    return hn::Add(hn::Mul(opacity, this->PerBin), hn::Mul(rise, share));
  }

  const ShareTable& Table;
  V Last, PerBin;
};

/// Integrates a vector of segments.
class SegmentVector
{
public:
  HWY_INLINE SegmentVector(const SharedVolume& volume, const VolumeSegments& segments,
    std::size_t first, std::size_t count)
    : Volume(volume)
    , Segments(segments)
    , At(first)
    , Function(volume.Table)
  {
    const Floats d;
    this->IsSegment = hn::FirstN(d, count);
    const auto load = [&](const VolumeSegments::Array<float>& array) HWY_ATTR
    { return hn::IfThenElseZero(this->IsSegment, hn::LoadU(d, &array[first])); };
    this->Length = load(segments.Length);
    for (std::size_t power = 0; power < 4; ++power)
    {
      this->Values.C[power] = load(segments.Cubic[power]);
    }
    this->Middle = load(segments.Middle);
    this->Bend = load(segments.Bend);
    this->Sum = this->Counted = hn::Zero(d);
    this->First = Number(1.0f);
  }

  template <bool isAverage>
  HWY_INLINE void Add()
  {
    const Floats d;
    const V one = Number(1.0f), half = Number(0.5f), zero = hn::Zero(d);
    const V steps = this->StepsFor<isAverage>();
    const V step = hn::Div(one, steps);
    const float most = hn::GetLane(hn::MaxOfLanes(d, steps));
    V from = zero, value = this->Values.C[0];
    ShareAt here = this->Function.At(this->Clipped<isAverage>(value));
    for (float done = 0.0f; done < most; done += 1.0f)
    {
      const V count = Number(done + 1.0f);
      const M isOn = hn::Le(count, steps);
      const V to = hn::IfThenElse(hn::Lt(count, steps), hn::Mul(count, step), one);
      const V next = this->Values.At(to);
      const ShareAt there = this->Function.At(this->Clipped<isAverage>(next));
      const V middle = this->Values.At(hn::Mul(half, hn::Add(from, to)));
      const V lift =
        hn::Mul(Number(2.0f / 3.0f), hn::Sub(middle, hn::Mul(half, hn::Add(value, next))));
      V share = hn::IfThenElseZero(isOn, step);
      if (isAverage)
      {
        const V inside = this->ShareInside(value, next, here.Value, there.Value);
        share = hn::Mul(share, inside);
        const M isCut = hn::Lt(inside, one);
        const V mean = this->Function.MeanBetween(here, there, hn::IfThenZeroElse(isCut, lift));
        this->NoteFirst(share, hn::Add(from, hn::Mul(step, this->Before(value, next, here.Value))));
        this->Counted = hn::Add(this->Counted, share);
        this->Sum = hn::Add(this->Sum, hn::Mul(share, mean));
      }
      else
      {
        this->Sum =
          hn::Add(this->Sum, hn::Mul(share, this->Function.MeanBetween(here, there, lift)));
      }
      from = to;
      value = next;
      here = there;
    }
  }

  /// Add the integrals to the rays.
  HWY_INLINE void Finish(BlendedRays& seen) const
  {
    const Floats d;
    const std::size_t count = hn::CountTrue(d, this->IsSegment);
    float sums[WidestVector] = {};
    hn::StoreU(hn::Mul(this->Sum, this->Length), d, sums);
    for (std::size_t lane = 0; lane < count; ++lane)
    {
      const auto ray = static_cast<std::size_t>(this->Segments.Ray[this->At + lane]);
      seen.Value[ray] += static_cast<double>(sums[lane]);
    }
    if (!this->Volume.IsAverage)
    {
      return;
    }
    float lengths[WidestVector] = {}, firsts[WidestVector] = {};
    hn::StoreU(hn::Mul(this->Counted, this->Length), d, lengths);
    const V enter = hn::LoadU(d, &this->Segments.Enter[this->At]);
    hn::StoreU(hn::Add(enter, hn::Mul(this->First, this->Length)), d, firsts);
    for (std::size_t lane = 0; lane < count; ++lane)
    {
      const auto ray = static_cast<std::size_t>(this->Segments.Ray[this->At + lane]);
      if (lengths[lane] > 0.0f)
      {
        seen.Length[ray] += static_cast<double>(lengths[lane]);
        seen.First[ray] = std::min(seen.First[ray], static_cast<double>(firsts[lane]));
      }
    }
  }

private:
  /// The number of steps in which values are nearly linear.
  template <bool isAverage>
  HWY_INLINE V StepsFor() const
  {
    const Floats d;
    const Integers di;
    const ShareTable& table = this->Volume.Table;
    const V b0 = this->Values.C[0];
    const V span = hn::Max(
      hn::Abs(hn::Sub(this->Values.At(Number(1.0f)), b0)), hn::Add(this->Bend, Number(1e-6f)));
    const V blocks = Number(static_cast<float>(table.Bends.size() - 1));
    const V perBlock = Number(1.0f / (1 << ShareTable::BlockBits));
    const V block = hn::Min(hn::Max(hn::Mul(this->Middle, perBlock), hn::Zero(d)), blocks);
    const I at = hn::ShiftLeft<1>(hn::ConvertTo(di, block));
    const float* const bends = &table.Bends.data()->Slopes;
    // Long stretches leave the blocks around them: take the bends of all bins.
    const M isLong = hn::Gt(span, Number(2 << ShareTable::BlockBits));
    const V slopes =
      hn::IfThenElse(isLong, Number(table.Largest.Slopes), hn::GatherIndex(d, bends, at));
    const V swing =
      hn::IfThenElse(isLong, Number(table.Largest.Swing), hn::GatherIndex(d, bends + 1, at));
    const V steepness = hn::Min(slopes, hn::Div(hn::Add(swing, swing), span));
    // The error of a straight line falls with the square of the steps.
    V square = hn::Mul(hn::Mul(steepness, this->Bend), Number(this->Volume.PerError));
    if (isAverage)
    {
      const V reach = hn::Add(span, this->Bend);
      const M isCut =
        hn::Or(hn::Lt(hn::Abs(hn::Sub(this->Middle, Number(this->Volume.Low))), reach),
          hn::Lt(hn::Abs(hn::Sub(this->Middle, Number(this->Volume.High))), reach));
      const V cut = hn::Div(hn::Mul(Number(CutSteps), this->Bend), span);
      square = hn::Max(square, hn::IfThenElseZero(isCut, cut));
    }
    else
    {
      square = hn::Mul(square, this->Length);
    }
    const V steps = hn::Min(hn::Max(hn::Ceil(hn::Sqrt(square)), Number(1.0f)), Number(MostSteps));
    return hn::IfThenElse(this->IsSegment, steps, Number(1.0f));
  }

  template <bool isAverage>
  HWY_INLINE V Clipped(V value) const
  {
    return isAverage ? hn::Min(hn::Max(value, Number(this->Volume.Low)), Number(this->Volume.High))
                     : value;
  }

  /// The share of a stretch on which values count.
  /// \param from, to values
  /// \param first, last clipped values
  HWY_INLINE V ShareInside(V from, V to, V first, V last) const
  {
    const V one = Number(1.0f), blur = Number(this->Volume.Blur);
    const V width = hn::Sub(to, from);
    const M isConstant = hn::Lt(hn::Abs(width), Number(Constant));
    const M isInside = hn::And(hn::Ge(from, hn::Sub(Number(this->Volume.Low), blur)),
      hn::Le(from, hn::Add(Number(this->Volume.High), blur)));
    const V share = hn::Div(hn::Sub(last, first), hn::IfThenElse(isConstant, one, width));
    return hn::IfThenElse(isConstant, hn::IfThenElseZero(isInside, one), share);
  }

  /// The share of a stretch that lies before the values that count.
  HWY_INLINE V Before(V from, V to, V first) const
  {
    const V width = hn::Sub(to, from);
    const M isConstant = hn::Lt(hn::Abs(width), Number(Constant));
    return hn::IfThenZeroElse(
      isConstant, hn::Div(hn::Sub(first, from), hn::IfThenElse(isConstant, Number(1.0f), width)));
  }

  HWY_INLINE void NoteFirst(V share, V at)
  {
    const Floats d;
    this->First = hn::IfThenElse(hn::Gt(share, hn::Zero(d)), hn::Min(this->First, at), this->First);
  }

  const SharedVolume& Volume;
  const VolumeSegments& Segments;
  std::size_t At;
  ShareFunction Function;
  M IsSegment;
  V Length, Middle, Bend;
  Line Values;
  V Sum;            ///< of means, weighted by shares
  V Counted, First; ///< of an average: the share that counts, and where it begins
};

template <bool isAverage>
HWY_INLINE void AddAll(
  const SharedVolume& volume, const VolumeSegments& segments, BlendedRays& seen)
{
  for (std::size_t i = 0, end = 0; i < static_cast<std::size_t>(segments.Count); i = end)
  {
    end = segments.EndOfVector(i, hn::Lanes(Floats()));
    SegmentVector vector(volume, segments, i, end - i);
    vector.Add<isAverage>();
    vector.Finish(seen);
  }
}

void AddVectors(const SharedVolume& volume, const VolumeSegments& segments, BlendedRays& seen)
{
  if (volume.IsAverage)
  {
    AddAll<true>(volume, segments, seen);
  }
  else
  {
    AddAll<false>(volume, segments, seen);
  }
}

}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{
namespace SharesKernels
{

HWY_EXPORT(AddVectors);

void AddSegments(const SharedVolume& volume, const VolumeSegments& segments, BlendedRays& seen)
{
  HWY_DYNAMIC_DISPATCH(AddVectors)(volume, segments, seen);
}

}
}
#endif
