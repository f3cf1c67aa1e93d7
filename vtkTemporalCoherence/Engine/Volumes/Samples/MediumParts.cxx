// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Samples/MediumParts.h"

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

/// Error of a part, times the transmittance in front of it, at most.
constexpr float Tolerance = 1.0f / 16384.0f;
constexpr int MostHalves = 16;

/// Distance of sampled places from the ends of a part, as a share of the part.
constexpr float Inwards = 1e-4f;

/// Weights of the estimated error: of the bend between three places, and of the change of colours.
constexpr float BendCounts = 1.0f / 6.0f, ChangeCounts = 1.0f / 16.0f;

}

void MediumParts::Clear()
{
  this->Enter.clear();
  this->Segments.Rows.clear();
  this->Segments.Enter.clear();
  this->Segments.Length.clear();
  this->Places.Count = 0;
  this->Parts.clear();
}

std::int32_t MediumParts::AddPlace(std::int32_t segment, float share)
{
  const std::size_t place = this->Places.Count++;
  this->Places.Share[place] = share;
  this->Places.Segment[place] = segment;
  return static_cast<std::int32_t>(place);
}

void MediumParts::AddPart(float from, float to, bool bends)
{
  if (this->Places.Count + 3 > MediumKernels::MediumPlaces::Most)
  {
    return;
  }
  Part part;
  part.Segment = static_cast<std::int32_t>(this->NumberOfSegments()) - 1;
  part.From = from;
  part.To = to;
  part.Bends = bends;
  // At the ends, rounding might lead into the neighbouring part, or gradients may be 0.
  const float inwards = Inwards * (to - from);
  part.Begin = this->AddPlace(part.Segment, from + inwards);
  part.Middle = this->AddPlace(part.Segment, 0.5f * (from + to));
  part.End = this->AddPlace(part.Segment, to - inwards);
  this->Parts.push_back(part);
}

void MediumParts::AddEvenPart()
{
  Part part;
  part.Segment = static_cast<std::int32_t>(this->NumberOfSegments()) - 1;
  part.From = 0.0f;
  part.To = 1.0f;
  part.Begin = part.Middle = part.End = this->AddPlace(part.Segment, 0.5f);
  part.IsEven = true;
  this->Parts.push_back(part);
}

double MediumParts::Blend(Veil& seen)
{
  double first = std::numeric_limits<double>::infinity();
  MediumKernels::FindMedium(this->Look, this->Segments, 0, this->Places);
  for (Part& part : this->Parts)
  {
    const float length = this->EdgesOf(part);
    // Without bends, a part is opaque as a whole, or at one end only.
    const bool isOpaque = this->IsOpaque(part.Begin) && this->IsOpaque(part.Middle);
    const Estimate found = isOpaque ? this->OpaqueAt(part.Begin)
                                    : this->EstimateOf(part.Begin, part.Middle, part.End, length);
    part.Best = found.Veil;
    part.Error = this->Look.HasGradientOpacity && !isOpaque ? 1.0f : found.Error;
  }
  for (std::size_t known = this->Places.Count; this->Refine(seen.Passed);
       known = this->Places.Count)
  {
    this->FindHalves(known);
  }
  for (const Part& part : this->Parts)
  {
    if (part.Best.Passed < 1.0f)
    {
      const auto segment = static_cast<std::size_t>(part.Segment);
      first = std::min(first,
        this->Enter[segment] + static_cast<double>(part.From * this->Segments.Length[segment]));
    }
    seen = seen.Before(part.Best);
  }
  this->Clear();
  return first;
}

MediumParts::Estimate MediumParts::OpaqueAt(std::int32_t place) const
{
  const auto at = static_cast<std::size_t>(place);
  const glm::vec3 seen(
    this->Places.Emission[0][at], this->Places.Emission[1][at], this->Places.Emission[2][at]);
  return { { seen, 0.0f }, 0.0f };
}

/// Estimate half of a part with known quarters.
MediumParts::Estimate MediumParts::HalfOf(const Part& part, bool isBack) const
{
  const std::int32_t begin = isBack ? part.Middle : part.Begin;
  const std::int32_t middle = part.Quarters[isBack ? 1 : 0];
  const std::int32_t end = isBack ? part.End : part.Middle;
  // Rounding makes opacities close to 1 opaque.
  if (part.Bends && this->IsOpaque(begin) && this->IsOpaque(middle) && this->IsOpaque(end))
  {
    return this->OpaqueAt(begin);
  }
  return this->EstimateOf(begin, middle, end, 0.5f * this->EdgesOf(part));
}

/// Estimate a part from three places, by Simpson's rule for its depth and its light.
MediumParts::Estimate MediumParts::EstimateOf(
  std::int32_t begin, std::int32_t middle, std::int32_t end, float length) const
{
  const auto a = static_cast<std::size_t>(begin), b = static_cast<std::size_t>(middle),
             c = static_cast<std::size_t>(end);
  const auto& found = this->Places.Extinction;
  const auto emitted = [this](std::size_t place)
  {
    return glm::vec3(this->Places.Emission[0][place], this->Places.Emission[1][place],
      this->Places.Emission[2][place]);
  };
  // A single opaque place is the end of a ramp: take its finite extinction.
  const float taken[3] = { std::abs(found[a]), std::abs(found[b]), std::abs(found[c]) };
  const auto light = [&](std::size_t place)
  { return found[place] < 0.0f ? std::abs(found[place]) * emitted(place) : emitted(place); };
  const float sixth = length / 6.0f;
  const float depth = sixth * (taken[0] + 4.0f * taken[1] + taken[2]);
  if (!(depth > 0.0f))
  {
    return { {}, 0.0f };
  }
  const glm::vec3 first = light(a), between = light(b), last = light(c);
  glm::vec3 sum = sixth * (first + 4.0f * between + last);
  // A part absorbs more of the light from its end than from its beginning: correct this to first
  // order in the depth, for linear light and extinction.
  const float pull = std::min(depth, 3.0f) / 12.0f;
  const float rise = length * (taken[2] - taken[0]) / depth;
  sum = glm::max(sum - pull * (length * (last - first) - rise * sum), glm::vec3(0.0f));
  const float passed = std::exp(-depth);
  const float share = depth > 1e-3f ? (1.0f - passed) / depth : 1.0f - 0.5f * depth;
  // Find the deviations of light and extinction from a line, and the change of colours in absorbing
  // parts.
  const glm::vec3 bend = glm::abs(first - 2.0f * between + last);
  const glm::vec3 change = glm::abs(taken[2] * first - taken[0] * last);
  const float bent = std::max(
    std::max(bend.x, bend.y), std::max(bend.z, std::abs(taken[0] - 2.0f * taken[1] + taken[2])));
  const float changed = std::max(change.x, std::max(change.y, change.z));
  return { { share * sum, passed },
    length * (BendCounts * bent + ChangeCounts * length * changed) };
}

/// Add the quarters of parts with too large an error, and halve these parts if the error is still
/// too large.
/// \param passed transmittance in front of all parts
/// \return false if all parts are finished
bool MediumParts::Refine(float passed)
{
  bool isDivided = false;
  this->Next.clear();
  for (Part& part : this->Parts)
  {
    const float before = passed;
    passed *= part.Best.Passed;
    const bool isKnown = part.Quarters[0] >= 0;
    if (part.IsEven || !(before * part.Error > Tolerance) || part.Halved >= MostHalves ||
      !this->HasRoom())
    {
      this->Next.push_back(part);
      continue;
    }
    isDivided = true;
    if (!isKnown)
    {
      const float step = 0.25f * (part.To - part.From);
      part.Quarters[0] = this->AddPlace(part.Segment, part.From + step);
      part.Quarters[1] = this->AddPlace(part.Segment, part.To - step);
      this->Next.push_back(part);
      continue;
    }
    Part half = part;
    half.Halved = static_cast<std::int8_t>(part.Halved + 1);
    half.To = 0.5f * (part.From + part.To);
    half.Middle = part.Quarters[0];
    half.End = part.Middle;
    half.Best = part.Front.Veil;
    half.Error = part.Front.Error;
    half.Quarters[0] = half.Quarters[1] = -1;
    this->Next.push_back(half);
    half.From = half.To;
    half.To = part.To;
    half.Begin = part.Middle;
    half.Middle = part.Quarters[1];
    half.End = part.End;
    half.Best = part.Back.Veil;
    half.Error = part.Back.Error;
    this->Next.push_back(half);
  }
  this->Parts.swap(this->Next);
  return isDivided;
}

/// Evaluate the places from number `from` on, and estimate halves from new quarters.
void MediumParts::FindHalves(std::size_t from)
{
  MediumKernels::FindMedium(this->Look, this->Segments, from, this->Places);
  for (Part& part : this->Parts)
  {
    if (part.Quarters[0] < static_cast<std::int32_t>(from))
    {
      continue;
    }
    part.Front = this->HalfOf(part, false);
    part.Back = this->HalfOf(part, true);
    const Veil both = part.Front.Veil.Before(part.Back.Veil);
    const glm::vec3 change = glm::abs(both.Color - part.Best.Color);
    part.Error =
      std::max({ change.x, change.y, change.z, std::abs(both.Passed - part.Best.Passed) });
    part.Best = both;
  }
}

}
