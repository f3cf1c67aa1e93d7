// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeFiles/Hdf5Attributes.h"
#include "VolumeFiles/Hdf5Layouts.h"

namespace TemporalCoherence
{

namespace
{

/// A name of a letter and a number with leading zeros.
std::string Numbered(char letter, int number, std::size_t digits)
{
  const std::string text = std::to_string(number);
  const std::size_t zeros = text.size() < digits ? digits - text.size() : 0;
  return letter + std::string(zeros, '0') + text;
}

bool AreFactors(const std::vector<glm::dvec3>& rows)
{
  constexpr double most = 2147483647.0;
  for (const glm::dvec3& row : rows)
  {
    // Not true for NaN.
    const bool isGood = glm::all(glm::greaterThanEqual(row, glm::dvec3(1.0))) &&
      glm::all(glm::lessThanEqual(row, glm::dvec3(most)));
    if (!isGood)
    {
      return false;
    }
  }
  return true;
}

}

bool IsBigDataViewer(const Hdf5File& file)
{
  return file.Has("/t00000") && file.Has("/s00");
}

bool FindBigDataViewer(const Hdf5File& file, const VolumeChoice& choice,
  std::vector<Hdf5Level>& levels, std::string& error)
{
  const std::string setup = '/' + Numbered('s', choice.Channel, 2);
  const std::string volume = '/' + Numbered('t', choice.TimePoint, 5) + setup;
  if (choice.Channel < 0 || choice.TimePoint < 0 || !file.Has(volume))
  {
    error = "File '" + file.Path() + "' has no channel (setup) " + std::to_string(choice.Channel) +
      " at time point " + std::to_string(choice.TimePoint) + "; choose others, from 0.";
    return false;
  }
  std::vector<glm::dvec3> factors;
  if (!ReadTriples(file, setup + "/resolutions", MostHdf5Levels, factors) || !AreFactors(factors))
  {
    error = file.DataSetText(setup + "/resolutions") +
      "is not a list of 1 to 32 levels with three factors each, from 1; write the file again.";
    return false;
  }
  for (std::size_t level = 0; level < factors.size(); ++level)
  {
    Hdf5Level found;
    const std::string name = volume + '/' + std::to_string(level) + "/cells";
    if (!found.Data.Open(file, name, error))
    {
      return false;
    }
    found.Data.TakeAsUnsigned();
    VolumeLevel& place = found.Place;
    place.Dimensions = found.Data.Dimensions();
    place.Chunk = found.Data.Chunk();
    place.Spacing = factors[level];
    // A coarse sample is the mean of fine ones. It lies in their middle.
    place.Origin = 0.5 * (factors[level] - 1.0);
    levels.push_back(std::move(found));
  }
  return true;
}

}
