// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Panels/HistogramPanel.h"

#include "Panels/Panels.h"
#include "Work/Workbench.h"

#include <vtkColorTransferFunction.h>

#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace
{

constexpr int Reach = 8; // pixels from a marker that still grab it

QColor ColorAt(const Workbench& bench, double value)
{
  Rgb rgb;
  bench.Data.View.Colors()->GetColor(value, rgb.data());
  return ColorOf(rgb);
}

}

HistogramPanel::HistogramPanel(Workbench& bench)
  : Bench(bench)
{
  this->setObjectName("histogram");
  this->setAccessibleName(tr("Histogram with isovalues and opacity"));
  this->setToolTip(tr("Drag a marker: the isovalue of a surface, or a node of the opacity.\n"
                      "Double click: another node. Right click: its colour."));
  this->setFocusPolicy(Qt::StrongFocus);
  QObject::connect(&bench, &Workbench::Changed, this, [this] { this->update(); });
  QObject::connect(&bench, &Workbench::Opened, this,
    [this]
    {
      this->BarsOf.clear(); // other samples
      this->update();
    });
}

QSize HistogramPanel::sizeHint() const
{
  return { 40 * this->fontMetrics().height(), 8 * this->fontMetrics().height() };
}

QSize HistogramPanel::minimumSizeHint() const
{
  return { 12 * this->fontMetrics().height(), 5 * this->fontMetrics().height() };
}

QRect HistogramPanel::Plot() const
{
  const int line = this->fontMetrics().height();
  return this->rect().adjusted(line, line / 2 + line, -line, -line - line / 4);
}

QPoint HistogramPanel::PlaceOf(double share) const
{
  const QRect plot = this->Plot();
  return { plot.x() + static_cast<int>(std::lround(share * (plot.width() - 1))),
    plot.center().y() };
}

double HistogramPanel::ValueAt(int x) const
{
  const QRect plot = this->Plot();
  const std::array<double, 2>& range = this->Bench.Data.Counted().Range;
  const double share = static_cast<double>(x - plot.x()) / std::max(plot.width() - 1, 1);
  return range[0] + std::clamp(share, 0.0, 1.0) * (range[1] - range[0]);
}

double HistogramPanel::XOf(double value) const
{
  const QRect plot = this->Plot();
  const std::array<double, 2>& range = this->Bench.Data.Counted().Range;
  return plot.x() + (value - range[0]) / (range[1] - range[0]) * (plot.width() - 1);
}

// Each column in the colour of its value, and once more without colour.
void HistogramPanel::MakeBars()
{
  const QRect plot = this->Plot();
  const Histogram& counted = this->Bench.Data.Counted();
  const double most = *std::max_element(counted.Bins.begin(), counted.Bins.end());
  const double scale = plot.height() / std::log1p(most);
  const auto lastBin = static_cast<double>(counted.Bins.size() - 1);
  const QColor faint = Blended(this->palette(), 0.3);
  for (QPixmap* bars : { &this->Bars, &this->FaintBars })
  {
    *bars = QPixmap(this->size() * this->devicePixelRatioF());
    bars->setDevicePixelRatio(this->devicePixelRatioF());
    bars->fill(Qt::transparent);
    QPainter painter(bars);
    for (int x = plot.left(); x <= plot.right(); ++x)
    {
      const double share = static_cast<double>(x - plot.x()) / std::max(plot.width() - 1, 1);
      const auto bin = static_cast<std::size_t>(share * lastBin + 0.5);
      const int height = static_cast<int>(std::ceil(scale * std::log1p(counted.Bins[bin])));
      painter.fillRect(x, plot.bottom() + 1 - height, 1, height,
        bars == &this->Bars ? ColorAt(this->Bench, this->ValueAt(x)) : faint);
    }
  }
}

// What no surface shows is faint: it lies below the least isovalue.
void HistogramPanel::DrawBars(QPainter& painter)
{
  constexpr int few = 256; // colours, which tell one palette from another
  const std::array<double, 2>& range = this->Bench.Data.Counted().Range;
  const QRect plot = this->Plot();
  std::vector<double> of(3 * few);
  this->Bench.Data.View.Colors()->GetTable(range[0], range[1], few, of.data());
  of.insert(of.end(),
    { plot.x() * 1.0, plot.y() * 1.0, plot.width() * 1.0, plot.height() * 1.0,
      this->devicePixelRatioF(), static_cast<double>(this->palette().cacheKey()) });
  if (of != this->BarsOf)
  {
    this->BarsOf = of;
    this->MakeBars();
  }
  double least = range[this->Bench.Data.DrawsSurfaces() ? 1 : 0];
  for (const Surface& surface : this->Bench.Data.Settings().Surfaces)
  {
    least = std::min(least, surface.Isovalue);
  }
  const QRect all = this->rect();
  const int begin = static_cast<int>(std::ceil(this->XOf(least)));
  painter.setClipRect(all.adjusted(begin, 0, 0, 0));
  painter.drawPixmap(0, 0, this->Bars);
  painter.setClipRect(QRect(0, 0, begin, all.height()));
  painter.drawPixmap(0, 0, this->FaintBars);
  painter.setClipping(false);
}

void HistogramPanel::DrawSurfaces(QPainter& painter) const
{
  const QRect plot = this->Plot();
  const auto& surfaces = this->Bench.Data.Settings().Surfaces;
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    const double x = this->XOf(surfaces[i].Isovalue);
    const bool isSelected = i == this->Bench.Selected();
    const QColor line = isSelected ? this->palette().color(QPalette::Highlight)
                                   : this->palette().color(QPalette::WindowText);
    painter.setPen(QPen(line, 2, surfaces[i].IsVisible ? Qt::SolidLine : Qt::DotLine));
    painter.drawLine(QPointF(x, plot.top() - 2), QPointF(x, plot.bottom()));
    painter.setBrush(
      surfaces[i].Color ? ColorOf(*surfaces[i].Color) : ColorAt(this->Bench, surfaces[i].Isovalue));
    const double size = 0.4 * this->fontMetrics().height();
    painter.drawEllipse(QPointF(x, plot.top() - 2), size, size);
  }
}

void HistogramPanel::DrawNodes(QPainter& painter) const
{
  const QRect plot = this->Plot();
  const auto& nodes = this->Bench.Data.Settings().Nodes;
  QPolygonF line;
  for (const auto& node : nodes)
  {
    line << QPointF(this->XOf(node.Value), plot.bottom() - node.Opacity * plot.height());
  }
  // With a rim, as it lies over bars of any colour.
  painter.setPen(QPen(this->palette().color(QPalette::Window), 4));
  painter.drawPolyline(line);
  painter.setPen(QPen(this->palette().color(QPalette::WindowText), 2));
  painter.drawPolyline(line);
  for (int i = 0; i < line.size(); ++i)
  {
    const double size = 0.4 * this->fontMetrics().height();
    painter.setPen(QPen(
      this->palette().color(i == this->Chosen() ? QPalette::Highlight : QPalette::WindowText), 2));
    painter.setBrush(ColorAt(this->Bench, nodes[static_cast<std::size_t>(i)].Value));
    painter.drawEllipse(line[i], size, size);
  }
}

void HistogramPanel::DrawNumbers(QPainter& painter) const
{
  const QRect plot = this->Plot();
  const int line = this->fontMetrics().height();
  const std::array<double, 2>& range = this->Bench.Data.Counted().Range;
  const Look& look = this->Bench.Data.Settings();
  const auto& node = look.Nodes[static_cast<std::size_t>(this->Chosen())];
  const QString what = this->Bench.Data.DrawsSurfaces()
    ? tr("Isovalue %1").arg(Short(look.Surfaces[this->Bench.Selected()].Isovalue))
    : tr("Value %1, opacity %2").arg(Short(node.Value), Short(node.Opacity));
  painter.setPen(this->palette().color(QPalette::WindowText));
  const QRect foot(plot.x(), plot.bottom() + 2, plot.width(), line);
  painter.drawText(foot, Qt::AlignLeft, Short(range[0]));
  painter.drawText(foot, Qt::AlignRight, Short(range[1]));
  painter.drawText(foot, Qt::AlignHCenter, what);
}

void HistogramPanel::paintEvent(QPaintEvent*)
{
  if (!this->Bench.Data.IsOpen())
  {
    return;
  }
  QPainter painter(this);
  this->DrawBars(painter);
  painter.setRenderHint(QPainter::Antialiasing);
  if (this->Bench.Data.DrawsSurfaces())
  {
    this->DrawSurfaces(painter);
  }
  else
  {
    this->DrawNodes(painter);
  }
  this->DrawNumbers(painter);
  if (this->hasFocus())
  {
    painter.setPen(QPen(this->palette().color(QPalette::Highlight), 1, Qt::DotLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(this->rect().adjusted(1, 1, -2, -2));
  }
}

int HistogramPanel::Chosen() const
{
  return std::clamp(this->Node, 0, static_cast<int>(this->Bench.Data.Settings().Nodes.size()) - 1);
}

int HistogramPanel::NodeNear(const QPoint& place) const
{
  const QRect plot = this->Plot();
  const auto& nodes = this->Bench.Data.Settings().Nodes;
  int nearest = -1;
  double least = 2.0 * Reach;
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    const double distance = std::hypot(this->XOf(nodes[i].Value) - place.x(),
      plot.bottom() - nodes[i].Opacity * plot.height() - place.y());
    if (distance < least)
    {
      least = distance;
      nearest = static_cast<int>(i);
    }
  }
  return nearest;
}

void HistogramPanel::Grab(const QPoint& place)
{
  if (!this->Bench.Data.DrawsSurfaces())
  {
    this->Bench.BeginGesture();
    const int near = this->NodeNear(place);
    this->Node = near < 0 ? this->Node : near;
    this->update();
    return;
  }
  const auto& surfaces = this->Bench.Data.Settings().Surfaces;
  double least = Reach;
  std::size_t nearest = this->Bench.Selected();
  for (std::size_t i = 0; i < surfaces.size(); ++i)
  {
    const double distance = std::abs(this->XOf(surfaces[i].Isovalue) - place.x());
    nearest = distance < least ? i : nearest;
    least = std::min(least, distance);
  }
  this->Bench.Select(nearest);
  this->Bench.PrepareDrag();
}

void HistogramPanel::DragTo(const QPoint& place)
{
  const double value = this->ValueAt(place.x());
  if (this->Bench.Data.DrawsSurfaces())
  {
    const std::size_t selected = this->Bench.Selected();
    this->Bench.Edit(tr("isovalue"), [=](Look& look) { look.Surfaces[selected].Isovalue = value; });
    return;
  }
  const QRect plot = this->Plot();
  const double opacity = static_cast<double>(plot.bottom() - place.y()) / plot.height();
  this->Bench.Edit(tr("opacity"),
    [=](Look& look)
    {
      const auto at = static_cast<std::size_t>(this->Chosen());
      auto& node = look.Nodes[at];
      const double before = at > 0 ? look.Nodes[at - 1].Value : value;
      const double after = at + 1 < look.Nodes.size() ? look.Nodes[at + 1].Value : value;
      node.Value = std::clamp(value, before, std::max(before, after));
      node.Opacity = std::clamp(opacity, 0.0, 1.0);
    });
}

void HistogramPanel::AddNode(const QPoint& place)
{
  const double value = this->ValueAt(place.x());
  this->Bench.BeginGesture();
  this->Bench.Edit(tr("node"),
    [&](Look& look)
    {
      const auto at = std::find_if(look.Nodes.begin(), look.Nodes.end(),
        [value](const auto& node) { return node.Value > value; });
      this->Node = static_cast<int>(at - look.Nodes.begin());
      look.Nodes.insert(at, { value, 0.0 });
    });
  this->DragTo(place);
}

void HistogramPanel::RemoveNode()
{
  this->Bench.BeginGesture();
  this->Bench.Edit(tr("node"),
    [this](Look& look)
    {
      if (look.Nodes.size() > 2)
      {
        look.Nodes.erase(look.Nodes.begin() + this->Chosen());
      }
    });
}

void HistogramPanel::ColorNode()
{
  const auto node = this->Bench.Data.Settings().Nodes[static_cast<std::size_t>(this->Chosen())];
  AskColor(this, ColorAt(this->Bench, node.Value),
    [this](const Rgb& color)
    {
      this->Bench.Edit(tr("colour"),
        [&](Look& look) { look.Nodes[static_cast<std::size_t>(this->Chosen())].Color = color; });
    });
}

void HistogramPanel::MoveBy(double steps, double opacity)
{
  const double value = steps * this->Bench.Data.StepOfIsovalues();
  const std::size_t surface = this->Bench.Selected();
  const bool isSurface = this->Bench.Data.DrawsSurfaces();
  this->Bench.Edit(isSurface ? tr("isovalue") : tr("opacity"),
    [=](Look& look)
    {
      if (isSurface)
      {
        look.Surfaces[surface].Isovalue += value;
        return;
      }
      auto& node = look.Nodes[static_cast<std::size_t>(this->Chosen())];
      node.Value += value;
      node.Opacity += opacity;
    });
}

void HistogramPanel::mousePressEvent(QMouseEvent* event)
{
  if (event->button() == Qt::LeftButton && this->Bench.Data.IsOpen())
  {
    this->Bench.SetDragging(true);
    this->Grab(event->pos());
    if (this->Bench.Data.DrawsSurfaces())
    {
      this->DragTo(event->pos());
    }
  }
}

void HistogramPanel::mouseMoveEvent(QMouseEvent* event)
{
  if (event->buttons() & Qt::LeftButton && this->Bench.Data.IsOpen())
  {
    this->DragTo(event->pos());
  }
}

void HistogramPanel::mouseReleaseEvent(QMouseEvent*)
{
  this->Bench.SetDragging(false);
}

void HistogramPanel::mouseDoubleClickEvent(QMouseEvent* event)
{
  if (this->Bench.Data.IsOpen() && !this->Bench.Data.DrawsSurfaces())
  {
    this->AddNode(event->pos());
  }
  else
  {
    this->mousePressEvent(event);
  }
}

void HistogramPanel::wheelEvent(QWheelEvent* event)
{
  if (this->Bench.Data.IsOpen())
  {
    this->MoveBy(event->angleDelta().y() / 120.0, 0.0);
  }
}

void HistogramPanel::keyPressEvent(QKeyEvent* event)
{
  const double many = event->modifiers() & Qt::ShiftModifier ? 10.0 : 1.0;
  const bool isSurface = this->Bench.Data.IsOpen() && this->Bench.Data.DrawsSurfaces();
  const int key = event->key();
  const int turn = key == Qt::Key_PageUp ? -1 : 1;
  if (!this->Bench.Data.IsOpen())
  {
    event->ignore();
  }
  else if (key == Qt::Key_Left || key == Qt::Key_Right)
  {
    this->MoveBy(key == Qt::Key_Left ? -many : many, 0.0);
  }
  else if (key == Qt::Key_Up || key == Qt::Key_Down)
  {
    const double up = key == Qt::Key_Up ? many : -many;
    this->MoveBy(isSurface ? up : 0.0, 0.01 * up);
  }
  else if (key == Qt::Key_PageUp || key == Qt::Key_PageDown)
  {
    const Look& look = this->Bench.Data.Settings();
    const auto count = static_cast<int>(isSurface ? look.Surfaces.size() : look.Nodes.size());
    const int now = isSurface ? static_cast<int>(this->Bench.Selected()) : this->Chosen();
    const int next = (now + turn + count) % count;
    this->Node = isSurface ? this->Node : next;
    this->Bench.Select(isSurface ? static_cast<std::size_t>(next) : this->Bench.Selected());
    this->update();
  }
  else if (key == Qt::Key_Insert && !isSurface)
  {
    const auto& nodes = this->Bench.Data.Settings().Nodes;
    const auto at = static_cast<std::size_t>(std::max(this->Chosen(), 1));
    this->AddNode(
      { static_cast<int>(0.5 * (this->XOf(nodes[at - 1].Value) + this->XOf(nodes[at].Value))),
        this->Plot().center().y() });
  }
  else if (key == Qt::Key_Delete && !isSurface)
  {
    this->RemoveNode();
  }
  else
  {
    QWidget::keyPressEvent(event);
  }
}

void HistogramPanel::contextMenuEvent(QContextMenuEvent* event)
{
  if (!this->Bench.Data.IsOpen() || this->Bench.Data.DrawsSurfaces())
  {
    return;
  }
  const int near = this->NodeNear(event->pos());
  QMenu menu;
  menu.addAction(tr("Add node here"), [=] { this->AddNode(event->pos()); });
  if (near >= 0)
  {
    this->Node = near;
    menu.addAction(tr("Colour of this node..."), [this] { this->ColorNode(); });
    menu.addAction(tr("Remove this node"), [this] { this->RemoveNode(); });
  }
  menu.exec(event->globalPos());
}
