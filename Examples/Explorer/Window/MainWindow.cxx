// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/MainWindow.h"

#include "Panels/Form.h"
#include "Panels/Panels.h"
#include "Window/ClipHandles.h"
#include "Window/Commands.h"

#include <vtkInteractorStyleTrackballCamera.h>

#include <QVTKInteractor.h>
#include <QVTKOpenGLNativeWidget.h>

#include <QApplication>
#include <QDockWidget>
#include <QDropEvent>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMenuBar>
#include <QMimeData>
#include <QProgressBar>
#include <QScreen>
#include <QScrollArea>
#include <QSettings>
#include <QStatusBar>
#include <QStyle>
#include <QToolButton>

#include <algorithm>
#include <iterator>

namespace
{

constexpr int ProgressAfter = 250; // ms: what is over sooner needs no bar
constexpr int MostRecent = 10;
constexpr int MostViews = 50; // that are remembered
constexpr int NumbersOfView = 11;
constexpr double StepOfWheels = 120.0; // of a mouse's
constexpr int PointAfter = 40;         // ms: what the pointer rests on is told

QString PathOf(const VolumeSource& source)
{
  return QFileInfo(QFile::decodeName(source.Path.c_str())).absoluteFilePath();
}

// All keys, for those who do not know them yet.
QWidget* MakeKeysPanel()
{
  QString text = "<table>";
  for (const auto& [keys, help] : AllKeys())
  {
    text +=
      QString("<tr><td><b>%1</b>&nbsp;&nbsp;</td><td>%2</td></tr>")
        .arg(QObject::tr(keys.c_str()).toHtmlEscaped(), QObject::tr(help.c_str()).toHtmlEscaped());
  }
  auto* label = new QLabel(text + "</table>");
  label->setTextFormat(Qt::RichText);
  label->setAlignment(Qt::AlignTop);
  label->setWordWrap(true);
  label->setMargin(label->fontMetrics().height() / 2);
  return label;
}

}

MainWindow::MainWindow(Workbench& bench)
  : Bench(bench)
  , Picture(new QVTKOpenGLNativeWidget)
  , Samples(new HistogramPanel(bench))
  , Sentence(new QLabel)
  , UnderPointer(new QLabel)
  , Progress(new QProgressBar)
  , StopButton(new QToolButton)
{
  this->setWindowTitle("vtkTemporalCoherence Explorer");
  this->setAcceptDrops(true);
  this->MakeView();
  this->MakeMenus();
  this->MakeDocks();
  this->MakeStatusBar();
  bench.OnMissing = [this](const std::string& path)
  {
    const QString name = QFile::decodeName(path.c_str());
    const QString chosen = QFileDialog::getOpenFileName(this,
      tr("%1 is not there any more: where is it now?").arg(QFileInfo(name).fileName()),
      QFileInfo(name).absolutePath());
    return chosen.isEmpty() ? path : QFile::encodeName(chosen).toStdString();
  };
  bench.OnRaw = [this](const QString& path) { return AskRaw(*this, path); };
  QObject::connect(&bench, &Workbench::Settled, this, &MainWindow::ShowState);
  QObject::connect(&bench, &Workbench::Opened, this, &MainWindow::OnOpened);
  this->ShowState();
  this->Picture->setFocus();
}

void MainWindow::TakeUpLast()
{
  if (!this->restoreGeometry(QSettings().value("geometry").toByteArray()))
  {
    // The frame, which the window system draws, takes some room, too.
    const QRect screen = this->screen()->availableGeometry();
    const int frame = 3 * this->fontMetrics().height();
    this->resize(this->size().boundedTo(screen.size() - QSize(frame / 2, frame)));
    this->move(screen.center() - this->rect().center());
  }
  QObject::connect(&this->Bench, &Workbench::Leaving, this, &MainWindow::KeepView);
  QObject::connect(&this->Bench, &Workbench::Opened, this,
    [this](bool isOtherFile)
    {
      if (isOtherFile && !this->Bench.Data.State().HasCamera)
      {
        this->RecallView();
      }
    });
  this->RemembersViews = true;
}

// Under the path of the file, the last ones of all.
void MainWindow::KeepView()
{
  const VolumeSource& source = this->Bench.Data.State().Source;
  if (!this->RemembersViews || source.Path.empty())
  {
    return;
  }
  const CameraState camera = this->Bench.Data.View.Camera();
  QVariantList numbers = { camera.ViewAngle, camera.ParallelScale };
  for (const Point& point : { camera.Position, camera.FocalPoint, camera.ViewUp })
  {
    std::copy(point.begin(), point.end(), std::back_inserter(numbers));
  }
  QSettings settings;
  QVariantMap views = settings.value("views").toMap();
  QStringList order = settings.value("views of").toStringList();
  const QString path = PathOf(source);
  order.removeAll(path);
  order.prepend(path);
  views[path] = numbers;
  while (order.size() > MostViews)
  {
    views.remove(order.takeLast());
  }
  settings.setValue("views", views);
  settings.setValue("views of", order);
}

void MainWindow::RecallView()
{
  const QVariantList numbers =
    QSettings().value("views").toMap().value(PathOf(this->Bench.Data.State().Source)).toList();
  if (numbers.size() != NumbersOfView)
  {
    return;
  }
  CameraState camera;
  camera.ViewAngle = numbers[0].toDouble();
  camera.ParallelScale = numbers[1].toDouble();
  int next = 2;
  for (Point* point : { &camera.Position, &camera.FocalPoint, &camera.ViewUp })
  {
    for (double& number : *point)
    {
      number = numbers[next++].toDouble();
    }
  }
  if (IsUsable(camera))
  {
    this->Bench.Data.View.SetCamera(camera);
    this->Bench.RenderSoon();
  }
}

void MainWindow::MakeView()
{
  this->Picture->setObjectName("view");
  this->Picture->setAccessibleName(tr("View of the volume"));
  this->Window->SetMultiSamples(0); // the picture is ray cast; samples would only cost
  this->Picture->setRenderWindow(this->Window);
  this->Picture->setAcceptDrops(false);                 // the window does that
  this->Picture->setAttribute(Qt::WA_OpaquePaintEvent); // nothing behind it has to be drawn
  vtkNew<vtkInteractorStyleTrackballCamera> style;
  this->Picture->interactor()->SetInteractorStyle(style);
  this->setCentralWidget(this->Picture);
  this->Picture->installEventFilter(this);
  this->Bench.SetWindow(this->Window);
  new ClipHandles(this->Bench, this->Picture->interactor(),
    std::max(1.0, this->logicalDpiX() * this->devicePixelRatioF() / 96.0), this);
}

void MainWindow::MakeMenus()
{
  for (const Command& command : AllCommands())
  {
    QMenu*& menu = this->Menus[command.Menu];
    if (!menu)
    {
      // In the order of the list, with the settings before the view.
      if (command.Menu == std::string("&View"))
      {
        this->MakeSettingsMenu(this->menuBar()->addMenu(tr("&Settings")));
      }
      menu = this->menuBar()->addMenu(tr(command.Menu));
    }
    QAction* item = command.Needs == Command::Need::Undo
      ? this->Bench.Changes.createUndoAction(this, tr(command.Name))
      : command.Needs == Command::Need::Redo
      ? this->Bench.Changes.createRedoAction(this, tr(command.Name))
      : NewAction(this, command.Name, command.Help,
          [this, &command]
          {
            this->Bench.Try([&] { command.Do(*this, this->Bench); });
            this->ShowState(); // at once, as the next key may need it
          });
    menu->addAction(item);
    item->setToolTip(tr(command.Help));
    item->setStatusTip(tr(command.Help));
    // Qt 6 takes an empty list for one key that is unknown.
    if (*command.Keys)
    {
      item->setShortcuts(QKeySequence::listFromString(command.Keys));
    }
    this->Actions[QString(command.Name).remove('&')] = item;
  }
  QMenu* recent = new QMenu(tr("Open &Recent"), this);
  this->Menus["&File"]->insertMenu(this->Actions["Save Session"], recent);
  QObject::connect(recent, &QMenu::aboutToShow, this, [=] { this->ShowRecent(recent); });
  QMenu* view = this->Menus["&View"];
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
}

// A menu with ticks for each choice. The key takes the next value, with Shift the one before.
void MainWindow::MakeSettingsMenu(QMenu* menu)
{
  for (const Setting& choice : AllSettings())
  {
    if (!choice.Key)
    {
      continue;
    }
    for (const int turn : { 1, -1 })
    {
      QAction* item = NewAction(this, choice.Label, choice.Help,
        [this, &choice, turn]
        {
          if (this->Bench.Data.IsOpen() && this->Bench.Data.Offers(choice))
          {
            this->Bench.Turn(choice.Place(), turn);
          }
        });
      item->setShortcut(QKeySequence(QString(turn > 0 ? "%1" : "Shift+%1").arg(choice.Key)));
      this->addAction(item);
    }
    this->AddChoiceMenu(menu, choice);
  }
}

// As the key alone does, in a menu: words to choose from, or a tick.
void MainWindow::AddChoiceMenu(QMenu* menu, const Setting& choice)
{
  const bool isSwitch = choice.Words[0] == std::string("off");
  QMenu* words =
    isSwitch ? menu : menu->addMenu(tr("%1\t%2").arg(tr(choice.Label)).arg(choice.Key));
  std::vector<QAction*> items;
  for (std::size_t word = isSwitch ? 1 : 0; word < choice.Words.size(); ++word)
  {
    const QString text =
      isSwitch ? tr("%1\t%2").arg(tr(choice.Label)).arg(choice.Key) : tr(choice.Words[word]);
    QAction* item = words->addAction(text,
      [this, &choice, word, isSwitch]
      {
        const int now = this->Bench.Data.Settings().Choice(static_cast<Row::Which>(choice.Place()));
        this->Bench.Turn(choice.Place(), isSwitch ? 1 : static_cast<int>(word) - now);
      });
    item->setCheckable(true);
    item->setStatusTip(tr(choice.Help));
    items.push_back(item);
  }
  QObject::connect(menu, &QMenu::aboutToShow, this,
    [this, words, items, &choice, isSwitch]
    {
      const bool isOpen = this->Bench.Data.IsOpen();
      const double now = isOpen ? this->Bench.Data.Settings().Values[choice.Place()] : -1.0;
      for (std::size_t i = 0; i < items.size(); ++i)
      {
        items[i]->setChecked(now == static_cast<double>(i + (isSwitch ? 1 : 0)));
        items[i]->setEnabled(isOpen && this->Bench.Data.Offers(choice));
      }
      words->menuAction()->setEnabled(isOpen && (isSwitch || this->Bench.Data.Offers(choice)));
    });
}

QDockWidget* MainWindow::AddDock(
  Qt::DockWidgetArea area, const QString& name, QWidget* panel, bool isWhole)
{
  auto* dock = new QDockWidget(name);
  dock->setObjectName(name);
  dock->setWidget(panel);
  this->addDockWidget(area, dock);
  this->Menus["&View"]->addAction(dock->toggleViewAction());
  if (!isWhole)
  {
    // Whatever the size of the font, all can be reached.
    auto* scroll = new QScrollArea;
    scroll->setWidget(panel);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setMinimumWidth(
      panel->minimumSizeHint().width() + this->style()->pixelMetric(QStyle::PM_ScrollBarExtent));
    dock->setWidget(scroll);
  }
  return dock;
}

void MainWindow::MakeDocks()
{
  constexpr Qt::DockWidgetArea right = Qt::RightDockWidgetArea, bottom = Qt::BottomDockWidgetArea;
  this->setDockNestingEnabled(true);
  this->setCorner(Qt::BottomRightCorner, right);
  this->setTabPosition(right, QTabWidget::North);
  const QList<QAction*> buttons = { this->Actions["Add Surface"], this->Actions["Remove Surface"] };
  const QList<QAction*> colors = { this->Actions["Colour..."], this->Actions["Colour of Palette"] };
  this->Samples->addActions(buttons + colors);
  QWidget* markers =
    MakeMarkersPanel(this->Bench, buttons, colors, this->Actions["Label Names..."]);
  QDockWidget* surfaces = this->AddDock(right, tr("Surfaces"), markers, false);
  QDockWidget* clip = this->AddDock(right, tr("Clip"), MakeClippingPanel(this->Bench), false);
  QDockWidget* light = this->AddDock(right, tr("Light"), MakeLightPanel(this->Bench), false);
  QDockWidget* scene = this->AddDock(right, tr("Scene"), MakeScenePanel(this->Bench), false);
  QDockWidget* data = this->AddDock(right, tr("Data"), MakeDataPanel(this->Bench), false);
  QDockWidget* reuse = this->AddDock(right, tr("Re-use"), MakeReusePanel(this->Bench), false);
  this->tabifyDockWidget(clip, light);
  this->tabifyDockWidget(light, scene);
  this->tabifyDockWidget(scene, data);
  this->tabifyDockWidget(data, reuse);
  clip->raise();
  QDockWidget* histogram = this->AddDock(bottom, tr("Histogram"), this->Samples, true);
  this->Time = this->AddDock(bottom, tr("Time"), MakeTimePanel(this->Bench), true);
  this->splitDockWidget(histogram, this->Time, Qt::Vertical);
  this->Time->hide();
  this->AddDock(Qt::LeftDockWidgetArea, tr("Keys"), MakeKeysPanel(), false)->hide();
  if (!this->restoreState(QSettings().value("window").toByteArray()))
  {
    // Once there is a layout: all of the surfaces' panel is seen, if there is room for it.
    QTimer::singleShot(0, this,
      [=]
      {
        const int title = 2 * this->fontMetrics().height();
        const int height = std::min(markers->sizeHint().height() + title, this->height() - title);
        this->resizeDocks({ surfaces, clip }, { height, this->height() - height }, Qt::Vertical);
      });
  }
}

void MainWindow::MakeStatusBar()
{
  this->Sentence->setObjectName("sentence");
  this->Sentence->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  this->StopButton->setDefaultAction(this->Actions["Stop"]);
  this->statusBar()->addWidget(this->Sentence, 1);
  this->UnderPointer->setObjectName("under pointer");
  this->UnderPointer->setToolTip(tr("What the pointer is on: its value, and where it is"));
  this->statusBar()->addPermanentWidget(this->UnderPointer);
  this->Pointing.setSingleShot(true);
  this->Pointing.setInterval(PointAfter);
  QObject::connect(&this->Pointing, &QTimer::timeout, this, &MainWindow::ShowUnderPointer);
  this->Progress->setObjectName("progress");
  this->Progress->setToolTip(tr("How far the work, or the picture, is"));
  this->statusBar()->addPermanentWidget(this->Progress);
  this->statusBar()->addPermanentWidget(this->StopButton);
  QObject::connect(&this->Bench, &Workbench::Said, this,
    [this](const QString& sentence, bool isWarning)
    {
      // Sentences run from left to right, whatever the name that they begin with.
      this->Sentence->setText(QChar(0x200e) + sentence);
      this->Sentence->setToolTip(sentence);
      QFont font = this->font();
      font.setBold(isWarning);
      this->Sentence->setFont(font);
    });
  QObject::connect(&this->Bench, &Workbench::Refined, this,
    [this](double share)
    {
      this->Refined = share;
      if (!this->Bench.IsBusy())
      {
        this->ShowProgress();
      }
    });
  QObject::connect(&this->Bench, &Workbench::Progressed, this,
    [this](double share)
    {
      this->Progress->setRange(0, 100);
      this->Progress->setValue(static_cast<int>(100.0 * share));
    });
}

void MainWindow::ShowUnderPointer()
{
  if (!this->Bench.Data.IsOpen() || this->Bench.IsBuilding())
  {
    return;
  }
  const double pixels = this->Picture->devicePixelRatioF();
  const int height = this->Bench.Data.View.Renderer->GetSize()[1];
  const auto seen = this->Bench.Data.View.SeenAt(static_cast<int>(pixels * this->Pointer.x()),
    height - 1 - static_cast<int>(pixels * this->Pointer.y()));
  this->UnderPointer->setText(!seen
      ? ""
      : (seen->IsCut                         ? tr("%1 at %2, %3, %4")
            : this->Bench.Data.DrawsLabels() ? tr("Label %1 at %2, %3, %4")
                                             : tr("Surface %1 at %2, %3, %4"))
          .arg((Short(seen->Value) + ' ' + QString::fromStdString(seen->Label)).trimmed(),
            Short(seen->Place[0]), Short(seen->Place[1]), Short(seen->Place[2])));
}

void MainWindow::ShowRecent(QMenu* menu)
{
  menu->clear();
  for (const QString& path : QSettings().value("recent").toStringList())
  {
    // An ampersand would be a shortcut.
    QAction* item = menu->addAction(QFileInfo(path).fileName().replace('&', "&&"),
      [this, path] { this->Bench.Try([&] { this->Bench.OpenPath(path); }); });
    item->setToolTip(path);
    item->setStatusTip(path);
    item->setEnabled(QFileInfo::exists(path));
  }
}

void MainWindow::OnOpened()
{
  const Volume& volume = this->Bench.Data.Data();
  const VolumeSource& source = this->Bench.Data.State().Source;
  this->setWindowTitle(QString::fromStdString(volume.Name) + " - Explorer");
  this->Time->setVisible(volume.TimeSteps > 1);
  if (!source.Path.empty() && !source.Raw)
  {
    QSettings settings;
    QStringList recent = settings.value("recent").toStringList();
    const QString path = PathOf(source);
    recent.removeAll(path);
    recent.prepend(path);
    settings.setValue("recent", QStringList(recent.mid(0, MostRecent)));
  }
  this->ShowState();
}

void MainWindow::ShowState()
{
  const bool isOpen = this->Bench.Data.IsOpen();
  const bool mayChange = isOpen && !this->Bench.IsBuilding();
  for (const Command& command : AllCommands())
  {
    using Need = Command::Need;
    if (command.Do) // Qt does it for the others
    {
      this->Actions[QString(command.Name).remove('&')]->setEnabled(command.Needs == Need::Nothing ||
        (command.Needs == Need::Data && mayChange) ||
        (command.Needs == Need::Surfaces && mayChange && this->Bench.Data.HasIsovalues()) ||
        (command.Needs == Need::Labels && mayChange && this->Bench.Data.DrawsLabels()) ||
        (command.Needs == Need::Steps && isOpen && this->Bench.Data.Data().TimeSteps > 1) ||
        (command.Needs == Need::Addable && mayChange && this->Bench.Data.HasMarkers()) ||
        (command.Needs == Need::Removable && isOpen && this->Bench.Data.HasMarkers() &&
          this->Bench.CanRemove()));
    }
  }
  const bool areSurfaces = !isOpen || this->Bench.Data.DrawsSurfaces();
  this->Actions["Add Surface"]->setText(areSurfaces ? tr("&Add Surface") : tr("&Add Node"));
  this->Actions["Remove Surface"]->setText(
    areSurfaces ? tr("&Remove Surface") : tr("&Remove Node"));
  this->Actions["Record"]->setText(
    this->Bench.Output.IsRecording() ? tr("&End Recording") : tr("&Record"));
  if (!this->Bench.IsBusy())
  {
    this->ShowProgress();
  }
  else if (!this->StopButton->isVisible())
  {
    this->Progress->setRange(0, 0);
    QTimer::singleShot(ProgressAfter, this, &MainWindow::ShowProgress);
  }
}

void MainWindow::ShowProgress()
{
  const bool isBusy = this->Bench.IsBusy();
  const bool isRefining = !isBusy && this->Refined < 1.0;
  this->Progress->setVisible(isBusy || isRefining);
  this->StopButton->setVisible(isBusy);
  if (isBusy)
  {
    this->Sentence->setText(QString::fromStdString(this->Bench.Doing()));
  }
  else if (isRefining)
  {
    this->Progress->setRange(0, 100);
    this->Progress->setValue(static_cast<int>(100.0 * this->Refined));
  }
}

// The view's events, before VTK sees them: true for those that it is not to see.
bool MainWindow::eventFilter(QObject*, QEvent* event)
{
  switch (event->type())
  {
    case QEvent::KeyPress:
    {
      const int key = static_cast<QKeyEvent*>(event)->key();
      if (key == Qt::Key_Left || key == Qt::Key_Right || key == Qt::Key_Up || key == Qt::Key_Down)
      {
        QApplication::sendEvent(this->Samples, event);
      }
      return key != Qt::Key_Tab && key != Qt::Key_Backtab;
    }
    case QEvent::MouseButtonDblClick:
    {
      // Whoever presses again soon wants to drag again.
      const auto* mouse = static_cast<QMouseEvent*>(event);
      QMouseEvent press(QEvent::MouseButtonPress, mouse->localPos(), mouse->windowPos(),
        mouse->screenPos(), mouse->button(), mouse->buttons(), mouse->modifiers());
      QApplication::sendEvent(this->Picture, &press);
      return true;
    }
    case QEvent::Wheel:
      if (!this->Bench.IsBuilding() && this->Bench.Data.IsOpen())
      {
        this->Bench.Zoom(static_cast<QWheelEvent*>(event)->angleDelta().y() / StepOfWheels);
      }
      return true;
    case QEvent::MouseMove:
      this->Pointer = static_cast<QMouseEvent*>(event)->pos();
      static_cast<QMouseEvent*>(event)->buttons() ? this->Pointing.stop() : this->Pointing.start();
      [[fallthrough]];
    case QEvent::MouseButtonPress:
      // It is drawn no more than its picture is changed.
      return this->Bench.IsBuilding() || !this->Bench.Data.IsOpen();
    default:
      return false;
  }
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
  const QList<QUrl> urls = event->mimeData()->urls();
  event->setAccepted(!urls.isEmpty() && urls.front().isLocalFile());
}

void MainWindow::dropEvent(QDropEvent* event)
{
  event->acceptProposedAction();
  this->Bench.Try([&] { this->Bench.OpenPath(event->mimeData()->urls().front().toLocalFile()); });
}

void MainWindow::closeEvent(QCloseEvent* event)
{
  this->Bench.Cancel();
  if (this->Bench.Output.IsRecording())
  {
    this->Bench.ToggleRecording();
  }
  this->KeepView();
  QSettings().setValue("window", this->saveState());
  QSettings().setValue("geometry", this->saveGeometry());
  event->accept();
}
