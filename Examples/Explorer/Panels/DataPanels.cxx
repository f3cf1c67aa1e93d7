// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// What is known of the data, and which part of them is drawn: array, component, time step.
#include "Panels/Form.h"
#include "Panels/Panels.h"

#include "Files/Arrays.h"
#include "Program/Quoted.h"

#include <vtkDataArray.h>

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSlider>
#include <QSpinBox>
#include <QToolButton>

namespace
{

QString TextOf(const Model& model)
{
  const Volume& volume = model.Data();
  const Box& box = model.View.DataBounds();
  const std::array<double, 2>& range = model.Counted().Range;
  const double bytes = 1024.0 * static_cast<double>(volume.Data->GetActualMemorySize());
  const QString size = QLocale().formattedDataSize(static_cast<qint64>(bytes));
  return QObject::tr("\u200e%1\n%2\nvalues %3 to %4\nx %5 to %6, y %7 to %8, z %9 to %10\n%11")
    .arg(QString::fromStdString(volume.Name), QString::fromStdString(model.Description()),
      Short(range[0]), Short(range[1]), Short(box[0]), Short(box[1]), Short(box[2]), Short(box[3]),
      Short(box[4]))
    .arg(
      Short(box[5]), volume.Bricks ? QObject::tr("%1, read as they are needed").arg(size) : size);
}

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
  play->setFocusPolicy(Qt::StrongFocus);
  slider->setToolTip(QObject::tr("the time step that is shown"));
  slider->setObjectName("time");
  row->addWidget(play);
  row->addWidget(slider, 1);
  row->addWidget(number);
  QObject::connect(slider, &QSlider::valueChanged, number, &QSpinBox::setValue);
  QObject::connect(number, QOverload<int>::of(&QSpinBox::valueChanged), slider, &QSlider::setValue);
  // Whenever nothing else is read: the step that is chosen meanwhile, or the next one of a play.
  const auto show = [=, &bench]
  {
    const int step = bench.Data.State().Source.TimeStep;
    const int wanted = step == slider->value() && play->isChecked() ? step + 1 : slider->value();
    if (bench.Data.IsOpen() && panel->isEnabled() && wanted != step)
    {
      bench.Ask([&] { return bench.Data.OtherTimeStep(wanted); });
    }
  };
  QObject::connect(slider, &QSlider::valueChanged, panel, show);
  QObject::connect(play, &QToolButton::toggled, panel, show);
  // A step is seen before the next one is read.
  QObject::connect(&bench, &Workbench::Changed, panel, show, Qt::QueuedConnection);
  // What cannot be read is not asked for again.
  QObject::connect(&bench, &Workbench::Said, panel,
    [=, &bench](const QString&, bool isWarning)
    {
      play->setChecked(play->isChecked() && !isWarning);
      slider->setValue(isWarning ? bench.Data.State().Source.TimeStep : slider->value());
    });
  QObject::connect(&bench, &Workbench::Opened, panel,
    [=, &bench](bool isOtherFile)
    {
      const QSignalBlocker ofSlider(slider), ofNumber(number);
      const int count = bench.Data.Data().TimeSteps;
      panel->setEnabled(count > 1);
      play->setChecked(play->isChecked() && count > 1);
      slider->setRange(1, count);
      number->setRange(1, count);
      if (isOtherFile || !slider->isSliderDown())
      {
        slider->setValue(bench.Data.State().Source.TimeStep);
        number->setValue(bench.Data.State().Source.TimeStep);
      }
    });
  return panel;
}

QWidget* MakeDataPanel(Workbench& bench)
{
  auto* form = new Form(bench);
  auto* text = new QLabel;
  auto* arrays = new QComboBox;
  auto* components = new QComboBox;
  text->setWordWrap(true);
  text->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  arrays->setObjectName("arrays");
  arrays->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  components->setObjectName("components");
  form->Add(text);
  form->Add(arrays, QObject::tr("which array of the file is drawn (N: the next)"));
  form->Add(components, QObject::tr("which component of the array is drawn"));
  const auto ask = [=, &bench](const std::string& array, int component)
  { bench.Ask([&] { return bench.Data.OtherArray(array, component); }); };
  QObject::connect(arrays, QOverload<int>::of(&QComboBox::activated),
    [=] { ask(arrays->currentData().toString().toStdString(), 0); });
  QObject::connect(components, QOverload<int>::of(&QComboBox::activated),
    [=, &bench] { ask(bench.Data.Data().Array.Name, components->currentData().toInt()); });
  QObject::connect(&bench, &Workbench::Opened, form,
    [=, &bench]
    {
      const Volume& volume = bench.Data.Data();
      const std::vector<vtkDataArray*> shown = ShownArrays(volume);
      const int count = shown.empty() ? 1 : shown.front()->GetNumberOfComponents();
      const char* active = shown.empty() ? nullptr : shown.front()->GetName();
      const std::string name = volume.Array.Name.empty() && active ? active : volume.Array.Name;
      text->setText(TextOf(bench.Data));
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
    });
  return form;
}
