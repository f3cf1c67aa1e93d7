// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Request/ArrayColorsFromVolume.h"

#include "Request/TransferNodes.h"
#include "Request/ValueDivision.h"

#include <vtkScalarsToColors.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace TemporalCoherence
{

bool ArrayColorsFromVolume::FindColors(const SurfaceLooks& looks, std::string& error)
{
  ValueDivision division;
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
  const auto made = std::make_shared<ValueColors>();
  ValueColors& colors = *made;
  for (std::size_t segment = 1; segment < division.Bounds.size() && areFine; ++segment)
  {
    const double low = division.Bounds[segment - 1], width = division.Bounds[segment] - low;
    for (std::size_t i = 0; i < division.InSegment; ++i)
    {
      const double step = width / static_cast<double>(division.InSegment);
      const double first = low + step * static_cast<double>(i);
      const double inside = division.AreSteps ? 0.5 : beside;
      const glm::vec3 begin = at(first + inside * step);
      colors.Intervals.push_back(
        { begin, division.AreSteps ? begin : at(first + (1.0 - inside) * step) });
    }
  }
  constexpr double infinite = std::numeric_limits<double>::infinity();
  colors.Below = at(std::nextafter(division.Bounds.front(), -infinite));
  colors.Above = at(std::nextafter(division.Bounds.back(), infinite));
  const bool isGray = !looks.Table && looks.Property->GetColorChannels(looks.Component) == 1;
  colors.Missing = isGray ? glm::vec3(0.5f) : at(std::numeric_limits<double>::quiet_NaN());
  colors.Bounds = std::move(division.Bounds);
  this->Known = made;
  return areFine;
}

bool ArrayColorsFromVolume::Make(FieldFromMapper& fields, const ArrayColorSettings& settings,
  int component, vtkVolume* volume, std::shared_ptr<const ArrayColors>& colors,
  std::vector<vtkSmartPointer<vtkObjectBase>>& read, std::string& error)
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
  FoundValues found;
  if (!fields.MakeValues(settings.Array, volume, found, error))
  {
    return false;
  }
  colors = std::make_shared<const ArrayColors>(ArrayColors{ found.Values, this->Known });
  read.insert(read.end(), found.Read.begin(), found.Read.end());
  return true;
}

}
