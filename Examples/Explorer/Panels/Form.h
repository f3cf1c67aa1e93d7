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
  explicit Form(Workbench& bench);

  void AddSetting(const Setting& setting);
  void AddSettings(const std::string& panel);
  QWidget* AddButtons(const QList<QAction*>& actions); // side by side
  // Over the whole width where there is no label.
  void Add(QWidget* widget, const QString& help = "", const QString& label = "");
  void ShowWhile(QWidget* widget, const std::function<bool()>& isOffered); // and its label
  void OnChange(const std::function<void()>& refresh); // soon after, and not too often

private:
  QWidget* NewWidget(const Setting& setting);
  QWidget* NewSlider(const Setting& number);

  Workbench& Bench;
  QFormLayout* Rows;
};

// What panels share.
QAction* NewAction(
  QObject* owner, const char* label, const char* help, const std::function<void()>& act);
QColor ToQColor(const Rgb& rgb);
QString Short(double number); // with as many digits as tell values apart

#endif
