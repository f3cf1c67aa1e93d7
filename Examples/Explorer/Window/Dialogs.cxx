// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/Commands.h"

#include "Program/CommandLine.h"
#include "Program/Quoted.h"
#include "Program/UserError.h"
#include "Work/Workbench.h"

#include <QColorDialog>
#include <QComboBox>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QPixmap>
#include <QPushButton>
#include <QSpinBox>

#include <vtkDataArray.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace
{

constexpr int MostPixels = 16384;

QString Directory(const Workbench& bench)
{
  return QFileInfo(QFile::decodeName(bench.Data.State().Source.Path.c_str())).absolutePath();
}

// How large a picture is to be, and what else is asked for.
class SizeDialog : public QDialog
{
public:
  SizeDialog(QWidget& over, Workbench& bench, const QString& title)
    : QDialog(&over)
    , Rows(new QFormLayout(this))
  {
    const int* size = bench.Data.View.Renderer->GetSize();
    this->setWindowTitle(title);
    this->Width = this->AddNumber(tr("Width"), size[0], MostPixels);
    this->Height = this->AddNumber(tr("Height"), size[1], MostPixels);
  }

  QSpinBox* AddNumber(const QString& name, int value, int most)
  {
    auto* box = new QSpinBox;
    box->setRange(1, most);
    box->setValue(value);
    this->Rows->addRow(name, box);
    return box;
  }

  bool Ask()
  {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    QObject::connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    QObject::connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    this->Rows->addRow(buttons);
    return this->exec() == QDialog::Accepted;
  }

  QFormLayout* Rows;
  QSpinBox* Width;
  QSpinBox* Height;
};

}

void AskOpen(QMainWindow& window, Workbench& bench)
{
  bench.OpenPath(QFileDialog::getOpenFileName(
    &window, QObject::tr("Open a volume or a session"), Directory(bench)));
}

void AskOpenFolder(QMainWindow& window, Workbench& bench)
{
  bench.OpenPath(QFileDialog::getExistingDirectory(&window,
    QObject::tr("Open a folder of DICOM files, of pictures, or of OME-Zarr"), Directory(bench)));
}

void AskLabelNames(QMainWindow& window, Workbench& bench)
{
  const QString name = QFileDialog::getOpenFileName(&window, QObject::tr("Names of labels"),
    Directory(bench), QObject::tr("Names of labels (*.txt *.label *.ctbl *.json);;All files (*)"));
  if (!name.isEmpty())
  {
    bench.EditOnce(QObject::tr("labels"),
      [&](Look& look) { Model::NameLabels(look, QFile::encodeName(name).toStdString()); });
  }
}

void AskSaveSession(QMainWindow& window, Workbench& bench)
{
  const QString path = QFileDialog::getSaveFileName(&window, QObject::tr("Save the session"),
    "explorer.session", QObject::tr("Sessions (*.session)"));
  if (!path.isEmpty())
  {
    const QString suffix = path.endsWith(".session") ? "" : ".session";
    bench.SaveSession(QFile::encodeName(path + suffix).toStdString());
  }
}

void AskColor(QMainWindow& window, Workbench& bench)
{
  const Rgb now = bench.Data.View.ColorOf(bench.Markers()[bench.Selected()]);
  const QColor color = QColorDialog::getColor(QColor::fromRgbF(now[0], now[1], now[2]), &window);
  if (color.isValid())
  {
    bench.BeginGesture();
    bench.EditMarker(QObject::tr("colour"),
      [&](Marker& marker) {
        marker.Color = { color.redF(), color.greenF(), color.blueF() };
      });
  }
}

void AskPicture(QMainWindow& window, Workbench& bench)
{
  SizeDialog dialog(window, bench, QObject::tr("Save a picture"));
  const QString path = !dialog.Ask()
    ? QString()
    : QFileDialog::getSaveFileName(
        &window, QObject::tr("Save the picture"), "explorer.png", QObject::tr("Pictures (*.png)"));
  if (!path.isEmpty())
  {
    bench.SavePicture(
      QFile::encodeName(path).toStdString(), dialog.Width->value(), dialog.Height->value());
  }
}

void AskTriangles(QMainWindow& window, Workbench& bench)
{
  const QString path = QFileDialog::getSaveFileName(&window, QObject::tr("Export triangles"),
    "surface.stl", QObject::tr("Triangles (*.stl *.ply *.vtp)"));
  if (!path.isEmpty())
  {
    bench.ExportTriangles(QFile::encodeName(path).toStdString());
  }
}

void AskSharing(QMainWindow& window, Workbench& bench)
{
  SizeDialog dialog(window, bench, QObject::tr("Share as a web page"));
  std::array<QLineEdit*, 4> texts;
  const std::array<QString, 4> names = { QObject::tr("Title"), QObject::tr("Caption"),
    QObject::tr("Citation"), QObject::tr("Units of values") };
  for (std::size_t i = 0; i < texts.size(); ++i)
  {
    texts[i] = new QLineEdit;
    dialog.Rows->addRow(names[i], texts[i]);
  }
  texts[0]->setText(QString::fromStdString(bench.Data.Data().Name));
  const QSpinBox* views = dialog.AddNumber(QObject::tr("Views around the volume"), 1, 64);
  const QString path = !dialog.Ask()
    ? QString()
    : QFileDialog::getSaveFileName(&window, QObject::tr("Share this view"), "view.html",
        QObject::tr("Web pages (*.html);;View files (*.tcview);;Cinema databases (*.cdb)"));
  if (!path.isEmpty())
  {
    SharedView wanted;
    const QString suffix = QFileInfo(path).suffix().isEmpty() ? ".html" : "";
    wanted.Path = QFile::encodeName(path + suffix).toStdString();
    wanted.Title = texts[0]->text().toStdString();
    wanted.Caption = texts[1]->text().toStdString();
    wanted.Citation = texts[2]->text().toStdString();
    wanted.Units = texts[3]->text().toStdString();
    wanted.Width = dialog.Width->value();
    wanted.Height = dialog.Height->value();
    wanted.Views = views->value();
    bench.Share(wanted);
  }
}

void AskFilm(QMainWindow& window, Workbench& bench)
{
  SizeDialog dialog(window, bench, QObject::tr("Make a film"));
  auto* motion = new QComboBox;
  motion->addItem(QObject::tr("turn around the volume"));
  if (!bench.Data.Projects())
  {
    motion->addItem(QObject::tr("sweep the isovalue"));
  }
  dialog.Rows->addRow(QObject::tr("Motion"), motion);
  const QSpinBox* frames = dialog.AddNumber(QObject::tr("Frames"), 120, 10000);
  const QSpinBox* rate = dialog.AddNumber(QObject::tr("Frames a second"), 25, 240);
  auto* format = new QComboBox;
  const Setting& film = AllSettings()[Row::Film];
  for (const char* word : film.Words)
  {
    format->addItem(word);
  }
  format->setCurrentIndex(bench.Data.Settings().Choice(Row::Film));
  dialog.Rows->addRow(QObject::tr("Format"), format);
  if (dialog.Ask())
  {
    Workbench::FilmOptions options;
    options.Motion = static_cast<FilmMotion>(motion->currentIndex());
    options.Frames = frames->value();
    options.Rate = rate->value();
    options.Format = format->currentText().toStdString();
    options.Width = dialog.Width->value();
    options.Height = dialog.Height->value();
    bench.MakeFilm(options);
  }
}

// It can be opened once the layout has as many bytes as the file.
std::optional<RawLayout> AskRaw(QWidget& window, const QString& path)
{
  const qint64 bytes = QFileInfo(path).size();
  QDialog dialog(&window);
  dialog.setWindowTitle(
    QObject::tr("How do the samples of %1 lie?").arg(QFileInfo(path).fileName()));
  auto* rows = new QFormLayout(&dialog);
  std::array<QSpinBox*, 3> counts;
  std::array<QDoubleSpinBox*, 3> distances;
  const int side = std::max(1, static_cast<int>(std::lround(std::cbrt(bytes))));
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    counts[axis] = new QSpinBox;
    counts[axis]->setRange(1, 1 << 20);
    counts[axis]->setValue(side);
    rows->addRow(QObject::tr("Samples in %1").arg("xyz"[axis]), counts[axis]);
  }
  auto* type = new QComboBox;
  for (const auto& [name, number] : ScalarTypes())
  {
    type->addItem(QString::fromStdString(name), number);
  }
  type->setCurrentText("uchar");
  rows->addRow(QObject::tr("Type"), type);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    distances[axis] = new QDoubleSpinBox;
    distances[axis]->setDecimals(6);
    distances[axis]->setRange(1e-6, 1e6);
    distances[axis]->setValue(1.0);
    rows->addRow(QObject::tr("Distance in %1").arg("xyz"[axis]), distances[axis]);
  }
  auto* sizes = new QLabel;
  rows->addRow(sizes);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel);
  rows->addRow(buttons);
  QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  const auto compare = [&]
  {
    double needed = vtkDataArray::GetDataTypeSize(type->currentData().toInt());
    for (const QSpinBox* count : counts)
    {
      needed *= count->value();
    }
    sizes->setText(
      QObject::tr("The file has %1 bytes, these samples %2.").arg(bytes).arg(needed, 0, 'f', 0));
    buttons->button(QDialogButtonBox::Open)->setEnabled(needed == static_cast<double>(bytes));
  };
  QObject::connect(type, &QComboBox::currentTextChanged, &dialog, compare);
  for (QSpinBox* count : counts)
  {
    QObject::connect(count, QOverload<int>::of(&QSpinBox::valueChanged), &dialog, compare);
  }
  compare();
  if (dialog.exec() != QDialog::Accepted)
  {
    return std::nullopt;
  }
  RawLayout layout;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    layout.Dimensions[axis] = counts[axis]->value();
    layout.Spacing[axis] = distances[axis]->value();
  }
  layout.ScalarType = type->currentData().toInt();
  return layout;
}

void SaveWindow(QWidget& window, const std::string& path)
{
  // Panels whose rows have changed are laid out soon: now.
  QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
  QFile file(QFile::decodeName(path.c_str()));
  if (!file.open(QFile::WriteOnly) || !window.grab().save(&file, "PNG"))
  {
    throw UserError("The picture " + Quoted(path) + " could not be written (" +
      file.errorString().toStdString() + "); name another file.");
  }
}
