// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Panels/Desk.h"

#include "Model/Model.h"
#include "Panels/Layout.h"

#include <vtkCallbackCommand.h>
#include <vtkRenderWindow.h>

namespace
{

void OnStart(vtkObject*, unsigned long, void* desk, void*)
{
  static_cast<Desk*>(desk)->Refresh();
}

}

Desk::Desk(vtkRenderWindow* window, Model& model)
  : Isovalue(this->Layer, model)
  , Statistics(this->Layer)
  , Switches(this->Layer, model)
  , Message(this->Layer)
  , Help(this->Layer)
  , Files(this->Layer)
  , Progress(this->Layer)
  , Window(window)
  , Shown(model)
{
  this->Window->SetNumberOfLayers(2);
  this->Window->AddRenderer(model.View.Renderer);
  this->Layer->SetLayer(1);
  this->Layer->InteractiveOff();
  this->Layer->EraseOff();
  this->Layer->PreserveDepthBufferOn(); // nothing on it has a depth
  this->Window->AddRenderer(this->Layer);
  vtkNew<vtkCallbackCommand> onStart;
  onStart->SetClientData(this);
  onStart->SetCallback(OnStart);
  this->Layer->AddObserver(vtkCommand::StartEvent, onStart);
  for (Panel* panel : { static_cast<Panel*>(&this->Message), static_cast<Panel*>(&this->Help),
         static_cast<Panel*>(&this->Files), static_cast<Panel*>(&this->Progress) })
  {
    panel->SetVisible(false);
    panel->SetLiesOnView();
  }
}

std::array<Panel*, 7> Desk::All()
{
  return { &this->Isovalue, &this->Statistics, &this->Switches, &this->Message, &this->Help,
    &this->Files, &this->Progress };
}

bool Desk::Arrange()
{
  const int* size = this->Window->GetSize();
  if (size[0] == this->Size[0] && size[1] == this->Size[1])
  {
    return false;
  }
  this->Size = { size[0], size[1] };
  const Layout layout(size[0], size[1]);
  this->Isovalue.Place(layout.Isovalue, size[1]);
  this->Statistics.Place(layout.Statistics, size[1]);
  this->Switches.SetRowHeight(layout.RowHeight);
  this->Switches.Place(layout.Switches, size[1]);
  this->Help.Place(layout.List, size[1]);
  this->Files.Place(layout.List, size[1]);
  this->Progress.Place(layout.Progress, size[1]);
  this->Message.Fit(layout.Message, size[1]);
  const Rect& view = layout.View;
  this->Shown.View.Renderer->SetViewport(static_cast<double>(view.X) / size[0],
    static_cast<double>(size[1] - view.Bottom()) / size[1],
    static_cast<double>(view.Right()) / size[0], static_cast<double>(size[1] - view.Y) / size[1]);
  return true;
}

void Desk::Refresh()
{
  for (Panel* panel : this->All())
  {
    panel->Refresh();
  }
}

void Desk::Invalidate()
{
  for (Panel* panel : this->All())
  {
    panel->Invalidate();
  }
}

void Desk::Say(const std::string& sentence, bool isWarning)
{
  this->Message.Say(sentence, isWarning);
  this->Message.SetVisible(true);
  const int* size = this->Window->GetSize();
  this->Message.Fit(Layout(size[0], size[1]).Message, size[1]);
}

void Desk::ClearMessage()
{
  this->Message.Clear();
}
