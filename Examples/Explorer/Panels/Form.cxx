// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Panels/Form.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QSlider>
#include <QToolButton>

#include <cmath>

namespace
{

constexpr int SliderSteps = 1000;

}

QColor ToQColor(const Rgb& rgb)
{
  return QColor::fromRgbF(rgb[0], rgb[1], rgb[2]);
}

QString Short(double number)
{
  return QString::number(number, 'g', 5);
}

Form::Form(Workbench& bench)
  : Bench(bench)
  , Rows(new QFormLayout(this))
{
  this->Rows->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
}

void Form::OnChange(const std::function<void()>& refresh)
{
  QObject::connect(&this->Bench, &Workbench::Settled, this,
    [this, refresh]
    {
      if (this->Bench.Data.IsOpen())
      {
        refresh();
      }
    });
}

void Form::Add(QWidget* widget, const QString& help, const QString& label, const Test& isUseful)
{
  widget->setToolTip(help.isEmpty() ? widget->toolTip() : help);
  label.isEmpty() ? this->Rows->addRow(widget) : this->Rows->addRow(label, widget);
  QWidget* left = this->Rows->labelForField(widget);
  if (left)
  {
    left->setToolTip(help);
    widget->setAccessibleName(label);
  }
  if (isUseful)
  {
    this->OnChange(
      [=]
      {
        widget->setVisible(isUseful());
        if (left)
        {
          left->setVisible(isUseful());
        }
      });
  }
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

void Form::AddChoice(const Choice& choice)
{
  const Choose::Which what = choice.What;
  const auto value = [this, what] { return this->Bench.Data.Settings().Choices[what]; };
  const auto offered = [this, &choice] { return this->Bench.Data.Offers(choice); };
  const QString label = tr(choice.Label);
  const QString help = tr("%1 (%2)").arg(tr(choice.Help)).arg(choice.Key);
  QWidget* widget = nullptr;
  if (choice.Values[0] == std::string("off"))
  {
    auto* check = new QCheckBox(label);
    QObject::connect(check, &QCheckBox::clicked, [=] { this->Bench.Turn(what, 1); });
    this->OnChange([=] { check->setChecked(value() != 0); });
    this->Add(widget = check, help, "", offered);
  }
  else
  {
    auto* combo = new QComboBox;
    for (const char* text : choice.Values)
    {
      combo->addItem(tr(text));
    }
    QObject::connect(combo, QOverload<int>::of(&QComboBox::activated),
      [=](int index) { this->Bench.Turn(what, index - value()); });
    this->OnChange([=] { combo->setCurrentIndex(value()); });
    this->Add(widget = combo, help, label, offered);
  }
  widget->setObjectName(choice.Name);
}

void Form::AddSlider(const QString& label, const QString& help, double most, const Get& get,
  const Set& set, const Test& isUseful)
{
  auto* slider = new QSlider(Qt::Horizontal);
  slider->setObjectName(label.toLower());
  slider->setRange(0, SliderSteps);
  slider->setPageStep(SliderSteps / 10);
  slider->setSingleStep(SliderSteps / 100);
  QObject::connect(slider, &QSlider::sliderPressed,
    [this]
    {
      this->Bench.BeginGesture();
      this->Bench.SetDragging(true);
    });
  QObject::connect(slider, &QSlider::sliderReleased, [this] { this->Bench.SetDragging(false); });
  QObject::connect(slider, &QSlider::valueChanged,
    [=](int value)
    { this->Bench.Edit(label, [&](Look& look) { set(look, most * value / SliderSteps); }); });
  this->OnChange(
    [=]
    {
      const QSignalBlocker blocker(slider);
      const double share = get(this->Bench.Data.Settings()) / most;
      slider->setValue(static_cast<int>(std::lround(share * SliderSteps)));
    });
  this->Add(slider, help, label, isUseful);
}

void Form::AddButtons(const QList<QAction*>& actions)
{
  auto* row = new QWidget;
  auto* layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  for (QAction* action : actions)
  {
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    layout->addWidget(button);
  }
  this->Add(row);
}

QAction* Form::NewAction(
  const QString& label, const QString& help, const std::function<void()>& act)
{
  auto* action = new QAction(label, this);
  action->setToolTip(help);
  QObject::connect(action, &QAction::triggered, act);
  return action;
}
