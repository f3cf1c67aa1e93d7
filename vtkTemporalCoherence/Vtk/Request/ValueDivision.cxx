// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Request/ValueDivision.h"

#include "Request/TransferNodes.h"

#include <vtkColorTransferFunction.h>
#include <vtkDiscretizableColorTransferFunction.h>
#include <vtkLookupTable.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVariant.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace TemporalCoherence
{
namespace
{

/// Intervals of a nonlinear function, and the fewest between neighbouring nodes.
constexpr std::size_t MostIntervals = 4096, FewestIntervals = 16;

bool AreFinite(const std::vector<double>& numbers)
{
  return std::all_of(
    numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); });
}

ValueDivision EvenSteps(const double* range, int count)
{
  return { { range[0], range[1] }, static_cast<std::size_t>(std::max(count, 1)), true };
}

/// The division of a table that names whole numbers.
/// \return false if it names other values
bool DivideNames(vtkScalarsToColors* table, ValueDivision& found)
{
  constexpr double most = 65536.0;
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  bool areWhole = table->GetNumberOfAnnotatedValues() > 0;
  for (vtkIdType i = 0; i < table->GetNumberOfAnnotatedValues(); ++i)
  {
    const double value = table->GetAnnotatedValue(i).ToDouble();
    least = std::min(least, value);
    greatest = std::max(greatest, value);
    areWhole = areWhole && std::floor(value) == value;
  }
  if (!areWhole || !(greatest - least < most))
  {
    return false;
  }
  const double range[2] = { least - 0.5, greatest + 0.5 };
  found = EvenSteps(range, static_cast<int>(greatest - least) + 1);
  return true;
}

/// Steps of equal size in the logarithm, as vtkLookupTable makes them.
ValueDivision LogarithmicSteps(const double* range, int count)
{
  double logarithms[2];
  vtkLookupTable::GetLogRange(range, logarithms);
  const bool hasOneSign =
    range[0] * range[1] >= 0.0 && std::isfinite(logarithms[1] - logarithms[0]);
  if (!hasOneSign)
  {
    return EvenSteps(range, count);
  }
  const double sign = range[0] < 0.0 ? -1.0 : 1.0;
  ValueDivision found;
  found.AreSteps = true;
  for (int i = 0; i <= std::max(count, 1); ++i)
  {
    const double share = static_cast<double>(i) / std::max(count, 1);
    found.Bounds.push_back(
      sign * std::pow(10.0, logarithms[0] + share * (logarithms[1] - logarithms[0])));
  }
  // Powers are rounded.
  found.Bounds.front() = range[0] != 0.0 ? range[0] : found.Bounds.front();
  found.Bounds.back() = range[1] != 0.0 ? range[1] : found.Bounds.back();
  std::sort(found.Bounds.begin(), found.Bounds.end());
  return found;
}

ValueDivision DivideLookupTable(vtkLookupTable* table)
{
  const int count = static_cast<int>(table->GetNumberOfTableValues());
  return table->GetScale() == VTK_SCALE_LOG10 ? LogarithmicSteps(table->GetTableRange(), count)
                                              : EvenSteps(table->GetTableRange(), count);
}

/// \param function vtkColorTransferFunction or vtkPiecewiseFunction
/// \param shape    place of midpoint and sharpness in a node
template <typename Function>
ValueDivision DivideAtNodes(Function* function, std::size_t shape, bool isLinear)
{
  ValueDivision found;
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[6];
    function->GetNodeValue(i, node);
    found.Bounds.push_back(node[0]);
    isLinear = isLinear && node[shape] == 0.5 && node[shape + 1] == 0.0;
  }
  if (AreFinite(found.Bounds)) // others have no order
  {
    std::sort(found.Bounds.begin(), found.Bounds.end());
  }
  found.InSegment = isLinear
    ? 1
    : std::max(MostIntervals / std::max(found.Bounds.size(), std::size_t(1)), FewestIntervals);
  return found;
}

/// Divide the segments of a logarithmic function evenly in the logarithm.
void DivideLogarithm(ValueDivision& division)
{
  std::vector<double> bounds;
  for (std::size_t i = 1; i < division.Bounds.size(); ++i)
  {
    const double low = division.Bounds[i - 1], high = division.Bounds[i];
    for (std::size_t part = 0; part < division.InSegment; ++part)
    {
      const double share = static_cast<double>(part) / static_cast<double>(division.InSegment);
      bounds.push_back(low * std::pow(high / low, share));
    }
  }
  bounds.push_back(division.Bounds.back());
  division.Bounds.swap(bounds);
  division.InSegment = 1;
}

ValueDivision DivideColors(vtkColorTransferFunction* function)
{
  auto* const steps = vtkDiscretizableColorTransferFunction::SafeDownCast(function);
  if (steps && steps->GetDiscretize())
  {
    const int count = static_cast<int>(steps->GetNumberOfValues());
    return steps->GetUseLogScale() ? LogarithmicSteps(steps->GetRange(), count)
                                   : EvenSteps(steps->GetRange(), count);
  }
  const bool isLogarithmic = function->GetScale() == VTK_CTF_LOG10;
  ValueDivision found =
    DivideAtNodes(function, 4, function->GetColorSpace() == VTK_CTF_RGB && !isLogarithmic);
  if (isLogarithmic && !found.Bounds.empty() && found.Bounds.front() > 0.0)
  {
    DivideLogarithm(found);
  }
  return found;
}

/// Make bounds at least two.
/// \param what  belongs to them, for the error
/// \param error receives the mistake and its remedy
/// \return false if they are not finite
bool AreUsable(std::vector<double>& bounds, const std::string& what, std::string& error)
{
  while (bounds.size() < 2)
  {
    bounds.push_back(bounds.empty() ? 0.0 : bounds.back());
  }
  if (!AreFinite(bounds))
  {
    error = "The values to which " + what +
      " belong are not all finite; set finite numbers in the ColorTable or in the " + what +
      " of the volume's property.";
    return false;
  }
  return true;
}

}

bool DivideByColor(const SurfaceLooks& looks, ValueDivision& found, std::string& error)
{
  if (looks.Table && looks.Table->GetIndexedLookup())
  {
    if (!DivideNames(looks.Table, found))
    {
      error = "The ColorTable has IndexedLookup on, but what it names are not whole numbers; call "
              "IndexedLookupOff(), or name whole numbers with SetAnnotation.";
      return false;
    }
  }
  else if (auto* const table = vtkLookupTable::SafeDownCast(looks.Table))
  {
    found = DivideLookupTable(table);
  }
  else if (auto* const colors = vtkColorTransferFunction::SafeDownCast(looks.Table))
  {
    found = DivideColors(colors);
  }
  else if (looks.Table)
  {
    const double* const range = looks.Table->GetRange();
    found = { { std::min(range[0], range[1]), std::max(range[0], range[1]) }, MostIntervals,
      false };
  }
  else
  {
    const TransferFunctions functions(looks.Property, looks.Component);
    found =
      functions.Color ? DivideColors(functions.Color) : DivideAtNodes(functions.Gray, 2, true);
  }
  return AreUsable(found.Bounds, "colours", error);
}

bool DivideByOpacity(const SurfaceLooks& looks, ValueDivision& found, std::string& error)
{
  auto* const steps = vtkDiscretizableColorTransferFunction::SafeDownCast(looks.Table);
  const bool hasFunction = steps && steps->GetEnableOpacityMapping() && !steps->GetIndexedLookup();
  vtkPiecewiseFunction* const function = hasFunction ? steps->GetScalarOpacityFunction()
    : looks.Table                                    ? nullptr
                  : looks.Property->GetScalarOpacity(looks.Component);
  if (!function)
  {
    return DivideByColor(looks, found, error);
  }
  found = DivideAtNodes(function, 2, true);
  return AreUsable(found.Bounds, "opacities", error);
}

}
