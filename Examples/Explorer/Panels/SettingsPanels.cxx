// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// Light and material, clipping, re-use.
#include "Panels/Form.h"
#include "Panels/Panels.h"

#include <vtkCamera.h>
#include <vtkMath.h>

#include <QAction>

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
  const auto turn = [&](const char* name, const char* help, const auto& change)
  {
    return form->NewAction(QObject::tr(name), QObject::tr(help),
      [&bench, change]
      {
        bench.EditOnce(QObject::tr("clipping"),
          [&](Look& look)
          {
            const bool isPlaced = look.Clip.Normal != Point{};
            look.Clip = isPlaced ? look.Clip : bench.Data.View.MiddlePlane();
            look.Choices[Choose::Clipping] = 1;
            change(look.Clip.Normal);
          });
      });
  };
  const auto across = [](std::size_t axis)
  {
    return [axis](Point& normal)
    {
      normal = {};
      normal[axis] = -1.0;
    };
  };
  const auto alongView = [&view](Point& normal)
  { view.Renderer->GetActiveCamera()->GetDirectionOfProjection(normal.data()); };
  const auto flip = [](Point& normal) { vtkMath::MultiplyScalar(normal.data(), -1.0); };
  form->AddChoice(AllChoices()[Choose::Clipping]);
  form->AddButtons({ turn("X", "cut across X", across(0)), turn("Y", "cut across Y", across(1)),
    turn("Z", "cut across Z", across(2)), turn("View", "cut as seen from here", alongView),
    turn("Flip", "show the other side", flip) });
  form->AddChoice(AllChoices()[Choose::Cropping]);
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
        look.Choices[Choose::Cropping] = 1;
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
