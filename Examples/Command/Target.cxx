// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Target.h"

#include "Files/Reading.h"
#include "Model/Film.h"
#include "Options.h"
#include "Program/Quoted.h"
#include "Program/UserError.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>

namespace
{

namespace fs = std::filesystem;

// The name of the volume without what says of which kind it is.
std::string StemOf(const Options& options)
{
  if (options.Source.Path.empty())
  {
    return "spheres";
  }
  std::error_code error;
  fs::path path = fs::weakly_canonical(options.Source.Path, error);
  path = path.has_filename() ? path : path.parent_path();
  if (fs::is_directory(path, error))
  {
    return path.filename().string();
  }
  path = LowerCase(path.extension().string()) == ".gz" ? path.stem() : path;
  return path.stem().string();
}

fs::path NameFor(const Options& options)
{
  const std::string stem = StemOf(options);
  const std::string end = !options.IsFilm() ? ".png" : Film::CanBeWritten() ? ".ogv" : "-film";
  return (stem.empty() ? "picture" : stem) + end;
}

void CheckFilm(const fs::path& target, const Options& options)
{
  const std::string suffix = LowerCase(target.extension().string());
  std::error_code error;
  if (Film::IsFilmName(target))
  {
    if (!Film::CanBeWritten())
    {
      throw UserError("This VTK cannot write films; name a directory with -o for the pictures.");
    }
    if (options.IsTransparent)
    {
      throw UserError("A film has no transparent background; choose a colour, or name a directory "
                      "with -o for the pictures.");
    }
    return;
  }
  if (!suffix.empty() && !fs::is_directory(target, error))
  {
    throw UserError("A film is written as .ogv, or as numbered pictures into a directory, not as " +
      Quoted(suffix) + "; name one of them with -o.");
  }
  if (options.Rate)
  {
    throw UserError(
      "--rate is that of a film .ogv, and numbered pictures have none; leave it out.");
  }
  if (fs::equivalent(target, options.Source.Path, error))
  {
    throw UserError("The pictures would lie among the files of the volume; name another directory "
                    "with -o.");
  }
}

void CheckPicture(const fs::path& target)
{
  std::error_code error;
  const std::string suffix = LowerCase(target.extension().string());
  if (fs::is_directory(target, error))
  {
    throw UserError(
      Quoted(target.string()) + " is a directory; name a file with -o, for example picture.png.");
  }
  if (suffix != ".png")
  {
    throw UserError("A picture is written as .png, not as " +
      (suffix.empty() ? Quoted(target.string()) : Quoted(suffix)) + "; change the name after -o.");
  }
}

// What could not be written later is told now. Leaves nothing that was not there.
void TryToWrite(const fs::path& file)
{
  std::error_code error;
  const bool wasThere = fs::exists(file, error);
  errno = 0;
  if (!std::ofstream(file, std::ios::app))
  {
    const std::string reason = errno ? std::strerror(errno) : "it cannot be opened";
    throw UserError(
      Quoted(file.string()) + " cannot be written (" + reason + "); " + OutputRemedy + ".");
  }
  if (!wasThere)
  {
    fs::remove(file, error);
  }
}

}

fs::path TargetOf(const Options& options)
{
  const fs::path target = options.Output.empty() ? NameFor(options) : fs::path(options.Output);
  options.IsFilm() ? CheckFilm(target, options) : CheckPicture(target);
  if (!options.IsFilm() || Film::IsFilmName(target))
  {
    TryToWrite(target);
    return target;
  }
  std::error_code error;
  const bool wasThere = fs::exists(target, error);
  fs::create_directories(target, error);
  TryToWrite(target / "frame-0001.png");
  if (!wasThere)
  {
    fs::remove(target, error);
  }
  return target;
}

std::string SizeForPeople(const fs::path& target)
{
  std::error_code error;
  double bytes = 0.0;
  if (fs::is_directory(target, error))
  {
    for (const fs::directory_entry& entry : fs::directory_iterator(target, error))
    {
      bytes += entry.is_regular_file(error) ? static_cast<double>(entry.file_size(error)) : 0.0;
    }
  }
  else
  {
    bytes = static_cast<double>(fs::file_size(target, error));
  }
  char text[32];
  const char* const format = bytes < 1e3 ? "%.0f bytes" : bytes < 1e6 ? "%.0f kB" : "%.1f MB";
  std::snprintf(text, sizeof(text), format, bytes / (bytes < 1e3 ? 1.0 : bytes < 1e6 ? 1e3 : 1e6));
  return text;
}
