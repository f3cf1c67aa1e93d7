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

void Form::Add(QWidget* widget, const QString& help, const QString& label)
{
  widget->setToolTip(help.isEmpty() ? widget->toolTip() : help);
  label.isEmpty() ? this->Rows->addRow(widget) : this->Rows->addRow(label, widget);
  if (QWidget* left = this->Rows->labelForField(widget))
  {
    left->setToolTip(help);
    widget->setAccessibleName(label);
  }
}

void Form::AddSettings(const std::string& panel)
{
  for (const Setting& setting : AllSettings())
  {
    if (setting.Panel == panel)
    {
      this->AddSetting(setting);
    }
  }
}

void Form::AddSetting(const Setting& setting)
{
  QWidget* widget = this->NewWidget(setting);
  const QString label = tr(setting.Label), help = tr(setting.Help);
  widget->setObjectName(setting.IsChoice() ? setting.Name : label.toLower());
  this->Add(widget, setting.Key ? tr("%1 (%2)").arg(help).arg(setting.Key) : help,
    qobject_cast<QCheckBox*>(widget) ? "" : label);
  this->ShowWhile(widget, [this, &setting] { return this->Bench.Data.Offers(setting); });
}

void Form::ShowWhile(QWidget* widget, const std::function<bool()>& isOffered)
{
  this->OnChange(
    [this, widget, isOffered]
    {
      const bool isSeen = isOffered();
      widget->setVisible(isSeen);
      if (QWidget* left = this->Rows->labelForField(widget))
      {
        left->setVisible(isSeen);
      }
    });
}

QWidget* Form::NewWidget(const Setting& setting)
{
  if (!setting.IsChoice())
  {
    return this->NewSlider(setting);
  }
  const std::size_t row = setting.Place();
  const auto value = [this, row]
  { return static_cast<int>(this->Bench.Data.Settings().Values[row]); };
  if (setting.Words[0] == std::string("off"))
  {
    auto* check = new QCheckBox(tr(setting.Label));
    QObject::connect(check, &QCheckBox::clicked, [=] { this->Bench.Turn(row, 1); });
    this->OnChange([=] { check->setChecked(value() != 0); });
    return check;
  }
  auto* box = new QComboBox;
  for (const char* text : setting.Words)
  {
    box->addItem(tr(text));
  }
  QObject::connect(box, QOverload<int>::of(&QComboBox::activated),
    [=](int index) { this->Bench.Turn(row, index - value()); });
  this->OnChange([=] { box->setCurrentIndex(value()); });
  return box;
}

QWidget* Form::NewSlider(const Setting& setting)
{
  auto* slider = new QSlider(Qt::Horizontal);
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
    [this, &setting](int value)
    { this->Bench.SetShare(setting, static_cast<double>(value) / SliderSteps); });
  this->OnChange(
    [this, slider, &setting]
    {
      const QSignalBlocker blocker(slider);
      slider->setValue(static_cast<int>(std::lround(this->Bench.ShareOf(setting) * SliderSteps)));
    });
  return slider;
}

QWidget* Form::AddButtons(const QList<QAction*>& actions)
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
  return row;
}

QAction* NewAction(
  QObject* owner, const char* label, const char* help, const std::function<void()>& act)
{
  auto* action = new QAction(QObject::tr(label), owner);
  action->setToolTip(QObject::tr(help));
  action->setStatusTip(QObject::tr(help));
  QObject::connect(action, &QAction::triggered, owner, act);
  return action;
}
