// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Dialogs_h
#define Dialogs_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

class QWidget;
class Workbench;

QWidget* MakeKeysPanel();

// A picture, or a film, of a chosen size.
void AskPicture(QWidget* over, Workbench& bench);
void AskFilm(QWidget* over, Workbench& bench);

// A window as it is seen.
vtkSmartPointer<vtkImageData> PictureOf(QWidget* window);

#endif
