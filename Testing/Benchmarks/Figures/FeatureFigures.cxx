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

#include <algorithm>
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
  { 0.15, 0.95, 0.85, 0.45, 0.3 }, { 0.45, 0.9, 0.35, 0.25, 1.0 } } };

/// Colours that are not multiplied by alpha, as image files have them.
void Divide(vtkImageData* rgba)
{
  auto* pixel = static_cast<unsigned char*>(rgba->GetScalarPointer());
  for (vtkIdType i = 0; i < rgba->GetNumberOfPoints(); ++i, pixel += 4)
  {
    for (int c = 0; c < 3 && pixel[3] > 0; ++c)
    {
      pixel[c] = static_cast<unsigned char>(std::min(255 * pixel[c] / pixel[3], 255));
    }
  }
}

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
  Divide(drawer.Color);
  return FigurePictures::WithCaption(drawer.Color, "opacities 0.25, 0.3 and 1");
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
    if (subject.Name.find("doubled") != std::string::npos)
    {
      continue; // it looks like the other
    }
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
