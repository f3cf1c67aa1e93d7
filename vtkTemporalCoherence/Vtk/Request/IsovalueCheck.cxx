// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Request/IsovalueCheck.h"

#include <vtkContourValues.h>

#include <algorithm>
#include <exception>
#include <iomanip>
#include <limits>
#include <sstream>
#include <utility>
#include <vector>

namespace TemporalCoherence
{
namespace
{

/// True if a surface is possible: samples lie inside and outside of the isovalue.
bool IsMet(double isovalue, SurfaceMode mode, const glm::dvec2& range)
{
  // If all samples are inside a THRESHOLD solid, its caps are visible.
  return isovalue <= range.y && (isovalue > range.x || mode == SurfaceMode::Threshold);
}

bool AreMet(const std::vector<double>& isovalues, SurfaceMode mode, const glm::dvec2& range)
{
  return std::any_of(isovalues.begin(), isovalues.end(),
    [&](double isovalue) { return IsMet(isovalue, mode, range); });
}

/// The isovalue that VTK constructs a property with.
bool IsUntouched(vtkContourValues* list)
{
  return list->GetNumberOfContours() == 1 && list->GetValue(0) == 0.0;
}

/// Write the end of a message: the reason why isovalues separate no samples, and the remedy.
void Explain(const ValueRangePyramid& ranges, std::ostringstream& what)
{
  const glm::dvec2 &finite = ranges.FiniteRange(), &all = ranges.WholeRange();
  if (all.x == all.y)
  {
    what << "all of them are " << all.x
         << ", so there is no isosurface; see whether this is the array that you want, which the "
            "mapper's SelectScalarArray chooses.";
    return;
  }
  const glm::dvec2& range = finite.x < finite.y ? finite : all;
  what << "they range from " << range.x << " to " << range.y
       << ", so there is no isosurface; set an isovalue above " << range.x << " and up to "
       << range.y << " with GetIsoSurfaceValues()->SetValue(0, isovalue) of the volume's property.";
}

constexpr const char* NoLabelIsDrawn =
  "No label is drawn: the image has none but the OutsideLabel, or all have an opacity of 0; raise "
  "opacities in the LabelTable, or with GetScalarOpacity()->AddPoint of the volume's property.";

}

std::string IsovalueCheck::Check(
  const DrawnVolume& drawn, const FrameRequest& request, const ValueRangePyramid& ranges)
{
  const Surfaces& surfaces = request.Key.Isosurfaces();
  if (request.Key.Samples.Labels)
  {
    const bool isWarned = std::exchange(this->AreLabelsSettled, true);
    return isWarned || !surfaces.Isovalues.empty() ? "" : NoLabelIsDrawn;
  }
  std::vector<double> isovalues = surfaces.Isovalues;
  const bool isTransparent = isovalues.empty();
  // A user may fade a surface out. But the default 0 is no choice, and opacities are often made for
  // other modes.
  if (this->IsSettled || (isTransparent && !IsUntouched(request.IsovalueList)))
  {
    return "";
  }
  ValueRangePyramid own; // transparent frames have no ranges of their own
  try
  {
    if (isTransparent)
    {
      isovalues = { 0.0 };
      own.Build(request.Key.Samples);
    }
  }
  catch (const std::exception&) // no memory: no warning
  {
    return "";
  }
  const ValueRangePyramid& known = isTransparent ? own : ranges;
  const glm::dvec2& all = known.WholeRange();
  const bool areMet = AreMet(isovalues, surfaces.Mode, all);
  this->IsSettled = areMet || isTransparent;
  // EmptyPicture warns of NaN samples.
  if ((areMet && !isTransparent) || all.x > all.y || MaySeePartOnly(drawn))
  {
    return "";
  }
  this->IsSettled = true;
  const auto [least, largest] = std::minmax_element(isovalues.begin(), isovalues.end());
  std::ostringstream what;
  what << std::setprecision(std::numeric_limits<float>::max_digits10);
  if (areMet)
  {
    what
      << "Isovalue 0 has a scalar opacity of 0, so there is no isosurface. Set an isovalue between "
      << all.x << " and " << all.y
      << ", the range of the samples, with GetIsoSurfaceValues()->SetValue(0, isovalue) of the "
         "volume's property, and its opacity with GetScalarOpacity()->AddPoint.";
    return what.str();
  }
  if (isovalues.size() == 1)
  {
    what << "Isovalue " << *least << " separates no samples: ";
  }
  else
  {
    what << "None of the " << isovalues.size() << " isovalues (" << *least << " to " << *largest
         << ") separates any samples: ";
  }
  Explain(known, what);
  return what.str();
}

}
