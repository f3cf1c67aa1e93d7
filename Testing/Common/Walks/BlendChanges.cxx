// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Walks/BlendChanges.h"

#include <vtkPiecewiseFunction.h>

namespace BlendChanges
{
namespace
{

constexpr double Largest = 1700.0;

/// From no opacity to some; thick fog is not seen through.
void SetRamp(vtkVolumeProperty* property, double begin, double width, double opacity)
{
  vtkNew<vtkPiecewiseFunction> ramp;
  ramp->AddPoint(begin, 0.0);
  ramp->AddPoint(begin + width, opacity);
  property->SetScalarOpacity(ramp);
}

/// The lower end of a function moves, as if dragged.
void DragRamp(vtkVolumeProperty* property, double by)
{
  vtkPiecewiseFunction* ramp = property->GetScalarOpacity();
  double node[4];
  if (ramp->GetSize() > 1 && ramp->GetNodeValue(0, node) >= 0)
  {
    double next[4];
    ramp->GetNodeValue(1, next);
    if (node[0] + by < next[0])
    {
      node[0] += by;
      ramp->SetNodeValue(0, node);
    }
  }
}

void SetColors(vtkVolumeProperty* property, RandomViews& views)
{
  vtkNew<vtkColorTransferFunction> color;
  for (double value = -Largest; value <= Largest; value += 0.5 * Largest)
  {
    color->AddRGBPoint(
      value, views.Between(0.0, 1.0), views.Between(0.0, 1.0), views.Between(0.0, 1.0));
  }
  property->SetColor(color);
}

}

std::vector<Change> OfMode(Scene& scene, RandomViews& views, const std::vector<int>& modes)
{
  vtkTemporalCoherenceVolumeMapper* mapper = scene.Mapper;
  std::vector<Change> changes;
  for (const int mode : modes)
  {
    changes.push_back({ false, [=] { mapper->SetBlendMode(mode); } });
  }
  changes.push_back({ false,
    [=, &views]
    {
      const double low = views.Between(-Largest, Largest);
      mapper->SetAverageIPScalarRange(low, low + views.Between(0.0, Largest));
    } });
  return changes;
}

std::vector<Change> OfLook(Scene& scene, RandomViews& views)
{
  vtkTemporalCoherenceVolumeMapper* mapper = scene.Mapper;
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  return {
    { false,
      [=, &views]
      {
        SetRamp(property, views.Between(-1500.0, 1000.0), views.Between(0.0, 800.0),
          views.Between(0.1, 1.0));
      } },
    { false, [=, &views] { SetRamp(property, views.Between(-900.0, 900.0), 1e-3, 1.0); } },
    { false, [=, &views] { DragRamp(property, views.Between(-50.0, 50.0)); } },
    { false, [=, &views] { DragRamp(property, views.Between(0.0, 20.0)); } },
    { false,
      [=, &views]
      {
        const double value = views.Between(-900.0, 900.0);
        vtkNew<vtkPiecewiseFunction> peak;
        peak->AddPoint(value - 20.0, 0.0);
        peak->AddPoint(value, 0.9);
        peak->AddPoint(value + 20.0, 0.0);
        property->SetScalarOpacity(peak);
      } },
    { false, [=, &views] { SetColors(property, views); } },
    { false, [=, &views] { property->SetScalarOpacityUnitDistance(views.Between(0.02, 0.5)); } },
    { false,
      [=, &views]
      {
        mapper->SetFinalColorWindow(static_cast<float>(views.Between(0.5, 1.5)));
        mapper->SetFinalColorLevel(static_cast<float>(views.Between(0.3, 0.7)));
      } },
  };
}

}
