// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef StallMeasurement_h
#define StallMeasurement_h

class MainWindow;
class Workbench;

// Uses the blended volume as people do, and prints how long events waited at most meanwhile.
void MeasureStalls(MainWindow& window, Workbench& bench);

#endif
