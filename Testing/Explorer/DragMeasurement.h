// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef DragMeasurement_h
#define DragMeasurement_h

class MainWindow;
class Workbench;

// Drags the isovalue through the histogram by the events that a mouse sends, shows two pictures of
// the view's size in the same widget in turn, and prints the medians of what each took.
void MeasureDrag(MainWindow& window, Workbench& bench, int steps);

#endif
