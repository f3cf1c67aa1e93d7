// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// Light and material, clipping, re-use.
#include "Panels/Form.h"
#include "Panels/Panels.h"

#include <vtkVector.h>

#include <array>

namespace
{

struct Part
{
  const char* Name;
  const char* Help;
};

// Through the middle, slantwise: the volume is open to the viewer, and the plane can be seen.
Plane MiddlePlane(const VolumeView& view)
{
  Plane plane;
  const CameraState camera = view.Camera();
  vtkVector3d forward, up(camera.ViewUp.data());
  for (std::size_t i = 0; i < 3; ++i)
  {
    plane.Origin[i] = 0.5 * (view.WorldBounds()[2 * i] + view.WorldBounds()[2 * i + 1]);
    forward[static_cast<int>(i)] = camera.FocalPoint[i] - camera.Position[i];
  }
  forward.Normalize();
  vtkVector3d right = forward.Cross(up);
  right.Normalize();
  for (std::size_t i = 0; i < 3; ++i)
  {
    plane.Normal[i] = 0.8 * forward[static_cast<int>(i)] - 0.6 * right[static_cast<int>(i)];
  }
  return plane;
}

Point AlongView(const CameraState& camera)
{
  Point along;
  for (std::size_t i = 0; i < 3; ++i)
  {
    along[i] = camera.FocalPoint[i] - camera.Position[i];
  }
  return along;
}

}

QWidget* MakeLightPanel(Workbench& bench)
{
  auto* form = new Form(bench);
  form->AddChoices(Choice::Panel::Light);
  const std::array<Part, 4> parts = { { { "Ambient", "light from everywhere" },
    { "Diffuse", "light that shows the shape" }, { "Specular", "how bright highlights are" },
    { "Power", "how small highlights are" } } };
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    form->AddSlider(
      QObject::tr(parts[i].Name), QObject::tr(parts[i].Help), i < 3 ? 1.0 : 100.0,
      [&bench, i](const Look&) { return bench.Data.View.Shading()[i]; },
      [&bench, i](Look& look, double value)
      {
        look.Shading = look.Shading.value_or(bench.Data.View.Shading());
        (*look.Shading)[i] = value;
      });
  }
  form->AddButtons({ form->NewAction(QObject::tr("As the material"),
    QObject::tr("forget the four sliders' changes"),
    [&bench]
    { bench.EditOnce(QObject::tr("material"), [](Look& look) { look.Shading.reset(); }); }) });
  return form;
}

QWidget* MakeClippingPanel(Workbench& bench)
{
  auto* form = new Form(bench);
  const VolumeView& view = bench.Data.View;
  form->AddSwitch(
    QObject::tr("Clip by a plane (T)"), QObject::tr("drag the plane's arrow in the view"), "clip",
    [](const Look& look) { return look.Clip ? 1.0 : 0.0; },
    [&view](Look& look, double isOn)
    { look.Clip = isOn != 0.0 ? std::optional<Plane>(MiddlePlane(view)) : std::nullopt; });
  const auto turn = [&](
                      const char* name, const char* help, const std::function<void(Point&)>& change)
  {
    return form->NewAction(QObject::tr(name), QObject::tr(help),
      [&bench, &view, change]
      {
        bench.EditOnce(QObject::tr("clipping"),
          [&](Look& look)
          {
            look.Clip = look.Clip.value_or(MiddlePlane(view));
            change(look.Clip->Normal);
          });
      });
  };
  form->AddButtons({
    turn("X", "cut across X",
      [](Point& normal) {
        normal = { -1.0, 0.0, 0.0 };
      }),
    turn("Y", "cut across Y",
      [](Point& normal) {
        normal = { 0.0, -1.0, 0.0 };
      }),
    turn("Z", "cut across Z",
      [](Point& normal) {
        normal = { 0.0, 0.0, -1.0 };
      }),
    turn("View", "cut as seen from here",
      [&view](Point& normal) { normal = AlongView(view.Camera()); }),
    turn("Flip", "show the other side",
      [](Point& normal) {
        normal = { -normal[0], -normal[1], -normal[2] };
      }),
  });
  form->AddSwitch(
    QObject::tr("Crop to a box (E)"), QObject::tr("drag the box's sides in the view"), "crop",
    [](const Look& look) { return look.Crop ? 1.0 : 0.0; },
    [&view](Look& look, double isOn)
    { look.Crop = isOn != 0.0 ? std::optional<Box>(view.DataBounds()) : std::nullopt; });
  const std::array<const char*, 6> sides = { "X from", "X to", "Y from", "Y to", "Z from", "Z to" };
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    const std::size_t from = i & ~std::size_t{ 1 };
    form->AddSlider(
      QObject::tr(sides[i]), QObject::tr("a side of the box"), 1.0,
      [&view, i, from](const Look& look)
      {
        const Box& box = view.DataBounds();
        return (look.Crop.value_or(box)[i] - box[from]) / (box[from + 1] - box[from]);
      },
      [&view, i, from](Look& look, double share)
      {
        const Box& box = view.DataBounds();
        look.Crop = look.Crop.value_or(box);
        (*look.Crop)[i] = box[from] + share * (box[from + 1] - box[from]);
      });
  }
  return form;
}

QWidget* MakeReusePanel(Workbench& bench)
{
  auto* form = new Form(bench);
  form->Add(MakeStatistics(bench));
  form->AddChoices(Choice::Panel::Reuse);
  return form;
}
