// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/SelectionPass.h"

#include "Input/MatrixFromVtk.h"
#include "Output/PixelHit.h"

#include <vtkDataSet.h>
#include <vtkHardwareSelector.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>

#include <algorithm>
#include <cmath>

namespace TemporalCoherence
{
namespace
{

/// 24 bits of a number, the lowest in red.
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

/// The point nearest to a place in the data's coordinates, or the cell around it; or 0 without one.
vtkIdType NumberAt(vtkDataSet* data, glm::dvec3 place, bool isPoint)
{
  // A hit on the boundary may lie outside of it by rounding.
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

std::vector<PixelColor> MakeNumbers(const Frame& frame, const View& view, vtkVolume* volume,
  vtkDataSet* data, bool isPoint, int shift)
{
  std::vector<PixelColor> colors(frame.Depth.size(), ColorOf(0));
  if (!data)
  {
    return colors;
  }
  volume->ComputeMatrix();
  const glm::dmat4 dataFromWorld = glm::inverse(MatrixFromVtk(volume->GetMatrix()));
  for (int y = 0; y < frame.Size.y; ++y)
  {
    for (int x = 0; x < frame.Size.x; ++x)
    {
      const std::size_t pixel = IndexOfPixel(frame, x, y);
      if (frame.Isovalues[pixel] != Frame::NoSurface)
      {
        const glm::dvec4 place(PositionOfHit(frame, view, x, y), 1.0);
        colors[pixel] =
          ColorOf(NumberAt(data, glm::dvec3(dataFromWorld * place), isPoint) >> shift);
      }
    }
  }
  return colors;
}

/// One colour for each pixel; meaningless where nothing is hit.
std::vector<PixelColor> MakeColors(vtkHardwareSelector* selector, const Frame& frame,
  const View& view, vtkVolume* volume, vtkDataSet* data)
{
  switch (selector->GetCurrentPass())
  {
    case vtkHardwareSelector::POINT_ID_LOW24:
      return MakeNumbers(frame, view, volume, data, true, 0);
    case vtkHardwareSelector::POINT_ID_HIGH24:
      return MakeNumbers(frame, view, volume, data, true, 24);
    case vtkHardwareSelector::CELL_ID_LOW24:
      return MakeNumbers(frame, view, volume, data, false, 0);
    case vtkHardwareSelector::CELL_ID_HIGH24:
      return MakeNumbers(frame, view, volume, data, false, 24);
    default:
      return std::vector<PixelColor>(frame.Depth.size(), ColorOfProp(selector));
  }
}

}

bool PresentToSelector(vtkRenderer* renderer, vtkVolume* volume, vtkDataSet* data,
  ViewerState& state, std::string& error)
{
  vtkHardwareSelector* selector = renderer->GetSelector();
  const Frame& frame = state.Frames.LastFrame();
  const View& view = state.Frames.LastKey().Seen;
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
  const bool isShown = state.Presenter.PresentColors(
    renderer, frame, view, state.Picture, MakeColors(selector, frame, view, volume, data), error);
  selector->EndRenderProp();
  return isShown;
}

}
