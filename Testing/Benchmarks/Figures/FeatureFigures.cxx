// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureFigures.h"

#include "FigurePictures.h"
#include "PngFile.h"
#include "Stage.h"

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkVolumeProperty.h>

#include <array>

namespace FeatureFigures
{
namespace
{

constexpr double Closeness = 1.4; ///< by which the volumes fill the pictures

/// A surface: how far its isovalue is above the subject's, as a share of the range of values.
struct Shell
{
  double Above, Red, Green, Blue, Opacity;
};

/// What is outside is clear, what is inside opaque.
constexpr std::array<Shell, 3> Shells = { { { 0.0, 0.45, 0.65, 0.95, 0.25 },
  { 0.12, 0.95, 0.85, 0.45, 0.45 }, { 0.3, 0.9, 0.35, 0.25, 1.0 } } };

vtkSmartPointer<vtkImageData> Translucent(Stage& stage)
{
  vtkNew<vtkColorTransferFunction> color;
  vtkNew<vtkPiecewiseFunction> opacity;
  vtkVolumeProperty* property = stage.Volume->GetProperty();
  const double isovalue = stage.Isovalue();
  property->GetIsoSurfaceValues()->SetNumberOfContours(static_cast<int>(Shells.size()));
  for (std::size_t i = 0; i < Shells.size(); ++i)
  {
    const Shell& shell = Shells[i];
    const double value = isovalue + stage.ShareOfRange(shell.Above);
    property->GetIsoSurfaceValues()->SetValue(static_cast<int>(i), value);
    color->AddRGBPoint(value, shell.Red, shell.Green, shell.Blue);
    opacity->AddPoint(value, shell.Opacity);
  }
  property->SetColor(color);
  property->SetScalarOpacity(opacity);
  Drawer drawer(stage);
  drawer.Draw(stage);
  return FigurePictures::WithCaption(drawer.Color, "opacities 0.25, 0.45 and 1");
}

vtkSmartPointer<vtkImageData> CutOpen(Stage& stage)
{
  Drawer drawer(stage);
  drawer.Mapper->SetSurfaceModeToThreshold();
  vtkNew<vtkPlane> plane;
  plane->SetOrigin(stage.Image->GetCenter());
  double forward[3];
  stage.Renderer->GetActiveCamera()->GetDirectionOfProjection(forward);
  plane->SetNormal(forward[0], forward[1] + 0.6, forward[2]);
  drawer.Mapper->AddClippingPlane(plane);
  drawer.Draw(stage);
  return FigurePictures::WithCaption(drawer.Color, "THRESHOLD, clipped by a plane");
}

}

void SeenThroughAndCutOpen(const Figures::Settings& settings)
{
  std::vector<vtkSmartPointer<vtkImageData>> translucent, open;
  for (const Figures::Subject& subject : settings.Subjects)
  {
    Stage clear(subject.Image, subject.Isovalue, settings.Size);
    clear.Approach(Closeness);
    translucent.push_back(Translucent(clear));
    Stage solid(subject.Image, subject.Isovalue, settings.Size);
    solid.Approach(Closeness);
    open.push_back(CutOpen(solid));
  }
  WritePng(FigurePictures::Tile({ translucent, open }), settings.Output + "/features.png");
}

}
