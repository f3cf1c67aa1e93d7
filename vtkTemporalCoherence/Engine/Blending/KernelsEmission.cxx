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

/// A segment is cut into no more steps at first, and in the end into no shorter ones.
constexpr float MostSteps = 64.0f, ShortestStep = 1.0f / 1024.0f;

/// The optical depth of a step, as far as it is seen: at first, and at most.
constexpr float DepthOfStep = 0.5f, MostDepthOfStep = 1.0f;

/// How far the optical depth of a segment may be off, as far as it is seen.
constexpr float DepthTolerance = 1.0f / 1024.0f;

/// The square of the steps for each unit by which light, or a gradient opacity, is off a straight
/// line, and by which a normal turns (1 - the cosine), as far as it is seen.
constexpr float StepsOfBend = 1600.0f, StepsOfOpacity = 4096.0f, StepsOfTurn = 2048.0f;

/// Up to this square of steps, light follows a parabola.
constexpr float MostOfParabola = 0.5f;

/// How much a gradient opacity may change in a step, as far as it is seen.
constexpr float MostOpacityChange = 1.0f / 64.0f;

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
  using S = V;

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

/// The same for narrow integers, whose rows are copied from where they lie. Where each lane needs
/// several numbers that lie side by side, copies are faster than gathering them one by one.
template <typename T>
class RowLoader
{
public:
  using Rows = PackedSamples::HWY_NAMESPACE::IntegerRows<T>;
  using S = typename Rows::V;

  HWY_INLINE RowLoader(const NarrowSamples<T>& samples, const VolumeSegments& segments,
    std::size_t first, float perValue)
    : PerValue(perValue)
  {
    const std::size_t lanes = hn::Lanes(Floats());
    const std::size_t last = static_cast<std::size_t>(segments.Count) - 1;
    for (std::size_t lane = 0; lane < lanes; ++lane)
    {
      // Lanes behind the last segment repeat it.
      const std::size_t i = std::min(first + lane, last);
      const T* const from = samples.Samples + segments.Cell[0][i] - 1 +
        static_cast<std::ptrdiff_t>(segments.Cell[1][i]) * samples.StrideY +
        static_cast<std::ptrdiff_t>(segments.Cell[2][i]) * samples.StrideZ;
      for (std::size_t row = 0; row < 12; ++row)
      {
        const T* const at = from + StepsY[row] * samples.StrideY + StepsZ[row] * samples.StrideZ;
        std::memcpy(&this->All[row][lane], at, sizeof(this->All[row][lane]));
      }
    }
  }

  HWY_INLINE void Four(std::size_t row, S out[4]) const { Rows::Load(this->All[row].data(), out); }
  HWY_INLINE void Two(std::size_t row, S out[2]) const
  {
    S four[4];
    Rows::Load(this->All[4 + row].data(), four);
    out[0] = four[1];
    out[1] = four[2];
  }
  HWY_INLINE V Minus(S a, S b) const
  {
    return hn::Mul(Rows::AsFloats(hn::Sub(a, b)), hn::Set(Floats(), this->PerValue));
  }

private:
  /// Where the rows of SamplesAround lie: its four, then its eight.
  static constexpr std::int32_t StepsY[12] = { 0, 1, 0, 1, -1, -1, 2, 2, 0, 1, 0, 1 };
  static constexpr std::int32_t StepsZ[12] = { 0, 0, 1, 1, 0, 1, 0, 1, -1, -1, 2, 2 };

  HWY_ALIGN std::array<std::array<std::array<T, 4>, WidestVector>, 12> All;
  float PerValue;
};

/// Twice the gradients of a field at the corners of a vector of cells: differences of samples two
/// steps apart.
struct CornerGradients
{
  template <typename Loader>
  HWY_INLINE explicit CornerGradients(const Loader& loader)
  {
    using S = typename Loader::S;
    S corner[8], row[4], before[2], behind[2];
    for (std::size_t yz = 0; yz < 4; ++yz)
    {
      loader.Four(yz, row);
      corner[2 * yz] = row[1];
      corner[2 * yz + 1] = row[2];
      this->Along[0][2 * yz] = loader.Minus(row[2], row[0]);
      this->Along[0][2 * yz + 1] = loader.Minus(row[3], row[1]);
    }
    for (std::size_t end = 0; end < 2; ++end)
    {
      loader.Two(end, before);
      loader.Two(2 + end, behind);
      for (std::size_t x = 0; x < 2; ++x)
      {
        this->Along[1][4 * end + x] = loader.Minus(corner[4 * end + 2 + x], before[x]);
        this->Along[1][4 * end + 2 + x] = loader.Minus(behind[x], corner[4 * end + x]);
      }
      loader.Two(4 + end, before);
      loader.Two(6 + end, behind);
      for (std::size_t x = 0; x < 2; ++x)
      {
        this->Along[2][2 * end + x] = loader.Minus(corner[4 + 2 * end + x], before[x]);
        this->Along[2][4 + 2 * end + x] = loader.Minus(behind[x], corner[2 * end + x]);
      }
    }
  }
  HWY_INLINE CornerGradients()
  {
    for (auto& corners : this->Along)
    {
      std::fill_n(corners, 8, hn::Zero(Floats()));
    }
  }

  /// \param at place in the cells
  HWY_INLINE void At(const V at[3], V gradient[3]) const
  {
    const auto mix = [&](V a, V b, V share) HWY_ATTR
    { return hn::Add(a, hn::Mul(share, hn::Sub(b, a))); };
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const V* const v = this->Along[axis];
      const V low = mix(mix(v[0], v[1], at[0]), mix(v[2], v[3], at[0]), at[1]);
      const V high = mix(mix(v[4], v[5], at[0]), mix(v[6], v[7], at[0]), at[1]);
      gradient[axis] = mix(low, high, at[2]);
    }
  }

  V Along[3][8]; ///< by axis, [x + 2 y + 4 z]
};

/// Emission at a value, and its integral up to there.
struct EmissionAt
{
  V Value[4], Sum[4], Moment;
};

/// Light along a vector of segments, as parabolas through three places.
class LightParabola
{
public:
  using Light = ReflectedLight<V>;

  HWY_INLINE LightParabola(const Light& begin, const Light& middle, const Light& end)
    : First(begin)
  {
    this->Off = hn::Zero(Floats());
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Fit(
        begin.Matt[a], middle.Matt[a], end.Matt[a], this->Slope.Matt[a], this->Bend.Matt[a]);
      this->Fit(
        begin.Shine[a], middle.Shine[a], end.Shine[a], this->Slope.Shine[a], this->Bend.Shine[a]);
    }
  }

  /// The mean light around a place.
  /// \param spread the mean square of the distance from it
  HWY_INLINE Light At(V share, V spread) const
  {
    const V square = hn::Add(hn::Mul(share, share), spread);
    const auto at = [&](V first, V slope, V bend) HWY_ATTR
    { return hn::Add(first, hn::Add(hn::Mul(share, slope), hn::Mul(square, bend))); };
    Light light;
    for (std::size_t a = 0; a < 3; ++a)
    {
      light.Matt[a] = at(this->First.Matt[a], this->Slope.Matt[a], this->Bend.Matt[a]);
      light.Shine[a] = at(this->First.Shine[a], this->Slope.Shine[a], this->Bend.Shine[a]);
    }
    return light;
  }

  /// How far light is off a straight line. Where it only seems straight, its slope counts a little.
  V Off;

private:
  HWY_INLINE void Fit(V begin, V middle, V end, V& slope, V& bend)
  {
    const Floats d;
    const V rise = hn::Sub(end, begin), up = hn::Sub(middle, begin);
    bend = hn::Sub(hn::Add(rise, rise), hn::Mul(hn::Set(d, 4.0f), up));
    slope = hn::Sub(rise, bend);
    const V off =
      hn::Add(hn::Mul(hn::Set(d, 0.5f), hn::Abs(bend)), hn::Mul(hn::Set(d, 0.05f), hn::Abs(rise)));
    this->Off = hn::Max(this->Off, off);
  }

  Light First, Slope, Bend;
};

/// What a vector of segments adds to its rays.
class SegmentVector
{
public:
  HWY_INLINE SegmentVector(const EmittingVolume& volume, const LitRays& rays,
    const VolumeSegments& segments, std::size_t first, BlendedRays& seen)
    : Volume(volume)
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
    this->Span = load(segments.Span);
    this->Bend = load(segments.Bend);
    this->Passed = hn::GatherIndex(d, seen.Passed.data(), this->Ray);
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Color[a] = hn::Zero(d);
      this->Begin[a] = load(segments.Begin[a]);
      this->Across[a] = load(segments.Across[a]);
      this->Direction[a] = hn::GatherIndex(d, rays.Direction[a].data(), this->Ray);
      this->Eye[a] = hn::GatherIndex(d, rays.Begin[a].data(), this->Ray);
    }
    this->LookUp(this->Values.C[0], this->AtBegin);
    this->ValueAtEnd = this->Values.At(hn::Set(d, 1.0f));
    this->LookUp(this->ValueAtEnd, this->AtEnd);
  }

  /// \param gradients of the cells, if the volume has any
  HWY_INLINE void Add(const CornerGradients& gradients)
  {
    const Floats d;
    const V zero = hn::Zero(d);
    V mean[4];
    MeanBetween(this->Values.C[0], this->AtBegin, this->ValueAtEnd, this->AtEnd, zero, mean);
    const V depth = hn::Mul(mean[0], this->Length);
    const V seen =
      hn::IfThenElseZero(this->IsSegment, hn::Mul(this->Passed, hn::Min(depth, hn::Set(d, 1.0f))));
    V square = this->SquareOfSteps(depth);
    if (!this->Volume.ByGradient.Opacities.empty())
    {
      square = hn::Add(square, hn::Mul(seen, this->OpacityBend(gradients)));
    }
    if (!this->Volume.Lights)
    {
      this->AddSteps(square, gradients, [](V, V) HWY_ATTR { return Unlit(); });
      return;
    }
    V normals[3][3];
    const LightParabola light(this->LightAt(gradients, zero, normals[0]),
      this->LightAt(gradients, hn::Set(d, 0.5f), normals[1]),
      this->LightAt(gradients, hn::Set(d, 1.0f), normals[2]));
    // Two measures, as each is blind for some turns of normals between these places.
    const V turn =
      hn::Sub(hn::Set(d, 1.0f), hn::Min(Dot(normals[0], normals[1]), Dot(normals[1], normals[2])));
    const V ofLight = hn::Mul(seen,
      hn::Max(hn::Mul(light.Off, hn::Set(d, StepsOfBend)), hn::Mul(turn, hn::Set(d, StepsOfTurn))));
    const M isSmooth = hn::Le(ofLight, hn::Set(d, MostOfParabola));
    this->AddSteps(hn::Add(square, hn::IfThenElseZero(hn::Not(isSmooth), ofLight)), gradients,
      [&](V at, V spread) HWY_ATTR
      {
        ReflectedLight<V> found = light.At(at, spread);
        if (!hn::AllTrue(d, isSmooth))
        {
          V ignored[3];
          const ReflectedLight<V> exact = this->LightAt(gradients, at, ignored);
          for (std::size_t a = 0; a < 3; ++a)
          {
            found.Matt[a] = hn::IfThenElse(isSmooth, found.Matt[a], exact.Matt[a]);
            found.Shine[a] = hn::IfThenElse(isSmooth, found.Shine[a], exact.Shine[a]);
          }
        }
        return found;
      });
  }

  /// Store what the rays have seen.
  HWY_INLINE void Finish() const
  {
    const Floats d;
    const std::size_t count = hn::CountTrue(d, this->IsSegment);
    std::int32_t rays[WidestVector];
    hn::StoreU(this->Ray, Integers(), rays);
    const auto store = [&](V value, RayBatch::Array<float>& array) HWY_ATTR
    {
      float values[WidestVector];
      hn::StoreU(value, d, values);
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
  /// The square of the steps that the field and the transfer function ask for.
  HWY_INLINE V SquareOfSteps(V depth) const
  {
    const Floats d;
    // What a straight line misses falls with the square of the steps.
    const V off =
      hn::Mul(this->SteepnessOf(this->Volume.Tables), hn::Mul(this->Bend, this->Length));
    const V steps = hn::Mul(hn::Mul(depth, this->Passed), hn::Set(d, 1.0f / DepthOfStep));
    return hn::Max(hn::Mul(hn::Mul(off, this->Passed), hn::Set(d, 1.0f / DepthTolerance)),
      hn::Mul(steps, steps));
  }

  /// The square of the steps that gradient opacities ask for, where all is seen of a segment.
  HWY_INLINE V OpacityBend(const CornerGradients& gradients) const
  {
    const Floats d;
    const V middle = this->OpacityAt(gradients, hn::Set(d, 0.5f));
    const V first = hn::Sub(middle, this->OpacityAt(gradients, hn::Zero(d)));
    const V second = hn::Sub(this->OpacityAt(gradients, hn::Set(d, 1.0f)), middle);
    const V change = hn::Max(hn::Max(hn::Abs(first), hn::Abs(second)), hn::Set(d, 0.01f));
    return hn::Mul(change, hn::Set(d, StepsOfOpacity));
  }

  /// Add segments step by step.
  /// \param square  of the number of first steps
  /// \param lightAt finds the light around a place, with the mean square of the distance from it
  template <typename LightAt>
  HWY_INLINE void AddSteps(V square, const CornerGradients& gradients, const LightAt& lightAt)
  {
    const Floats d;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f), half = hn::Set(d, 0.5f);
    const V first =
      hn::Div(one, hn::Min(hn::Max(hn::Ceil(hn::Sqrt(square)), one), hn::Set(d, MostSteps)));
    V begin = zero, step = first, value = this->Values.C[0];
    EmissionAt last = this->AtBegin;
    V opacity = this->OpacityAt(gradients, zero);
    M isOn = this->IsSegment;
    while (!hn::AllFalse(d, isOn))
    {
      // What is left over of a segment is a part of its last step.
      const M isLast = hn::Gt(hn::Add(begin, hn::Mul(step, hn::Set(d, 1.001f))), one);
      const V end = hn::IfThenElse(isLast, one, hn::Add(begin, step));
      V next = this->ValueAtEnd;
      EmissionAt there = this->AtEnd;
      if (!hn::AllTrue(d, hn::Or(isLast, hn::Not(isOn))))
      {
        next = this->Values.At(end);
        this->LookUp(next, there);
      }
      const V share = hn::Sub(end, begin);
      const V middle = this->Values.At(hn::Add(begin, hn::Mul(half, share)));
      const V lift =
        hn::Mul(hn::Set(d, 2.0f / 3.0f), hn::Sub(middle, hn::Mul(half, hn::Add(value, next))));
      V mean[4];
      MeanBetween(value, last, next, there, lift, mean);
      V depth = hn::Mul(hn::Mul(mean[0], this->Length), share);
      const V opacityThere = this->OpacityAt(gradients, end);
      const M isShort = hn::Le(share, hn::Set(d, ShortestStep));
      const M isTaken =
        hn::And(isOn, hn::Or(isShort, this->IsGood(depth, hn::Sub(opacityThere, opacity))));
      depth =
        hn::IfThenElseZero(isTaken, hn::Mul(depth, hn::Mul(half, hn::Add(opacity, opacityThere))));
      if (!hn::AllFalse(d, hn::Gt(depth, zero)))
      {
        const V centre = CentreOf(value, last, next, there, depth);
        const V at = hn::Add(begin, hn::Mul(centre, share));
        PullColors(last, there, depth, mean);
        const V spread = hn::Mul(hn::Mul(share, share), hn::Set(d, 1.0f / 12.0f));
        this->AddStep(at, depth, mean, lightAt(at, spread));
      }
      // Steps that are too long are tried again, and what follows short ones is longer again.
      step = hn::IfThenElse(
        isTaken, hn::Min(first, hn::Add(step, step)), hn::Mul(hn::Set(d, 0.25f), share));
      begin = hn::IfThenElse(isTaken, end, begin);
      value = hn::IfThenElse(isTaken, next, value);
      opacity = hn::IfThenElse(isTaken, opacityThere, opacity);
      Take(isTaken, there, last);
      isOn = hn::And(isOn, hn::And(hn::Lt(begin, one), hn::Gt(this->Passed, hn::Set(d, 1e-4f))));
    }
  }

  /// The largest change of extinction from bin to bin in segments.
  HWY_INLINE V SteepnessOf(const TransferTables& tables) const
  {
    const Floats d;
    const std::size_t count = tables.Steepness.size() / TransferTables::Levels;
    const V last = hn::Set(d, static_cast<float>(count - 1));
    const V perBlock = hn::Set(d, 1.0f / (1 << TransferTables::BlockBits));
    const V block = hn::Floor(hn::Min(hn::Max(hn::Mul(this->Middle, perBlock), hn::Zero(d)), last));
    V place = block;
    for (int level = 0; level < TransferTables::Levels - 1; ++level)
    {
      const V reach = hn::Set(d, static_cast<float>(1 << (TransferTables::BlockBits + level)));
      place = hn::Add(place,
        hn::IfThenElseZero(hn::Gt(this->Span, reach), hn::Set(d, static_cast<float>(count))));
    }
    return hn::GatherIndex(d, tables.Steepness.data(), hn::ConvertTo(Integers(), place));
  }

  /// True where a step may be taken.
  /// \param change of the gradient opacity
  HWY_INLINE M IsGood(V depth, V change) const
  {
    const Floats d;
    const V seen = hn::Mul(this->Passed, hn::Min(depth, hn::Set(d, 1.0f)));
    return hn::And(hn::Le(hn::Mul(depth, this->Passed), hn::Set(d, MostDepthOfStep)),
      hn::Le(hn::Mul(hn::Abs(change), seen), hn::Set(d, MostOpacityChange)));
  }

  static HWY_INLINE void Take(M isTaken, const EmissionAt& there, EmissionAt& last)
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      last.Value[i] = hn::IfThenElse(isTaken, there.Value[i], last.Value[i]);
      last.Sum[i] = hn::IfThenElse(isTaken, there.Sum[i], last.Sum[i]);
    }
    last.Moment = hn::IfThenElse(isTaken, there.Moment, last.Moment);
  }

  static HWY_INLINE ReflectedLight<V> Unlit()
  {
    const Floats d;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f);
    return { { one, one, one }, { zero, zero, zero } };
  }

  HWY_INLINE void PlaceAt(V share, V place[3]) const
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      place[a] = hn::Add(this->Begin[a], hn::Mul(share, this->Across[a]));
    }
  }

  /// \param normal there, of unit length
  HWY_INLINE ReflectedLight<V> LightAt(const CornerGradients& gradients, V share, V normal[3]) const
  {
    V place[3], gradient[3], point[3];
    this->PlaceAt(share, place);
    gradients.At(place, gradient);
    FindNormals(this->Volume.WorldFromGradient, gradient, normal);
    const V t = hn::Add(this->Enter, hn::Mul(share, this->Length));
    for (std::size_t a = 0; a < 3; ++a)
    {
      point[a] = hn::Add(this->Eye[a], hn::Mul(t, this->Direction[a]));
    }
    return Reflect<V>(*this->Volume.Lights, { normal, this->Direction, point });
  }

  /// The mean place of what is emitted in a step, as a share of it.
  static HWY_INLINE V CentreOf(V a, const EmissionAt& atA, V b, const EmissionAt& atB, V depth)
  {
    const Floats d;
    const V one = hn::Set(d, 1.0f), least = hn::Set(d, 1e-20f);
    const V difference = hn::Sub(b, a), sum = hn::Sub(atB.Sum[0], atA.Sum[0]);
    const V product = hn::Mul(difference, sum);
    const M isFar =
      hn::And(hn::Ge(hn::Abs(difference), hn::Set(d, 4.0f)), hn::Gt(hn::Abs(product), least));
    const V moment = hn::Sub(hn::Sub(atB.Moment, atA.Moment), hn::Mul(a, sum));
    const V ends = hn::Add(hn::Add(atA.Value[0], atB.Value[0]), least);
    // Where values are close together, extinction changes evenly.
    const V above =
      hn::IfThenElse(isFar, moment, hn::Mul(hn::Set(d, 1.0f / 3.0f), hn::Add(ends, atB.Value[0])));
    const V share = hn::Div(above, hn::IfThenElse(isFar, product, ends));
    const V pulled = hn::Mul(hn::Min(depth, hn::Set(d, 3.0f)), hn::Set(d, 1.0f / 12.0f));
    return hn::Min(hn::Max(hn::Sub(share, pulled), hn::Zero(d)), one);
  }

  /// Of what is emitted in a step, more is seen of its beginning than of its end. Where both emit,
  /// colours change evenly in between.
  static HWY_INLINE void PullColors(
    const EmissionAt& begin, const EmissionAt& end, V depth, V mean[4])
  {
    const Floats d;
    const V one = hn::Set(d, 1.0f), least = hn::Set(d, 1e-20f);
    const V larger = hn::Max(begin.Value[0], end.Value[0]);
    const V smaller = hn::Min(begin.Value[0], end.Value[0]);
    const M isPulled = hn::Gt(smaller, hn::Mul(hn::Set(d, 1e-3f), larger));
    const V perBegin = hn::Div(one, hn::Max(begin.Value[0], least));
    const V perEnd = hn::Div(one, hn::Max(end.Value[0], least));
    const V pull = hn::IfThenElseZero(isPulled,
      hn::Mul(hn::Mul(hn::Min(depth, hn::Set(d, 3.0f)), hn::Set(d, 1.0f / 12.0f)), mean[0]));
    for (std::size_t i = 1; i < 4; ++i)
    {
      const V rise = hn::Sub(hn::Mul(end.Value[i], perEnd), hn::Mul(begin.Value[i], perBegin));
      mean[i] = hn::Max(hn::Sub(mean[i], hn::Mul(pull, rise)), hn::Zero(d));
    }
  }

  HWY_INLINE void LookUp(V value, EmissionAt& at) const
  {
    const Floats d;
    const Integers di;
    const TransferTables& tables = this->Volume.Tables;
    const V zero = hn::Zero(d), one = hn::Set(d, 1.0f), half = hn::Set(d, 0.5f);
    const V last = hn::Set(d, static_cast<float>(tables.Bins));
    const V bin = hn::Min(hn::Max(hn::Floor(value), zero), last);
    // Above the range there is only the beginning of a bin.
    const V inBin = hn::IfThenElseZero(hn::Lt(bin, last), hn::Sub(value, bin));
    const V share = hn::Min(hn::Max(inBin, zero), one);
    const V beyond = hn::Sub(hn::Sub(value, bin), share);
    std::int32_t bins[WidestVector];
    hn::StoreU(hn::ConvertTo(di, bin), di, bins);
    // Four numbers lie side by side: copies of all of them are faster than gathering each.
    HWY_ALIGN float values[4 * WidestVector], rises[4 * WidestVector], sums[4 * WidestVector];
    HWY_ALIGN float moments[WidestVector], boosts[WidestVector];
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane)
    {
      const EmissionBin& from = tables.All[static_cast<std::size_t>(bins[lane])];
      std::memcpy(values + 4 * lane, from.Value.data(), sizeof(from.Value));
      std::memcpy(rises + 4 * lane, from.Rise.data(), sizeof(from.Rise));
      std::memcpy(sums + 4 * lane, from.Sum.data(), sizeof(from.Sum));
      moments[lane] = from.Moment;
      boosts[lane] = from.Boost;
    }
    V rise[4];
    hn::LoadInterleaved4(d, values, at.Value[0], at.Value[1], at.Value[2], at.Value[3]);
    hn::LoadInterleaved4(d, rises, rise[0], rise[1], rise[2], rise[3]);
    hn::LoadInterleaved4(d, sums, at.Sum[0], at.Sum[1], at.Sum[2], at.Sum[3]);
    // The moment of what lies between the node and the value, about half way.
    const V middle = hn::Add(bin, hn::Mul(half, hn::Add(share, beyond)));
    const V between = hn::Mul(hn::Add(share, beyond), middle);
    const V boost = hn::IfThenElse(hn::Eq(share, zero), hn::Load(d, boosts), one);
    for (std::size_t i = 0; i < 4; ++i)
    {
      const V mean = hn::Add(at.Value[i], hn::Mul(hn::Mul(half, share), rise[i]));
      const V here = hn::Add(at.Value[i], hn::Mul(share, rise[i]));
      at.Value[i] = hn::Mul(boost, here);
      at.Sum[i] = hn::Add(at.Sum[i], hn::Add(hn::Mul(share, mean), hn::Mul(beyond, here)));
      if (i == 0)
      {
        at.Moment = hn::Add(hn::Load(d, moments), hn::Mul(between, mean));
      }
    }
  }

  /// The mean emission of a stretch on which values go from one to another.
  /// \param lift how far the mean value is above that of both ends
  HWY_INLINE void MeanBetween(
    V a, const EmissionAt& atA, V b, const EmissionAt& atB, V lift, V mean[4]) const
  {
    const Floats d;
    const V one = hn::Set(d, 1.0f);
    const V difference = hn::Sub(b, a);
    // The difference of sums loses its digits where these are close together.
    const M isClose = hn::Lt(hn::Abs(difference), hn::Set(d, this->Volume.Tables.Closest));
    // Sums do not count all of what is opaque at once.
    const M isOpaque =
      hn::Gt(hn::Max(atA.Value[0], atB.Value[0]), hn::Set(d, this->Volume.Tables.MostCounted));
    const V perBin = hn::Div(one, hn::IfThenElse(isClose, one, difference));
    const V lifted = hn::IfThenElseZero(hn::Not(isClose), lift);
    for (std::size_t i = 0; i < 4; ++i)
    {
      // The sums of the straight line that has the same mean value.
      const V more = hn::Mul(lifted, hn::Sub(atB.Value[i], atA.Value[i]));
      const V far = hn::Mul(hn::Add(hn::Sub(atB.Sum[i], atA.Sum[i]), more), perBin);
      const V close = hn::Mul(hn::Set(d, 0.5f), hn::Add(atA.Value[i], atB.Value[i]));
      mean[i] = hn::Max(hn::IfThenElse(hn::Or(isClose, isOpaque), close, far), hn::Zero(d));
    }
  }

  /// Composite a step behind what has been seen.
  HWY_INLINE void AddStep(V at, V depth, const V mean[4], const ReflectedLight<V>& light)
  {
    const Floats d;
    const V zero = hn::Zero(d);
    const V left = hn::Mul(this->Passed, ExpOfMinus(depth));
    const V perMean = hn::Div(hn::Sub(this->Passed, left), hn::Max(mean[0], hn::Set(d, 1e-30f)));
    for (std::size_t a = 0; a < 3; ++a)
    {
      const V lit = hn::Add(hn::Mul(mean[a + 1], light.Matt[a]), hn::Mul(mean[0], light.Shine[a]));
      const V emitted = hn::Min(hn::Max(lit, zero), mean[0]);
      this->Color[a] = hn::Add(this->Color[a], hn::Mul(perMean, emitted));
    }
    this->NoteFirst(hn::Gt(depth, hn::Set(d, 1e-4f)), at);
    this->Passed = left;
  }

  /// Note where rays first see anything.
  HWY_INLINE void NoteFirst(M isSeen, V at) const
  {
    const Floats d;
    const M isFirst = hn::And(isSeen, hn::Gt(this->Passed, hn::Set(d, 0.9999f)));
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

  HWY_INLINE V OpacityAt(const CornerGradients& gradients, V share) const
  {
    const Floats d;
    const Integers di;
    const GradientTable& table = this->Volume.ByGradient;
    if (table.Opacities.empty())
    {
      return hn::Set(d, 1.0f);
    }
    V place[3], gradient[3];
    this->PlaceAt(share, place);
    gradients.At(place, gradient);
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
    const V floor = hn::Min(hn::Floor(clamped), last);
    const I index = hn::ConvertTo(di, floor);
    const V low = hn::GatherIndex(d, table.Opacities.data(), index);
    const V high = hn::GatherIndex(d, table.Opacities.data() + 1, index);
    return hn::Add(low, hn::Mul(hn::Sub(clamped, floor), hn::Sub(high, low)));
  }

  const EmittingVolume& Volume;
  BlendedRays& Seen;
  M IsSegment;
  I Ray;
  V Enter, Length, Middle, Span, Bend;
  Line Values;
  V ValueAtEnd;
  EmissionAt AtBegin, AtEnd;
  V Passed, Color[3], Direction[3], Eye[3], Begin[3], Across[3];
};

/// \param loaderAt makes what loads the samples around the cells of a vector
template <typename LoaderAt>
HWY_INLINE void AddAll(const EmittingVolume& volume, const LitRays& rays,
  const VolumeSegments& segments, const LoaderAt& loaderAt, BlendedRays& seen)
{
  for (std::size_t i = 0; i < static_cast<std::size_t>(segments.Count); i += hn::Lanes(Floats()))
  {
    SegmentVector vector(volume, rays, segments, i, seen);
    vector.Add(volume.HasGradients() ? CornerGradients(loaderAt(i)) : CornerGradients());
    vector.Finish();
  }
}

void AddOfValues(const EmittingVolume& volume, const LitRays& rays, const VolumeSegments& segments,
  const SamplesAround& around, BlendedRays& seen)
{
  AddAll(
    volume, rays, segments,
    [&](std::size_t i) HWY_ATTR {
      return ArrayLoader{ around, i };
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
    [&](std::size_t i) HWY_ATTR { return RowLoader<T>(samples, segments, i, perValue); }, seen);
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
