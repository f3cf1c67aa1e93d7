// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Request/ArrayLooksFromVolume.h"

#include "Request/TransferNodes.h"
#include "Request/ValueDivision.h"
#include "Scene/ValueTable.h"

#include <vtkColorTransferFunction.h>
#include <vtkPiecewiseFunction.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace TemporalCoherence
{
namespace
{

/// Make a table of the looks in the intervals of a division, and beyond it.
/// \param missing the look where there is no value
/// \param at      called as at(value, look); false on error
/// \return null on error
template <typename Look, typename LookAt>
std::shared_ptr<const ValueTable<Look>> MakeTable(
  const ValueDivision& division, const Look& missing, const LookAt& at)
{
  // A look may jump at the end of an interval.
  constexpr double beside = 1e-9;
  std::vector<typename ValueTable<Look>::Interval> intervals;
  for (std::size_t segment = 1; segment < division.Bounds.size(); ++segment)
  {
    const double low = division.Bounds[segment - 1], width = division.Bounds[segment] - low;
    for (std::size_t i = 0; i < division.InSegment; ++i)
    {
      const double step = width / static_cast<double>(division.InSegment);
      const double first = low + step * static_cast<double>(i);
      const double inside = division.AreSteps ? 0.5 : beside;
      auto& made = intervals.emplace_back();
      bool isFine = at(first + inside * step, made.First);
      made.Last = made.First;
      if (isFine && !division.AreSteps)
      {
        isFine = at(first + (1.0 - inside) * step, made.Last);
      }
      if (!isFine)
      {
        return nullptr;
      }
    }
  }
  constexpr double infinite = std::numeric_limits<double>::infinity();
  typename ValueTable<Look>::OtherLooks others{ missing, missing, missing };
  const bool isFine = at(std::nextafter(division.Bounds.front(), -infinite), others.Below) &&
    at(std::nextafter(division.Bounds.back(), infinite), others.Above);
  return isFine ? std::make_shared<const ValueTable<Look>>(division.Bounds, intervals, others)
                : nullptr;
}

/// The opacity where there is no value.
float MissingOpacity(vtkScalarsToColors* table)
{
  auto* const colors = vtkColorTransferFunction::SafeDownCast(table);
  const double opacity = colors ? colors->GetNanOpacity()
    : table                     ? table->GetOpacity(std::numeric_limits<double>::quiet_NaN())
                                : 1.0;
  return static_cast<float>(std::fmin(std::fmax(opacity, 0.0), 1.0));
}

SurfaceLooks LooksOf(const ArrayLookSettings& settings, vtkVolumeProperty* property, int component)
{
  if (settings.Table)
  {
    settings.Table->Build();
  }
  return { property, component, settings.Table };
}

}

bool ArrayLooksFromVolume::FindColors(const SurfaceLooks& looks, std::string& error)
{
  vtkObject* const of = looks.Table ? static_cast<vtkObject*>(looks.Table)
                                    : TransferFunctions(looks.Property, looks.Component).Colors();
  if (this->Colors.IsOf(of))
  {
    return true;
  }
  const auto at = [&](double value, glm::vec3& look)
  {
    glm::dvec3 color(0.0);
    const bool isFine = FindColor(looks, "value", value, color, error);
    look = glm::vec3(color);
    return isFine;
  };
  ValueDivision division;
  const bool isGray = !looks.Table && looks.Property->GetColorChannels(looks.Component) == 1;
  glm::vec3 missing(0.5f);
  if (!DivideByColor(looks, division, error) ||
    (!isGray && !at(std::numeric_limits<double>::quiet_NaN(), missing)))
  {
    return false;
  }
  const auto made = MakeTable(division, missing, at);
  if (made)
  {
    this->Colors = { made, of, of->GetMTime() };
  }
  return made != nullptr;
}

bool ArrayLooksFromVolume::FindOpacities(const SurfaceLooks& looks, std::string& error)
{
  vtkObject* const of = looks.Table ? static_cast<vtkObject*>(looks.Table)
                                    : looks.Property->GetScalarOpacity(looks.Component);
  if (this->Opacities.IsOf(of))
  {
    return true;
  }
  const auto at = [&](double value, float& look)
  {
    double opacity = 0.0;
    const bool isFine = FindOpacity(looks, "value", value, opacity, error);
    look = static_cast<float>(opacity);
    return isFine;
  };
  ValueDivision division;
  if (!DivideByOpacity(looks, division, error))
  {
    return false;
  }
  const auto made = MakeTable(division, MissingOpacity(looks.Table), at);
  if (made)
  {
    this->Opacities = { made->IsAll(1.0f) ? nullptr : made, of, of->GetMTime() };
  }
  return made != nullptr;
}

bool ArrayLooksFromVolume::Make(FieldFromMapper& fields, const ArrayLookSettings& settings,
  int component, vtkVolume* volume, bool hasViewer, FrameKey& key,
  std::vector<vtkSmartPointer<vtkObjectBase>>& read, std::string& error)
{
  const SurfaceLooks looks = LooksOf(settings, volume->GetProperty(), component);
  FoundValues found;
  if ((hasViewer && !this->FindColors(looks, error)) ||
    (settings.HasOpacity && !this->FindOpacities(looks, error)) ||
    !fields.MakeValues(settings.Array, volume, found, error))
  {
    return false;
  }
  if (hasViewer)
  {
    key.Appearance.ByArray =
      std::make_shared<const ArrayColors>(ArrayColors{ found.Values, this->Colors.Looks });
  }
  if (settings.HasOpacity && this->Opacities.Looks)
  {
    key.EditIsosurfaces().ByArray =
      std::make_shared<const ArrayOpacities>(ArrayOpacities{ found.Values, this->Opacities.Looks });
  }
  read.insert(read.end(), found.Read.begin(), found.Read.end());
  return true;
}

bool ArrayLooksFromVolume::AreOpaque(
  const ArrayLookSettings& settings, vtkVolumeProperty* property, int component)
{
  std::string error; // the next frame reports it
  return !settings.HasOpacity ||
    (this->FindOpacities(LooksOf(settings, property, component), error) && !this->Opacities.Looks);
}

}
