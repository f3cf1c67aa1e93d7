// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/ZarrImage.h"

#include <cmath>

namespace TemporalCoherence
{
namespace
{

constexpr std::size_t FewestAxes = 2, MostAxes = 5;

ZarrAxis AxisOf(const std::string& name, const std::string& type)
{
  return type == "time" || (type.empty() && name == "t")           ? ZarrAxis::Time
    : type == "channel" || (type.empty() && name == "c")           ? ZarrAxis::Channel
    : type == "space" || name == "x" || name == "y" || name == "z" ? ZarrAxis::Space
                                                                   : ZarrAxis::Other;
}

/// The number of axes of space at the end of the list, or 0 if some come earlier.
std::size_t CountSpace(const std::vector<ZarrAxis>& axes)
{
  std::size_t count = 0, last = 0;
  for (const ZarrAxis axis : axes)
  {
    count += axis == ZarrAxis::Space ? 1 : 0;
    last = axis == ZarrAxis::Space ? last + 1 : 0;
  }
  return count == last ? count : 0;
}

/// Read the axes: objects, or names only in older versions, or nothing in the oldest ones.
bool ParseAxes(const Json& list, std::vector<ZarrAxis>& axes, std::string& defect)
{
  axes = UnnamedZarrAxes(MostAxes);
  if (list.is_null())
  {
    return true;
  }
  axes.clear();
  std::string names;
  for (const Json& axis : list)
  {
    const std::string name = axis.is_string() ? axis.get<std::string>() : TextOf(axis, "name");
    axes.push_back(AxisOf(name, TextOf(axis, "type")));
    names += axes.back() == ZarrAxis::Space ? name : std::string();
  }
  const std::size_t space = CountSpace(axes);
  // Names are free, but those of the other order would swap x and z.
  const bool isReversed = names == "xyz" || names == "xy";
  defect = "has axes other than t, c, z, y and x in this order; write the volume with these axes";
  return list.is_array() && axes.size() >= FewestAxes && axes.size() <= MostAxes && !isReversed &&
    (space == 2 || space == 3);
}

bool ParseNumbers(const Json& list, std::size_t count, std::vector<double>& numbers)
{
  numbers.clear();
  for (const Json& number : list)
  {
    numbers.push_back(number.is_number() ? number.get<double>() : std::nan(""));
    if (!std::isfinite(numbers.back()))
    {
      return false;
    }
  }
  return list.is_array() && numbers.size() == count;
}

/// Apply a scale or a translation after the level's earlier transformations.
bool ApplyTransformation(const Json& transformation, ZarrImageLevel& level)
{
  const std::string type = TextOf(transformation, "type");
  if (type == "identity")
  {
    return true;
  }
  std::vector<double> numbers;
  if ((type != "scale" && type != "translation") ||
    !ParseNumbers(MemberOf(transformation, type.c_str()), level.Scale.size(), numbers))
  {
    return false;
  }
  const bool isScale = type == "scale";
  level.HasScale = level.HasScale || isScale;
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    level.Scale[i] *= isScale ? numbers[i] : 1.0;
    level.Translation[i] =
      isScale ? level.Translation[i] * numbers[i] : level.Translation[i] + numbers[i];
  }
  return true;
}

bool ApplyTransformations(const Json& list, ZarrImageLevel& level)
{
  if (!list.is_null() && !list.is_array())
  {
    return false;
  }
  for (const Json& transformation : list)
  {
    if (!ApplyTransformation(transformation, level))
    {
      return false;
    }
  }
  return true;
}

/// Distances must be positive numbers along x, y and z.
bool IsPlaced(const ZarrImage& image, const ZarrImageLevel& level)
{
  for (std::size_t i = 0; i < image.Axes.size(); ++i)
  {
    const bool isGood =
      std::isnormal(level.Scale[i]) && level.Scale[i] > 0.0 && std::isfinite(level.Translation[i]);
    if (image.Axes[i] == ZarrAxis::Space && !isGood)
    {
      return false;
    }
  }
  return true;
}

}

std::vector<ZarrAxis> UnnamedZarrAxes(std::size_t count)
{
  const std::vector<ZarrAxis> all = { ZarrAxis::Time, ZarrAxis::Channel, ZarrAxis::Space,
    ZarrAxis::Space, ZarrAxis::Space };
  return { all.end() - static_cast<std::ptrdiff_t>(count), all.end() };
}

bool ParseZarrImage(const Json& multiscale, ZarrImage& image, std::string& defect)
{
  image = ZarrImage();
  if (!ParseAxes(MemberOf(multiscale, "axes"), image.Axes, defect))
  {
    return false;
  }
  const Json& levels = MemberOf(multiscale, "datasets");
  constexpr std::size_t MostLevels = 64;
  if (!levels.is_array() || levels.empty() || levels.size() > MostLevels)
  {
    defect = "has no list \"datasets\" with 1 to 64 entries; copy the volume again";
    return false;
  }
  for (const Json& dataSet : levels)
  {
    ZarrImageLevel level;
    level.Path = TextOf(dataSet, "path");
    level.Scale.assign(image.Axes.size(), 1.0);
    level.Translation.assign(image.Axes.size(), 0.0);
    if (!ApplyTransformations(MemberOf(dataSet, "coordinateTransformations"), level) ||
      !ApplyTransformations(MemberOf(multiscale, "coordinateTransformations"), level) ||
      !IsPlaced(image, level))
    {
      defect = "has coordinateTransformations other than positive scales and translations along "
               "all axes; write the volume with these";
      return false;
    }
    image.Levels.push_back(level);
  }
  return true;
}

}
