// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// Which other array of the data gives surfaces their colours.
#include "Panels/Form.h"
#include "Panels/Panels.h"

#include "Program/Quoted.h"

#include <QComboBox>
#include <QLayout>
#include <QSignalBlocker>

namespace
{

void ShowColorArrays(QComboBox* box, const Model& model)
{
  const QSignalBlocker blocker(box);
  box->clear();
  box->addItem(QObject::tr("none"), "");
  for (const ColorArrays::Item& item : model.View.Colors.Arrays().All())
  {
    box->addItem(
      QString::fromStdString(Printable(item.Choice.Name)), QByteArray(item.Choice.Name.c_str()));
  }
}

// Components of the array that is chosen, the length first.
void ShowColorComponents(QComboBox* box, const Model& model)
{
  const ArrayColor& color = model.Settings().ColorBy;
  const ColorArrays::Item* const array = model.View.Colors.Arrays().Find(color.Name);
  const int count = array ? array->Components : 1;
  if (box->count() != count + 1)
  {
    box->clear();
    for (int i = -1; i < count; ++i)
    {
      box->addItem(
        i < 0 ? QObject::tr("length of vectors") : QObject::tr("component %1").arg(i + 1), i);
    }
  }
  box->setCurrentIndex(color.Component + 1);
}

QComboBox* NewArrayBox(const char* name)
{
  auto* box = new QComboBox;
  box->setObjectName(name);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  return box;
}

void AddColorRows(Form& form, Workbench& bench)
{
  QComboBox* const arrays = NewArrayBox("color-by");
  QComboBox* const components = NewArrayBox("color-by-component");
  form.Add(
    arrays, QObject::tr("which array of the data colours surfaces"), QObject::tr("Colour by"));
  form.Add(components, QObject::tr("which component of that array"), QObject::tr("Component"));
  form.AddSetting(AllSettings()[Row::ColorMap]);
  const auto choose = [&bench](const ArrayColor& color)
  { bench.EditOnce(QObject::tr("colour by"), [&](Look& look) { look.ColorBy = color; }); };
  QObject::connect(arrays, QOverload<int>::of(&QComboBox::activated), &form,
    [=] {
      choose({ arrays->currentData().toByteArray().toStdString(), -1 });
    });
  QObject::connect(components, QOverload<int>::of(&QComboBox::activated), &form,
    [=, &bench] {
      choose({ bench.Data.Settings().ColorBy.Name, components->currentData().toInt() });
    });
  QObject::connect(
    &bench, &Workbench::Opened, &form, [=, &bench] { ShowColorArrays(arrays, bench.Data); });
  form.OnChange(
    [=, &bench]
    {
      const ColorArrays& all = bench.Data.View.Colors.Arrays();
      const ColorArrays::Item* const chosen = all.Find(bench.Data.Settings().ColorBy.Name);
      arrays->setCurrentIndex(chosen ? 1 + static_cast<int>(chosen - all.All().data()) : 0);
      ShowColorComponents(components, bench.Data);
    });
  form.ShowWhile(components,
    [&bench]
    {
      const ArrayColor& color = bench.Data.Settings().ColorBy;
      const ColorArrays::Item* const chosen = bench.Data.View.Colors.Arrays().Find(color.Name);
      return bench.Data.ColorsByArray() && chosen && chosen->Components > 1;
    });
}

}

// They take room from the first time on that data have another array.
void AddArrayColors(Form& form, Workbench& bench)
{
  auto* const rows = new Form(bench);
  rows->setParent(&form);
  rows->hide();
  rows->layout()->setContentsMargins(0, 0, 0, 0);
  AddColorRows(*rows, bench);
  form.OnChange(
    [=, &form, &bench]
    {
      if (bench.Data.CanColorByArray() && form.layout()->indexOf(rows) < 0)
      {
        form.Add(rows);
      }
      rows->setVisible(bench.Data.CanColorByArray());
    });
}
