// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef HistogramPanel_h
#define HistogramPanel_h

#include "Model/Model.h"

#include <QPixmap>
#include <QWidget>

#include <array>

class Workbench;

// The histogram. Over it lie the markers, surfaces or nodes of the opacity of a blended volume:
// they are dragged, or moved with keys.
class HistogramPanel : public QWidget
{
public:
  explicit HistogramPanel(Workbench& bench);

  QPoint PlaceOf(double share) const; // of the range of values
  void Zoom(double factor, double x); // about a place of the panel; 0: all values are seen
  QSize sizeHint() const override { return 2 * this->minimumSize(); }

protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

private:
  QRect Plot() const;
  double XOf(double share) const;
  double ShareAt(double x) const;
  bool CanEdit() const { return this->Data.IsOpen() && !this->Data.DrawsLabels(); }
  void Move(double share); // what is seen of the values
  QPointF PlaceOf(const Marker& marker) const;
  Marker MarkerAt(const QPoint& place) const;
  int Nearest(const QPoint& place) const; // marker within reach; -1: none
  void Refresh();
  void MakeBars();
  void DrawBars(QPainter& painter) const;
  void DrawMarkers(QPainter& painter) const;
  void DragTo(const QPoint& place);
  void MoveBy(double steps, double opacity);

  Workbench& Bench;
  const Model& Data;
  std::array<double, 2> Seen = { 0.0, 1.0 }; // shares of the range of values
  bool IsLate = false;                       // until the next frame
  QPixmap Bars;
  std::vector<double> BarsOf; // what they were made of
};

#endif
