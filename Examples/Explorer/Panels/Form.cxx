// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Panels/Form.h"

#include "Panels/Panels.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>

#include <cmath>

namespace
{

constexpr int SliderSteps = 1000;

}

QColor ColorOf(const std::array<double, 3>& rgb)
{
  return QColor::fromRgbF(rgb[0], rgb[1], rgb[2]);
}

QColor Blended(const QPalette& palette, double share)
{
  const QColor ground = palette.color(QPalette::Window), text = palette.color(QPalette::WindowText);
  const auto mixed = [share](double a, double b) { return a + share * (b - a); };
  return QColor::fromRgbF(mixed(ground.redF(), text.redF()), mixed(ground.greenF(), text.greenF()),
    mixed(ground.blueF(), text.blueF()));
}

QString Short(double number)
{
  return QString::number(number, 'g', 5);
}

void AskColor(QWidget* over, const QColor& first, const std::function<void(const Rgb&)>& take)
{
  const QColor color = QColorDialog::getColor(first, over);
  if (color.isValid())
  {
    take({ color.redF(), color.greenF(), color.blueF() });
  }
}

Form::Form(Workbench& bench, QWidget* panel)
  : Bench(bench)
  , Rows(new QFormLayout(panel))
{
  this->Rows->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
}

void Form::OnChange(QWidget* widget, const std::function<void()>& refresh)
{
  const auto act = [this_ = &this->Bench, refresh]
  {
    if (this_->Data.IsOpen())
    {
      refresh();
    }
  };
  QObject::connect(&this->Bench, &Workbench::Settled, widget, act);
  QObject::connect(&this->Bench, &Workbench::Opened, widget, act);
}

void Form::ShowIf(QWidget* widget, const std::function<bool()>& isUseful)
{
  QWidget* label = this->Rows->labelForField(widget);
  this->OnChange(widget,
    [widget, label, isUseful]
    {
      widget->setVisible(isUseful());
      if (label)
      {
        label->setVisible(isUseful());
      }
    });
}

void Form::AddRow(const QString& label, const QString& help, QWidget* widget)
{
  widget->setToolTip(help);
  widget->setAccessibleName(label);
  this->Rows->addRow(label, widget);
  this->Rows->labelForField(widget)->setToolTip(help);
}

void Form::AddWidget(QWidget* widget)
{
  this->Rows->addRow(widget);
}

void Form::AddChoice(const Choice& choice)
{
  Workbench& bench = this->Bench;
  const Choose what = choice.What;
  const QString help =
    QObject::tr("%1 (%2)").arg(QObject::tr(choice.Help)).arg(QChar(choice.Key).toUpper());
  QWidget* box = nullptr;
  if (choice.IsSwitch())
  {
    auto* check = new QCheckBox(QObject::tr(choice.Label));
    check->setToolTip(help);
    this->AddWidget(check);
    QObject::connect(check, &QCheckBox::clicked, [&bench, what] { bench.Turn(what, 1); });
    this->OnChange(check,
      [&bench, check, what] { check->setChecked(bench.Data.Settings().Choices.IsOn(what)); });
    box = check;
  }
  else
  {
    auto* combo = new QComboBox;
    for (const char* value : choice.Values)
    {
      combo->addItem(QObject::tr(value));
    }
    this->AddRow(QObject::tr(choice.Label), help, combo);
    QObject::connect(combo, QOverload<int>::of(&QComboBox::activated),
      [&bench, what](int index) { bench.Turn(what, index - bench.Data.Settings().Choices[what]); });
    this->OnChange(combo,
      [&bench, combo, what] { combo->setCurrentIndex(bench.Data.Settings().Choices[what]); });
    box = combo;
  }
  box->setObjectName(choice.Name);
  this->ShowIf(box, [&bench, &choice] { return bench.Data.Offers(choice); });
}

void Form::AddChoices(Choice::Panel panel)
{
  for (const Choice& choice : AllChoices())
  {
    if (choice.In == panel)
    {
      this->AddChoice(choice);
    }
  }
}

QAbstractButton* Form::AddSwitch(const QString& label, const QString& help,
  const std::function<bool(const Look&)>& get, const std::function<void(Look&, bool)>& set)
{
  Workbench& bench = this->Bench;
  auto* check = new QCheckBox(label);
  check->setToolTip(help);
  this->AddWidget(check);
  QObject::connect(check, &QCheckBox::clicked,
    [&bench, label, set](bool isOn)
    {
      bench.BeginGesture();
      bench.Edit(label, [&](Look& look) { set(look, isOn); });
    });
  this->OnChange(check, [&bench, check, get] { check->setChecked(get(bench.Data.Settings())); });
  return check;
}

QSlider* Form::AddSlider(const QString& label, const QString& help, double most,
  const std::function<double(const Look&)>& get, const std::function<void(Look&, double)>& set)
{
  Workbench& bench = this->Bench;
  auto* slider = new QSlider(Qt::Horizontal);
  slider->setRange(0, SliderSteps);
  slider->setPageStep(SliderSteps / 10);
  slider->setSingleStep(SliderSteps / 100);
  this->AddRow(label, help, slider);
  QObject::connect(slider, &QSlider::sliderPressed,
    [&bench]
    {
      bench.BeginGesture();
      bench.SetDragging(true);
    });
  QObject::connect(slider, &QSlider::sliderReleased, [&bench] { bench.SetDragging(false); });
  QObject::connect(slider, &QSlider::valueChanged,
    [&bench, label, most, set](int value)
    { bench.Edit(label, [&](Look& look) { set(look, most * value / SliderSteps); }); });
  this->OnChange(slider,
    [&bench, slider, most, get]
    {
      const QSignalBlocker blocker(slider);
      slider->setValue(
        static_cast<int>(std::lround(get(bench.Data.Settings()) / most * SliderSteps)));
    });
  return slider;
}

QWidget* Form::AddButton(
  const QString& label, const QString& help, const std::function<void()>& act)
{
  auto* button = new QPushButton(label);
  button->setToolTip(help);
  this->AddWidget(button);
  QObject::connect(button, &QPushButton::clicked, act);
  return button;
}
