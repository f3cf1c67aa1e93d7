// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_BlendedScene_h
#define Testing_BlendedScene_h

#include "Scenes/OffScreen.h"
#include "Scenes/Scene.h"
#include "Volumes/Volumes.h"

#include <vtkActor.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <array>
#include <string>

/// The modes that blend a volume.
inline const std::array<int, 5> BlendModes = { vtkVolumeMapper::COMPOSITE_BLEND,
  vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND, vtkVolumeMapper::MINIMUM_INTENSITY_BLEND,
  vtkVolumeMapper::AVERAGE_INTENSITY_BLEND, vtkVolumeMapper::ADDITIVE_BLEND };

/// True if a mode shows no colours, but shares of the range of all samples, in grey.
inline bool IsGrey(int mode)
{
  return mode == vtkVolumeMapper::AVERAGE_INTENSITY_BLEND ||
    mode == vtkVolumeMapper::ADDITIVE_BLEND;
}

inline std::string NameOfMode(int mode)
{
  const std::array<const char*, 5> names = { "composite", "maximum", "minimum", "average",
    "additive" };
  return names[static_cast<std::size_t>(mode)];
}

/// Four spheres of values up to 255 in a box of 31 x 31 x 31, seen at an angle.
struct BlendedScene : Scene
{
  explicit BlendedScene(int mode, vtkDataSet* data = Volumes::FourSpheres(32))
    : Scene(data, {})
  {
    this->Mapper->SetBlendMode(mode);
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(0.0, 0.1, 0.2, 0.9);
    color->AddRGBPoint(128.0, 0.3, 0.9, 0.2);
    color->AddRGBPoint(255.0, 1.0, 0.9, 0.8);
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0.0, mode == vtkVolumeMapper::MINIMUM_INTENSITY_BLEND ? 0.4 : 0.0);
    opacity->AddPoint(20.0, mode == vtkVolumeMapper::MINIMUM_INTENSITY_BLEND ? 0.4 : 0.0);
    opacity->AddPoint(255.0, 0.8);
    vtkVolumeProperty* property = this->Volume->GetProperty();
    property->SetColor(color);
    property->SetScalarOpacity(opacity);
    property->SetScalarOpacityUnitDistance(8.0);
    property->ShadeOff();
    this->LookFrom(1.0, 2.0, 0.7);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetFocalPoint(15.5, 15.5, 15.5);
    camera->SetPosition(45.0, 85.0, 35.0);
    camera->SetClippingRange(20.0, 200.0);
  }
};

/// An opaque blue plane, wider than the picture.
struct BluePlane
{
  BluePlane(const std::array<double, 3>& centre, const std::array<double, 3>& normal)
  {
    this->Source->SetOrigin(-300.0, -300.0, 0.0);
    this->Source->SetPoint1(300.0, -300.0, 0.0);
    this->Source->SetPoint2(-300.0, 300.0, 0.0);
    this->Source->SetNormal(normal[0], normal[1], normal[2]);
    this->Source->SetCenter(centre[0], centre[1], centre[2]);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(this->Source->GetOutputPort());
    this->Actor->SetMapper(mapper);
    this->Actor->GetProperty()->SetColor(0.0, 0.0, 1.0);
    this->Actor->GetProperty()->LightingOff();
  }

  vtkNew<vtkPlaneSource> Source;
  vtkNew<vtkActor> Actor;
};

#endif
