// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Mouse_h
#define Mouse_h

#include <QApplication>
#include <QMouseEvent>
#include <QWidget>

// An event of the left button at a place in a widget.
inline void SendMouse(QWidget* widget, QEvent::Type type, const QPoint& place)
{
  QMouseEvent event(type, place, widget->mapToGlobal(place), Qt::LeftButton,
    type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(widget, &event);
}

#endif
