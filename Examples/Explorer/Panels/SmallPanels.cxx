// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// Light and material, clipping, re-use, time, and what is known of the data.
#include "Panels/Form.h"
#include "Panels/Panels.h"

#include "Files/Arrays.h"
#include "Program/Quoted.h"

#include <vtkDataArray.h>
#include <vtkVector.h>

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSpinBox>
#include <QTimer>
#include <QToolButton>

#include <algorithm>

namespace
{

// Ambient, diffuse, specular and power as they are now, by the choice or one by one.
std::array<double, 4> ShadingOf(const Look& look)
{
  static const std::array<std::array<double, 4>, 4> presets = { { { 0.15, 0.8, 0.25, 20.0 },
    { 0.15, 0.85, 0.0, 1.0 }, { 0.12, 0.7, 0.6, 60.0 }, { 1.0, 0.0, 0.0, 1.0 } } };
  return look.Shading.value_or(presets[static_cast<std::size_t>(look.Choices[Choose::Material])]);
}

// Through the middle, slantwise: the volume is open to the viewer, and the plane can be seen.
Plane MiddlePlane(const Workbench& bench)
{
  Plane plane;
  const std::array<double, 6> box = bench.Data.View.WorldBounds();
  const CameraState camera = bench.Data.View.Camera();
  vtkVector3d forward, up(camera.ViewUp.data());
  for (int i = 0; i < 3; ++i)
  {
    const auto axis = static_cast<std::size_t>(i);
    plane.Origin[axis] = 0.5 * (box[2 * axis] + box[2 * axis + 1]);
    forward[i] = camera.FocalPoint[axis] - camera.Position[axis];
  }
  forward.Normalize();
  vtkVector3d right = forward.Cross(up);
  right.Normalize();
  for (int i = 0; i < 3; ++i)
  {
    plane.Normal[static_cast<std::size_t>(i)] = 0.8 * forward[i] - 0.6 * right[i];
  }
  return plane;
}

}

QWidget* MakeLightPanel(Workbench& bench)
{
  auto* panel = new QWidget;
  Form form(bench, panel);
  form.AddChoices(Choice::Panel::Light);
  const std::array<const char*, 4> names = { "Ambient", "Diffuse", "Specular", "Power" };
  const std::array<const char*, 4> help = { "light from everywhere", "light that shows the shape",
    "how bright highlights are", "how small highlights are" };
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    form.AddSlider(
      QObject::tr(names[i]), QObject::tr(help[i]), i < 3 ? 1.0 : 100.0,
      [i](const Look& look) { return ShadingOf(look)[i]; },
      [i](Look& look, double value)
      {
        look.Shading = ShadingOf(look);
        (*look.Shading)[i] = value;
      });
  }
  form.AddButton(QObject::tr("As the material"), QObject::tr("forget the four sliders' changes"),
    [&bench]
    {
      bench.BeginGesture();
      bench.Edit(QObject::tr("material"), [](Look& look) { look.Shading.reset(); });
    });
  return panel;
}

QWidget* MakeClippingPanel(Workbench& bench)
{
  auto* panel = new QWidget;
  Form form(bench, panel);
  form
    .AddSwitch(
      QObject::tr("Clip by a plane (T)"), QObject::tr("drag the plane's arrow in the view"),
      [](const Look& look) { return look.Clip.has_value(); },
      [&bench](Look& look, bool isOn)
      { look.Clip = isOn ? std::optional<Plane>(MiddlePlane(bench)) : std::nullopt; })
    ->setObjectName("clip");
  auto* directions = new QWidget;
  auto* row = new QHBoxLayout(directions);
  row->setContentsMargins(0, 0, 0, 0);
  const auto turn = [&bench](const QString& name, const std::function<void(Plane&)>& change)
  {
    return [&bench, name, change]
    {
      bench.BeginGesture();
      bench.Edit(name,
        [&](Look& look)
        {
          look.Clip = look.Clip.value_or(MiddlePlane(bench));
          change(*look.Clip);
        });
    };
  };
  const auto add =
    [&](const QString& name, const QString& help, const std::function<void(Plane&)>& change)
  {
    auto* button = new QToolButton;
    button->setText(name);
    button->setToolTip(help);
    row->addWidget(button);
    QObject::connect(button, &QToolButton::clicked, turn(QObject::tr("clipping"), change));
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    const QString name = QString(QChar('X' + axis));
    add(name, QObject::tr("cut across %1").arg(name),
      [axis](Plane& plane)
      {
        plane.Normal = {};
        plane.Normal[static_cast<std::size_t>(axis)] = -1.0;
      });
  }
  add(QObject::tr("View"), QObject::tr("cut as seen from here"),
    [&bench](Plane& plane)
    {
      const CameraState camera = bench.Data.View.Camera();
      for (std::size_t i = 0; i < 3; ++i)
      {
        plane.Normal[i] = camera.FocalPoint[i] - camera.Position[i];
      }
    });
  add(QObject::tr("Flip"), QObject::tr("show the other side"),
    [](Plane& plane)
    {
      for (double& part : plane.Normal)
      {
        part = -part;
      }
    });
  form.AddWidget(directions);
  form
    .AddSwitch(
      QObject::tr("Crop to a box (E)"), QObject::tr("drag the box's sides in the view"),
      [](const Look& look) { return look.Crop.has_value(); },
      [&bench](Look& look, bool isOn)
      {
        look.Crop =
          isOn ? std::optional<std::array<double, 6>>(bench.Data.View.DataBounds()) : std::nullopt;
      })
    ->setObjectName("crop");
  const std::array<const char*, 6> sides = { "X from", "X to", "Y from", "Y to", "Z from", "Z to" };
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    form.AddSlider(
      QObject::tr(sides[i]), QObject::tr("a side of the box"), 1.0,
      [&bench, i](const Look& look)
      {
        const auto box = bench.Data.View.DataBounds();
        const std::size_t axis = i & ~std::size_t{ 1 };
        return (look.Crop.value_or(box)[i] - box[axis]) / (box[axis + 1] - box[axis]);
      },
      [&bench, i](Look& look, double share)
      {
        const auto box = bench.Data.View.DataBounds();
        const std::size_t axis = i & ~std::size_t{ 1 };
        look.Crop = look.Crop.value_or(box);
        (*look.Crop)[i] = box[axis] + share * (box[axis + 1] - box[axis]);
      });
  }
  return panel;
}

QWidget* MakeReusePanel(Workbench& bench)
{
  auto* panel = new QWidget;
  Form form(bench, panel);
  form.AddWidget(MakeStatistics(bench));
  form.AddChoices(Choice::Panel::Reuse);
  form.AddChoices(Choice::Panel::Output);
  return panel;
}

QWidget* MakeTimePanel(Workbench& bench)
{
  auto* panel = new QWidget;
  auto* row = new QHBoxLayout(panel);
  auto* play = new QToolButton;
  auto* slider = new QSlider(Qt::Horizontal);
  auto* number = new QSpinBox;
  play->setObjectName("play");
  play->setText(QObject::tr("Play"));
  play->setToolTip(QObject::tr("play time steps, and pause (Space)"));
  play->setCheckable(true);
  slider->setToolTip(QObject::tr("the time step that is shown"));
  slider->setObjectName("time");
  row->addWidget(play);
  row->addWidget(slider, 1);
  row->addWidget(number);
  const auto ask = [&bench](int step)
  { bench.Ask([&bench, step] { return bench.Data.OtherTimeStep(step); }); };
  const auto next = [&bench, ask, play]
  {
    if (play->isChecked())
    {
      ask(bench.Data.State().Source.TimeStep + 1);
    }
  };
  const auto show = [=, &bench](int step)
  {
    if (bench.Data.IsOpen() && step != bench.Data.State().Source.TimeStep)
    {
      ask(step);
    }
  };
  QObject::connect(play, &QToolButton::toggled, next);
  QObject::connect(slider, &QSlider::valueChanged, show);
  QObject::connect(number, QOverload<int>::of(&QSpinBox::valueChanged), show);
  QObject::connect(&bench, &Workbench::Changed, panel,
    [&bench, slider, number, play, show]
    {
      if (!bench.IsBusy() && slider->isEnabled())
      {
        show(slider->value()); // where it was dragged to meanwhile
      }
    });
  QObject::connect(&bench, &Workbench::Opened, panel,
    [=, &bench]
    {
      const int count = bench.Data.Data().TimeSteps;
      const QSignalBlocker ofSlider(slider), ofNumber(number);
      if (!slider->isSliderDown())
      {
        slider->setRange(1, count);
        slider->setValue(bench.Data.State().Source.TimeStep);
      }
      number->setRange(1, count);
      number->setValue(bench.Data.State().Source.TimeStep);
      play->setChecked(play->isChecked() && count > 1);
      panel->setEnabled(count > 1);
      // A step is seen before the next is read.
      QTimer::singleShot(0, panel, next);
    });
  return panel;
}

QWidget* MakeDataPanel(Workbench& bench)
{
  auto* panel = new QWidget;
  Form form(bench, panel);
  auto* text = new QLabel;
  auto* arrays = new QComboBox;
  auto* components = new QComboBox;
  text->setWordWrap(true);
  text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  arrays->setToolTip(QObject::tr("which array of the file is drawn (N: the next)"));
  components->setToolTip(QObject::tr("which component of the array is drawn"));
  arrays->setObjectName("arrays");
  components->setObjectName("components");
  arrays->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  for (QWidget* widget : { static_cast<QWidget*>(text), static_cast<QWidget*>(arrays),
         static_cast<QWidget*>(components) })
  {
    form.AddWidget(widget);
  }
  QObject::connect(arrays, QOverload<int>::of(&QComboBox::activated),
    [&bench, arrays](int index)
    {
      const std::string name = arrays->itemData(index).toString().toStdString();
      bench.Ask([&] { return bench.Data.OtherArray(name, 0); });
    });
  QObject::connect(components, QOverload<int>::of(&QComboBox::activated),
    [&bench, components](int index)
    {
      const int component = components->itemData(index).toInt();
      bench.Ask([&] { return bench.Data.OtherArray(bench.Data.Data().Array.Name, component); });
    });
  QObject::connect(&bench, &Workbench::Opened, panel,
    [=, &bench]
    {
      const Volume& volume = bench.Data.Data();
      const std::vector<vtkDataArray*> shown = ShownArrays(volume);
      const int count = shown.empty() ? 1 : shown.front()->GetNumberOfComponents();
      const std::string name = !volume.Array.Name.empty() ? volume.Array.Name
        : !shown.empty() && shown.front()->GetName()      ? shown.front()->GetName()
                                                          : "";
      arrays->clear();
      for (const ArrayChoice& choice : AllArrays(volume.Data))
      {
        arrays->addItem(
          QString::fromStdString(Printable(choice.Name)), QString::fromStdString(choice.Name));
      }
      arrays->setCurrentIndex(arrays->findData(QString::fromStdString(name)));
      arrays->setEnabled(arrays->count() > 1);
      components->clear();
      for (int i = count > 1 ? -1 : 0; i < count; ++i)
      {
        components->addItem(
          i < 0 ? QObject::tr("length of vectors") : QObject::tr("component %1").arg(i + 1), i);
      }
      components->setCurrentIndex(components->findData(bench.Data.State().Component));
      components->setEnabled(count > 1);
      const auto box = bench.Data.View.DataBounds();
      const auto range = bench.Data.Counted().Range;
      const double bytes = 1024.0 * static_cast<double>(volume.Data->GetActualMemorySize());
      text->setText(
        QObject::tr("\u200e%1\n%2\nvalues %3 to %4\nx %5 to %6, y %7 to %8, z %9 to %10\n%11")
          .arg(QString::fromStdString(volume.Name),
            QString::fromStdString(bench.Data.Description()), Short(range[0]), Short(range[1]),
            Short(box[0]), Short(box[1]), Short(box[2]), Short(box[3]), Short(box[4]))
          .arg(Short(box[5]), QLocale().formattedDataSize(static_cast<qint64>(bytes))));
    });
  return panel;
}
