// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Model/Film.h"

#include "Files/Reading.h"
#include "Program/Quoted.h"
#include "Program/Silence.h"
#include "Program/UserError.h"
#include "View/Picture.h"

#include <cstdio>

#ifdef EXAMPLES_HAVE_THEORA
#include <vtkOggTheoraWriter.h>
#endif

namespace fs = std::filesystem;

bool Film::IsFilmName(const fs::path& path)
{
  return LowerCase(path.extension().string()) == ".ogv";
}

bool Film::CanBeWritten()
{
#ifdef EXAMPLES_HAVE_THEORA
  return true;
#else
  return false;
#endif
}

Film::Film(const fs::path& path, int rate, const std::string& remedy)
  : Target(path)
  , Remedy(remedy)
{
  if (!IsFilmName(path))
  {
    std::error_code error;
    fs::create_directories(path, error); // without one, the first picture tells why
    return;
  }
#ifdef EXAMPLES_HAVE_THEORA
  const auto film = vtkSmartPointer<vtkOggTheoraWriter>::New();
  film->SetQuality(2);
  film->SetRate(rate);
  film->SetFileName(path.string().c_str());
  this->Writer = film;
#else
  static_cast<void>(rate);
  throw UserError("This VTK cannot write Ogg Theora films; choose png instead.");
#endif
}

void Film::Add(vtkImageData* picture)
{
  ++this->Pictures;
  if (!this->Writer)
  {
    char name[32];
    std::snprintf(name, sizeof(name), "frame-%04d.png", this->Pictures);
    WritePng(picture, (this->Target / name).string(), this->Remedy);
  }
#ifdef EXAMPLES_HAVE_THEORA
  if (auto* film = vtkOggTheoraWriter::SafeDownCast(this->Writer))
  {
    const Silence silence;
    film->SetInputData(picture);
    if (this->Pictures == 1)
    {
      film->Start();
    }
    film->Write();
    if (film->GetError() != 0 || silence.HeardErrors())
    {
      throw UserError("The film " + Quoted(this->Target.string()) +
        " could not be written; make room, or " + this->Remedy + ".");
    }
  }
#endif
}

void Film::End()
{
#ifdef EXAMPLES_HAVE_THEORA
  if (this->Writer && this->Pictures > 0)
  {
    const Silence silence;
    vtkOggTheoraWriter::SafeDownCast(this->Writer)->End();
  }
#endif
  this->Writer = nullptr;
}
