// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Panels/Panels.h"
#include "Work/Workbench.h"

#include <QPainter>
#include <QTimer>
#include <QWidget>

#include <algorithm>
#include <deque>

namespace
{

constexpr std::size_t MostFrames = 200;
constexpr int PaintEvery = 100; // ms

const QColor Hit(84, 184, 148), Possible(236, 196, 72), Miss(110, 124, 148);

struct Frame
{
  double WindowMs = 0.0;
  double MapperMs = 0.0;
};

// What the last frame was like, and how long the last ones took.
class Statistics : public QWidget
{
public:
  explicit Statistics(Workbench& bench)
    : Bench(bench)
  {
    this->setObjectName("statistics");
    this->setAccessibleName(tr("Statistics of the last frames"));
    this->setToolTip(tr("A bar a frame, the last 200: the window's time, and the mapper's in it"));
    this->Due.setSingleShot(true);
    QObject::connect(&this->Due, &QTimer::timeout, this, [this] { this->update(); });
    QObject::connect(&bench, &Workbench::FrameDrawn, this,
      [this](double ms)
      {
        this->Facts = this->Bench.Data.View.Facts();
        this->Frames.push_back({ ms, this->Facts.Ms });
        if (this->Frames.size() > MostFrames)
        {
          this->Frames.pop_front();
        }
        if (!this->Due.isActive())
        {
          this->Due.start(PaintEvery);
        }
      });
  }

  QSize sizeHint() const override
  {
    const int line = this->fontMetrics().height();
    return { 18 * line, 10 * line };
  }
  QSize minimumSizeHint() const override { return this->sizeHint(); }

protected:
  void paintEvent(QPaintEvent*) override
  {
    if (this->Frames.empty())
    {
      return;
    }
    QPainter painter(this);
    const int line = this->fontMetrics().height();
    this->DrawFrames(painter, { 0, 0, this->width(), 4 * line });
    const Frame& last = this->Frames.back();
    const FrameFacts& facts = this->Facts;
    int place = 0;
    // Two of them in a row: all are seen in a panel of half the window's height.
    const auto tell = [&](const QString& label, const QString& value, const QColor& key = {})
    {
      const int width = (this->width() - line) / 2;
      const int y = 4 * line + line / 2 + place / 2 * line;
      const QRect rect(place % 2 * (width + line), y, width, line);
      ++place;
      const int indent = key.isValid() ? line : 0;
      if (key.isValid())
      {
        painter.fillRect(rect.x() + line / 4, y + line / 4, line / 2, line / 2, key);
      }
      painter.setPen(Blended(this->palette(), 0.7));
      painter.drawText(rect.adjusted(indent, 0, 0, 0), Qt::AlignLeft, label);
      painter.setPen(this->palette().color(QPalette::WindowText));
      painter.drawText(rect, Qt::AlignRight, value);
    };
    const auto percent = [](double share) { return tr("%1 %").arg(100.0 * share, 0, 'f', 1); };
    tell(tr("Mapper"), tr("%1 ms").arg(facts.Ms, 0, 'f', 1));
    tell(tr("Window"), tr("%1 ms").arg(last.WindowMs, 0, 'f', 1));
    tell(tr("Hits"), percent(facts.Hits), Hit);
    tell(tr("Traced"), percent(facts.Traced));
    tell(tr("Possible"), percent(facts.PossibleHits), Possible);
    tell(tr("Samples"), tr("%1 a ray").arg(facts.SamplesPerRay, 0, 'f', 1));
    tell(tr("Misses"), percent(facts.Misses), Miss);
    tell(tr("Isomap"), tr("%1 MiB").arg(facts.IsomapMiB, 0, 'f', 1));
    tell(tr("Route"), QString::fromStdString(facts.Route));
  }

private:
  void DrawFrames(QPainter& painter, const QRect& area) const
  {
    double most = 0.0;
    for (const Frame& frame : this->Frames)
    {
      most = std::max(most, frame.WindowMs);
    }
    painter.fillRect(area, this->palette().color(QPalette::Base));
    const double width = static_cast<double>(area.width()) / MostFrames;
    double x = area.right() - width * static_cast<double>(this->Frames.size());
    for (const Frame& frame : this->Frames)
    {
      const auto bar = [&](double ms, const QColor& color)
      {
        const double height = area.height() * ms / std::max(most, 1e-3);
        painter.fillRect(QRectF(x, area.bottom() + 1 - height, width, height), color);
      };
      bar(frame.WindowMs, Miss);
      bar(frame.MapperMs, this->palette().color(QPalette::Highlight));
      x += width;
    }
    painter.setPen(this->palette().color(QPalette::Text));
    painter.drawText(
      area.adjusted(4, 2, -4, -2), Qt::AlignLeft | Qt::AlignTop, tr("%1 ms").arg(most, 0, 'f', 0));
  }

  Workbench& Bench;
  QTimer Due;
  FrameFacts Facts;
  std::deque<Frame> Frames;
};

}

QWidget* MakeStatistics(Workbench& bench)
{
  return new Statistics(bench);
}
