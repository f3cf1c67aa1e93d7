// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Panels/Panels.h"
#include "Work/Workbench.h"

#include <QPainter>
#include <QWidget>

#include <algorithm>
#include <deque>

namespace
{

constexpr std::size_t MostFrames = 200;
constexpr int PaintEvery = 100; // ms
constexpr double BytesPerMiB = 1024.0 * 1024.0;

const QColor Hit(84, 184, 148), Possible(236, 196, 72), Miss(110, 124, 148);

struct Fact
{
  QString Label;
  QString Value;
  QColor Key = {};
};

// What the last frame was like, and how long the last ones took.
class Statistics : public QWidget
{
public:
  explicit Statistics(Workbench& bench)
  {
    this->setObjectName("statistics");
    this->setAccessibleName(tr("Statistics of the last frames"));
    this->setToolTip(tr("A bar a frame, the last 200: the window's time, and the mapper's in it"));
    const int line = this->fontMetrics().height();
    this->setMinimumSize(18 * line, 10 * line);
    this->Due.setSingleShot(true);
    QObject::connect(&this->Due, &QTimer::timeout, this, [this] { this->update(); });
    QObject::connect(&bench, &Workbench::FrameDrawn, this,
      [this, &bench](double ms) { this->Take(*bench.Data.View.Mapper->GetStatistics(), ms); });
  }

protected:
  void paintEvent(QPaintEvent*) override
  {
    QPainter painter(this);
    const int line = this->fontMetrics().height();
    this->DrawFrames(painter, { 0, 0, this->width(), 4 * line });
    // Two of them in a row: all are seen in a panel of half the window's height.
    const int width = (this->width() - line) / 2;
    QRect place(0, 4 * line + line / 2, width, line);
    for (const Fact& fact : this->Facts)
    {
      const QRect key(place.x() + line / 4, place.y() + line / 4, line / 2, line / 2);
      painter.fillRect(fact.Key.isValid() ? key : QRect(), fact.Key);
      painter.setPen(this->palette().color(QPalette::PlaceholderText));
      painter.drawText(
        place.adjusted(fact.Key.isValid() ? line : 0, 0, 0, 0), Qt::AlignLeft, fact.Label);
      painter.setPen(this->palette().color(QPalette::WindowText));
      painter.drawText(place, Qt::AlignRight, fact.Value);
      const bool isLeft = place.x() == 0;
      place.moveTo(isLeft ? width + line : 0, place.y() + (isLeft ? 0 : line));
    }
  }

private:
  void Take(vtkTemporalCoherenceStatistics& last, double windowMs)
  {
    const double ms = 1000.0 * last.GetFrameTime();
    const double rays = std::max(1.0, static_cast<double>(last.GetNumberOfRays()));
    const auto each = [](double number, const char* unit)
    { return tr("%1 %2").arg(number, 0, 'f', 1).arg(tr(unit)); };
    const auto share = [&](vtkIdType count)
    { return each(100.0 * static_cast<double>(count) / rays, "%"); };
    this->Facts = {
      { tr("Mapper"), each(ms, "ms") },
      { tr("Window"), each(windowMs, "ms") },
      { tr("Hits"), share(last.GetNumberOfDefiniteHits()), Hit },
      { tr("Traced"), share(last.GetNumberOfTracedRays()) },
      { tr("Possible"), share(last.GetNumberOfPossibleHits()), Possible },
      { tr("Samples"), each(static_cast<double>(last.GetNumberOfFieldSamples()) / rays, "a ray") },
      { tr("Misses"), share(last.GetNumberOfDefiniteMisses()), Miss },
      { tr("Isomap"), each(static_cast<double>(last.GetIsomapMemory()) / BytesPerMiB, "MiB") },
      { tr("Route"), last.GetRouteAsString() },
    };
    this->Frames.push_back({ windowMs, ms });
    if (this->Frames.size() > MostFrames)
    {
      this->Frames.pop_front();
    }
    if (!this->Due.isActive())
    {
      this->Due.start(PaintEvery);
    }
  }

  void DrawFrames(QPainter& painter, const QRect& area) const
  {
    double most = 1e-3;
    for (const auto& frame : this->Frames)
    {
      most = std::max(most, frame[0]);
    }
    painter.fillRect(area, this->palette().color(QPalette::Base));
    const double width = static_cast<double>(area.width()) / MostFrames;
    double x = area.right() - width * static_cast<double>(this->Frames.size());
    for (const auto& frame : this->Frames)
    {
      for (const bool isMapper : { false, true })
      {
        const double height = area.height() * frame[isMapper ? 1 : 0] / most;
        painter.fillRect(QRectF(x, area.bottom() + 1 - height, width, height),
          isMapper ? this->palette().color(QPalette::Highlight) : Miss);
      }
      x += width;
    }
    painter.setPen(this->palette().color(QPalette::Text));
    painter.drawText(
      area.adjusted(4, 2, -4, -2), Qt::AlignLeft | Qt::AlignTop, tr("%1 ms").arg(most, 0, 'f', 0));
  }

  QTimer Due;
  std::vector<Fact> Facts;
  std::deque<std::array<double, 2>> Frames; // ms: of the window, of the mapper
};

}

QWidget* MakeStatistics(Workbench& bench)
{
  return new Statistics(bench);
}
