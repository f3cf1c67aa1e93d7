// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/Dialogs.h"

#include "Work/Actions.h"
#include "Work/Workbench.h"

#include <vtkCamera.h>

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFile>
#include <QFileDialog>
#include <QFormLayout>
#include <QImage>
#include <QLabel>
#include <QPixmap>
#include <QProgressDialog>
#include <QSpinBox>
#include <QWidget>

#include <algorithm>

namespace
{

constexpr int MostPixels = 16384;

QSpinBox* AddNumber(QFormLayout* rows, const QString& name, int value, int most)
{
  auto* box = new QSpinBox;
  box->setRange(1, most);
  box->setValue(value);
  rows->addRow(name, box);
  return box;
}

bool Ask(QDialog& dialog, QFormLayout* rows)
{
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  QObject::connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  rows->addRow(buttons);
  return dialog.exec() == QDialog::Accepted;
}

enum Motion
{
  Turn,
  Sweep, // of the selected isovalue
};

// One frame after another; between them the window answers.
void MakeFilm(QWidget* over, Workbench& bench, Motion motion, int frames, int width, int height)
{
  QProgressDialog progress(QObject::tr("Making a film"), QObject::tr("Stop"), 0, frames, over);
  progress.setWindowModality(Qt::WindowModal);
  Recorder recorder(bench.Chosen.OutputDirectory);
  recorder.Start(bench.Data.Settings().Choices.TextOf(Choose::Film));
  const Look before = bench.Data.Settings();
  const CameraState camera = bench.Data.View.Camera();
  const auto& range = bench.Data.Counted().Range;
  for (int frame = 0; frame < frames && !progress.wasCanceled(); ++frame)
  {
    if (motion == Sweep)
    {
      Look look = before;
      look.Surfaces[bench.Selected()].Isovalue =
        range[0] + (frame + 0.5) / frames * (range[1] - range[0]);
      bench.Data.SetSettings(look);
    }
    recorder.Add(bench.Data.View.Picture(width, height));
    if (motion == Turn)
    {
      bench.Data.View.Renderer->GetActiveCamera()->Azimuth(360.0 / frames);
    }
    progress.setValue(frame + 1);
  }
  bench.Data.View.SetCamera(camera);
  bench.Data.SetSettings(before);
  bench.RenderSoon();
  bench.Say(recorder.Stop());
}

}

QWidget* MakeKeysPanel()
{
  QString text = "<table>";
  const auto add = [&text](const QString& keys, const QString& help)
  {
    text += QString("<tr><td><b>%1</b>&nbsp;&nbsp;</td><td>%2</td></tr>")
              .arg(keys.toHtmlEscaped(), help.toHtmlEscaped());
  };
  for (const Gesture& gesture : AllGestures())
  {
    add(QObject::tr(gesture.Keys), QObject::tr(gesture.Help));
  }
  for (const Action& action : AllActions())
  {
    add(action.Keys, QObject::tr(action.Help));
  }
  for (const Choice& choice : AllChoices())
  {
    add(QString(QChar(choice.Key).toUpper()), QObject::tr(choice.Help));
  }
  auto* label = new QLabel(text + "</table>");
  label->setTextFormat(Qt::RichText);
  label->setAlignment(Qt::AlignTop);
  label->setWordWrap(true);
  label->setMargin(label->fontMetrics().height() / 2);
  return label;
}

void AskPicture(QWidget* over, Workbench& bench)
{
  QDialog dialog(over);
  dialog.setWindowTitle(QObject::tr("Save a picture"));
  auto* rows = new QFormLayout(&dialog);
  const int* size = bench.Data.View.Renderer->GetSize();
  QSpinBox* width = AddNumber(rows, QObject::tr("Width"), size[0], MostPixels);
  QSpinBox* height = AddNumber(rows, QObject::tr("Height"), size[1], MostPixels);
  if (!Ask(dialog, rows))
  {
    return;
  }
  const QString path = QFileDialog::getSaveFileName(
    over, QObject::tr("Save the picture"), "explorer.png", QObject::tr("Pictures (*.png)"));
  if (!path.isEmpty())
  {
    bench.SavePicture(QFile::encodeName(path).toStdString(), width->value(), height->value());
  }
}

void AskFilm(QWidget* over, Workbench& bench)
{
  QDialog dialog(over);
  dialog.setWindowTitle(QObject::tr("Make a film"));
  auto* rows = new QFormLayout(&dialog);
  auto* motion = new QComboBox;
  motion->addItems({ QObject::tr("turn around the volume"), QObject::tr("sweep the isovalue") });
  rows->addRow(QObject::tr("Motion"), motion);
  const int* size = bench.Data.View.Renderer->GetSize();
  QSpinBox* frames = AddNumber(rows, QObject::tr("Frames"), 120, 10000);
  QSpinBox* width = AddNumber(rows, QObject::tr("Width"), size[0], MostPixels);
  QSpinBox* height = AddNumber(rows, QObject::tr("Height"), size[1], MostPixels);
  if (Ask(dialog, rows))
  {
    bench.Try(
      [&]
      {
        MakeFilm(over, bench, static_cast<Motion>(motion->currentIndex()), frames->value(),
          width->value(), height->value());
      });
  }
}

vtkSmartPointer<vtkImageData> PictureOf(QWidget* window)
{
  const QImage image = window->grab().toImage().convertToFormat(QImage::Format_RGB888);
  auto picture = vtkSmartPointer<vtkImageData>::New();
  picture->SetDimensions(image.width(), image.height(), 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < image.height(); ++y)
  {
    const uchar* row = image.constScanLine(image.height() - 1 - y);
    std::copy_n(
      row, 3 * image.width(), static_cast<unsigned char*>(picture->GetScalarPointer(0, y, 0)));
  }
  return picture;
}
