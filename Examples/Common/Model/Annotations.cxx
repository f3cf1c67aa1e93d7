// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Model/Annotations.h"

#include "Files/Arrays.h"
#include "Files/CoarseImage.h"

#include <vtkActor.h>
#include <vtkAxisActor2D.h>
#include <vtkCamera.h>
#include <vtkCaptionActor2D.h>
#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkImageExtractComponents.h>
#include <vtkImageInterpolator.h>
#include <vtkImageProperty.h>
#include <vtkMath.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindow.h>
#include <vtkTextProperty.h>
#include <vtkTransform.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <sstream>

namespace
{

constexpr double LengthOfAxes = 0.25; // of the longest edge
constexpr double BeforePlane = 1e-4;  // of the diagonal: in front of caps
constexpr int Dpi = 72;

Rgb InkOn(vtkRenderer* renderer)
{
  const double* ground = renderer->GetBackground();
  const double grey = ground[0] + ground[1] + ground[2] > 1.2 ? 0.1 : 0.9;
  return { grey, grey, grey };
}

void SetInk(vtkTextProperty* text, const Rgb& ink)
{
  text->SetColor(ink[0], ink[1], ink[2]);
  text->BoldOff();
  text->ItalicOff();
  text->ShadowOff();
  text->SetFontFamilyToArial();
}

}

Annotations::Annotations(vtkRenderer* renderer)
  : Renderer(renderer)
{
  this->CutMapper->SetSlicePlane(this->CutPlane);
  this->CutMapper->SliceAtFocalPointOff();
  this->CutMapper->SliceFacesCameraOff();
  this->Cut->SetMapper(this->CutMapper);
  this->Cut->GetProperty()->SetInterpolationTypeToLinear();
  this->Cut->GetProperty()->UseLookupTableScalarRangeOn();
  this->OutlineMapper->SetInputConnection(this->Outline->GetOutputPort());
  this->OutlineActor->SetMapper(this->OutlineMapper);
  this->OutlineActor->GetProperty()->LightingOff();
  this->ScaleBar->AllAxesOff();
  this->ScaleBar->BottomAxisVisibilityOn();
  this->ScaleBar->LegendVisibilityOff();
  this->ScaleBar->SetLabelModeToDistance();
  this->ColorBar->SetNumberOfLabels(5);
  this->ColorBar->SetLabelFormat("%.4g");
  this->ColorBar->UnconstrainedFontSizeOn();
  this->ColorBar->SetPosition(0.84, 0.15);
  this->ColorBar->SetWidth(0.07);
  this->ColorBar->SetHeight(0.7);
  // The bar's own title lies in its middle: long ones would not end in the picture.
  this->TitleOfBar->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  this->TitleOfBar->SetPosition(0.93, 0.88);
  this->TitleOfBar->GetTextProperty()->SetJustificationToRight();
  for (vtkProp* prop : { static_cast<vtkProp*>(this->Cut),
         static_cast<vtkProp*>(this->OutlineActor), static_cast<vtkProp*>(this->Axes),
         static_cast<vtkProp*>(this->ScaleBar), static_cast<vtkProp*>(this->ColorBar),
         static_cast<vtkProp*>(this->TitleOfBar), static_cast<vtkProp*>(this->Ruler) })
  {
    prop->VisibilityOff();
    prop->PickableOff();
    prop->UseBoundsOff();
    renderer->AddViewProp(prop);
  }
}

void Annotations::Show(const Volume& volume, int component, const Box& bounds)
{
  this->Shown = volume;
  this->Component = component;
  this->Bounds = bounds;
  this->HideRuler();
  this->Placement->Identity();
  if (volume.Placement)
  {
    this->Placement->DeepCopy(volume.Placement);
  }
  this->Samples = nullptr;
  this->HasSamples = vtkImageData::SafeDownCast(volume.Data) && component >= 0 &&
    !volume.Array.IsOnCells && ShownArrays(volume).size() == 1;
  this->Outline->SetBounds(this->Bounds.data());
  this->OutlineActor->SetUserMatrix(this->Placement);
}

// Along the image's own axes: its directions are a part of the matrix.
void Annotations::TakeSamples()
{
  // Of a volume that is read as it is needed, those of its coarse image.
  vtkImageData* const image = vtkImageData::SafeDownCast(SamplesInMemory(this->Shown));
  vtkDataArray* const array = ArrayOf(image, this->Shown.Array);
  vtkNew<vtkImageData> plain;
  plain->SetExtent(image->GetExtent());
  plain->SetSpacing(image->GetSpacing());
  plain->SetOrigin(image->GetOrigin());
  plain->GetPointData()->SetScalars(array);
  vtkNew<vtkMatrix4x4> turned;
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      turned->SetElement(row, column, image->GetDirectionMatrix()->GetElement(row, column));
    }
  }
  const double* const origin = image->GetOrigin(); // about which it is turned
  vtkNew<vtkTransform> toWorld;
  toWorld->SetMatrix(this->Placement);
  toWorld->Translate(origin);
  toWorld->Concatenate(turned);
  toWorld->Translate(-origin[0], -origin[1], -origin[2]);
  this->SamplesToWorld->DeepCopy(toWorld->GetMatrix());
  this->Samples = plain;
  if (array->GetNumberOfComponents() > 1)
  {
    vtkNew<vtkImageExtractComponents> extract;
    extract->SetInputData(plain);
    extract->SetComponents(this->Component);
    extract->Update();
    this->Samples = extract->GetOutput();
  }
}

bool Annotations::HasAny() const
{
  return this->Cut->GetVisibility() || this->OutlineActor->GetVisibility() ||
    this->Axes->GetVisibility() || this->Ruler->GetVisibility() ||
    this->ScaleBar->GetVisibility() || this->ColorBar->GetVisibility();
}

void Annotations::ShowRuler(const Point& from, const Point& to)
{
  vtkCoordinate* const begin = this->Ruler->GetPositionCoordinate();
  vtkCoordinate* const end = this->Ruler->GetPosition2Coordinate();
  begin->SetCoordinateSystemToWorld();
  end->SetCoordinateSystemToWorld();
  end->SetReferenceCoordinate(nullptr);
  begin->SetValue(from[0], from[1], from[2]);
  end->SetValue(to[0], to[1], to[2]);
  std::ostringstream label;
  label.precision(5);
  label << std::sqrt(vtkMath::Distance2BetweenPoints(from.data(), to.data()));
  this->Ruler->SetLabel(label.str().c_str());
  this->Ruler->SetArrowPlacementToNone();
  this->Ruler->VisibilityOn();
}

void Annotations::ShowAs(const Annotations& other)
{
  this->Show(other.Shown, other.Component, other.Bounds);
  this->Samples = other.Samples;
  this->SamplesToWorld->DeepCopy(other.SamplesToWorld);
  this->Apply(other.Applied, other.Colors, other.Key);
  if (other.Ruler->GetVisibility())
  {
    Point from, to;
    std::copy_n(other.Ruler->GetPositionCoordinate()->GetValue(), 3, from.begin());
    std::copy_n(other.Ruler->GetPosition2Coordinate()->GetValue(), 3, to.begin());
    this->ShowRuler(from, to);
  }
}

void Annotations::Apply(const Look& look, vtkColorTransferFunction* colors, const ColorKey& key)
{
  this->Applied = look;
  this->Colors = colors;
  this->Key = key;
  const Rgb ink = InkOn(this->Renderer);
  const Box& box = this->Bounds;
  this->OutlineActor->SetVisibility(look.Choice(Row::Outline));
  this->OutlineActor->GetProperty()->SetColor(ink[0], ink[1], ink[2]);

  const double longest = std::max({ box[1] - box[0], box[3] - box[2], box[5] - box[4] });
  vtkNew<vtkTransform> toCorner;
  toCorner->Concatenate(this->Placement);
  toCorner->Translate(box[0], box[2], box[4]);
  this->Axes->SetUserTransform(toCorner);
  const double length = LengthOfAxes * longest;
  this->Axes->SetTotalLength(length, length, length);
  this->Axes->SetVisibility(look.Choice(Row::Axes));
  for (vtkCaptionActor2D* caption : { this->Axes->GetXAxisCaptionActor2D(),
         this->Axes->GetYAxisCaptionActor2D(), this->Axes->GetZAxisCaptionActor2D() })
  {
    SetInk(caption->GetCaptionTextProperty(), ink);
    caption->GetTextActor()->SetTextScaleModeToNone();
  }

  this->ScaleBar->SetVisibility(look.Choice(Row::ScaleBar));
  SetInk(this->ScaleBar->GetBottomAxis()->GetLabelTextProperty(), ink);
  this->ScaleBar->GetBottomAxis()->GetProperty()->SetColor(ink[0], ink[1], ink[2]);

  this->ColorBar->SetLookupTable(key.Colors ? key.Colors.Get() : colors);
  this->TitleOfBar->SetInput(key.Title.c_str());
  this->ColorBar->SetVisibility(look.Choice(Row::ColorBar));
  SetInk(this->ColorBar->GetLabelTextProperty(), ink);
  this->TitleOfBar->SetVisibility(look.Choice(Row::ColorBar) != 0 && !key.Title.empty());
  SetInk(this->TitleOfBar->GetTextProperty(), ink);

  SetInk(this->Ruler->GetLabelTextProperty(), ink);
  this->Ruler->GetProperty()->SetColor(ink[0], ink[1], ink[2]);

  const bool isCut = look.Values[Row::Clipping] != 0.0 && look.Choice(Row::Cut) != OnCut::Nothing &&
    this->HasSamples;
  this->Cut->SetVisibility(isCut);
  if (isCut)
  {
    this->PlaceCut();
  }
}

// A hair in front of the plane: behind it, caps begin.
void Annotations::PlaceCut()
{
  const Look& look = this->Applied;
  if (!this->Samples)
  {
    this->TakeSamples();
  }
  if (this->CutMapper->GetInput() != this->Samples)
  {
    this->CutMapper->SetInputData(this->Samples);
    this->Cut->SetUserMatrix(this->SamplesToWorld);
  }
  const double* box = this->Cut->GetBounds();
  const double diagonal = std::hypot(box[1] - box[0], box[3] - box[2], box[5] - box[4]);
  this->CutPlane->SetNormal(look.Clip.Normal.data());
  this->CutPlane->SetOrigin(look.Clip.Origin.data());
  this->CutPlane->Push(-BeforePlane * diagonal);
  this->Greys->RemoveAllPoints();
  for (const Marker& end : look.Greys)
  {
    this->Greys->AddRGBPoint(end.Value, end.Opacity, end.Opacity, end.Opacity);
  }
  this->Cut->GetProperty()->SetLookupTable(
    look.Choice(Row::Cut) == OnCut::Colors ? this->Colors.Get() : this->Greys.Get());
  this->PlaceCrop();
}

// The cut ends where the box does that is cropped to.
void Annotations::PlaceCrop()
{
  const Look& look = this->Applied;
  this->CutMapper->RemoveAllClippingPlanes();
  if (look.Values[Row::Cropping] == 0.0)
  {
    return;
  }
  vtkNew<vtkTransform> toWorld;
  toWorld->SetMatrix(this->Placement);
  for (std::size_t side = 0; side < 6; ++side)
  {
    Point origin = {}, normal = {};
    origin[side / 2] = look.Values[Row::Crop + side];
    normal[side / 2] = side % 2 == 0 ? 1.0 : -1.0;
    toWorld->TransformNormal(normal.data(), normal.data());
    toWorld->TransformPoint(origin.data(), origin.data());
    vtkNew<vtkPlane> plane;
    plane->SetOrigin(origin.data());
    plane->SetNormal(normal.data());
    this->CutMapper->AddClippingPlane(plane);
  }
}

std::optional<double> Annotations::SampleAt(const Point& place) const
{
  if (!this->Samples)
  {
    return std::nullopt;
  }
  vtkNew<vtkMatrix4x4> toSamples;
  vtkMatrix4x4::Invert(this->SamplesToWorld, toSamples);
  const std::array<double, 4> world = { place[0], place[1], place[2], 1.0 };
  std::array<double, 4> point;
  toSamples->MultiplyPoint(world.data(), point.data());
  vtkNew<vtkImageInterpolator> interpolator;
  interpolator->Initialize(this->Samples);
  double sample = 0.0;
  return interpolator->Interpolate(point.data(), &sample) ? std::optional<double>(sample)
                                                          : std::nullopt;
}

namespace
{

// Distances along rays of what a window shows, as the mapper tells them; infinity where nothing is.
std::vector<float> DistancesOf(vtkRenderWindow* window, vtkCamera* camera, int width, int height)
{
  vtkNew<vtkFloatArray> depths;
  window->GetZbufferData(0, 0, width - 1, height - 1, depths);
  const double* const range = camera->GetClippingRange();
  const double tangent = std::tan(0.5 * vtkMath::RadiansFromDegrees(camera->GetViewAngle()));
  std::vector<float> distances(static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
    std::numeric_limits<float>::infinity());
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      const vtkIdType at = static_cast<vtkIdType>(y) * width + x;
      const double depth = depths->GetValue(at);
      if (depth >= 1.0)
      {
        continue;
      }
      double distance = range[0] + depth * (range[1] - range[0]);
      if (!camera->GetParallelProjection())
      {
        const double right = tangent * (2.0 * x + 1.0 - width) / height;
        const double up = tangent * (2.0 * y + 1.0 - height) / height;
        distance = range[0] * range[1] / (range[1] - depth * (range[1] - range[0])) *
          std::sqrt(1.0 + right * right + up * up);
      }
      distances[static_cast<std::size_t>(at)] = static_cast<float>(distance);
    }
  }
  return distances;
}

// Both have colours multiplied by alpha.
void LayOver(const unsigned char* above, unsigned char* below)
{
  for (int c = 0; c < 4; ++c)
  {
    below[c] = static_cast<unsigned char>(
      std::min(255L, above[c] + std::lround(below[c] * (1.0 - above[3] / 255.0))));
  }
}

}

// By a copy in a window off the screen: the one that is seen may belong to another thread.
void Annotations::DrawOver(vtkImageData* picture) const
{
  vtkNew<vtkCamera> camera;
  camera->DeepCopy(this->Renderer->GetActiveCamera());
  vtkNew<vtkRenderer> renderer;
  renderer->SetActiveCamera(camera);
  renderer->SetBackground(this->Renderer->GetBackground());
  Annotations copy(renderer);
  copy.ShowAs(*this);
  renderer->SetBackground(0.0, 0.0, 0.0); // adds nothing to the picture
  const int* const size = picture->GetDimensions();
  const int heightOfView = this->Renderer->GetSize()[1];
  const double scale = heightOfView > 0 ? 1.0 * size[1] / heightOfView : 1.0;
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetAlphaBitPlanes(1);
  window->SetDPI(static_cast<int>(std::lround(Dpi * scale)));
  window->SetSize(size[0], size[1]);
  window->AddRenderer(renderer);
  window->Render();
  vtkNew<vtkUnsignedCharArray> drawn;
  window->GetRGBACharPixelData(0, 0, size[0] - 1, size[1] - 1, 0, drawn);
  const std::vector<float> distances = DistancesOf(window, camera, size[0], size[1]);
  auto* const depths = vtkFloatArray::SafeDownCast(picture->GetPointData()->GetArray("Depth"));
  auto* const colors = static_cast<unsigned char*>(picture->GetScalarPointer());
  for (std::size_t i = 0; i < distances.size(); ++i)
  {
    unsigned char* const note = drawn->GetPointer(static_cast<vtkIdType>(4 * i));
    unsigned char* const color = colors + 4 * i;
    // Text has no depth, and is in front.
    if (std::isinf(distances[i]) || distances[i] <= depths->GetValue(static_cast<vtkIdType>(i)))
    {
      LayOver(note, color);
    }
    else
    {
      LayOver(color, note);
      std::copy_n(note, 4, color);
    }
  }
}
