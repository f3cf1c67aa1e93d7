// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/ZarrLevel.h"

#include <algorithm>

namespace TemporalCoherence
{
namespace
{

std::size_t CountSpace(const std::vector<ZarrAxis>& axes)
{
  return static_cast<std::size_t>(std::count(axes.begin(), axes.end(), ZarrAxis::Space));
}

/// Take the sizes along x, y and z. A picture has one sample along z.
glm::ivec3 SpaceOf(const std::vector<int>& sizes, std::size_t space)
{
  glm::ivec3 size(1);
  for (std::size_t i = 0; i < space; ++i)
  {
    size[static_cast<glm::length_t>(i)] = sizes[sizes.size() - 1 - i];
  }
  return size;
}

/// Check the position along an axis before those of space.
bool IsChosen(
  ZarrAxis axis, int position, int size, const std::filesystem::path& folder, std::string& error)
{
  const bool isTime = axis == ZarrAxis::Time;
  if (axis == ZarrAxis::Other && size > 1)
  {
    error = "Array " + folder.string() +
      " has an axis that is neither time, channel nor space; write the volume without it.";
    return false;
  }
  if (position < 0 || position >= size)
  {
    error = "Array " + folder.string() + " has " + std::to_string(size) +
      (isTime ? " time points" : " channels") + ", counted from 0, but " +
      std::to_string(position) + " is chosen; choose another " +
      (isTime ? "time point." : "channel.");
    return false;
  }
  return true;
}

bool HasAxis(const std::vector<ZarrAxis>& axes, ZarrAxis axis)
{
  return std::find(axes.begin(), axes.end(), axis) != axes.end();
}

/// A channel or a time point cannot be chosen if the array has no such axis.
bool IsChosenWithoutAxis(const std::vector<ZarrAxis>& axes, const VolumeChoice& choice,
  const std::filesystem::path& folder, std::string& error)
{
  return (HasAxis(axes, ZarrAxis::Channel) ||
           IsChosen(ZarrAxis::Channel, choice.Channel, 1, folder, error)) &&
    (HasAxis(axes, ZarrAxis::Time) || IsChosen(ZarrAxis::Time, choice.TimePoint, 1, folder, error));
}

}

bool ChooseZarrVolume(const std::vector<ZarrAxis>& axes, const VolumeChoice& choice,
  ZarrLevel& level, VolumeLevel& geometry, std::string& error)
{
  const ZarrArray& array = level.Array;
  if (array.Shape.size() != axes.size())
  {
    error = "Array " + level.Folder.string() + " has " + std::to_string(array.Shape.size()) +
      " axes, but the image's metadata name " + std::to_string(axes.size()) +
      "; copy the volume again.";
    return false;
  }
  if (!IsChosenWithoutAxis(axes, choice, level.Folder, error))
  {
    return false;
  }
  const std::size_t space = CountSpace(axes);
  geometry.Dimensions = SpaceOf(array.Shape, space);
  geometry.Chunk = SpaceOf(array.Chunk, space);
  level.VolumeBytes = geometry.SamplesOfChunk() * SizeOf(array.Type);
  level.Leading.clear();
  std::size_t volume = 0;
  for (std::size_t i = 0; i < axes.size() - space; ++i)
  {
    const int position = axes[i] == ZarrAxis::Time ? choice.TimePoint
      : axes[i] == ZarrAxis::Channel               ? choice.Channel
                                                   : 0;
    if (!IsChosen(axes[i], position, array.Shape[i], level.Folder, error))
    {
      return false;
    }
    level.Leading.push_back(position);
    volume = volume * static_cast<std::size_t>(array.Chunk[i]) +
      static_cast<std::size_t>(position % array.Chunk[i]);
  }
  level.FirstByte = volume * level.VolumeBytes;
  return true;
}

ZarrChunkPlace PlaceOfChunk(const ZarrLevel& level, const glm::ivec3& chunk)
{
  const ZarrArray& array = level.Array;
  ZarrChunkPlace place;
  std::string key = array.KeyPrefix;
  const std::size_t space = array.Shape.size() - level.Leading.size();
  for (std::size_t i = 0; i < array.Shape.size(); ++i)
  {
    const std::size_t isSpace = i < level.Leading.size() ? 0 : 1;
    int position = isSpace
      ? chunk[static_cast<glm::length_t>(space - 1 - (i - level.Leading.size()))]
      : level.Leading[i] / array.Chunk[i];
    if (!array.Shard.Chunks.empty())
    {
      const int chunks = array.Shard.Chunks[i];
      place.InFile = place.InFile * static_cast<std::size_t>(chunks) +
        static_cast<std::size_t>(position % chunks);
      position /= chunks;
    }
    key += i > 0 ? std::string(1, array.Separator) : std::string();
    key += std::to_string(position);
  }
  place.Path = level.Folder / key;
  return place;
}

void PlaceZarrLevel(const std::vector<ZarrAxis>& axes, const ZarrImageLevel& from,
  const VolumeLevel& finest, VolumeLevel& geometry)
{
  if (!from.HasScale)
  {
    // Samples of coarser levels are means, and lie in the middles of those that they replace.
    geometry.Spacing = glm::dvec3(finest.Dimensions) / glm::dvec3(geometry.Dimensions);
    geometry.Origin = 0.5 * (geometry.Spacing - 1.0);
  }
  for (std::size_t i = 0; i < CountSpace(axes) && !from.Scale.empty(); ++i)
  {
    const auto axis = static_cast<glm::length_t>(i);
    const std::size_t place = from.Scale.size() - 1 - i;
    geometry.Spacing[axis] = from.HasScale ? from.Scale[place] : geometry.Spacing[axis];
    geometry.Origin[axis] = from.Translation[place] + (from.HasScale ? 0.0 : geometry.Origin[axis]);
  }
}

}
