// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef HistogramPanel_h
#define HistogramPanel_h

#include <QPixmap>
#include <QWidget>

#include <vector>

class Workbench;

// The histogram. Over it lie the isovalues of surfaces, or the opacity of a blended volume: both
// are dragged, or moved with keys.
class HistogramPanel : public QWidget
{
public:
  explicit HistogramPanel(Workbench& bench);

  // Where a share of the range of values lies.
  QPoint PlaceOf(double share) const;
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

private:
  QRect Plot() const;
  double ValueAt(int x) const;
  double XOf(double value) const;
  void MakeBars();
  void DrawBars(QPainter& painter);
  void DrawSurfaces(QPainter& painter) const;
  void DrawNodes(QPainter& painter) const;
  void DrawNumbers(QPainter& painter) const;
  void Grab(const QPoint& place);
  void DragTo(const QPoint& place);
  void AddNode(const QPoint& place);
  void RemoveNode();
  void ColorNode();
  int NodeNear(const QPoint& place) const; // -1: none
  void MoveBy(double steps, double opacity);
  int Chosen() const; // node

  Workbench& Bench;
  int Node = 1;
  QPixmap Bars, FaintBars;
  std::vector<double> BarsOf; // what they were made of, but the samples
};

#endif
