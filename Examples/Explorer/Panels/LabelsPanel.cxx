// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// The labels of a segmentation: which are seen, and how they look.
#include "Panels/Form.h"
#include "Panels/Panels.h"

#include <QColorDialog>
#include <QHeaderView>
#include <QLineEdit>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{

constexpr int NameColumn = 0; // with a box: visible
constexpr int OpacityColumn = 1;

class LabelList : public QWidget
{
public:
  LabelList(Workbench& bench, QAction* names)
    : Bench(bench)
    , Search(new QLineEdit)
    , Table(new QTableWidget(0, 2))
  {
    this->Search->setObjectName("search labels");
    this->Search->setPlaceholderText(tr("Search labels"));
    this->Search->setClearButtonEnabled(true);
    this->Table->setObjectName("labels");
    this->Table->setAccessibleName(tr("Labels"));
    this->Table->setToolTip(
      tr("A label a row: tick it to see it, double click for another colour or opacity"));
    this->Table->verticalHeader()->hide();
    this->Table->setHorizontalHeaderLabels({ tr("Label"), tr("Opacity") });
    this->Table->horizontalHeader()->setSectionResizeMode(NameColumn, QHeaderView::Stretch);
    this->Table->setSelectionBehavior(QAbstractItemView::SelectRows);
    this->Table->setTabKeyNavigation(false);
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->addWidget(this->Search);
    rows->addWidget(this->Table);
    auto* buttons = new Form(bench);
    buttons->AddButtons({ this->NewButton("Show", "see the labels that are found", true),
      this->NewButton("Hide", "hide the labels that are found", false),
      NewAction(this, "Solo", "see the selected labels alone", [this] { this->ShowAlone(); }),
      names });
    rows->addWidget(buttons);
    QObject::connect(this->Search, &QLineEdit::textChanged, this, [this] { this->Find(); });
    QObject::connect(this->Table, &QTableWidget::itemChanged, this,
      [this](QTableWidgetItem* item) { this->Take(item); });
    QObject::connect(this->Table, &QTableWidget::cellDoubleClicked, this,
      [this](int row, int column)
      {
        if (column == NameColumn)
        {
          this->AskColor(static_cast<std::size_t>(row));
        }
      });
    this->hide();
  }

  void Refresh()
  {
    this->setVisible(this->Bench.Data.DrawsLabels());
    if (!this->Bench.Data.DrawsLabels())
    {
      return;
    }
    const std::vector<int>& present = this->Bench.Data.LabelsOfData();
    std::vector<LabelLook> labels;
    for (const LabelLook& label : this->Bench.Data.Settings().Labels)
    {
      if (std::binary_search(present.begin(), present.end(), label.Label))
      {
        labels.push_back(label);
      }
    }
    if (std::exchange(this->Shown, labels) == labels)
    {
      return;
    }
    const QSignalBlocker blocker(this->Table);
    this->Table->setRowCount(static_cast<int>(labels.size()));
    int row = 0;
    for (const LabelLook& label : labels)
    {
      QPixmap color(16, 16);
      color.fill(ToQColor(label.Color));
      QTableWidgetItem& name = this->ItemAt(row, NameColumn);
      name.setIcon(QIcon(color));
      name.setText(
        QString("%1 %2").arg(label.Label).arg(QString::fromStdString(label.Name)).trimmed());
      name.setFlags(name.flags() & ~Qt::ItemIsEditable);
      name.setCheckState(label.IsVisible ? Qt::Checked : Qt::Unchecked);
      this->ItemAt(row++, OpacityColumn)
        .setText(tr("%1 %").arg(std::lround(100.0 * label.Opacity)));
    }
    this->Find();
  }

private:
  QTableWidgetItem& ItemAt(int row, int column)
  {
    if (!this->Table->item(row, column))
    {
      this->Table->setItem(row, column, new QTableWidgetItem);
    }
    return *this->Table->item(row, column);
  }

  QAction* NewButton(const char* text, const char* help, bool isVisible)
  {
    return NewAction(this, text, help,
      [this, isVisible]
      {
        std::vector<LabelLook> labels = this->Shown;
        for (std::size_t i = 0; i < labels.size(); ++i)
        {
          const bool isFound = !this->Table->isRowHidden(static_cast<int>(i));
          labels[i].IsVisible = isFound ? isVisible : labels[i].IsVisible;
        }
        this->Edit(labels);
      });
  }

  void Edit(const std::vector<LabelLook>& labels)
  {
    if (labels == this->Shown)
    {
      return;
    }
    this->Bench.EditOnce(tr("labels"),
      [&](Look& look)
      {
        auto changed = labels.begin(); // both are in ascending order
        for (LabelLook& label : look.Labels)
        {
          if (changed != labels.end() && changed->Label == label.Label)
          {
            label = *changed++;
          }
        }
      });
    this->Refresh(); // at once, for what is pressed next
  }

  // The rows with all words of the search.
  void Find()
  {
    const QStringList words = this->Search->text().simplified().split(' ');
    for (int row = 0; row < this->Table->rowCount(); ++row)
    {
      const QString name = this->Table->item(row, NameColumn)->text();
      this->Table->setRowHidden(row,
        !std::all_of(words.begin(), words.end(),
          [&](const QString& word) { return name.contains(word, Qt::CaseInsensitive); }));
    }
  }

  // A second time, or without a selection, all are seen.
  void ShowAlone()
  {
    std::vector<LabelLook> labels = this->Shown;
    const QModelIndexList rows = this->Table->selectionModel()->selectedRows();
    for (LabelLook& label : labels)
    {
      label.IsVisible = rows.isEmpty();
    }
    for (const QModelIndex& row : rows)
    {
      labels[static_cast<std::size_t>(row.row())].IsVisible = true;
    }
    if (labels == this->Shown)
    {
      for (LabelLook& label : labels)
      {
        label.IsVisible = true;
      }
    }
    this->Edit(labels);
  }

  void Take(QTableWidgetItem* item)
  {
    std::vector<LabelLook> labels = this->Shown;
    LabelLook& label = labels[static_cast<std::size_t>(item->row())];
    bool isNumber = false;
    const double percent = QString(item->text()).remove('%').trimmed().toDouble(&isNumber);
    if (item->column() == NameColumn)
    {
      label.IsVisible = item->checkState() == Qt::Checked;
    }
    else if (isNumber && std::isfinite(percent))
    {
      label.Opacity = std::clamp(0.01 * percent, 0.0, 1.0);
    }
    this->Edit(labels);
    this->Shown.clear(); // the text may be another one than that of the label
    this->Refresh();
  }

  void AskColor(std::size_t asked)
  {
    const QColor color =
      QColorDialog::getColor(ToQColor(this->Shown[asked].Color), this, tr("Colour of the label"));
    if (color.isValid() && asked < this->Shown.size())
    {
      std::vector<LabelLook> labels = this->Shown;
      labels[asked].Color = { color.redF(), color.greenF(), color.blueF() };
      this->Edit(labels);
    }
  }

  Workbench& Bench;
  QLineEdit* Search;
  QTableWidget* Table;
  std::vector<LabelLook> Shown;
};

}

void AddLabels(Form& form, Workbench& bench, QAction* names)
{
  auto* list = new LabelList(bench, names);
  form.Add(list);
  form.OnChange([list] { list->Refresh(); });
  form.AddSettings("Labels");
}
