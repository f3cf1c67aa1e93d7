// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/MainWindow.h"

#include "Panels/Panels.h"
#include "Window/ClipHandles.h"
#include "Window/Dialogs.h"

#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkObjectFactory.h>

#include <QVTKInteractor.h>
#include <QVTKOpenGLNativeWidget.h>

#include <QApplication>
#include <QDockWidget>
#include <QFileInfo>
#include <QLabel>
#include <QMenuBar>
#include <QProgressBar>
#include <QScrollArea>
#include <QSettings>
#include <QStatusBar>
#include <QStyle>
#include <QTimer>
#include <QToolButton>

namespace
{

constexpr int ProgressAfter = 250; // ms: what is over sooner needs no bar

// None of VTK's own keys.
class Style : public vtkInteractorStyleTrackballCamera
{
public:
  static Style* New();
  void OnChar() override {}
  // Whoever presses again soon wants to drag again.
  void OnLeftButtonDoubleClick() override { this->OnLeftButtonDown(); }
  void OnRightButtonDoubleClick() override { this->OnRightButtonDown(); }
};

vtkStandardNewMacro(Style);

}

MainWindow::MainWindow(Workbench& bench)
  : Bench(bench)
  , Picture(new QVTKOpenGLNativeWidget)
  , Samples(new HistogramPanel(bench))
  , Sentence(new QLabel)
  , Progress(new QProgressBar)
  , StopButton(nullptr)
{
  this->setWindowTitle("vtkTemporalCoherence Explorer");
  this->Picture->setObjectName("view");
  this->Picture->setAccessibleName(tr("View of the volume"));
  this->Window->SetMultiSamples(0); // the picture is ray cast; samples would only cost
  this->Picture->setRenderWindow(this->Window);
  vtkNew<Style> style;
  this->Picture->interactor()->SetInteractorStyle(style);
  this->setCentralWidget(this->Picture);
  this->Picture->installEventFilter(this);
  qApp->installEventFilter(this);
  bench.SetWindow(this->Window);
  new ClipHandles(bench, this->Picture->interactor(),
    std::max(1.0, this->logicalDpiX() * this->devicePixelRatioF() / 96.0));
  this->setAcceptDrops(true);
  this->MakeMenus();
  this->MakeDocks();

  this->Sentence->setObjectName("sentence");
  this->Sentence->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  auto* stop = new QToolButton;
  stop->setDefaultAction(this->Actions[Do::Stop]);
  this->StopButton = stop;
  this->statusBar()->addWidget(this->Sentence, 1);
  this->statusBar()->addPermanentWidget(this->Progress);
  this->statusBar()->addPermanentWidget(stop);
  QObject::connect(&bench, &Workbench::Said, this,
    [this](const QString& sentence, bool isWarning)
    {
      // Sentences run from left to right, whatever the name that they begin with.
      this->Sentence->setText(QChar(0x200e) + sentence);
      this->Sentence->setToolTip(sentence);
      QFont font = this->font();
      font.setBold(isWarning);
      this->Sentence->setFont(font);
    });
  QObject::connect(&bench, &Workbench::Progressed, this,
    [this](double share)
    {
      this->Progress->setRange(0, 100);
      this->Progress->setValue(static_cast<int>(100.0 * share));
    });
  QObject::connect(&bench, &Workbench::Settled, this, &MainWindow::ShowState);
  QObject::connect(&bench, &Workbench::Opened, this,
    [this]
    {
      const Volume& volume = this->Bench.Data.Data();
      this->setWindowTitle(QString::fromStdString(volume.Name) + " - Explorer");
      this->Time->setVisible(volume.TimeSteps > 1);
      const std::string& path = this->Bench.Data.State().Source.Path;
      if (!path.empty() && !this->Bench.Data.State().Source.Raw)
      {
        this->AddRecent(QFile::decodeName(path.c_str()));
      }
      this->ShowState();
    });
  this->ShowState();
  this->Picture->setFocus();
}

void MainWindow::MakeMenus()
{
  std::map<QString, QMenu*> menus;
  for (const Action& action : AllActions())
  {
    QMenu*& menu = menus[action.Menu];
    if (!menu)
    {
      menu = this->menuBar()->addMenu(tr(action.Menu));
    }
    const Do what = action.What;
    QAction* item = menu->addAction(tr(action.Name), this,
      [this, what]
      {
        this->Perform(what);
        this->ShowState(); // at once, as the next key may need it
      });
    item->setShortcuts(QKeySequence::listFromString(action.Keys));
    item->setToolTip(tr(action.Help));
    item->setStatusTip(tr(action.Help));
    this->Actions[what] = item;
    if (what == Do::OpenFolder)
    {
      QMenu* recent = menu->addMenu(tr("Open &Recent"));
      QObject::connect(recent, &QMenu::aboutToShow, this, [=] { this->ShowRecent(recent); });
    }
  }
  QMenu* view = this->ViewMenu = menus["&View"];
  view->addSeparator();
  for (const char* from : { "+x", "-x", "+y", "-y", "+z", "-z" })
  {
    view->addAction(tr("From %1").arg(from),
      [this, from]
      {
        this->Bench.Data.LookFrom(from);
        this->Bench.RenderSoon();
      });
  }
  view->addSeparator();
  auto* settings = new QMenu(tr("&Settings"), this);
  this->menuBar()->insertMenu(menus["&View"]->menuAction(), settings);
  for (const Choice& choice : AllChoices())
  {
    // The next value, by the key alone; with Shift, the one before.
    for (const int turn : { 1, -1 })
    {
      const QString key = QString(turn > 0 ? "%1" : "Shift+%1").arg(QChar(choice.Key).toUpper());
      auto* item = new QAction(tr(choice.Label), this);
      item->setShortcut(QKeySequence(key));
      item->setToolTip(tr(choice.Help));
      item->setStatusTip(tr(choice.Help));
      QObject::connect(item, &QAction::triggered, this,
        [this, &choice, turn]
        {
          if (this->Bench.Data.IsOpen() && this->Bench.Data.Offers(choice))
          {
            this->Bench.Turn(choice.What, turn);
          }
        });
      this->addAction(item);
      if (turn > 0)
      {
        settings->addAction(item);
      }
    }
  }
}

QDockWidget* MainWindow::AddDock(
  Qt::DockWidgetArea area, const QString& name, QWidget* panel, bool isWhole)
{
  auto* dock = new QDockWidget(name);
  dock->setObjectName(name);
  this->addDockWidget(area, dock);
  if (isWhole)
  {
    dock->setWidget(panel);
    return dock;
  }
  // Whatever the size of the font, all can be reached.
  auto* scroll = new QScrollArea;
  scroll->setWidget(panel);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setMinimumWidth(
    panel->minimumSizeHint().width() + this->style()->pixelMetric(QStyle::PM_ScrollBarExtent));
  dock->setWidget(scroll);
  return dock;
}

void MainWindow::MakeDocks()
{
  this->setDockNestingEnabled(true);
  this->setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  this->setTabPosition(Qt::RightDockWidgetArea, QTabWidget::North);
  QDockWidget* surfaces = this->AddDock(Qt::RightDockWidgetArea, tr("Surfaces"),
    MakeSurfacesPanel(
      this->Bench, { this->Actions[Do::AddSurface], this->Actions[Do::RemoveSurface] }),
    true);
  QDockWidget* clipping =
    this->AddDock(Qt::RightDockWidgetArea, tr("Clip"), MakeClippingPanel(this->Bench));
  QDockWidget* light =
    this->AddDock(Qt::RightDockWidgetArea, tr("Light"), MakeLightPanel(this->Bench));
  QDockWidget* reuse =
    this->AddDock(Qt::RightDockWidgetArea, tr("Re-use"), MakeReusePanel(this->Bench));
  QDockWidget* data =
    this->AddDock(Qt::RightDockWidgetArea, tr("Data"), MakeDataPanel(this->Bench));
  this->tabifyDockWidget(clipping, light);
  this->tabifyDockWidget(light, reuse);
  this->tabifyDockWidget(reuse, data);
  clipping->raise();
  QDockWidget* histogram =
    this->AddDock(Qt::BottomDockWidgetArea, tr("Histogram"), this->Samples, true);
  this->Time =
    this->AddDock(Qt::BottomDockWidgetArea, tr("Time"), MakeTimePanel(this->Bench), true);
  this->splitDockWidget(histogram, this->Time, Qt::Vertical);
  this->Time->hide();
  this->Keys = this->AddDock(Qt::LeftDockWidgetArea, tr("Keys"), MakeKeysPanel());
  this->Keys->hide();
  for (QDockWidget* dock : { surfaces, clipping, light, reuse, data, histogram, this->Time })
  {
    this->ViewMenu->addAction(dock->toggleViewAction());
  }
  // Scripts begin with the same window each time.
  if (!this->Bench.Chosen.Log.empty() ||
    !this->restoreState(QSettings().value("window").toByteArray()))
  {
    // Once there is a layout: the table of surfaces begins small.
    QTimer::singleShot(0, this,
      [=] {
        this->resizeDocks({ surfaces, clipping }, { 1, 10000 }, Qt::Vertical);
      });
  }
}

void MainWindow::ShowState()
{
  const bool isOpen = this->Bench.Data.IsOpen();
  const bool isBusy = this->Bench.IsBusy();
  const bool isBuilding = this->Bench.IsBuilding();
  for (const Do what :
    { Do::SaveSession, Do::SaveSessionAs, Do::Picture, Do::PictureAs, Do::Record, Do::Film,
      Do::AddSurface, Do::Clip, Do::Crop, Do::ResetView, Do::UpsideDown, Do::BuildIsomap })
  {
    this->Actions[what]->setEnabled(isOpen && !isBuilding);
  }
  const bool hasSteps = isOpen && this->Bench.Data.Data().TimeSteps > 1;
  this->Actions[Do::Play]->setEnabled(hasSteps);
  this->Actions[Do::RemoveSurface]->setEnabled(
    isOpen && this->Bench.Data.Settings().Surfaces.size() > 1);
  this->Actions[Do::Undo]->setEnabled(this->Bench.Changes.canUndo());
  this->Actions[Do::Redo]->setEnabled(this->Bench.Changes.canRedo());
  this->Actions[Do::Undo]->setText(tr("&Undo %1").arg(this->Bench.Changes.undoText()));
  this->Actions[Do::Redo]->setText(tr("&Redo %1").arg(this->Bench.Changes.redoText()));
  this->Actions[Do::Record]->setText(
    this->Bench.Output.IsRecording() ? tr("&End Recording") : tr("&Record"));
  if (isBusy && !this->StopButton->isVisible())
  {
    this->Progress->setRange(0, 0);
    QTimer::singleShot(ProgressAfter, this,
      [this]
      {
        const bool isBusy = this->Bench.IsBusy();
        this->Progress->setVisible(isBusy);
        this->StopButton->setVisible(isBusy);
        if (isBusy)
        {
          this->Sentence->setText(QString::fromStdString(this->Bench.Doing()));
        }
      });
  }
  if (!isBusy)
  {
    this->Progress->hide();
    this->StopButton->hide();
  }
}
