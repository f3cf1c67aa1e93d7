// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/SelectionPass.h"

#include "Input/MatrixFromVtk.h"
#include "Window/PixelHit.h"

#include <vtkDataSet.h>
#include <vtkHardwareSelector.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace TemporalCoherence
{
namespace
{

/// 24 bits of an id as a colour, the lowest in red.
PixelColor ColorOf(vtkIdType number)
{
  const auto byte = [&](int shift) { return static_cast<std::uint8_t>(number >> shift & 0xff); };
  return { byte(0), byte(8), byte(16), 255 };
}

PixelColor ColorOfProp(vtkHardwareSelector* selector)
{
  float color[3];
  selector->GetPropColorValue(color);
  const auto byte = [](float value)
  { return static_cast<std::uint8_t>(std::lround(255.0f * value)); };
  return { byte(color[0]), byte(color[1]), byte(color[2]), 255 };
}

/// The point nearest to a position in the data's coordinates, or the cell around it; 0 if there is
/// none.
vtkIdType NumberAt(vtkDataSet* data, glm::dvec3 place, bool isPoint)
{
  // Rounding may put a hit on the boundary outside.
  const double* bounds = data->GetBounds();
  for (int axis = 0; axis < 3; ++axis)
  {
    place[axis] = std::min(std::max(place[axis], bounds[2 * axis]), bounds[2 * axis + 1]);
  }
  const double tolerance = 1e-6 * data->GetLength();
  vtkIdType number = -1;
  if (isPoint)
  {
    number = data->FindPoint(&place.x);
  }
  else
  {
    int part;
    double inCell[3], weights[8];
    number = data->FindCell(&place.x, nullptr, 0, tolerance * tolerance, part, inCell, weights);
  }
  return std::max<vtkIdType>(number, 0);
}

/// The id to draw for a ray with a hit.
using ColorOfRay = std::function<PixelColor(const glm::ivec2&)>;

/// The id of the point or the cell at the hit.
ColorOfRay NumbersOf(
  const ShownFrame& shown, vtkVolume* volume, vtkDataSet* data, bool isPoint, int shift)
{
  if (!data)
  {
    return [](const glm::ivec2&) { return ColorOf(0); };
  }
  volume->ComputeMatrix();
  const glm::dmat4 dataFromWorld = glm::inverse(MatrixFromVtk(volume->GetMatrix()));
  return [=](const glm::ivec2& ray)
  {
    const glm::dvec4 place(PositionOfHit(shown.Picture, shown.View, ray.x, ray.y), 1.0);
    return ColorOf(NumberAt(data, glm::dvec3(dataFromWorld * place), isPoint) >> shift);
  };
}

ColorOfRay ColorsOf(
  vtkHardwareSelector* selector, const ShownFrame& shown, vtkVolume* volume, vtkDataSet* data)
{
  switch (selector->GetCurrentPass())
  {
    case vtkHardwareSelector::POINT_ID_LOW24:
      return NumbersOf(shown, volume, data, true, 0);
    case vtkHardwareSelector::POINT_ID_HIGH24:
      return NumbersOf(shown, volume, data, true, 24);
    case vtkHardwareSelector::CELL_ID_LOW24:
      return NumbersOf(shown, volume, data, false, 0);
    case vtkHardwareSelector::CELL_ID_HIGH24:
      return NumbersOf(shown, volume, data, false, 24);
    default:
      return [color = ColorOfProp(selector)](const glm::ivec2&) { return color; };
  }
}

}

bool PresentToSelector(vtkRenderer* renderer, vtkVolume* volume, vtkDataSet* data,
  ViewerState& state, std::string& error)
{
  vtkHardwareSelector* selector = renderer->GetSelector();
  const ShownFrame shown = state.Shown();
  selector->BeginRenderProp();
  if (selector->GetCurrentPass() == vtkHardwareSelector::COMPOSITE_INDEX_PASS)
  {
    selector->RenderCompositeIndex(0);
  }
  if (data)
  {
    selector->UpdateMaximumPointId(data->GetNumberOfPoints() - 1);
    selector->UpdateMaximumCellId(data->GetNumberOfCells() - 1);
  }
  const bool isShown =
    state.Presenter.PresentColors(renderer, shown, ColorsOf(selector, shown, volume, data), error);
  selector->EndRenderProp();
  return isShown;
}

}
