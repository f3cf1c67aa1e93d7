// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Scene_h
#define Scene_h

#include "Model/Model.h"
#include "View/Viewpoint.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

struct Options;

// The volume as the options want it to be seen. The functions throw UserError.
class Scene
{
public:
  Scene(const Options& options, const Progress& progress);

  // The volume and what is drawn of it, for people.
  std::string Description() const;

  // The place in the film, from 0 to 1: in a turn, or in a sweep.
  void MoveTo(double share);

  vtkSmartPointer<vtkImageData> Picture(const Progress& progress);

  // Sentences on what is otherwise than the user may think.
  std::vector<std::string> Remarks() const;

private:
  class Messages;

  void Open(const Progress& progress);
  void SetSurfaces(Look& look);
  void SetPreset(Look& look);
  void SetGreys(Look& look);
  void SetClip(Look& look);
  void FitView();
  vtkSmartPointer<vtkImageData> Finished(vtkImageData* rgba);

  const Options& Asked;
  Model Shown;
  Viewpoint Around;
  bool IsChosen = false; // the isovalue, from the histogram
  std::array<double, 2> Sweep = {};
  bool IsSeen = false;           // anything of the volume, in any picture
  std::vector<std::string> Said; // by the mapper
};

#endif
