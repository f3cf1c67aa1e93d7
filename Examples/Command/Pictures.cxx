// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Pictures.h"

#include "Files/Reading.h"
#include "Model/Model.h"
#include "Model/Recorder.h"
#include "Options.h"
#include "Program/Quoted.h"
#include "Program/UserError.h"
#include "View/Picture.h"

#include <cmath>
#include <filesystem>

namespace
{

const char* const Remedy = "name another file with -o";

// By default the name of the volume, where the program runs.
std::string OutputOf(const Options& options)
{
  if (!options.Output.empty())
  {
    return options.Output;
  }
  const std::filesystem::path volume = options.Source.Path;
  const std::string stem =
    volume.has_filename() ? volume.stem().string() : volume.parent_path().filename().string();
  return (stem.empty() ? "spheres" : stem) + (options.Motion ? "-film" : ".png");
}

bool IsFilmFile(const std::string& path)
{
  return EndsWith(LowerCase(path), ".ogv");
}

bool IsSharedFile(const std::string& path)
{
  return EndsWith(path, ".html") || EndsWith(path, ".tcview") || EndsWith(path, ".cdb");
}

vtkSmartPointer<vtkImageData> PictureOf(Model& model, const Options& options)
{
  return model.View.Picture(
    options.Width, options.Height, [](double) { return true; },
    model.Settings().Values[Row::Transparency] == 0.0,
    static_cast<int>(std::lround(std::sqrt(options.Samples))));
}

// Whether the last picture shows anything.
bool IsAnythingSeen(Model& model)
{
  vtkNew<vtkImageData> frame;
  if (!model.View.Mapper->GetLastFrame(frame, vtkTemporalCoherenceVolumeMapper::FRAME_COLOR))
  {
    return true; // nothing is known of it
  }
  const auto* color = static_cast<const unsigned char*>(frame->GetScalarPointer());
  for (vtkIdType i = 0; i < frame->GetNumberOfPoints(); ++i)
  {
    if (color[4 * i + 3] != 0)
    {
      return true;
    }
  }
  return false;
}

std::string MakeFilm(Model& model, const Options& options)
{
  const std::string path = OutputOf(options);
  Recorder film("");
  film.Start(IsFilmFile(path) ? "ogv" : "png", path, options.Rate.value_or(25));
  ForEachFrame(model, model.Settings(), 0, *options.Motion, options.Frames.value_or(120),
    [&](int)
    {
      film.Add(PictureOf(model, options));
      return true;
    });
  return film.Stop();
}

}

void CheckOutput(const Options& options)
{
  const std::string path = options.Share.Path.empty() ? OutputOf(options) : options.Share.Path;
  const bool isFilm = options.Motion.has_value();
  if (!options.Share.Path.empty() && !IsSharedFile(path))
  {
    throw UserError(
      "--share takes a page that ends with .html, a view file that ends with .tcview, "
      "or a Cinema database that ends with .cdb, not " +
      Quoted(path) + ".");
  }
  if (options.Share.Path.empty() && !isFilm && !EndsWith(LowerCase(path), ".png"))
  {
    throw UserError(
      "A picture is a PNG file; give -o a name that ends with .png, not " + Quoted(path) + ".");
  }
  if (isFilm && !IsFilmFile(path) && std::filesystem::path(path).has_extension())
  {
    throw UserError("A film is a directory of pictures, or a file that ends with .ogv; " +
      Quoted(path) + " is neither.");
  }
  const std::filesystem::path directory = std::filesystem::path(path).parent_path();
  if (!directory.empty() && !std::filesystem::is_directory(directory))
  {
    throw UserError("There is no directory " + Quoted(directory.string()) + " for " + Quoted(path) +
      "; make it, or " + (options.Share.Path.empty() ? Remedy : "name another file with --share") +
      ".");
  }
}

std::string WritePictures(Model& model, const Options& options)
{
  if (!options.Share.Path.empty())
  {
    return ShareView(model.View, options.Share, [](double) { return true; });
  }
  if (options.Motion)
  {
    return MakeFilm(model, options);
  }
  const std::string path = OutputOf(options);
  const auto picture = PictureOf(model, options);
  WritePng(picture, path, Remedy);
  const std::string size =
    std::to_string(options.Width) + " x " + std::to_string(options.Height) + " pixels";
  return "Picture: " + Printable(path) + ", " + size +
    (IsAnythingSeen(model)
        ? ""
        : "\nNothing is seen in it: choose another isovalue or view; a preset in Hounsfield units "
          "may need --shift.");
}
