// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Request/ArrayColorsFromVolume.h"

#include "Request/TransferNodes.h"

#include <vtkColorTransferFunction.h>
#include <vtkDiscretizableColorTransferFunction.h>
#include <vtkLookupTable.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVariant.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace TemporalCoherence
{
namespace
{

/// Intervals between neighbouring nodes of a nonlinear function.
constexpr std::size_t IntervalsBetweenNodes = 256;

/// The division of values into intervals.
struct Division
{
  std::vector<double> Bounds; ///< as ValueColors::Bounds
  std::size_t InSegment = 1;  ///< intervals
  bool AreSteps = false;      ///< an interval has one colour
};

Division EvenSteps(const double* range, int count)
{
  return { { range[0], range[1] }, static_cast<std::size_t>(std::max(count, 1)), true };
}

/// The division of a table that names whole numbers.
/// \return false if it names other values
bool DivideNames(vtkScalarsToColors* table, Division& found)
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

Division DivideLookupTable(vtkLookupTable* table)
{
  const int count = static_cast<int>(table->GetNumberOfTableValues());
  const double* const range = table->GetTableRange();
  if (table->GetScale() != VTK_SCALE_LOG10 || !(range[0] > 0.0))
  {
    return EvenSteps(range, count);
  }
  Division logarithmic;
  logarithmic.AreSteps = true;
  for (int i = 0; i <= count; ++i)
  {
    logarithmic.Bounds.push_back(range[0] * std::pow(range[1] / range[0], double(i) / count));
  }
  return logarithmic;
}

/// \param function vtkColorTransferFunction or vtkPiecewiseFunction
/// \param shape    place of midpoint and sharpness in a node
template <typename Function>
Division DivideAtNodes(Function* function, std::size_t shape, bool isLinear)
{
  Division found;
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[6];
    function->GetNodeValue(i, node);
    found.Bounds.push_back(node[0]);
    isLinear = isLinear && node[shape] == 0.5 && node[shape + 1] == 0.0;
  }
  std::sort(found.Bounds.begin(), found.Bounds.end());
  found.InSegment = isLinear ? 1 : IntervalsBetweenNodes;
  return found;
}

Division DivideColors(vtkColorTransferFunction* function)
{
  auto* const steps = vtkDiscretizableColorTransferFunction::SafeDownCast(function);
  if (steps && steps->GetDiscretize())
  {
    return EvenSteps(steps->GetRange(), static_cast<int>(steps->GetNumberOfValues()));
  }
  return DivideAtNodes(function, 4,
    function->GetColorSpace() == VTK_CTF_RGB && function->GetScale() == VTK_CTF_LINEAR);
}

bool Divide(const SurfaceLooks& looks, Division& found, std::string& error)
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
    found = { { range[0], range[1] }, IntervalsBetweenNodes, false };
  }
  else
  {
    const TransferFunctions functions(looks.Property, looks.Component);
    found =
      functions.Color ? DivideColors(functions.Color) : DivideAtNodes(functions.Gray, 2, true);
  }
  while (found.Bounds.size() < 2)
  {
    found.Bounds.push_back(found.Bounds.empty() ? 0.0 : found.Bounds.back());
  }
  const auto isFinite = [](double bound) { return std::isfinite(bound); };
  if (!std::all_of(found.Bounds.begin(), found.Bounds.end(), isFinite))
  {
    error = "The values to which colours belong are not all finite; set finite numbers in the "
            "ColorTable or in the colours of the volume's property.";
    return false;
  }
  return true;
}

}

bool ArrayColorsFromVolume::FindColors(const SurfaceLooks& looks, std::string& error)
{
  Division division;
  if (!Divide(looks, division, error))
  {
    return false;
  }
  bool areFine = true;
  const auto at = [&](double value)
  {
    glm::dvec3 color(0.0);
    areFine = areFine && FindColor(looks, "value", value, color, error);
    return glm::vec3(color);
  };
  // A colour may jump at the end of an interval.
  constexpr double beside = 1e-9;
  ValueColors& colors = this->Known;
  colors = ValueColors();
  for (std::size_t segment = 1; segment < division.Bounds.size() && areFine; ++segment)
  {
    const double low = division.Bounds[segment - 1], width = division.Bounds[segment] - low;
    for (std::size_t i = 0; i < division.InSegment; ++i)
    {
      const double step = width / static_cast<double>(division.InSegment);
      const double first = low + step * static_cast<double>(i);
      const glm::vec3 ofAll = at(first + 0.5 * step);
      colors.Intervals.push_back({ division.AreSteps ? ofAll : at(first + beside * step),
        division.AreSteps ? ofAll : at(first + (1.0 - beside) * step) });
    }
  }
  constexpr double infinite = std::numeric_limits<double>::infinity();
  colors.Below = at(std::nextafter(division.Bounds.front(), -infinite));
  colors.Above = at(std::nextafter(division.Bounds.back(), infinite));
  const bool isGray = !looks.Table && looks.Property->GetColorChannels(looks.Component) == 1;
  colors.Missing = isGray ? glm::vec3(0.5f) : at(std::numeric_limits<double>::quiet_NaN());
  colors.Bounds = std::move(division.Bounds);
  return areFine;
}

bool ArrayColorsFromVolume::Make(FieldFromMapper& fields, const ArrayColorSettings& settings,
  int component, vtkVolume* volume, std::shared_ptr<const ArrayColors>& colors, std::string& error)
{
  const SurfaceLooks looks = { volume->GetProperty(), component, settings.Table };
  if (settings.Table)
  {
    settings.Table->Build();
  }
  vtkObject* const table = settings.Table ? static_cast<vtkObject*>(settings.Table)
                                          : TransferFunctions(looks.Property, component).Colors();
  if (this->Of != table || this->Time != table->GetMTime())
  {
    this->Of = nullptr;
    if (!this->FindColors(looks, error))
    {
      return false;
    }
    this->Of = table;
    this->Time = table->GetMTime();
  }
  std::shared_ptr<const ArrayValues> values;
  if (!fields.MakeValues(settings.Array, volume, values, error))
  {
    return false;
  }
  colors = std::make_shared<const ArrayColors>(values, this->Known);
  return true;
}

}
