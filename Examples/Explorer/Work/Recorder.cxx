// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Work/Recorder.h"

#include "Program/Quoted.h"
#include "Program/Silence.h"
#include "Program/UserError.h"
#include "View/Picture.h"

#include <cstdio>
#include <filesystem>

#ifdef EXPLORER_HAS_THEORA
#include <vtkNew.h>
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

struct Recorder::Writer
{
  fs::path Path;
  virtual ~Writer() = default;
  virtual void Write(vtkImageData* picture, int frame) = 0;
};

struct Recorder::PngWriter : Recorder::Writer
{
  void Write(vtkImageData* picture, int frame) override
  {
    WritePng(picture, (this->Path / Numbered("frame-", frame, ".png")).string(), Remedy);
  }
};

#ifdef EXPLORER_HAS_THEORA
struct Recorder::FilmWriter : Recorder::Writer
{
  FilmWriter()
  {
    this->Film->SetQuality(2);
    this->Film->SetRate(25);
  }
  ~FilmWriter() override
  {
    if (this->IsStarted)
    {
      const Silence silence;
      this->Film->End();
    }
  }
  void Write(vtkImageData* picture, int) override
  {
    const Silence silence;
    this->Film->SetInputData(picture);
    if (!this->IsStarted)
    {
      this->Film->SetFileName(this->Path.string().c_str());
      this->Film->Start();
      this->IsStarted = true;
    }
    this->Film->Write();
    if (this->Film->GetError() != 0 || silence.HeardErrors())
    {
      throw UserError("The film " + Quoted(this->Path.string()) +
        " could not be written; make room, or " + Remedy + ".");
    }
  }

  vtkNew<vtkOggTheoraWriter> Film;
  bool IsStarted = false;
};
#endif

Recorder::Recorder(const std::string& directory)
  : Directory(directory)
{
}

Recorder::~Recorder() = default;

std::string Recorder::Save(vtkImageData* picture)
{
  const std::string path = FirstFree(this->Directory, "explorer-", ".png").string();
  WritePng(picture, path, Remedy);
  return path;
}

void Recorder::Start(const std::string& format)
{
  this->Frames = 0;
  if (format == "png")
  {
    this->Target = std::make_unique<PngWriter>();
    this->Target->Path = FirstFree(this->Directory, "recording-", "");
    std::error_code error;
    fs::create_directories(this->Target->Path, error);
    return;
  }
#ifdef EXPLORER_HAS_THEORA
  this->Target = std::make_unique<FilmWriter>();
  this->Target->Path = FirstFree(this->Directory, "recording-", ".ogv");
#else
  throw UserError("This VTK cannot write Ogg Theora films; choose png for Film instead.");
#endif
}

void Recorder::Add(vtkImageData* picture)
{
  this->Target->Write(picture, ++this->Frames);
}

std::string Recorder::Stop()
{
  const std::string path = this->Target->Path.string();
  this->Target.reset();
  return "Recorded " + std::to_string(this->Frames) + " frames: " + path;
}
