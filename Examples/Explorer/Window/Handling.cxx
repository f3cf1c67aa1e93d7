// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// What ExplorerWindow does with mouse, keys and dropped files.
#include "Window/ExplorerWindow.h"

#include <vtkCallbackCommand.h>

#include <cctype>
#include <map>

namespace
{

template <void (ExplorerWindow::*Method)()>
void Call(vtkObject*, unsigned long, void* window, void*)
{
  (static_cast<ExplorerWindow*>(window)->*Method)();
}

// The last line of a message of VTK's, which is the sentence itself.
std::string SentenceOfVtk(const char* message)
{
  const std::string text = message ? message : "";
  const std::size_t begin = text.find("): ");
  const std::string sentence = begin == std::string::npos ? text : text.substr(begin + 3);
  return sentence.substr(0, sentence.find_last_not_of("\n ") + 1);
}

}

void ExplorerWindow::ObserveFrames()
{
  const auto observe = [this](vtkObject* subject, unsigned long event,
                         void (*callback)(vtkObject*, unsigned long, void*, void*))
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(this);
    command->SetCallback(callback);
    subject->AddObserver(event, command);
  };
  observe(this->Shown, vtkCommand::StartEvent, Call<&ExplorerWindow::OnFrameBegin>);
  observe(this->Shown, vtkCommand::EndEvent, Call<&ExplorerWindow::OnFrameEnd>);
  // The panels are drawn after the view: they tell of the very frame they stand in.
  observe(this->Data.View.Renderer, vtkCommand::EndEvent,
    [](vtkObject*, unsigned long, void* window, void*)
    {
      auto* self = static_cast<ExplorerWindow*>(window);
      self->Parts.Statistics.SetFacts(self->Data.View.Facts());
    });
  // With an observer, VTK writes nothing on the terminal itself.
  for (const unsigned long event : { vtkCommand::ErrorEvent, vtkCommand::WarningEvent })
  {
    observe(this->Data.View.Mapper, event,
      [](vtkObject*, unsigned long, void* window, void* message)
      {
        static_cast<ExplorerWindow*>(window)->Say(
          SentenceOfVtk(static_cast<const char*>(message)), true);
      });
  }
}

Hands::Grip ExplorerWindow::Press(int x, int y, bool isRight)
{
  this->Parts.ClearMessage();
  if (this->Parts.Files.IsVisible())
  {
    if (!this->Parts.Files.Contains(x, y))
    {
      this->ToggleFiles();
      return Grip::Done;
    }
    std::optional<FileList::Entry> chosen;
    this->Try([&] { chosen = this->Parts.Files.Click(x, y); });
    if (chosen)
    {
      this->OpenPath(chosen->Path.string());
    }
    return Grip::Done;
  }
  if (this->Parts.Help.IsVisible())
  {
    this->ToggleHelp();
    return Grip::Done;
  }
  if (this->Parts.Isovalue.Contains(x, y))
  {
    this->PrepareDrag();
    this->SetIsovalueAt(x);
    return Grip::Held;
  }
  const SwitchBar::Target target = this->Parts.Switches.At(x, y);
  if (target.Turned)
  {
    this->Turn(*target.Turned, isRight ? -1 : 1);
  }
  if (target.Done)
  {
    this->Perform(*target.Done);
  }
  const bool isPanel = this->Parts.Switches.Contains(x, y) || this->Parts.Statistics.Contains(x, y);
  return isPanel ? Grip::Done : Grip::None;
}

void ExplorerWindow::Drag(int x, int)
{
  this->SetIsovalueAt(x);
}

bool ExplorerWindow::Wheel(int x, int y, int turns)
{
  if (this->Parts.Files.Contains(x, y))
  {
    this->Parts.Files.Scroll(-3 * turns);
    this->Render();
    return true;
  }
  if (this->Parts.Isovalue.Contains(x, y))
  {
    this->Try([&] { this->Data.StepIsovalue(turns); });
    return true;
  }
  return this->Parts.Switches.Contains(x, y) || this->Parts.Statistics.Contains(x, y);
}

void ExplorerWindow::KeyInList(const std::string& name)
{
  if (name == "Escape" || name == "o")
  {
    this->ToggleFiles();
    return;
  }
  std::optional<FileList::Entry> chosen;
  this->Try([&] { chosen = this->Parts.Files.Key(name); });
  if (chosen)
  {
    this->OpenPath(chosen->Path.string());
  }
}

void ExplorerWindow::Key(const std::string& name, char character, bool hasShift)
{
  // What was done by hand before has been dealt with: scripts may go on.
  this->Log.Event(this->Busy ? "key-while-busy" : "key", name);
  if (this->Busy)
  {
    this->IsStopped = this->IsStopped || name == "Escape";
    return;
  }
  if (name.compare(0, 5, "Shift") == 0)
  {
    return; // of "?", say: not a key of its own
  }
  const bool hadMessage = this->Parts.Message.HasMessage();
  this->Parts.ClearMessage();
  if (hadMessage && character == 'S')
  {
    this->Render(); // it is not to be in the picture
  }
  if (this->Parts.Files.IsVisible())
  {
    this->KeyInList(name);
    return;
  }
  static const std::map<std::string, int> steps = { { "Left", -1 }, { "Right", 1 }, { "Down", -1 },
    { "Up", 1 } };
  if (steps.count(name) == 1)
  {
    this->Try([&] { this->Data.StepIsovalue((hasShift ? 10 : 1) * steps.at(name)); });
    return;
  }
  if (name == "Escape" && this->Parts.Help.IsVisible())
  {
    this->ToggleHelp();
    return;
  }
  for (const Choice& choice : AllChoices())
  {
    if (choice.Key == std::tolower(static_cast<unsigned char>(character)) &&
      this->Data.Offers(choice))
    {
      this->Turn(choice.What, std::isupper(static_cast<unsigned char>(character)) ? -1 : 1);
      return;
    }
  }
  for (const Action& action : AllActions())
  {
    if (action.Key == character)
    {
      this->Perform(action.What);
      return;
    }
  }
  this->Render(); // without the message
}

void ExplorerWindow::Drop(const std::vector<std::string>& paths)
{
  if (!paths.empty())
  {
    this->OpenPath(paths.front());
  }
}

void ExplorerWindow::ToggleHelp()
{
  this->Parts.Help.SetVisible(!this->Parts.Help.IsVisible());
  this->Log.Event("help", this->Parts.Help.IsVisible() ? "on" : "off");
  this->Render();
}

void ExplorerWindow::ToggleFiles()
{
  this->Parts.Help.SetVisible(false);
  this->Try(
    [this]
    {
      if (this->Parts.Files.IsVisible())
      {
        this->Parts.Files.SetVisible(false);
      }
      else
      {
        this->Parts.Files.Open();
        this->Parts.Files.ForEachPlace(
          [this](const std::string& name, int x, int y) { this->Log.Place(name, x, y); });
      }
    });
  this->Log.Event("files", this->Parts.Files.IsVisible() ? "on" : "off");
}

void ExplorerWindow::Perform(Do action)
{
  switch (action)
  {
    case Do::Open:
      this->ToggleFiles();
      break;
    case Do::BuildIsomap:
      this->Try([this] { this->BuildIsomap(); });
      break;
    case Do::Picture:
      this->Try([this] { this->SavePicture(); });
      break;
    case Do::WindowPicture:
      this->Try([this] { this->Say("Saved " + this->Output.Save(this->PictureOfWindow())); });
      break;
    case Do::Record:
      this->Try([this] { this->ToggleRecording(); });
      break;
    case Do::Save:
      this->Try(
        [this]
        {
          this->Data.Save(this->SessionFile);
          this->Say("Saved " + this->SessionFile);
        });
      break;
    case Do::Restore:
      this->Try([this] { this->Open(ReadSession(this->SessionFile)); });
      break;
    case Do::ResetView:
      this->Try([this] { this->Data.ResetView(); });
      break;
    case Do::NextArray:
      this->ShowOther([this] { this->Data.TurnArray(); });
      break;
    case Do::EarlierStep:
      this->ShowOther([this] { this->Data.TurnTimeStep(-1); });
      break;
    case Do::LaterStep:
      this->ShowOther([this] { this->Data.TurnTimeStep(1); });
      break;
    case Do::Help:
      this->ToggleHelp();
      break;
    case Do::Quit:
      this->Log.Event("quit", "");
      this->Events->ExitCallback();
      break;
  }
}
