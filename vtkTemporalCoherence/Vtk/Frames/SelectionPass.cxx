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

/// The colour of a ray with a hit, which encodes an id.
using ColorOfRay = std::function<PixelColor(const glm::ivec2&)>;

/// The input of a selection.
struct Selection
{
  vtkHardwareSelector* Selector;
  vtkVolume* Volume;
  vtkDataSet* Data;         ///< or null
  const CellOrigins* Cells; ///< of a mesh; or null
};

/// The transform from the world to the data's coordinates.
glm::dmat4 DataFromWorld(vtkVolume* volume)
{
  volume->ComputeMatrix();
  return glm::inverse(MatrixFromVtk(volume->GetMatrix()));
}

/// The id of the point or the cell at the hit.
ColorOfRay NumbersOf(const ShownFrame& shown, const Selection& of, bool isPoint, int shift)
{
  if (!of.Data && !of.Cells)
  {
    return [](const glm::ivec2&) { return ColorOf(0); };
  }
  const glm::dmat4 dataFromWorld = DataFromWorld(of.Volume);
  return [=](const glm::ivec2& ray)
  {
    const glm::dvec3 place(
      dataFromWorld * glm::dvec4(PositionOfHit(shown.Picture, shown.View, ray.x, ray.y), 1.0));
    if (!of.Cells)
    {
      return ColorOf(NumberAt(of.Data, place, isPoint) >> shift);
    }
    const CellOrigin cell = of.Cells->Of(CellOfHit(shown.Picture, ray.x, ray.y));
    const vtkIdType number = isPoint ? NearestPointOf(cell, place) : cell.Cell;
    return ColorOf(std::max<vtkIdType>(number, 0) >> shift);
  };
}

/// The block of the cell that is hit, in the colours of the selector.
ColorOfRay BlocksOf(const ShownFrame& shown, const Selection& of)
{
  if (!of.Cells)
  {
    of.Selector->RenderCompositeIndex(0);
    return [color = ColorOfProp(of.Selector)](const glm::ivec2&) { return color; };
  }
  return [=](const glm::ivec2& ray)
  {
    of.Selector->RenderCompositeIndex(of.Cells->Of(CellOfHit(shown.Picture, ray.x, ray.y)).Block);
    return ColorOfProp(of.Selector);
  };
}

ColorOfRay ColorsOf(const ShownFrame& shown, const Selection& of)
{
  switch (of.Selector->GetCurrentPass())
  {
    case vtkHardwareSelector::POINT_ID_LOW24:
      return NumbersOf(shown, of, true, 0);
    case vtkHardwareSelector::POINT_ID_HIGH24:
      return NumbersOf(shown, of, true, 24);
    case vtkHardwareSelector::CELL_ID_LOW24:
      return NumbersOf(shown, of, false, 0);
    case vtkHardwareSelector::CELL_ID_HIGH24:
      return NumbersOf(shown, of, false, 24);
    case vtkHardwareSelector::COMPOSITE_INDEX_PASS:
      return BlocksOf(shown, of);
    default:
      return [color = ColorOfProp(of.Selector)](const glm::ivec2&) { return color; };
  }
}

}

bool PresentToSelector(vtkRenderer* renderer, vtkVolume* volume, vtkDataSet* data,
  ViewerState& state, std::string& error)
{
  vtkHardwareSelector* selector = renderer->GetSelector();
  const ShownFrame shown = state.Shown();
  const Selection of = { selector, volume, data, state.Cells.get() };
  selector->BeginRenderProp();
  if (of.Cells)
  {
    selector->UpdateMaximumPointId(of.Cells->LargestPoint());
    selector->UpdateMaximumCellId(of.Cells->LargestCell());
  }
  else if (data)
  {
    selector->UpdateMaximumPointId(data->GetNumberOfPoints() - 1);
    selector->UpdateMaximumCellId(data->GetNumberOfCells() - 1);
  }
  const bool isShown = state.Presenter.PresentColors(renderer, shown, ColorsOf(shown, of), error);
  selector->EndRenderProp();
  return isShown;
}

}
