// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Panels/Form.h"
#include "Panels/Panels.h"

#include <vtkColorTransferFunction.h>

#include <QHBoxLayout>
#include <QHeaderView>
#include <QMenu>
#include <QTableWidget>
#include <QToolButton>

#include <cmath>

namespace
{

enum Column
{
  Isovalue, // with a box: visible
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

// A row for each surface.
class SurfaceTable : public QTableWidget
{
public:
  explicit SurfaceTable(Workbench& bench)
    : QTableWidget(0, 3)
    , Bench(bench)
  {
    this->setObjectName("surfaces");
    this->setAccessibleName(tr("Surfaces"));
    this->setHorizontalHeaderLabels({ tr("Isovalue"), tr("Colour"), tr("Opacity") });
    this->setToolTip(tr("A surface a row: tick it to see it, double click to change it"));
    this->verticalHeader()->hide();
    this->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    this->setSelectionBehavior(SelectRows);
    this->setSelectionMode(SingleSelection);
    this->setTabKeyNavigation(false);
    this->setContextMenuPolicy(Qt::ActionsContextMenu);
    auto* reset = new QAction(tr("Colour of the palette"), this);
    this->addAction(reset);
    QObject::connect(reset, &QAction::triggered, this, [this] { this->SetColor(std::nullopt); });
    QObject::connect(
      this, &QTableWidget::itemChanged, this, [this](QTableWidgetItem* item) { this->Take(item); });
    QObject::connect(this, &QTableWidget::currentCellChanged, this,
      [this](int row, int, int, int)
      {
        if (row >= 0)
        {
          this->Bench.Select(static_cast<std::size_t>(row));
        }
      });
  }

  void Refresh()
  {
    const QSignalBlocker blocker(this);
    const auto& surfaces = this->Bench.Data.Settings().Surfaces;
    this->setRowCount(static_cast<int>(surfaces.size()));
    this->updateGeometry();
    for (int row = 0; row < this->rowCount(); ++row)
    {
      const Surface& surface = surfaces[static_cast<std::size_t>(row)];
      Rgb rgb = surface.Color.value_or(Rgb{});
      if (!surface.Color)
      {
        this->Bench.Data.View.Colors()->GetColor(surface.Isovalue, rgb.data());
      }
      QTableWidgetItem* value = this->ItemAt(row, Isovalue);
      value->setText(Short(surface.Isovalue));
      value->setCheckState(surface.IsVisible ? Qt::Checked : Qt::Unchecked);
      QTableWidgetItem* color = this->ItemAt(row, Colour);
      color->setIcon(IconOf(ColorOf(rgb)));
      color->setData(Qt::UserRole, ColorOf(rgb));
      color->setText(surface.Color ? ColorOf(rgb).name() : tr("palette"));
      color->setFlags(color->flags() & ~Qt::ItemIsEditable);
      this->ItemAt(row, Opacity)
        ->setText(tr("%1 %").arg(static_cast<int>(std::lround(100.0 * surface.Opacity))));
    }
    this->setCurrentCell(
      static_cast<int>(this->Bench.Selected()), std::max(this->currentColumn(), 0));
  }

  QSize sizeHint() const override
  {
    const int rows = std::clamp(this->rowCount(), 2, 4);
    return { 18 * this->fontMetrics().height(),
      this->horizontalHeader()->sizeHint().height() +
        rows * this->verticalHeader()->defaultSectionSize() + 2 * this->frameWidth() };
  }
  QSize minimumSizeHint() const override { return this->sizeHint(); }

private:
  QTableWidgetItem* ItemAt(int row, int column)
  {
    if (!this->item(row, column))
    {
      this->setItem(row, column, new QTableWidgetItem);
    }
    return this->item(row, column);
  }

  void Change(const QString& name, const std::function<void(Surface&)>& change)
  {
    const auto row = static_cast<std::size_t>(std::max(this->currentRow(), 0));
    this->Bench.BeginGesture();
    this->Bench.Edit(name, [&](Look& look) { change(look.Surfaces.at(row)); });
  }

  void Take(QTableWidgetItem* item)
  {
    bool isNumber = false;
    const double number = QString(item->text()).remove('%').trimmed().toDouble(&isNumber);
    const auto row = static_cast<std::size_t>(item->row());
    const bool isVisible = item->checkState() == Qt::Checked;
    this->Bench.BeginGesture();
    this->Bench.Edit(tr("surface"),
      [&](Look& look)
      {
        Surface& surface = look.Surfaces[row];
        if (item->column() == Isovalue)
        {
          // What is shown has fewer digits.
          const bool isNew = isNumber && item->text() != Short(surface.Isovalue);
          surface.Isovalue = isNew ? number : surface.Isovalue;
          surface.IsVisible = isVisible;
        }
        else if (item->column() == Opacity && isNumber)
        {
          surface.Opacity = 0.01 * number;
        }
      });
  }

  // Colours are changed as numbers are, whatever a single click does on this desktop.
  bool edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) override
  {
    if (index.column() != Colour || !(trigger & (DoubleClicked | EditKeyPressed)))
    {
      return QTableWidget::edit(index, trigger, event);
    }
    const auto color = index.data(Qt::UserRole).value<QColor>();
    AskColor(this, color, [this](const Rgb& rgb) { this->SetColor(rgb); });
    return false;
  }

  void SetColor(const std::optional<Rgb>& color)
  {
    this->Change(tr("colour"), [&](Surface& surface) { surface.Color = color; });
  }

  Workbench& Bench;
};

}

// What the menu has for surfaces, where they are seen.
QWidget* MakeSurfacesPanel(Workbench& bench, const std::vector<QAction*>& actions)
{
  auto* panel = new QWidget;
  Form form(bench, panel);
  auto* table = new SurfaceTable(bench);
  auto* buttons = new QWidget;
  auto* row = new QHBoxLayout(buttons);
  row->setContentsMargins(0, 0, 0, 0);
  for (QAction* action : actions)
  {
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    row->addWidget(button);
  }
  form.AddChoice(ChoiceOf(Choose::Drawing));
  form.AddWidget(table);
  form.OnChange(table, [table] { table->Refresh(); });
  form.ShowIf(table, [&bench] { return bench.Data.DrawsSurfaces(); });
  form.AddWidget(buttons);
  form.ShowIf(buttons, [&bench] { return bench.Data.DrawsSurfaces(); });
  QSlider* opacity = form.AddSlider(
    QObject::tr("Opacity"), QObject::tr("of the selected surface: less is see-through"), 1.0,
    [&bench](const Look& look) { return look.Surfaces[bench.Selected()].Opacity; },
    [&bench](Look& look, double value) { look.Surfaces[bench.Selected()].Opacity = value; });
  opacity->setObjectName("opacity");
  QSlider* density = form.AddSlider(
    QObject::tr("Density"), QObject::tr("of the blended volume: how soon it is opaque"), 4.0,
    [](const Look& look) { return std::log10(look.Density) + 2.0; },
    [](Look& look, double value) { look.Density = std::pow(10.0, value - 2.0); });
  form.ShowIf(opacity, [&bench] { return bench.Data.DrawsSurfaces(); });
  form.ShowIf(density, [&bench] { return !bench.Data.DrawsSurfaces(); });
  form.AddChoice(ChoiceOf(Choose::Surface));
  form.AddChoice(ChoiceOf(Choose::Palette));
  return panel;
}
