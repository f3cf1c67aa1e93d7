// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// Views for every isovalue, written to files.
#include "vtkTemporalIsosurfaceRepresentation.h"

#include "vtkMultiProcessController.h"
#include "vtkPVLODVolume.h"
#include "vtkPVRenderView.h"
#include "vtkRenderer.h"
#include "vtkTemporalCoherenceViewWriter.h"

#include <algorithm>

//------------------------------------------------------------------------------
void vtkTemporalIsosurfaceRepresentation::WriteView(const char* path)
{
  if (!path || !*path)
  {
    return;
  }
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  if (controller && controller->GetNumberOfProcesses() > 1)
  {
    vtkErrorMacro("A view is written by one process; run ParaView in one.");
    return;
  }
  auto* view = vtkPVRenderView::SafeDownCast(this->GetView());
  if (!view)
  {
    vtkErrorMacro("The representation is shown in no view; show it, and render once.");
    return;
  }
  vtkNew<vtkTemporalCoherenceViewWriter> writer;
  const int* const size = view->GetRenderer()->GetSize();
  writer->SetSize(std::max(size[0], 1), std::max(size[1], 1));
  writer->WriteView(path, view->GetRenderer(), this->Actor);
}
