// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_PlateStack_h
#define Testing_PlateStack_h

#include "Checks/EventCounter.h"
#include "Checks/Expect.h"
#include "Scenes/OffScreen.h"
#include "vtkTemporalCoherenceVolume.h"
#include "vtkTemporalCoherenceVolumeMapper.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkContourValues.h>
#include <vtkDualDepthPeelingPass.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTranslucentPass.h>
#include <vtkVolumeProperty.h>
#include <vtkVolumetricPass.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

/// Polygons and isosurfaces that are horizontal rectangles, seen from above and drawn with depth
/// peeling. The colour of each pixel can be computed.
namespace PlateStack
{

constexpr int Size = 96; ///< of windows
using Color = std::array<double, 3>;
constexpr Color Background{ 0.2, 0.2, 0.2 };

/// A rectangle at a height: an isosurface or a polygon seen from above.
struct Plate
{
  double Height = 0.0;
  std::array<double, 4> Place{ -1.0, 1.0, -1.0, 1.0 }; ///< least and largest x, and y
  Color Paint{ 1.0, 1.0, 1.0 };
  double Opacity = 1.0;

  bool Covers(double x, double y) const
  {
    return x > this->Place[0] && x < this->Place[1] && y > this->Place[2] && y < this->Place[3];
  }
  bool IsBeside(double x, double y, double pixel) const
  {
    return std::abs(x - this->Place[0]) < pixel || std::abs(x - this->Place[1]) < pixel ||
      std::abs(y - this->Place[2]) < pixel || std::abs(y - this->Place[3]) < pixel;
  }
};

/// The colour of plates over the background.
inline Color Seen(std::vector<Plate> plates, double x, double y, const Color& below = Background)
{
  std::sort(plates.begin(), plates.end(),
    [](const Plate& a, const Plate& b) { return a.Height < b.Height; });
  Color seen = below;
  for (const Plate& plate : plates)
  {
    for (std::size_t c = 0; c < 3 && plate.Covers(x, y); ++c)
    {
      seen[c] = plate.Opacity * plate.Paint[c] + (1.0 - plate.Opacity) * seen[c];
    }
  }
  return seen;
}

/// A volume whose isosurfaces are plates of one place.
struct Pile
{
  Pile(const std::vector<Plate>& plates, bool isOwnProp)
    : Plates(plates)
    , Prop(isOwnProp
          ? vtkSmartPointer<vtkVolume>(vtkSmartPointer<vtkTemporalCoherenceVolume>::New())
          : vtkSmartPointer<vtkVolume>::New())
  {
    const std::array<double, 4>& place = plates.front().Place;
    vtkNew<vtkImageData> image;
    image->SetDimensions(3, 3, 21);
    image->SetOrigin(place[0], place[2], -1.0);
    image->SetSpacing((place[1] - place[0]) / 2, (place[3] - place[2]) / 2, 0.1);
    image->AllocateScalars(VTK_FLOAT, 1);
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      image->GetPointData()->GetScalars()->SetComponent(i, 0, image->GetPoint(i)[2]);
    }
    this->Mapper->SetInputData(image);
    this->Mapper->SetAntialiasingToOff();
    this->Prop->SetMapper(this->Mapper);
    vtkVolumeProperty* property = this->Prop->GetProperty();
    vtkNew<vtkColorTransferFunction> color;
    vtkNew<vtkPiecewiseFunction> opacity;
    property->GetIsoSurfaceValues()->SetNumberOfContours(static_cast<int>(plates.size()));
    for (std::size_t i = 0; i < plates.size(); ++i)
    {
      const Plate& plate = plates[i];
      property->GetIsoSurfaceValues()->SetValue(static_cast<int>(i), plate.Height);
      color->AddRGBPoint(plate.Height, plate.Paint[0], plate.Paint[1], plate.Paint[2]);
      opacity->AddPoint(plate.Height, plate.Opacity);
    }
    property->SetColor(color);
    property->SetScalarOpacity(opacity);
    property->SetInterpolationTypeToLinear();
  }

  std::vector<Plate> Plates;
  vtkSmartPointer<vtkVolume> Prop;
  vtkNew<vtkTemporalCoherenceVolumeMapper> Mapper;
};

/// The pass that peels.
enum class Peeler
{
  Renderer,     ///< its own pass, volumes among the polygons
  PolygonsOnly, ///< its own pass, without UseDepthPeelingForVolumes
  OwnDualPass,  ///< the same passes, assembled by the user
  OwnSinglePass,
};

/// Piles and polygons, seen from above: x and y from -1 to 1.
class StackScene
{
public:
  explicit StackScene(Peeler peeler, const std::array<double, 4>& viewport = { 0.0, 0.0, 1.0, 1.0 })
    : How(peeler)
  {
    this->Renderer->SetBackground(Background[0], Background[1], Background[2]);
    this->Renderer->SetViewport(viewport[0], viewport[1], viewport[2], viewport[3]);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 0.0, 5.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(1.0);
    camera->SetClippingRange(3.0, 7.0);
    this->Window->SetAlphaBitPlanes(1);
    OpenWindow(this->Window, this->Renderer,
      static_cast<int>(std::lround(Size / (viewport[2] - viewport[0]))),
      static_cast<int>(std::lround(Size / (viewport[3] - viewport[1]))));
    this->SetPasses();
  }

  void AddPolygon(const Plate& plate)
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(plate.Place[0], plate.Place[2], plate.Height);
    plane->SetPoint1(plate.Place[1], plate.Place[2], plate.Height);
    plane->SetPoint2(plate.Place[0], plate.Place[3], plate.Height);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(plane->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->LightingOff();
    actor->GetProperty()->SetColor(plate.Paint[0], plate.Paint[1], plate.Paint[2]);
    actor->GetProperty()->SetOpacity(plate.Opacity);
    this->Renderer->AddActor(actor);
    this->Polygons.push_back(plate);
  }

  Pile& AddPile(const std::vector<Plate>& plates, bool isOwnProp)
  {
    this->Piles.push_back(std::make_unique<Pile>(plates, isOwnProp));
    this->Errors.push_back(
      std::make_unique<EventCounter>(this->Piles.back()->Mapper.Get(), vtkCommand::ErrorEvent));
    this->Renderer->AddVolume(this->Piles.back()->Prop);
    return *this->Piles.back();
  }

  /// The colour of the middle of a pixel.
  Color ExpectedAt(double x, double y) const
  {
    std::vector<Plate> all = this->Polygons;
    if (this->AreVolumesLast)
    {
      // Plates above opaque polygons are drawn over all of them.
      double highest = -2.0;
      for (const Plate& plate : this->Polygons)
      {
        highest =
          plate.Opacity == 1.0 && plate.Covers(x, y) ? std::max(highest, plate.Height) : highest;
      }
      std::vector<Plate> shown;
      for (const auto& pile : this->Piles)
      {
        std::copy_if(pile->Plates.begin(), pile->Plates.end(), std::back_inserter(shown),
          [=](const Plate& plate) { return plate.Height > highest; });
      }
      return Seen(shown, x, y, Seen(all, x, y));
    }
    for (const auto& pile : this->Piles)
    {
      all.insert(all.end(), pile->Plates.begin(), pile->Plates.end());
    }
    return Seen(all, x, y);
  }

  /// Draw, and compare all pixels that are not at an edge with what is expected.
  void ExpectOrder(const std::string& what, double tolerance)
  {
    this->Window->Render();
    const int left = static_cast<int>(this->Renderer->GetOrigin()[0]);
    const int below = static_cast<int>(this->Renderer->GetOrigin()[1]);
    const auto pixels = PixelsOf(this->Window, left, below, left + Size - 1, below + Size - 1);
    int wrong = 0, seen = 0;
    double largest = 0.0;
    for (int row = 0; row < Size; ++row)
    {
      for (int column = 0; column < Size; ++column)
      {
        const double x = 2.0 * (column + 0.5) / Size - 1.0, y = 2.0 * (row + 0.5) / Size - 1.0;
        if (this->IsEdge(x, y))
        {
          continue;
        }
        ++seen;
        const Color expected = this->ExpectedAt(x, y);
        double difference = 0.0;
        for (int c = 0; c < 3; ++c)
        {
          difference = std::max(difference,
            std::abs(pixels->GetValue(4 * (row * Size + column) + c) -
              255.0 * expected[static_cast<std::size_t>(c)]));
        }
        largest = std::max(largest, difference);
        wrong += difference > tolerance;
      }
    }
    Expect(seen > Size * Size / 8 && wrong == 0,
      what + ": " + std::to_string(wrong) + " of " + std::to_string(seen) +
        " pixels are wrong, by up to " + std::to_string(largest) + " / 255");
    for (const auto& errors : this->Errors)
    {
      Expect(errors->Count == 0, what + ": an error");
    }
  }

  bool AreVolumesLast = false; ///< over translucent polygons, as always without peeling
  double Edge = 3.0 / Size;    ///< pixels this near to an edge may belong to either side
  void ForgetErrors()
  {
    for (const auto& errors : this->Errors)
    {
      errors->Count = 0;
    }
  }

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  std::vector<Plate> Polygons;
  std::vector<std::unique_ptr<Pile>> Piles;

private:
  void SetPasses()
  {
    const bool isOwn = this->How == Peeler::OwnDualPass || this->How == Peeler::OwnSinglePass;
    if (!isOwn)
    {
      this->Renderer->SetUseDepthPeeling(1);
      this->Renderer->SetUseDepthPeelingForVolumes(this->How == Peeler::Renderer);
      this->Renderer->SetMaximumNumberOfPeels(20);
      this->Renderer->SetOcclusionRatio(0.0);
      return;
    }
    vtkNew<vtkRenderStepsPass> steps;
    vtkNew<vtkTranslucentPass> polygons;
    vtkSmartPointer<vtkDepthPeelingPass> peels = vtkSmartPointer<vtkDepthPeelingPass>::New();
    if (this->How == Peeler::OwnDualPass)
    {
      const auto dual = vtkSmartPointer<vtkDualDepthPeelingPass>::New();
      vtkNew<vtkVolumetricPass> volumes;
      dual->SetVolumetricPass(volumes);
      steps->SetVolumetricPass(nullptr);
      peels = dual;
    }
    peels->SetTranslucentPass(polygons);
    peels->SetMaximumNumberOfPeels(20);
    peels->SetOcclusionRatio(0.0);
    steps->SetTranslucentPass(peels);
    this->Renderer->SetPass(steps);
  }

  bool IsEdge(double x, double y) const
  {
    const auto isBeside = [&](const Plate& plate) { return plate.IsBeside(x, y, this->Edge); };
    return std::any_of(this->Polygons.begin(), this->Polygons.end(), isBeside) ||
      std::any_of(this->Piles.begin(), this->Piles.end(),
        [&](const auto& pile) { return isBeside(pile->Plates.front()); });
  }

  Peeler How;
  std::vector<std::unique_ptr<EventCounter>> Errors;
};

}

#endif
