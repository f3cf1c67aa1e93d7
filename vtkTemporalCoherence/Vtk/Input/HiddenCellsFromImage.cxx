// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/HiddenCellsFromImage.h"

#include "Input/GhostArray.h"
#include "Input/SamplesOfArray.h"

#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <exception>
#include <vector>

namespace TemporalCoherence
{
namespace
{

constexpr std::uint8_t NotToBeShown = vtkDataSetAttributes::HIDDENCELL |
  vtkDataSetAttributes::REFINEDCELL | vtkDataSetAttributes::DUPLICATECELL;

/// One byte for each cell of an image: 1 if its own flag or a corner's flag hides it.
std::vector<std::uint8_t> FlagsOfCells(
  const glm::ivec3& points, const std::uint8_t* ofCells, const std::uint8_t* ofPoints)
{
  const glm::ivec3 cells = points - 1;
  const auto row = static_cast<std::size_t>(points.x);
  const std::size_t slice = row * static_cast<std::size_t>(points.y);
  std::vector<std::uint8_t> flags(static_cast<std::size_t>(cells.x) *
    static_cast<std::size_t>(cells.y) * static_cast<std::size_t>(cells.z));
  std::size_t cell = 0;
  for (int k = 0; k < cells.z; ++k)
  {
    for (int j = 0; j < cells.y; ++j)
    {
      std::size_t first = static_cast<std::size_t>(j) * row + static_cast<std::size_t>(k) * slice;
      for (int i = 0; i < cells.x; ++i, ++cell, ++first)
      {
        const auto pair = [&](std::size_t at)
        { return static_cast<unsigned int>(ofPoints[at] | ofPoints[at + 1]); };
        const unsigned int corners =
          pair(first) | pair(first + row) | pair(first + slice) | pair(first + row + slice);
        const bool isShown = !(corners & vtkDataSetAttributes::HIDDENPOINT) &&
          !(ofCells && (ofCells[cell] & NotToBeShown));
        flags[cell] = isShown ? 0 : 1;
      }
    }
  }
  return flags;
}

/// Hidden cells of a field whose samples are the cells of an image.
std::shared_ptr<const HiddenCells> MakeBetweenCells(const glm::ivec3& points,
  const std::uint8_t* ofCells, const std::uint8_t* ofPoints, const std::uint8_t* shown)
{
  HidingFlags flags;
  flags.Shown = shown;
  if (!ofPoints)
  {
    flags.OfSamples = ofCells;
    flags.SampleMask = NotToBeShown;
    return HiddenCells::Make(points - 1, flags);
  }
  const std::vector<std::uint8_t> both = FlagsOfCells(points, ofCells, ofPoints);
  flags.OfSamples = both.data();
  flags.SampleMask = 1;
  return HiddenCells::Make(points - 1, flags);
}

}

bool HiddenCellsOfImage::Find(vtkImageData* image, bool samplesAreCells, const SampleMask& mask,
  std::shared_ptr<const HiddenCells>& hidden, std::string& error)
{
  hidden = nullptr;
  vtkUnsignedCharArray* const ofCells = GhostsOf(image->GetCellData());
  vtkUnsignedCharArray* const ofPoints = GhostsOf(image->GetPointData());
  const std::uint8_t* cells = nullptr;
  const std::uint8_t* samples = nullptr;
  if (!FindFlags(
        image->GetCellData(), { "The image", true, CountSamples(image, true) }, cells, error) ||
    !FindFlags(
      image->GetPointData(), { "The image", false, CountSamples(image, false) }, samples, error))
  {
    return false;
  }
  Origin origin;
  image->GetDimensions(origin.Dimensions.data());
  const glm::ivec3 points(origin.Dimensions[0], origin.Dimensions[1], origin.Dimensions[2]);
  const int fewest = samplesAreCells ? 3 : 2;
  if ((!ofCells && !ofPoints && !mask.Array) || glm::any(glm::lessThan(points, glm::ivec3(fewest))))
  {
    this->Release();
    return true;
  }
  origin.Arrays = { ofCells, ofPoints };
  origin.Times = { ofCells ? ofCells->GetMTime() : 0, ofPoints ? ofPoints->GetMTime() : 0 };
  origin.SamplesAreCells = samplesAreCells;
  origin.Mask = mask;
  if (!(origin == this->MadeFrom))
  {
    this->Release();
    try
    {
      std::vector<std::uint8_t> room;
      const std::uint8_t* const shown = mask.Array ? SamplesShown(mask, room) : nullptr;
      this->Made = samplesAreCells
        ? MakeBetweenCells(points, cells, samples, shown)
        : HiddenCells::Make(
            points, { cells, NotToBeShown, samples, vtkDataSetAttributes::HIDDENPOINT, shown });
    }
    catch (const std::exception&)
    {
      error =
        "There is not enough memory for the flags of hidden cells, one bit for each cell of the "
        "image; free memory, or render a part of the volume "
        "(vtkExtractVOI).";
      return false;
    }
    this->MadeFrom = origin;
  }
  hidden = this->Made;
  return true;
}

}
