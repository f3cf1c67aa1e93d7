// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "View/Isovalue.h"

#include "Program/UserError.h"
#include "View/Histogram.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>

namespace
{

// The bin that parts the histogram into two classes that differ most: N. Otsu, "A threshold
// selection method from gray-level histograms", 1979, equation 12 (variance between classes). Where
// no samples lie between the classes, that is any of several bins: the middle one.
std::size_t OtsuBin(const std::vector<double>& bins)
{
  double all = 0.0, allMoment = 0.0;
  for (std::size_t i = 0; i < bins.size(); ++i)
  {
    all += bins[i];
    allMoment += static_cast<double>(i) * bins[i];
  }

  double below = 0.0, belowMoment = 0.0, best = -1.0;
  std::size_t firstBin = 0, lastBin = 0;
  for (std::size_t i = 0; i + 1 < bins.size(); ++i)
  {
    below += bins[i];
    belowMoment += static_cast<double>(i) * bins[i];
    const double above = all - below;
    if (below <= 0.0 || above <= 0.0)
    {
      continue;
    }
    const double apart = belowMoment / below - (allMoment - belowMoment) / above;
    const double variance = below * above * apart * apart;
    if (variance > best)
    {
      best = variance;
      firstBin = i;
    }
    if (variance >= best)
    {
      lastBin = i;
    }
  }
  return (firstBin + lastBin) / 2;
}

double ValueBetweenClasses(const Histogram& histogram)
{
  const std::array<double, 2>& range = histogram.Range;
  // The surface lies between the bin and the next; three digits are as good and easier to repeat.
  const double share = (static_cast<double>(OtsuBin(histogram.Bins)) + 0.5) /
    static_cast<double>(histogram.Bins.size() - 1);
  const double step = std::pow(10.0, std::floor(std::log10(range[1] - range[0])) - 2.0);
  const double value = range[0] + share * (range[1] - range[0]);
  const double rounded = step * std::round(value / step);
  // Of a tiny range the step is 0, and a value far from 0 has no such digits.
  return rounded > range[0] && rounded < range[1] ? rounded : value;
}

}

IsovalueChoice ChooseIsovalue(
  const Histogram& histogram, const std::optional<double>& given, const std::string& name)
{
  IsovalueChoice choice;
  choice.Range = histogram.Range;
  choice.IsChosen = !given;
  choice.Value = given ? *given : ValueBetweenClasses(histogram);
  if (choice.Value < choice.Range[0] || choice.Value > choice.Range[1])
  {
    std::ostringstream what;
    what << "Isovalue " << choice.Value << " lies outside the values of " << name << ", "
         << choice.Range[0] << " to " << choice.Range[1]
         << ": nothing would be drawn; choose one between, for example "
         << ValueBetweenClasses(histogram) << ".";
    throw UserError(what.str());
  }
  return choice;
}
