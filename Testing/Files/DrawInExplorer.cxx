// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Draw.h"

#include "Model/Model.h"
#include "Model/Session.h"

#include <vtkCallbackCommand.h>
#include <vtkVolumeCollection.h>

#include <stdexcept>

namespace
{

constexpr int Size = 40; // pixels of a side

void Draw(const Session& session)
{
  Model model("", "+z");
  model.Open(session);
  // What the window would say of the mapper must have been said of the file.
  std::string complaint;
  vtkNew<vtkCallbackCommand> onError;
  onError->SetClientData(&complaint);
  onError->SetCallback([](vtkObject*, unsigned long, void* to, void* message)
    { *static_cast<std::string*>(to) = static_cast<const char*>(message); });
  model.View.Mapper->AddObserver(vtkCommand::ErrorEvent, onError);
  vtkVolumeCollection* volumes = model.View.Renderer->GetVolumes();
  volumes->InitTraversal();
  vtkVolume* volume = volumes->GetNextVolume();
  vtkNew<vtkImageData> picture;
  // Another isovalue takes another route.
  for (const double steps : { 0.0, 3.0, -7.0 })
  {
    Look look = model.Settings();
    look.Surfaces[0].Value += steps * model.StepOfValues();
    model.SetSettings(look);
    model.View.Renderer->ResetCameraClippingRange();
    model.View.Mapper->MakeImage(model.View.Renderer, volume, Size, Size, picture, nullptr);
  }
  if (!complaint.empty())
  {
    throw std::runtime_error("The mapper refused: " + complaint);
  }
}

}

void DrawInExplorer(const VolumeSource& source)
{
  Session session;
  session.Source = source;
  Draw(session);
}

void DrawSessionInExplorer(const std::string& path)
{
  Draw(ReadSession(path));
}
