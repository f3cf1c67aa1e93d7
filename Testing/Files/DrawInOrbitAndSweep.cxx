// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Draw.h"

#include "Extraction.h"
#include "Files/VolumeReader.h"
#include "Options.h"
#include "Program/Quoted.h"
#include "Program/UserError.h"
#include "Scene.h"
#include "View/Histogram.h"
#include "View/Isovalue.h"

#include <vtkImageData.h>

namespace
{

constexpr int Size = 40; // pixels of a side

}

void DrawInOrbitAndSweep(const VolumeSource& source)
{
  const Options options;
  const Volume volume = ReadVolume(source);
  const IsovalueChoice isovalue = ChooseIsovalue(CountSamples(volume), {}, Quoted(volume.Name));
  Scene scene(volume, isovalue, options);
  vtkNew<vtkImageData> picture;
  for (const double degrees : { 0.0, 2.0 })
  {
    scene.SetAzimuth(degrees);
    if (!scene.Mapper->MakeImage(scene.Renderer, scene.Actor, Size, Size, picture, nullptr))
    {
      throw UserError("The mapper could not draw the volume; its message above says what to do.");
    }
  }
  TimeExtraction(volume, isovalue.Value);
}
