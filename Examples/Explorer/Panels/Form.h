// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Form_h
#define Form_h

#include "Work/Workbench.h"

#include <QAbstractButton>
#include <QSlider>
#include <QString>

#include <functional>

class QFormLayout;

// Rows of a panel: a label and what is set, kept up to date with the model.
class Form
{
public:
  Form(Workbench& bench, QWidget* panel);

  void AddChoice(const Choice& choice);
  void AddChoices(Choice::Panel panel);
  QAbstractButton* AddSwitch(const QString& label, const QString& help,
    const std::function<bool(const Look&)>& get, const std::function<void(Look&, bool)>& set);
  QSlider* AddSlider(const QString& label, const QString& help, double most,
    const std::function<double(const Look&)>& get, const std::function<void(Look&, double)>& set);
  QWidget* AddButton(const QString& label, const QString& help, const std::function<void()>& act);
  void AddWidget(QWidget* widget); // over the whole width
  void OnChange(QWidget* widget, const std::function<void()>& refresh);
  void ShowIf(QWidget* widget, const std::function<bool()>& isUseful); // and its label

private:
  void AddRow(const QString& label, const QString& help, QWidget* widget);

  Workbench& Bench;
  QFormLayout* Rows;
};

#endif
