// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "View/Histogram.h"

#include "Program/UserError.h"

#include <vtkArrayDispatch.h>
#include <vtkDataArray.h>
#include <vtkDataArrayRange.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <cmath>
#include <cstddef>
#include <sstream>

namespace
{

struct Counter
{
  Histogram& Counted;

  template <typename ArrayType>
  void operator()(ArrayType* array)
  {
    const std::array<double, 2> range = this->Counted.Range;
    std::vector<double>& bins = this->Counted.Bins;
    const double scale = static_cast<double>(bins.size() - 1) / (range[1] - range[0]);
    for (const auto tuple : vtk::DataArrayTupleRange(array))
    {
      const double value = static_cast<double>(tuple[0]);
      if (value >= range[0] && value <= range[1])
      {
        bins[static_cast<std::size_t>(scale * (value - range[0]) + 0.5)] += 1.0;
      }
    }
  }
};

}

Histogram CountSamples(vtkImageData* image, const std::string& name)
{
  Histogram histogram;
  vtkDataArray* array = image->GetPointData()->GetScalars();
  array->GetFiniteRange(histogram.Range.data(), 0);
  if (histogram.Range[0] > histogram.Range[1])
  {
    throw UserError("No sample of " + name +
      " is a number: it has no isosurface; choose another volume, or another type for --raw.");
  }
  if (!std::isfinite(histogram.Range[1] - histogram.Range[0]))
  {
    std::ostringstream what;
    what << "The values of " << name << ", " << histogram.Range[0] << " to " << histogram.Range[1]
         << ", lie too far apart to choose an isovalue between them; scale them down, or choose "
            "another type for --raw.";
    throw UserError(what.str());
  }
  if (!(histogram.Range[0] < histogram.Range[1]))
  {
    std::ostringstream what;
    what << "All samples of " << name << " have the value " << histogram.Range[0]
         << ": it has no isosurface; choose another volume, or another type for --raw.";
    throw UserError(what.str());
  }
  // Few whole numbers get a bin each: bins between them would be empty.
  const double values = histogram.Range[1] - histogram.Range[0] + 1.0;
  const bool isWhole = array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE;
  if (isWhole && values < static_cast<double>(histogram.Bins.size()))
  {
    histogram.Bins.resize(static_cast<std::size_t>(values));
  }
  Counter counter{ histogram };
  if (!vtkArrayDispatch::Dispatch::Execute(array, counter))
  {
    counter(array);
  }
  return histogram;
}
