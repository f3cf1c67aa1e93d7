// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// Light and material, clipping, what is beside the volume, re-use.
#include "Panels/Form.h"
#include "Panels/Panels.h"

#include <vtkCamera.h>
#include <vtkMath.h>

#include <QAction>

QWidget* MakeLightPanel(Workbench& bench)
{
  auto* form = new Form(bench);
  form->AddSettings("Light");
  form->AddButtons({ NewAction(form, "As the material", "forget the four sliders' changes",
    [&bench]
    {
      bench.EditOnce(QObject::tr("material"), [](Look& look) { look.Values[Row::OwnShading] = 0; });
    }) });
  return form;
}

QWidget* MakeClippingPanel(Workbench& bench)
{
  auto* form = new Form(bench);
  const VolumeView& view = bench.Data.View;
  const auto turn = [&](const char* name, const char* help, const auto& change)
  {
    return NewAction(form, name, help,
      [&bench, change]
      {
        bench.EditOnce(QObject::tr("clipping"),
          [&](Look& look)
          {
            const bool isPlaced = look.Clip.Normal != Point{};
            look.Clip = isPlaced ? look.Clip : bench.Data.View.MiddlePlane();
            look.Values[Row::Clipping] = 1;
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
  form->AddSettings("Clip");
  form->AddButtons({ turn("X", "cut across X", across(0)), turn("Y", "cut across Y", across(1)),
    turn("Z", "cut across Z", across(2)), turn("View", "cut as seen from here", alongView),
    turn("Flip", "show the other side", flip) });
  form->AddSettings("Crop");
  return form;
}

QWidget* MakeScenePanel(Workbench& bench)
{
  auto* form = new Form(bench);
  form->AddSettings("Scene");
  return form;
}

QWidget* MakeReusePanel(Workbench& bench)
{
  auto* form = new Form(bench);
  form->Add(MakeStatistics(bench));
  form->AddSettings("Re-use");
  return form;
}
