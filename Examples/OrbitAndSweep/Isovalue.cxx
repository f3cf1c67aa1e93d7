// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Isovalue.h"

#include "Options.h"

#include <vtkArrayDispatch.h>
#include <vtkDataArray.h>
#include <vtkDataArrayRange.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>

namespace
{

constexpr std::size_t BinCount = 256;

// How many samples of component 0 lie in each of equal parts of the range.
struct Histogram
{
  std::vector<double> Bins = std::vector<double>(BinCount, 0.0);

  template <typename ArrayType>
  void operator()(ArrayType* array, const double* range)
  {
    const double scale = static_cast<double>(BinCount - 1) / (range[1] - range[0]);
    for (const auto tuple : vtk::DataArrayTupleRange(array))
    {
      const double value = static_cast<double>(tuple[0]);
      if (value >= range[0] && value <= range[1])
      {
        this->Bins[static_cast<std::size_t>(scale * (value - range[0]) + 0.5)] += 1.0;
      }
    }
  }
};

// The bin that parts the histogram into two classes that differ most: N. Otsu, "A threshold
// selection method from gray-level histograms", 1979, equation 12 (variance between classes).
std::size_t OtsuBin(const std::vector<double>& bins)
{
  double all = 0.0, allMoment = 0.0;
  for (std::size_t i = 0; i < bins.size(); ++i)
  {
    all += bins[i];
    allMoment += static_cast<double>(i) * bins[i];
  }

  double below = 0.0, belowMoment = 0.0, best = -1.0;
  std::size_t bestBin = 0;
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
      bestBin = i;
    }
  }
  return bestBin;
}

double FromHistogram(vtkDataArray* array, const double* range)
{
  Histogram histogram;
  if (!vtkArrayDispatch::Dispatch::Execute(array, histogram, range))
  {
    histogram(array, range);
  }
  // The surface lies between the bin and the next; three digits are as good and easier to repeat.
  const double share =
    (static_cast<double>(OtsuBin(histogram.Bins)) + 0.5) / static_cast<double>(BinCount - 1);
  const double step = std::pow(10.0, std::floor(std::log10(range[1] - range[0])) - 2.0);
  const double value = range[0] + share * (range[1] - range[0]);
  return std::clamp(step * std::round(value / step), range[0], range[1]);
}

}

IsovalueChoice ChooseIsovalue(vtkImageData* image, const std::optional<double>& given)
{
  IsovalueChoice choice;
  vtkDataArray* array = image->GetPointData()->GetScalars();
  array->GetFiniteRange(choice.Range, 0);
  if (!(choice.Range[0] < choice.Range[1]))
  {
    std::ostringstream what;
    what << "All samples of the volume have the value " << choice.Range[0]
         << ": it has no isosurface; choose another volume, or another type for --raw.";
    throw UserError(what.str());
  }
  choice.IsChosen = !given;
  choice.Value = given ? *given : FromHistogram(array, choice.Range);
  if (choice.Value < choice.Range[0] || choice.Value > choice.Range[1])
  {
    std::ostringstream what;
    what << "Isovalue " << choice.Value << " lies outside the volume's values, " << choice.Range[0]
         << " to " << choice.Range[1]
         << ": nothing would be drawn; choose one between, for example "
         << FromHistogram(array, choice.Range) << ".";
    throw UserError(what.str());
  }
  return choice;
}

std::vector<double> SweepAround(const IsovalueChoice& isovalue, int count)
{
  const double width = isovalue.Range[1] - isovalue.Range[0];
  const double margin = 0.01 * width;
  const double begin = std::max(isovalue.Value - 0.03 * width, isovalue.Range[0] + margin);
  const double end = std::min(isovalue.Value + 0.07 * width, isovalue.Range[1] - margin);
  std::vector<double> values;
  for (int i = 0; i < count; ++i)
  {
    values.push_back(begin + (end - begin) * i / std::max(count - 1, 1));
  }
  return values;
}
