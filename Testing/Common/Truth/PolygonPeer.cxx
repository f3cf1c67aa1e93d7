// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Truth/PolygonPeer.h"

#include "Checks/Expect.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkContourFilter.h>
#include <vtkContourValues.h>
#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkLight.h>
#include <vtkMatrix4x4.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>

namespace
{

/// Pixels with a surface, in a picture of some width.
struct Mask
{
  int Width, Height;
  std::vector<char> Covered;

  /// \return whether a pixel that is covered, or one that is not, lies within a pixel around
  bool HasAround(int x, int y, bool isCovered) const
  {
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, this->Height - 1); ++v)
    {
      for (int u = std::max(x - 1, 0); u <= std::min(x + 1, this->Width - 1); ++u)
      {
        const auto at = static_cast<std::size_t>(v * this->Width + u);
        if ((this->Covered[at] != 0) == isCovered)
        {
          return true;
        }
      }
    }
    return false;
  }

  bool IsAtRim(int x, int y) const
  {
    return x == 0 || y == 0 || x == this->Width - 1 || y == this->Height - 1;
  }
};

/// A pixel that only `one` covers strays unless the outlines of both pass within a pixel.
bool Strays(const Mask& one, const Mask& other, int x, int y)
{
  return !other.HasAround(x, y, true) || !(one.HasAround(x, y, false) || one.IsAtRim(x, y));
}

/// The value that a share of the numbers does not exceed.
double Percentile(std::vector<double>& numbers, double share)
{
  if (numbers.empty())
  {
    return 0.0;
  }
  const auto last = static_cast<double>(numbers.size() - 1);
  const auto at = numbers.begin() + static_cast<std::ptrdiff_t>(share * last);
  std::nth_element(numbers.begin(), at, numbers.end());
  return *at;
}

template <class Filter>
vtkSmartPointer<vtkPolyData> ContoursBy(Filter* filter, vtkDataSet* data, double isovalue)
{
  filter->SetInputData(data);
  filter->SetValue(0, isovalue);
  filter->ComputeNormalsOn();
  filter->ComputeScalarsOff();
  filter->Update();
  return filter->GetOutput();
}

vtkSmartPointer<vtkPolyData> ContoursOf(vtkDataSet* data, double isovalue)
{
  return vtkImageData::SafeDownCast(data)
    ? ContoursBy(vtkNew<vtkFlyingEdges3D>().Get(), data, isovalue)
    : ContoursBy(vtkNew<vtkContourFilter>().Get(), data, isovalue);
}

int LargestDifference(const std::array<unsigned char, 3>& a, const std::array<unsigned char, 3>& b)
{
  return std::max({ std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2]) });
}

}

PolygonPeer::PolygonPeer(vtkVolume* volume, vtkRenderer* renderer, int width, int height)
  : Volume(volume)
  , Renderer(renderer)
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(renderer);
  renderer->AddVolume(volume);
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  renderer->AddLight(light);
}

PolygonPeer::~PolygonPeer()
{
  this->RemovePolygons();
  this->Renderer->RemoveVolume(this->Volume);
  this->Window->RemoveRenderer(this->Renderer);
}

void PolygonPeer::RemovePolygons()
{
  for (const Surface& surface : this->Surfaces)
  {
    this->Renderer->RemoveActor(surface.Actor);
  }
  this->Surfaces.clear();
}

void PolygonPeer::SetContours(vtkDataSet* data)
{
  this->RemovePolygons();
  vtkVolumeProperty* property = this->Volume->GetProperty();
  vtkContourValues* isovalues = property->GetIsoSurfaceValues();
  for (int i = 0; i < isovalues->GetNumberOfContours(); ++i)
  {
    const double isovalue = isovalues->GetValue(i);
    if (property->GetScalarOpacity()->GetValue(isovalue) > 0.0)
    {
      this->AddPolygons(ContoursOf(data, isovalue), isovalue);
    }
  }
}

vtkActor* PolygonPeer::AddPolygons(vtkPolyData* polygons, double isovalue)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(polygons);
  mapper->ScalarVisibilityOff();
  const auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  this->Renderer->AddActor(actor);
  this->Surfaces.push_back({ actor, isovalue });
  this->UpdatePolygons();
  return actor;
}

void PolygonPeer::UpdatePolygons()
{
  vtkVolumeProperty* from = this->Volume->GetProperty();
  this->Volume->ComputeMatrix();
  for (const Surface& surface : this->Surfaces)
  {
    vtkNew<vtkMatrix4x4> transform;
    transform->DeepCopy(this->Volume->GetMatrix());
    surface.Actor->SetUserMatrix(transform);
    vtkProperty* property = surface.Actor->GetProperty();
    property->SetColor(from->GetRGBTransferFunction()->GetColor(surface.Isovalue));
    property->SetInterpolationToPhong();
    if (from->GetShade())
    {
      property->LightingOn();
      property->SetAmbient(from->GetAmbient());
      property->SetDiffuse(from->GetDiffuse());
      property->SetSpecular(from->GetSpecular());
      property->SetSpecularPower(from->GetSpecularPower());
      property->SetSpecularColor(1.0, 1.0, 1.0);
    }
    else
    {
      property->LightingOff();
      property->SetAmbient(0.0);
      property->SetDiffuse(1.0);
    }
  }
}

void PolygonPeer::LookFrom(double x, double y, double z)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(x, y, z);
  const bool isVertical = std::abs(z) > 0.9 * std::hypot(x, y, z);
  camera->SetViewUp(0.0, isVertical ? 1.0 : 0.0, isVertical ? 0.0 : 1.0);
  this->Renderer->ResetCamera(this->Volume->GetBounds());
  this->Renderer->ResetCameraClippingRange();
}

WindowPixels PolygonPeer::Draw(bool showsVolume, bool showsPolygons)
{
  this->Volume->SetVisibility(showsVolume);
  for (const Surface& surface : this->Surfaces)
  {
    surface.Actor->SetVisibility(showsPolygons);
  }
  this->Window->Render();
  const int* size = this->Window->GetSize();
  constexpr int backBuffer = 0;
  vtkNew<vtkUnsignedCharArray> colors;
  this->Window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, backBuffer, colors);
  vtkNew<vtkFloatArray> depths;
  this->Window->GetZbufferData(0, 0, size[0] - 1, size[1] - 1, depths);
  this->Volume->VisibilityOn();

  WindowPixels pixels;
  const auto count = static_cast<std::size_t>(size[0] * size[1]);
  pixels.Colors.resize(count);
  pixels.Depths.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    colors->GetTypedTuple(static_cast<vtkIdType>(i), pixels.Colors[i].data());
    pixels.Depths[i] = depths->GetValue(static_cast<vtkIdType>(i));
  }
  return pixels;
}

WindowPixels PolygonPeer::DrawVolume()
{
  return this->Draw(true, false);
}

WindowPixels PolygonPeer::DrawPolygons()
{
  return this->Draw(false, true);
}

double PolygonPeer::DistanceOf(float depth) const
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  double nearest, farthest;
  camera->GetClippingRange(nearest, farthest);
  const double range = farthest - nearest;
  return camera->GetParallelProjection() ? nearest + depth * range
                                         : nearest * farthest / (farthest - depth * range);
}

PeerAgreement PolygonPeer::Compare()
{
  const WindowPixels ground = this->Draw(false, false);
  const WindowPixels polygons = this->DrawPolygons(), volume = this->DrawVolume();
  const int* size = this->Window->GetSize();
  Mask ofVolume{ size[0], size[1], {} }, ofPolygons = ofVolume;
  for (std::size_t i = 0; i < ground.Depths.size(); ++i)
  {
    ofVolume.Covered.push_back(volume.Depths[i] < ground.Depths[i]);
    ofPolygons.Covered.push_back(polygons.Depths[i] < ground.Depths[i]);
  }

  PeerAgreement agreement;
  std::vector<double> colors, depths;
  for (int y = 0; y < size[1]; ++y)
  {
    for (int x = 0; x < size[0]; ++x)
    {
      const auto i = static_cast<std::size_t>(y * size[0] + x);
      const bool isVolume = ofVolume.Covered[i] != 0, isPolygon = ofPolygons.Covered[i] != 0;
      if (isVolume && isPolygon)
      {
        colors.push_back(LargestDifference(volume.Colors[i], polygons.Colors[i]));
        depths.push_back(
          std::abs(this->DistanceOf(volume.Depths[i]) - this->DistanceOf(polygons.Depths[i])));
      }
      else if (isVolume || isPolygon)
      {
        (isVolume ? agreement.OnlyVolume : agreement.OnlyPolygons)++;
        agreement.Astray +=
          isVolume ? Strays(ofVolume, ofPolygons, x, y) : Strays(ofPolygons, ofVolume, x, y);
      }
    }
  }
  agreement.Both = static_cast<long>(colors.size());
  agreement.MedianColor = Percentile(colors, 0.5);
  agreement.Color90 = Percentile(colors, 0.9);
  agreement.MedianDepth = Percentile(depths, 0.5);
  agreement.Depth90 = Percentile(depths, 0.9);
  return agreement;
}

PeerAgreement PolygonPeer::ExpectAgreement(const std::string& what, long fewest)
{
  constexpr double mostColor = 3.0;
  const PeerAgreement found = this->Compare();
  std::cout << what << ": " << found.Both << " pixels of both, " << found.OnlyVolume
            << " of the volume only, " << found.OnlyPolygons << " of polygons only, "
            << found.Astray << " astray; colours differ by " << found.MedianColor << " (median), "
            << found.Color90 << " (90 %) of 255, depths by " << found.MedianDepth << ", "
            << found.Depth90 << '\n';
  Expect(found.Both >= fewest, what + ": both cover " + std::to_string(found.Both) + " pixels");
  Expect(found.Astray == 0, what + ": outlines are more than a pixel apart");
  Expect(found.MedianColor <= mostColor, what + ": colours differ");
  return found;
}
