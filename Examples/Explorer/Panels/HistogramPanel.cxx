// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Panels/HistogramPanel.h"

#include "Panels/Form.h"

#include <QMouseEvent>
#include <QPaintEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{

constexpr double Reach = 12.0;     // pixels from a marker that still grab it
constexpr double Faint = 0.35;     // opacity
constexpr double LeastSeen = 0.01; // of the range of values

}

HistogramPanel::HistogramPanel(Workbench& bench)
  : Bench(bench)
  , Data(bench.Data)
{
  this->setObjectName("histogram");
  this->setAccessibleName(tr("Histogram with isovalues and opacity"));
  this->setToolTip(tr("Drag a marker: the isovalue of a surface, or a node of the opacity.\n"
                      "Right click: its colour. Double click: another node.\n"
                      "Ctrl and wheel: fewer values are seen. Shift and wheel: others."));
  const int line = this->fontMetrics().height();
  this->setMinimumSize(12 * line, 5 * line);
  this->setFocusPolicy(Qt::StrongFocus);
  this->setContextMenuPolicy(Qt::ActionsContextMenu);
  this->setAttribute(Qt::WA_OpaquePaintEvent); // nothing behind it has to be drawn
  QObject::connect(&bench, &Workbench::Changed, this, &HistogramPanel::Refresh);
  QObject::connect(&bench, &Workbench::FrameDrawn, this,
    [this]
    {
      if (this->IsLate)
      {
        this->Refresh();
      }
    });
  QObject::connect(&bench, &Workbench::Opened, this,
    [this](bool isOtherFile) { this->Zoom(isOtherFile ? 0.0 : 1.0, 0.0); });
}

QRect HistogramPanel::Plot() const
{
  const int line = this->fontMetrics().height();
  return this->rect().adjusted(line, line / 2 + line, -line, -line - line / 4);
}

QPoint HistogramPanel::PlaceOf(double share) const
{
  return { static_cast<int>(std::lround(this->XOf(share))), this->Plot().center().y() };
}

double HistogramPanel::XOf(double share) const
{
  const QRect plot = this->Plot();
  const double part = (share - this->Seen[0]) / (this->Seen[1] - this->Seen[0]);
  return plot.x() + part * (plot.width() - 1);
}

double HistogramPanel::ShareAt(double x) const
{
  const QRect plot = this->Plot();
  const double part = (x - plot.x()) / std::max(plot.width() - 1, 1);
  return std::clamp(this->Seen[0] + part * (this->Seen[1] - this->Seen[0]), 0.0, 1.0);
}

void HistogramPanel::Zoom(double factor, double x)
{
  const double middle = this->ShareAt(x);
  const double width = this->Seen[1] - this->Seen[0];
  const double next = factor > 0.0 ? std::clamp(width / factor, LeastSeen, 1.0) : 1.0;
  const double from = middle - (middle - this->Seen[0]) * next / width;
  this->Seen = { from, from + next };
  this->Move(0.0);
}

void HistogramPanel::Move(double share)
{
  const double width = this->Seen[1] - this->Seen[0];
  const double from = std::clamp(this->Seen[0] + share, 0.0, std::max(1.0 - width, 0.0));
  this->Seen = { from, from + width };
  this->Refresh();
}

QPointF HistogramPanel::PlaceOf(const Marker& marker) const
{
  const QRect plot = this->Plot();
  const double height = this->Data.DrawsSurfaces() ? 1.0 : marker.Opacity;
  return { this->XOf(this->Data.ShareOf(marker.Value)), plot.bottom() - height * plot.height() };
}

Marker HistogramPanel::MarkerAt(const QPoint& place) const
{
  const QRect plot = this->Plot();
  const double height = static_cast<double>(plot.bottom() - place.y()) / plot.height();
  return { this->Data.ValueAt(this->ShareAt(place.x())), std::clamp(height, 0.0, 1.0) };
}

int HistogramPanel::Nearest(const QPoint& place) const
{
  int nearest = -1;
  double least = Reach;
  const std::vector<Marker>& markers = this->Bench.Markers();
  for (std::size_t i = 0; i < markers.size(); ++i)
  {
    const QPointF way = this->PlaceOf(markers[i]) - place;
    const double distance =
      this->Data.DrawsSurfaces() ? std::abs(way.x()) : std::hypot(way.x(), way.y());
    nearest = distance < least ? static_cast<int>(i) : nearest;
    least = std::min(least, distance);
  }
  return nearest;
}

// With the frame that is due: the window is drawn once for both.
void HistogramPanel::Refresh()
{
  this->IsLate = this->Bench.IsRenderDue() && !this->Bench.IsBuilding();
  if (!this->IsLate)
  {
    this->update();
  }
}

// Each column in the colour of its value. They are kept while they stay as they are.
void HistogramPanel::MakeBars()
{
  const QRect plot = this->Plot();
  const Histogram& counted = this->Data.Counted();
  const std::size_t count = counted.Bins.size();
  const double most = *std::max_element(counted.Bins.begin(), counted.Bins.end());
  std::vector<double> of = counted.Bins;
  const QColor ground = this->palette().color(QPalette::Window);
  of.insert(of.end(),
    { 1.0 * plot.width(), 1.0 * plot.height(), this->devicePixelRatioF(), 1.0 * ground.rgb(),
      this->Seen[0], this->Seen[1] });
  std::vector<QColor> colors;
  for (std::size_t bin = 0; bin < count; ++bin)
  {
    const double share = static_cast<double>(bin) / static_cast<double>(count - 1);
    const Rgb rgb = this->Data.View.ColorOf({ this->Data.ValueAt(share) });
    of.insert(of.end(), rgb.begin(), rgb.end());
    colors.push_back(ToQColor(rgb));
  }
  if (std::exchange(this->BarsOf, of) == of)
  {
    return;
  }
  this->Bars = QPixmap(this->size() * this->devicePixelRatioF());
  this->Bars.setDevicePixelRatio(this->devicePixelRatioF());
  this->Bars.fill(ground);
  QPainter painter(&this->Bars);
  for (int x = 0; x < plot.width(); ++x)
  {
    const auto bin =
      static_cast<std::size_t>(this->ShareAt(plot.x() + x) * static_cast<double>(count - 1));
    const double height = plot.height() * std::log1p(counted.Bins[bin]) / std::log1p(most);
    painter.fillRect(QRectF(plot.x() + x, plot.bottom() + 1 - height, 1.0, height), colors[bin]);
  }
}

// What no surface shows is faint: it lies below the least isovalue.
void HistogramPanel::DrawBars(QPainter& painter) const
{
  const QRect all = this->rect();
  double begin = this->Data.HasIsovalues() ? all.width() : 0.0;
  for (const Marker& marker : this->Bench.Markers())
  {
    begin = std::min(begin, this->PlaceOf(marker).x());
  }
  const int from = static_cast<int>(std::ceil(begin));
  painter.setClipRect(all.adjusted(from, 0, 0, 0));
  painter.drawPixmap(0, 0, this->Bars);
  painter.setClipRect(QRect(0, 0, from, all.height()));
  painter.setOpacity(Faint);
  painter.drawPixmap(0, 0, this->Bars);
  painter.setOpacity(1.0);
  painter.setClipping(false);
}

void HistogramPanel::DrawMarkers(QPainter& painter) const
{
  const QRect plot = this->Plot();
  const QColor text = this->palette().color(QPalette::WindowText);
  const double size = 0.4 * this->fontMetrics().height();
  QPolygonF line;
  for (const Marker& marker : this->Bench.Markers())
  {
    line << this->PlaceOf(marker);
  }
  if (!this->Data.DrawsSurfaces())
  {
    // With a rim, as it lies over bars of any colour.
    painter.setPen(QPen(this->palette().color(QPalette::Window), 4));
    painter.drawPolyline(line);
    painter.setPen(QPen(text, 2));
    painter.drawPolyline(line);
  }
  for (int i = 0; i < line.size(); ++i)
  {
    const Marker& marker = this->Bench.Markers()[static_cast<std::size_t>(i)];
    const bool isSelected = static_cast<std::size_t>(i) == this->Bench.Selected();
    painter.setPen(QPen(isSelected ? this->palette().color(QPalette::Highlight) : text, 2,
      marker.IsVisible ? Qt::SolidLine : Qt::DotLine));
    if (this->Data.DrawsSurfaces())
    {
      painter.drawLine(line[i], QPointF(line[i].x(), plot.bottom()));
    }
    painter.setBrush(ToQColor(this->Data.View.ColorOf(marker)));
    painter.drawEllipse(line[i], size, size);
    if (isSelected)
    {
      const QString label = this->Data.Projects()
        ? (i == 0 ? tr("Black %1") : tr("White %1")).arg(Short(marker.Value))
        : this->Data.DrawsSurfaces()
        ? tr("Isovalue %1").arg(Short(marker.Value))
        : tr("%1: %2 %").arg(Short(marker.Value)).arg(100.0 * marker.Opacity, 0, 'f', 1);
      const double width = this->fontMetrics().horizontalAdvance(label);
      const double right = line[i].x() + 2.0 * size;
      painter.setPen(text);
      painter.drawText(QPointF(right + width < this->width() ? right : right - width - 4.0 * size,
                         this->fontMetrics().ascent()),
        label);
    }
  }
}

void HistogramPanel::paintEvent(QPaintEvent* event)
{
  QPainter painter(this);
  painter.fillRect(event->rect(), this->palette().color(QPalette::Window));
  if (!this->Data.IsOpen())
  {
    return;
  }
  this->MakeBars();
  this->DrawBars(painter);
  painter.setRenderHint(QPainter::Antialiasing);
  const int line = this->fontMetrics().height();
  painter.setClipRect(this->Plot().adjusted(-line, -2 * line, line, line));
  if (!this->Data.DrawsLabels())
  {
    this->DrawMarkers(painter);
  }
  painter.setClipping(false);
  const QRect foot = this->rect().adjusted(0, this->Plot().bottom() + 2, 0, 0);
  const auto valueAt = [&](double part)
  { return Short(this->Data.ValueAt(this->Seen[0] + part * (this->Seen[1] - this->Seen[0]))); };
  painter.setPen(this->palette().color(QPalette::WindowText));
  painter.drawText(foot, Qt::AlignLeft, " " + valueAt(0.0));
  painter.drawText(foot, Qt::AlignHCenter, valueAt(0.5));
  painter.drawText(foot, Qt::AlignRight, valueAt(1.0) + " ");
  if (this->hasFocus())
  {
    painter.setPen(QPen(this->palette().color(QPalette::Highlight), 1, Qt::DotLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(this->rect().adjusted(1, 1, -2, -2));
  }
}

// Surfaces move along the values only; nodes not beyond their neighbours.
void HistogramPanel::DragTo(const QPoint& place)
{
  const Marker to = this->MarkerAt(place);
  const std::size_t at = this->Bench.Selected();
  const bool isSurface = this->Data.DrawsSurfaces();
  this->Bench.Edit(isSurface ? tr("isovalue") : tr("opacity"),
    [&](Look& look)
    {
      std::vector<Marker>& markers = this->Data.MarkersOf(look);
      const double before = isSurface || at == 0 ? to.Value : markers[at - 1].Value;
      const double after = isSurface || at + 1 == markers.size() ? to.Value : markers[at + 1].Value;
      markers[at].Value = std::clamp(to.Value, std::min(before, after), std::max(before, after));
      markers[at].Opacity = isSurface ? markers[at].Opacity : to.Opacity;
    });
}

void HistogramPanel::MoveBy(double steps, double opacity)
{
  const bool isSurface = this->Data.DrawsSurfaces();
  this->Bench.EditMarker(isSurface ? tr("isovalue") : tr("opacity"),
    [=](Marker& marker)
    {
      marker.Value += steps * this->Data.StepOfValues() * (this->Seen[1] - this->Seen[0]);
      marker.Opacity += isSurface ? 0.0 : opacity;
    });
}

void HistogramPanel::mousePressEvent(QMouseEvent* event)
{
  if (!this->CanEdit())
  {
    return;
  }
  const int near = this->Nearest(event->pos());
  this->Bench.Select(near < 0 ? this->Bench.Selected() : static_cast<std::size_t>(near));
  if (event->button() != Qt::LeftButton)
  {
    return;
  }
  this->Bench.SetDragging(true);
  this->Bench.PrepareDrag();
  if (this->Data.DrawsSurfaces())
  {
    this->DragTo(event->pos());
  }
}

void HistogramPanel::mouseMoveEvent(QMouseEvent* event)
{
  if (event->buttons() & Qt::LeftButton && this->CanEdit())
  {
    this->DragTo(event->pos());
    // At once: the window is drawn once, with this frame. Moves meanwhile become one.
    this->Bench.Render();
  }
}

void HistogramPanel::mouseReleaseEvent(QMouseEvent*)
{
  this->Bench.SetDragging(false);
}

void HistogramPanel::mouseDoubleClickEvent(QMouseEvent* event)
{
  if (this->Data.IsOpen() && !this->Data.DrawsSurfaces())
  {
    this->Bench.AddMarker(this->MarkerAt(event->pos()));
  }
  else
  {
    this->mousePressEvent(event); // whoever presses again soon wants to drag again
  }
}

void HistogramPanel::wheelEvent(QWheelEvent* event)
{
  const double clicks = event->angleDelta().y() / 120.0;
  if (event->modifiers() & Qt::ControlModifier)
  {
    this->Zoom(std::pow(1.25, clicks), event->position().x());
  }
  else if (event->modifiers() & Qt::ShiftModifier)
  {
    this->Move(-0.1 * clicks * (this->Seen[1] - this->Seen[0]));
  }
  else if (this->CanEdit())
  {
    this->MoveBy(clicks, 0.0);
  }
}

void HistogramPanel::keyPressEvent(QKeyEvent* event)
{
  const double many = event->modifiers() & Qt::ShiftModifier ? 10.0 : 1.0;
  const bool isSurface = this->Data.IsOpen() && this->Data.DrawsSurfaces();
  const std::size_t count = this->Bench.Markers().size();
  switch (this->CanEdit() ? event->key() : static_cast<int>(Qt::Key_unknown))
  {
    case Qt::Key_Left:
      return this->MoveBy(-many, 0.0);
    case Qt::Key_Right:
      return this->MoveBy(many, 0.0);
    case Qt::Key_Up:
      return this->MoveBy(isSurface ? many : 0.0, 0.01 * many);
    case Qt::Key_Down:
      return this->MoveBy(isSurface ? -many : 0.0, -0.01 * many);
    case Qt::Key_PageUp:
      return this->Bench.Select((this->Bench.Selected() + count - 1) % count);
    case Qt::Key_PageDown:
      return this->Bench.Select((this->Bench.Selected() + 1) % count);
    case Qt::Key_Insert:
      return this->Bench.AddMarker();
    case Qt::Key_Delete:
      return this->Bench.RemoveMarker();
    default:
      QWidget::keyPressEvent(event);
  }
}
