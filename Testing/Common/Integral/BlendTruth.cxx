// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Integral/BlendTruth.h"
#include "Checks/Infinity.h"

#include <algorithm>
#include <array>
#include <cmath>

using namespace TemporalCoherence;

namespace
{

/// Gauss's points and weights on [0, 1], exact for polynomials of degree 5.
constexpr std::array<double, 3> GaussAt{ 0.11270166537925831, 0.5, 0.8872983346207417 };
constexpr std::array<double, 3> GaussWeight{ 5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0 };

/// Where a linear function of t, zero at `root`, cuts what is kept.
void ClipTo(double atBegin, double slope, double& begin, double& end)
{
  // atBegin + slope * t >= 0 is kept.
  if (slope == 0.0)
  {
    end = atBegin < 0.0 ? -Infinity : end;
    return;
  }
  const double root = -atBegin / slope;
  begin = slope > 0.0 ? std::max(begin, root) : begin;
  end = slope < 0.0 ? std::min(end, root) : end;
}

}

/// What is found along a ray.
struct BlendTruth::Sums
{
  Veil Seen;
  bool IsAnyKept = false;                    ///< some part of the ray is
  bool HasValues = false;                    ///< some visible cell was met
  std::array<double, 4> Extremes{};          ///< Maximum, Minimum
  std::array<double, 4> Shares{}, Lengths{}; ///< Average, Additive
};

BlendTruthLook::Place BlendTruth::Line::At(double t) const
{
  return { this->IndexOrigin + t * this->IndexDirection, this->Origin + t * this->Direction,
    this->Direction };
}

BlendTruth::BlendTruth(const FrameKey& key, const GridCoordinates* coordinates)
  : Key(key)
  , Field(key, coordinates)
  , Look(key, this->Field)
{
  for (std::size_t c = 0; c < this->Field.Components(); ++c)
  {
    this->Bends.push_back(this->Look.Bends(c));
  }
}

glm::dvec4 BlendTruth::ShownAt(int x, int y) const
{
  const glm::dvec4 color = this->At(x, y);
  const Appearance& appearance = this->Key.Appearance;
  const glm::dvec3 shown =
    appearance.ColorScale * glm::dvec3(color) + appearance.ColorShift * color.w;
  return 255.0 * glm::clamp(glm::dvec4(shown, color.w), 0.0, 1.0);
}

glm::dvec4 BlendTruth::At(int x, int y) const
{
  const Ray ray = this->Key.View.RayThrough(x, y);
  const glm::dmat4& toIndex = this->Key.Transform.IndexFromWorld;
  const Line line{ ray.Origin, ray.Direction, glm::dvec3(toIndex * glm::dvec4(ray.Origin, 1.0)),
    glm::dvec3(toIndex * glm::dvec4(ray.Direction, 0.0)) };
  const auto pixel = static_cast<std::size_t>(y * this->Key.View.Size.x + x);
  const auto& ends = this->Key.Blended().Ends;
  double entry = 0.0;
  const std::vector<Part> kept = this->KeptOf(line, ends ? (*ends)[pixel] : Infinity, entry);
  Sums sums;
  sums.IsAnyKept = !kept.empty();
  if (this->Key.Blended().SampleDistance > 0.0)
  {
    this->AddSamples(line, kept, entry, sums);
  }
  else
  {
    for (const Part& part : kept)
    {
      this->AddCells(line, part, sums);
    }
  }
  return this->ColorOf(sums);
}

bool BlendTruth::IsKept(const glm::dvec3& index) const
{
  const Region& region = this->Key.Region;
  int box = 0;
  for (int axis = 2; axis >= 0; --axis)
  {
    const glm::dvec2& crop = region.Crops[static_cast<std::size_t>(axis)];
    const int third = index[axis] < crop.x ? 0 : index[axis] <= crop.y ? 1 : 2;
    box = 3 * box + third;
  }
  return region.Boxes == Region::AllBoxes || (region.Boxes >> box & 1u) != 0;
}

/// The parts of a ray that the box, the clipping range and the region keep.
/// \param entry becomes where the ray enters, whatever cropping keeps
std::vector<BlendTruth::Part> BlendTruth::KeptOf(const Line& line, double end, double& entry) const
{
  const View& view = this->Key.View;
  double begin = 0.0;
  const glm::dvec3 last = this->Field.Last();
  for (int axis = 0; axis < 3; ++axis)
  {
    ClipTo(line.IndexOrigin[axis], line.IndexDirection[axis], begin, end);
    ClipTo(last[axis] - line.IndexOrigin[axis], -line.IndexDirection[axis], begin, end);
  }
  const double depth = glm::dot(line.Origin - view.Position, view.Forward);
  const double perDepth = glm::dot(line.Direction, view.Forward);
  ClipTo(depth - view.Near, perDepth, begin, end);
  ClipTo(view.Far - depth, -perDepth, begin, end);
  for (const glm::dvec4& plane : this->Key.Region.Clips)
  {
    const glm::dvec3 normal(plane);
    ClipTo(glm::dot(normal, line.Origin) + plane.w, glm::dot(normal, line.Direction), begin, end);
  }
  entry = begin;
  std::vector<double> cuts{ begin, end };
  for (int axis = 0; axis < 3 && this->Key.Region.Boxes != Region::AllBoxes; ++axis)
  {
    for (int side = 0; side < 2; ++side)
    {
      const double crop = this->Key.Region.Crops[static_cast<std::size_t>(axis)][side];
      const double t = (crop - line.IndexOrigin[axis]) / line.IndexDirection[axis];
      if (t > begin && t < end)
      {
        cuts.push_back(t);
      }
    }
  }
  std::sort(cuts.begin(), cuts.end());
  std::vector<Part> kept;
  for (std::size_t i = 1; begin < end && i < cuts.size(); ++i)
  {
    if (cuts[i - 1] < cuts[i] && this->IsKept(line.At(0.5 * (cuts[i - 1] + cuts[i])).Index))
    {
      kept.push_back({ cuts[i - 1], cuts[i] });
    }
  }
  return kept;
}

void BlendTruth::AddCells(const Line& line, const Part& kept, Sums& sums) const
{
  std::vector<double> cuts{ kept.Begin, kept.End };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double plane : this->Field.Breaks(axis))
    {
      const double t = (plane - line.IndexOrigin[axis]) / line.IndexDirection[axis];
      if (t > kept.Begin && t < kept.End)
      {
        cuts.push_back(t);
      }
    }
  }
  std::sort(cuts.begin(), cuts.end());
  BlendTruthField::Cell cell;
  constexpr double nothing = 1e-9;
  for (std::size_t i = 1; i < cuts.size() && sums.Seen.Passed > nothing; ++i)
  {
    const Part part{ cuts[i - 1], cuts[i] };
    if (part.Begin < part.End)
    {
      this->Field.Read(line.At(0.5 * (part.Begin + part.End)).Index, cell);
      if (cell.IsVisible)
      {
        this->AddCell(line, cell, part, sums);
      }
    }
  }
}

std::array<double, 4> BlendTruth::ValuesAt(
  const Line& line, const BlendTruthField::Cell& cell, double t) const
{
  std::array<double, 4> values{};
  for (std::size_t c = 0; c < this->Field.Components(); ++c)
  {
    values[c] = this->Field.ValueAt(cell, c, line.At(t).Index);
  }
  return values;
}

/// Where in a cell a component turns, or comes to a bend of its functions; and its gradient.
std::vector<double> BlendTruth::BreaksOf(
  const Line& line, const BlendTruthField::Cell& cell, const Part& part) const
{
  std::vector<double> breaks{ part.Begin, part.End };
  for (std::size_t c = 0; c < this->Field.Components() && !this->Field.IsNearest(); ++c)
  {
    BlendTruthBreaks::AddOfCubic([&](double t)
      { return this->Field.ValueAt(cell, c, line.At(t).Index); },
      part, this->Bends[c], breaks);
  }
  const bool isLit = this->Key.Blended().Mode == BlendMode::Composite && !this->Field.IsNearest();
  for (std::size_t c = 0; c < this->Look.Parts() && isLit; ++c)
  {
    const std::vector<double> bends = this->Look.GradientBends(c);
    if (!bends.empty())
    {
      BlendTruthBreaks::AddOfSmooth([&](double t)
        { return this->Look.SteepnessAt(c, cell, line.At(t).Index); },
        part, bends, breaks);
    }
  }
  std::sort(breaks.begin(), breaks.end());
  return breaks;
}

void BlendTruth::AddCell(
  const Line& line, const BlendTruthField::Cell& cell, const Part& part, Sums& sums) const
{
  const BlendMode mode = this->Key.Blended().Mode;
  const std::vector<double> breaks = this->BreaksOf(line, cell, part);
  if (mode == BlendMode::Maximum || mode == BlendMode::Minimum)
  {
    const std::vector<double> middle{ 0.5 * (part.Begin + part.End) };
    for (const double t : this->Field.IsNearest() ? middle : breaks)
    {
      this->AddValues(this->ValuesAt(line, cell, t), sums);
    }
    return;
  }
  for (std::size_t i = 1; i < breaks.size(); ++i)
  {
    if (breaks[i - 1] < breaks[i])
    {
      this->AddPart(line, cell, { breaks[i - 1], breaks[i] }, sums);
    }
  }
}

/// Add a part between breaks: everything is smooth there, except for light.
void BlendTruth::AddPart(
  const Line& line, const BlendTruthField::Cell& cell, const Part& part, Sums& sums) const
{
  if (this->Key.Blended().Mode != BlendMode::Composite)
  {
    this->AddShares(line, cell, part, sums);
    return;
  }
  constexpr int mostHalves = 24;
  const Veil veil = this->VeilWithin(
    line, cell, part, this->VeilOf(line, cell, part), sums.Seen.Passed, mostHalves);
  sums.Seen.Color += sums.Seen.Passed * veil.Color;
  sums.Seen.Passed *= veil.Passed;
}

/// A part of a ray from what it is at three places.
BlendTruth::Veil BlendTruth::VeilOf(
  const Line& line, const BlendTruthField::Cell& cell, const Part& part) const
{
  Veil veil;
  const double length = part.End - part.Begin;
  for (std::size_t i = 0; i < GaussAt.size(); ++i)
  {
    const BlendTruthLook::Medium medium =
      this->Look.MediumAt(cell, line.At(part.Begin + GaussAt[i] * length));
    if (medium.IsOpaque)
    {
      veil.Color += veil.Passed * medium.Emission;
      veil.Passed = 0.0;
      return veil;
    }
    const double step = GaussWeight[i] * length;
    const double taken = -std::expm1(-medium.Extinction * step);
    const double shown = medium.Extinction > 0.0 ? taken / medium.Extinction : step;
    veil.Color += veil.Passed * shown * medium.Emission;
    veil.Passed *= 1.0 - taken;
  }
  return veil;
}

/// The same by halves, until they agree with the whole.
BlendTruth::Veil BlendTruth::VeilWithin(const Line& line, const BlendTruthField::Cell& cell,
  const Part& part, const Veil& whole, double passed, int depth) const
{
  constexpr double tolerance = 2e-7;
  const double middle = 0.5 * (part.Begin + part.End);
  const Part first{ part.Begin, middle }, second{ middle, part.End };
  Veil front = this->VeilOf(line, cell, first), back = this->VeilOf(line, cell, second);
  const glm::dvec3 change = glm::abs(front.Color + front.Passed * back.Color - whole.Color);
  const double largest =
    std::max({ change.x, change.y, change.z, std::abs(front.Passed * back.Passed - whole.Passed) });
  if (passed * largest > tolerance && depth > 0)
  {
    front = this->VeilWithin(line, cell, first, front, passed, depth - 1);
    back = this->VeilWithin(line, cell, second, back, passed * front.Passed, depth - 1);
  }
  return { front.Color + front.Passed * back.Color, front.Passed * back.Passed };
}

/// Integrate opacity times value: polynomials in each part.
void BlendTruth::AddShares(
  const Line& line, const BlendTruthField::Cell& cell, const Part& part, Sums& sums) const
{
  const Blending& volume = this->Key.Blended();
  const double length = part.End - part.Begin;
  const std::array<double, 4> middle = this->ValuesAt(line, cell, part.Begin + 0.5 * length);
  for (std::size_t c = 0; c < this->Look.Parts(); ++c)
  {
    const bool counts = volume.AverageRange.x <= middle[c] && middle[c] <= volume.AverageRange.y;
    if (volume.Mode == BlendMode::Average && !counts)
    {
      continue;
    }
    // Opacity and value are cubics of t: four points would be exact, two halves of three are near.
    for (std::size_t i = 0; i < 2 * GaussAt.size(); ++i)
    {
      const std::size_t point = i % GaussAt.size();
      const double t =
        part.Begin + 0.5 * length * (GaussAt[point] + static_cast<double>(i / GaussAt.size()));
      sums.Shares[c] += 0.5 * length * GaussWeight[point] *
        this->Look.WeighedShareOf(c, this->ValuesAt(line, cell, t));
    }
    sums.Lengths[c] += length;
  }
}

/// Take values into account, for Maximum and Minimum.
void BlendTruth::AddValues(const std::array<double, 4>& values, Sums& sums) const
{
  const bool isMaximum = this->Key.Blended().Mode == BlendMode::Maximum;
  const auto isBeyond = [&](std::size_t c)
  {
    return !sums.HasValues ||
      (isMaximum ? values[c] > sums.Extremes[c] : values[c] < sums.Extremes[c]);
  };
  if (this->Key.Blended().Use == ComponentUse::Independent)
  {
    for (std::size_t c = 0; c < this->Field.Components(); ++c)
    {
      sums.Extremes[c] = isBeyond(c) ? values[c] : sums.Extremes[c];
    }
  }
  else if (isBeyond(this->Field.Components() - 1))
  {
    sums.Extremes = values;
  }
  sums.HasValues = true;
}

/// VTK's samples: the first lies a step behind where the ray enters.
void BlendTruth::AddSamples(
  const Line& line, const std::vector<Part>& kept, double entry, Sums& sums) const
{
  const Blending& volume = this->Key.Blended();
  const double step = volume.SampleDistance;
  BlendTruthField::Cell cell;
  auto part = kept.begin();
  for (double count = 1.0; part != kept.end(); ++count)
  {
    const double t = entry + count * step;
    part = std::find_if(part, kept.end(), [&](const Part& each) { return t <= each.End; });
    if (part == kept.end() || t < part->Begin)
    {
      continue;
    }
    const BlendTruthLook::Place place = line.At(t);
    this->Field.Read(place.Index, cell);
    if (!cell.IsVisible)
    {
      continue;
    }
    if (volume.Mode == BlendMode::Composite)
    {
      const BlendTruthLook::Medium medium = this->Look.StepAt(cell, place, step);
      sums.Seen.Color += sums.Seen.Passed * medium.Emission;
      sums.Seen.Passed *= 1.0 - medium.Extinction;
    }
    const std::array<double, 4> values = this->ValuesAt(line, cell, t);
    this->AddValues(values, sums);
    for (std::size_t c = 0; c < this->Look.Parts(); ++c)
    {
      const bool counts = volume.Mode == BlendMode::Additive ||
        (volume.AverageRange.x <= values[c] && values[c] <= volume.AverageRange.y);
      if (counts && c < volume.ScalarRanges.size())
      {
        sums.Shares[c] += step * this->Look.WeighedShareOf(c, values);
        sums.Lengths[c] += step;
      }
    }
  }
}

glm::dvec4 BlendTruth::ColorOf(const Sums& sums) const
{
  const BlendMode mode = this->Key.Blended().Mode;
  if (mode == BlendMode::Composite)
  {
    return glm::dvec4(sums.Seen.Color, 1.0 - sums.Seen.Passed);
  }
  if (mode == BlendMode::Maximum || mode == BlendMode::Minimum)
  {
    return sums.HasValues ? this->Look.BlendedColorOf(sums.Extremes) : glm::dvec4(0.0);
  }
  const bool isAverage = mode == BlendMode::Average;
  double grey = 0.0;
  bool isAnySeen = !isAverage && sums.IsAnyKept;
  for (std::size_t c = 0; c < this->Look.Parts(); ++c)
  {
    const double weight = this->Look.Parts() > 1 ? this->Look.Weight(c) : 1.0;
    const double length = isAverage ? sums.Lengths[c] : this->Look.UnitDistance(c);
    isAnySeen = isAnySeen || sums.Lengths[c] > 0.0;
    grey += length > 0.0 ? weight * sums.Shares[c] / length : 0.0;
  }
  return isAnySeen ? glm::dvec4(glm::dvec3(std::clamp(grey, 0.0, 1.0)), 1.0) : glm::dvec4(0.0);
}
