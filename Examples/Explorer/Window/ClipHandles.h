// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ClipHandles_h
#define ClipHandles_h

#include "Work/Workbench.h"

#include <vtkBoxRepresentation.h>
#include <vtkBoxWidget2.h>
#include <vtkImplicitPlaneRepresentation.h>
#include <vtkImplicitPlaneWidget2.h>
#include <vtkNew.h>

class vtkRenderWindowInteractor;

// The clipping plane and the box that is cropped to, to be dragged in the view.
class ClipHandles : public QObject
{
public:
  // pixels: of a line
  ClipHandles(
    Workbench& bench, vtkRenderWindowInteractor* interactor, double pixels, QObject* parent);

private:
  void Place(); // for other data
  void Show();  // as the settings are
  void TakePlane();
  void TakeBox();

  Workbench& Bench;
  vtkNew<vtkImplicitPlaneWidget2> PlaneWidget;
  vtkNew<vtkImplicitPlaneRepresentation> PlaneShape;
  vtkNew<vtkBoxWidget2> BoxWidget;
  vtkNew<vtkBoxRepresentation> BoxShape;
};

#endif
