// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Panels/Form.h"
#include "Panels/Panels.h"

#include <QAction>
#include <QHeaderView>
#include <QTableWidget>

#include <cmath>

namespace
{

enum Column
{
  Value, // with a box for surfaces: visible
  Colour,
  Opacity,
};

// The same where it is selected.
QIcon IconOf(const QColor& color)
{
  QPixmap pixmap(32, 32);
  pixmap.fill(color);
  QIcon icon(pixmap);
  icon.addPixmap(pixmap, QIcon::Selected);
  return icon;
}

// A row for each surface, or for each node of the opacity.
class MarkerTable : public QTableWidget
{
public:
  MarkerTable(Workbench& bench, const QList<QAction*>& colors)
    : QTableWidget(0, 3)
    , Bench(bench)
  {
    this->setObjectName("surfaces");
    this->setAccessibleName(tr("Surfaces"));
    this->setToolTip(tr("A surface a row: tick it to see it, double click to change it"));
    this->verticalHeader()->hide();
    this->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    this->setSelectionBehavior(SelectRows);
    this->setSelectionMode(SingleSelection);
    this->setTabKeyNavigation(false);
    this->setContextMenuPolicy(Qt::ActionsContextMenu);
    this->addActions(colors);
    QObject::connect(
      this, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* item) { this->Take(item); });
    QObject::connect(this, &QTableWidget::currentCellChanged, this,
      [this](int row) { this->Bench.Select(static_cast<std::size_t>(std::max(row, 0))); });
  }

  void Refresh()
  {
    if (this->state() == EditingState)
    {
      return; // what is typed comes first
    }
    const QSignalBlocker blocker(this);
    this->setVisible(!this->Bench.Data.DrawsLabels());
    const bool areSurfaces = this->Bench.Data.DrawsSurfaces();
    this->setHorizontalHeaderLabels(
      { areSurfaces ? tr("Isovalue") : tr("Value"), tr("Colour"), tr("Opacity") });
    // Black and white are what they are, and an array gives one surface many colours.
    this->setColumnHidden(Colour, this->Bench.Data.Projects() || this->Bench.Data.ColorsByArray());
    this->setColumnHidden(Opacity, this->Bench.Data.Projects());
    this->setRowCount(static_cast<int>(this->Bench.Markers().size()));
    int row = 0;
    for (const Marker& marker : this->Bench.Markers())
    {
      const QColor color = ToQColor(this->Bench.Data.View.ColorOf(marker));
      auto* value = new QTableWidgetItem(Short(marker.Value));
      if (areSurfaces)
      {
        value->setCheckState(marker.IsVisible ? Qt::Checked : Qt::Unchecked);
      }
      this->setItem(row, Value, value);
      this->setItem(row, Colour,
        new QTableWidgetItem(IconOf(color), marker.Color ? color.name() : tr("palette")));
      this->setItem(
        row++, Opacity, new QTableWidgetItem(tr("%1 %").arg(std::lround(100.0 * marker.Opacity))));
    }
    this->setCurrentCell(
      static_cast<int>(this->Bench.Selected()), std::max(this->currentColumn(), 0));
  }

  QSize sizeHint() const override
  {
    constexpr int rows = 2; // those of more are scrolled to
    return { 18 * this->fontMetrics().height(),
      this->horizontalHeader()->sizeHint().height() +
        rows * this->verticalHeader()->defaultSectionSize() + 2 * this->frameWidth() };
  }
  QSize minimumSizeHint() const override { return this->sizeHint(); }

private:
  void Take(QTableWidgetItem* item)
  {
    bool isNumber = false;
    const double number = QString(item->text()).remove('%').trimmed().toDouble(&isNumber);
    this->Bench.Select(static_cast<std::size_t>(item->row()));
    this->Bench.BeginGesture();
    this->Bench.EditMarker(tr("marker"),
      [&](Marker& marker)
      {
        if (item->column() == Value)
        {
          // What is shown has fewer digits.
          const bool isNew = isNumber && item->text() != Short(marker.Value);
          marker.Value = isNew ? number : marker.Value;
          marker.IsVisible = !this->Bench.Data.DrawsSurfaces() || item->checkState() == Qt::Checked;
        }
        else if (item->column() == Opacity && isNumber)
        {
          marker.Opacity = 0.01 * number;
        }
      });
  }

  // Colours are changed as numbers are, whatever a single click does on this desktop.
  bool edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) override
  {
    if (index.column() != Colour)
    {
      return QTableWidget::edit(index, trigger, event);
    }
    if (trigger & (DoubleClicked | EditKeyPressed))
    {
      this->actions().front()->trigger();
    }
    return false;
  }

  Workbench& Bench;
};

}

// What the menu has for surfaces, where they are seen.
QWidget* MakeMarkersPanel(
  Workbench& bench, const QList<QAction*>& buttons, const QList<QAction*>& colors, QAction* names)
{
  auto* form = new Form(bench);
  auto* table = new MarkerTable(bench, colors);
  form->AddSetting(AllSettings()[Row::Drawing]);
  form->AddSetting(AllSettings()[Row::Preset]);
  form->AddSetting(AllSettings()[Row::Shift]);
  form->AddSetting(AllSettings()[Row::Window]);
  form->AddSetting(AllSettings()[Row::Level]);
  form->Add(table);
  form->OnChange([table] { table->Refresh(); });
  QWidget* row = form->AddButtons(buttons);
  form->OnChange([=, &bench] { row->setVisible(!bench.Data.DrawsLabels()); });
  AddLabels(*form, bench, names);
  form->AddSetting(AllSettings()[Row::Opacity]);
  form->AddSetting(AllSettings()[Row::Density]);
  form->AddSetting(AllSettings()[Row::Brightness]);
  form->AddSetting(AllSettings()[Row::Surface]);
  form->AddSetting(AllSettings()[Row::Palette]);
  AddArrayColors(*form, bench);
  return form;
}
