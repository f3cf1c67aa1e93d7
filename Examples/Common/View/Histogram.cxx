// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "View/Histogram.h"

#include "Files/Arrays.h"
#include "Files/CoarseImage.h"
#include "Files/Drawn.h"
#include "Program/Quoted.h"
#include "Program/UserError.h"

#include <vtkArrayDispatch.h>
#include <vtkDataArray.h>
#include <vtkDataArrayRange.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>

namespace
{

struct Counter
{
  Histogram& Counted;
  int Component;

  template <typename ArrayType>
  void operator()(ArrayType* array, const std::vector<unsigned char>* isDrawn)
  {
    const std::array<double, 2> range = this->Counted.Range;
    std::vector<double>& bins = this->Counted.Bins;
    const double width = range[1] - range[0], last = static_cast<double>(bins.size() - 1);
    std::size_t i = 0;
    for (const auto tuple : vtk::DataArrayTupleRange(array))
    {
      if (isDrawn && (*isDrawn)[i++] == 0)
      {
        continue;
      }
      double value = 0.0;
      if (this->Component >= 0)
      {
        value = static_cast<double>(tuple[this->Component]);
      }
      else
      {
        for (const auto part : tuple)
        {
          value += static_cast<double>(part) * static_cast<double>(part);
        }
        value = std::sqrt(value);
      }
      if (value >= range[0] && value <= range[1])
      {
        // Divided first: the inverse of a tiny width is infinite.
        bins[static_cast<std::size_t>((value - range[0]) / width * last + 0.5)] += 1.0;
      }
    }
  }
};

// The volume, and the array if it was chosen among others.
std::string NameOf(const Volume& volume)
{
  const std::string& array = volume.Array.Name;
  return array.empty() ? Quoted(volume.Name) : Quoted(array) + " in " + Quoted(volume.Name);
}

}

Histogram CountSamples(const Volume& volume, int component)
{
  Histogram histogram;
  const std::string name = NameOf(volume);
  Drawn drawn(SamplesInMemory(volume));
  const std::vector<DrawnArray> arrays = drawn.Arrays(volume.Array);
  histogram.Range = volume.Bricks ? RangeOf(volume) : drawn.Range(volume.Array, component);
  const std::string others = OthersThan(volume);
  const std::string forRaw = volume.IsRaw ? ", or choose another type for --raw" : "";
  const std::string advice = others.empty() ? "another volume" + forRaw : others;
  if (histogram.Range[0] > histogram.Range[1])
  {
    throw UserError(
      "No sample of " + name + " is a number: it has no isosurface; choose " + advice + ".");
  }
  if (!std::isfinite(histogram.Range[1] - histogram.Range[0]))
  {
    std::ostringstream what;
    what << "The values of " << name << ", " << histogram.Range[0] << " to " << histogram.Range[1]
         << ", lie too far apart to choose an isovalue between them; scale them down" << forRaw
         << ".";
    throw UserError(what.str());
  }
  if (!(histogram.Range[0] < histogram.Range[1]))
  {
    std::ostringstream what;
    what << "All samples of " << name << " have the value " << histogram.Range[0]
         << ": it has no isosurface; choose " << advice << ".";
    throw UserError(what.str());
  }
  // Few whole numbers get a bin each: bins between them would be empty.
  const double values = histogram.Range[1] - histogram.Range[0] + 1.0;
  const bool isWhole = component >= 0 &&
    std::all_of(arrays.begin(), arrays.end(),
      [](const DrawnArray& array)
      {
        const int type = array.Values->GetDataType();
        return type != VTK_FLOAT && type != VTK_DOUBLE;
      });
  if (isWhole && values < static_cast<double>(histogram.Bins.size()))
  {
    histogram.Bins.resize(static_cast<std::size_t>(values));
  }
  Counter counter{ histogram, component };
  for (const DrawnArray& array : arrays)
  {
    vtkDataArray* const values = array.Values;
    if (!vtkArrayDispatch::Dispatch::Execute(values, counter, array.IsDrawn))
    {
      counter(values, array.IsDrawn);
    }
  }
  return histogram;
}
