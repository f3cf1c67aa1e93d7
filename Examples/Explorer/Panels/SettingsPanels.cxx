// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// Light and material, clipping, re-use.
#include "Panels/Form.h"
#include "Panels/Panels.h"

#include <vtkVector.h>
#include <vtkVectorOperators.h>

#include <array>

namespace
{

Point AlongView(const CameraState& camera)
{
  vtkVector3d along = vtkVector3d(camera.FocalPoint.data()) - vtkVector3d(camera.Position.data());
  along.Normalize();
  return { along[0], along[1], along[2] };
}

// Unless it was placed: through the middle, slantwise. The volume is open to the viewer, and the
// plane can be seen.
void PlacePlane(Look& look, const VolumeView& view)
{
  look.IsClipped = true;
  if (look.Clip.Normal != Point{})
  {
    return;
  }
  const CameraState camera = view.Camera();
  const Box& box = view.WorldBounds();
  const Point forward = AlongView(camera);
  vtkVector3d right = vtkVector3d(forward.data()).Cross(vtkVector3d(camera.ViewUp.data()));
  right.Normalize();
  for (std::size_t i = 0; i < 3; ++i)
  {
    look.Clip.Origin[i] = 0.5 * (box[2 * i] + box[2 * i + 1]);
    look.Clip.Normal[i] = 0.8 * forward[i] - 0.6 * right[static_cast<int>(i)];
  }
}

}

QWidget* MakeLightPanel(Workbench& bench)
{
  auto* form = new Form(bench);
  form->AddChoices(Choice::Panel::Light);
  const std::array<std::array<const char*, 2>, 4> parts = {
    { { "Ambient", "light from everywhere" }, { "Diffuse", "light that shows the shape" },
      { "Specular", "how bright highlights are" }, { "Power", "how small highlights are" } }
  };
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    form->AddSlider(
      QObject::tr(parts[i][0]), QObject::tr(parts[i][1]), i < 3 ? 1.0 : 100.0,
      [&bench, i](const Look&) { return bench.Data.View.Shading()[i]; },
      [&bench, i](Look& look, double value)
      {
        look.Shading = bench.Data.View.Shading();
        look.Shading[i] = value;
        look.HasShading = true;
      });
  }
  form->AddButtons({ form->NewAction(QObject::tr("As the material"),
    QObject::tr("forget the four sliders' changes"),
    [&bench]
    { bench.EditOnce(QObject::tr("material"), [](Look& look) { look.HasShading = false; }); }) });
  return form;
}

QWidget* MakeClippingPanel(Workbench& bench)
{
  auto* form = new Form(bench);
  const VolumeView& view = bench.Data.View;
  form->AddSwitch(QObject::tr("Clip by a plane (T)"),
    QObject::tr("drag the plane's arrow in the view"), "clip", &Look::IsClipped,
    [&view](Look& look) { PlacePlane(look, view); });
  const auto turn = [&](
                      const char* name, const char* help, const std::function<void(Point&)>& change)
  {
    return form->NewAction(QObject::tr(name), QObject::tr(help),
      [&bench, &view, change]
      {
        bench.EditOnce(QObject::tr("clipping"),
          [&](Look& look)
          {
            PlacePlane(look, view);
            change(look.Clip.Normal);
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
  form->AddSwitch(QObject::tr("Crop to a box (E)"), QObject::tr("drag the box's sides in the view"),
    "crop", &Look::IsCropped);
  const std::array<const char*, 6> sides = { "X from", "X to", "Y from", "Y to", "Z from", "Z to" };
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    const std::size_t from = i & ~std::size_t{ 1 };
    form->AddSlider(
      QObject::tr(sides[i]), QObject::tr("a side of the box"), 1.0,
      [&view, i, from](const Look& look)
      {
        const Box& box = view.DataBounds();
        return (look.Crop[i] - box[from]) / (box[from + 1] - box[from]);
      },
      [&view, i, from](Look& look, double share)
      {
        const Box& box = view.DataBounds();
        look.IsCropped = true;
        look.Crop[i] = box[from] + share * (box[from + 1] - box[from]);
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
