// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef DragMeasurement_h
#define DragMeasurement_h

class ExplorerWindow;

// Drags the isovalue through the histogram by the events that a mouse sends, shows two pictures of
// the window's size in turn, and prints the medians of what each took.
void MeasureDrag(ExplorerWindow& window, int steps);

#endif
