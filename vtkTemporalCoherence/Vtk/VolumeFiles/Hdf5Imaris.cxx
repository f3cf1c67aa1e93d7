// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/Hdf5Attributes.h"
#include "VolumeFiles/Hdf5Layouts.h"

namespace TemporalCoherence
{

namespace
{

constexpr const char* Axes[] = { "X", "Y", "Z" };

std::string LevelName(int level)
{
  return "/DataSet/ResolutionLevel " + std::to_string(level);
}

std::string ChannelName(int level, const VolumeChoice& choice)
{
  return LevelName(level) + "/TimePoint " + std::to_string(choice.TimePoint) + "/Channel " +
    std::to_string(choice.Channel);
}

/// Find the size without padding. Files without it have no padding.
bool FindSize(const Hdf5File& file, const std::string& channel, const glm::ivec3& padded,
  glm::ivec3& size, std::string& error)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    double along = padded[axis];
    const std::string attribute = std::string("ImageSize") + Axes[axis];
    ReadNumber(file, channel, attribute, along);
    if (along < 1.0 || along > padded[axis])
    {
      error = "Attribute '" + attribute + "' of group '" + channel + "' of file '" + file.Path() +
        "' is no number of samples from 1 to " + std::to_string(padded[axis]) +
        ", which the data set has; write the file again.";
      return false;
    }
    size[axis] = static_cast<int>(along);
  }
  return true;
}

/// The box that the samples fill.
struct Box
{
  glm::dvec3 Min{ 0.0 };
  glm::dvec3 Max{ 0.0 };
};

/// Read the box. Axes without one get the unit of the finest sample.
Box FindBox(const Hdf5File& file, const glm::ivec3& finest)
{
  Box box;
  for (int axis = 0; axis < 3; ++axis)
  {
    const std::string number = std::to_string(axis);
    if (!ReadNumber(file, "/DataSetInfo/Image", "ExtMin" + number, box.Min[axis]) ||
      !ReadNumber(file, "/DataSetInfo/Image", "ExtMax" + number, box.Max[axis]) ||
      box.Max[axis] <= box.Min[axis])
    {
      box.Min[axis] = -0.5;
      box.Max[axis] = finest[axis] - 0.5;
    }
  }
  return box;
}

}

bool IsImaris(const Hdf5File& file)
{
  return file.Has(LevelName(0));
}

bool FindImaris(const Hdf5File& file, const VolumeChoice& choice, std::vector<Hdf5Level>& levels,
  std::string& error)
{
  if (!file.Has(ChannelName(0, choice)))
  {
    error = "File '" + file.Path() + "' has no channel " + std::to_string(choice.Channel) +
      " at time point " + std::to_string(choice.TimePoint) + "; choose others, from 0.";
    return false;
  }
  Box box;
  for (int level = 0; level < MostHdf5Levels && (level == 0 || file.Has(LevelName(level))); ++level)
  {
    Hdf5Level found;
    const std::string channel = ChannelName(level, choice);
    VolumeLevel& place = found.Place;
    if (!found.Data.Open(file, channel + "/Data", error) ||
      !FindSize(file, channel, found.Data.Dimensions(), place.Dimensions, error))
    {
      return false;
    }
    if (level == 0)
    {
      box = FindBox(file, place.Dimensions);
    }
    place.Chunk = found.Data.Chunk();
    place.Spacing = (box.Max - box.Min) / glm::dvec3(place.Dimensions);
    place.Origin = box.Min + 0.5 * place.Spacing;
    levels.push_back(std::move(found));
  }
  return true;
}

}
