// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// What the Workbench writes and says.
#include "Program/Quoted.h"
#include "Program/UserError.h"
#include "View/Picture.h"
#include "Work/Workbench.h"

#include <cstdio>
#include <exception>

void Workbench::SaveSession(const std::string& path)
{
  this->Try(
    [&]
    {
      this->Data.Save(path);
      this->SessionFile = path;
      this->RenderSoon();
      this->Say("Saved " + path);
    });
}

// Without a path it is counted up, without a size it is that of the view, as often as chosen.
void Workbench::SavePicture(const std::string& path, int width, int height)
{
  this->Try(
    [&]
    {
      if (this->Builds)
      {
        throw UserError("The isomap is being built; wait for it, or stop it with Escape.");
      }
      const Look& look = this->Data.Settings();
      const int scale = std::stoi(look.Choices.TextOf(Choose::Scale));
      const int* size = this->Data.View.Renderer->GetSize();
      this->Render();
      vtkSmartPointer<vtkImageData> picture;
      if (width <= 0 && scale == 1)
      {
        picture = this->Data.View.LastFrame();
      }
      else
      {
        picture = this->Data.View.Picture(
          width > 0 ? width : scale * size[0], width > 0 ? height : scale * size[1]);
      }
      if (!path.empty())
      {
        WritePng(picture, path, "name another file");
      }
      this->Say("Saved " + (path.empty() ? this->Output.Save(picture) : path));
    });
}

void Workbench::ToggleRecording()
{
  this->Try(
    [this]
    {
      if (this->Output.IsRecording())
      {
        this->Say(this->Output.Stop());
      }
      else
      {
        this->Output.Start(this->Data.Settings().Choices.TextOf(Choose::Film));
        this->Say("Recording every frame");
      }
    });
  emit this->Changed();
}

void Workbench::Say(const std::string& said, bool isWarning)
{
  const std::string sentence = Printable(said);
  if (!sentence.empty())
  {
    this->Log.Said(sentence);
    std::fprintf(
      isWarning ? stderr : stdout, "%s%s\n", isWarning ? "Explorer: " : "", sentence.c_str());
    std::fflush(stdout);
  }
  emit this->Said(QString::fromStdString(sentence), isWarning);
}

void Workbench::Try(const std::function<void()>& action)
{
  try
  {
    action();
  }
  catch (const std::exception& failure)
  {
    if (this->Refused && !this->IsStopped)
    {
      this->Refused(SentenceOf(failure));
      return;
    }
    this->Say(SentenceOf(failure), true);
  }
}
