// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Model/Recorder.h"

#include "Program/Quoted.h"
#include "Program/Silence.h"
#include "Program/UserError.h"
#include "View/Picture.h"

#include <cstdio>
#include <utility>

#ifdef EXAMPLES_HAVE_THEORA
#include <vtkOggTheoraWriter.h>
#endif

namespace
{

namespace fs = std::filesystem;

const char* const Remedy = "name another directory with --output";

std::string Numbered(const std::string& before, int number, const std::string& after)
{
  char digits[16];
  std::snprintf(digits, sizeof(digits), "%04d", number);
  return before + digits + after;
}

fs::path FirstFree(const fs::path& directory, const std::string& before, const std::string& after)
{
  std::error_code error;
  fs::create_directories(directory, error);
  int number = 1;
  while (fs::exists(directory / Numbered(before, number, after), error))
  {
    ++number;
  }
  return (directory / Numbered(before, number, after)).lexically_normal();
}

}

Recorder::Recorder(const std::string& directory)
  : Directory(directory)
{
}

std::string Recorder::NextPath() const
{
  return FirstFree(this->Directory, "explorer-", ".png").string();
}

std::string Recorder::Save(vtkImageData* picture)
{
  const std::string path = this->NextPath();
  WritePng(picture, path, Remedy);
  return path;
}

void Recorder::Start(const std::string& format, const std::string& path, [[maybe_unused]] int rate)
{
  this->Frames = 0;
  if (format == "png")
  {
    this->Target = path.empty() ? FirstFree(this->Directory, "recording-", "") : fs::path(path);
    std::error_code error;
    fs::create_directories(this->Target, error);
    return;
  }
#ifdef EXAMPLES_HAVE_THEORA
  this->Target = path.empty() ? FirstFree(this->Directory, "recording-", ".ogv") : fs::path(path);
  const auto film = vtkSmartPointer<vtkOggTheoraWriter>::New();
  film->SetQuality(2);
  film->SetRate(rate);
  film->SetFileName(this->Target.string().c_str());
  this->Film = film;
#else
  throw UserError("This VTK cannot write Ogg Theora films; choose png for Recording instead.");
#endif
}

void Recorder::Add(vtkImageData* picture)
{
  const fs::path target = std::exchange(this->Target, {}); // a recording that fails ends
  ++this->Frames;
  if (!this->Film)
  {
    WritePng(picture, (target / Numbered("frame-", this->Frames, ".png")).string(), Remedy);
  }
#ifdef EXAMPLES_HAVE_THEORA
  if (auto* film = vtkOggTheoraWriter::SafeDownCast(this->Film))
  {
    const Silence silence;
    film->SetInputData(picture);
    if (this->Frames == 1)
    {
      film->Start();
    }
    film->Write();
    if (film->GetError() != 0 || silence.HeardErrors())
    {
      throw UserError("The film " + Quoted(target.string()) +
        " could not be written; make room, or " + Remedy + ".");
    }
  }
#endif
  this->Target = target;
}

std::string Recorder::Stop()
{
#ifdef EXAMPLES_HAVE_THEORA
  if (this->Film && this->Frames > 0)
  {
    const Silence silence;
    vtkOggTheoraWriter::SafeDownCast(this->Film)->End();
  }
#endif
  this->Film = nullptr;
  return "Recorded " + std::to_string(this->Frames) +
    " frames: " + std::exchange(this->Target, {}).string();
}
