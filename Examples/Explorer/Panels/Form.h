// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Form_h
#define Form_h

#include "Work/Workbench.h"

#include <QColor>
#include <QWidget>

class QAction;
class QFormLayout;

// A panel of rows: a label and what is set, kept up to date with the model.
class Form : public QWidget
{
public:
  using Get = std::function<double(const Look&)>;
  using Set = std::function<void(Look&, double)>;
  using Test = std::function<bool()>;

  explicit Form(Workbench& bench);

  void AddChoice(const Choice& choice);
  void AddChoices(Choice::Panel panel);
  void AddSlider(const QString& label, const QString& help, double most, const Get& get,
    const Set& set, const Test& isUseful = nullptr);
  void AddButtons(const QList<QAction*>& actions); // side by side
  QAction* NewAction(const QString& label, const QString& help, const std::function<void()>& act);
  // Over the whole width where there is no label. Seen while it is useful.
  void Add(QWidget* widget, const QString& help = "", const QString& label = "",
    const Test& isUseful = nullptr);
  void OnChange(const std::function<void()>& refresh); // soon after, and not too often

private:
  Workbench& Bench;
  QFormLayout* Rows;
};

// What panels share.
QColor ToQColor(const Rgb& rgb);
QString Short(double number); // with as many digits as tell values apart

#endif
