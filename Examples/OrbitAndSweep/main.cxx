// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
// Orbits around a volume's isosurface and sweeps its isovalue with
// vtkTemporalCoherenceVolumeMapper: pictures, and a table of what each kind of change took.
#include "Extraction.h"
#include "Files/Arrays.h"
#include "Files/Trial.h"
#include "Files/VolumeReader.h"
#include "Options.h"
#include "Pictures.h"
#include "Program/Quoted.h"
#include "Program/UserError.h"
#include "Report.h"
#include "Scene.h"
#include "Tour.h"
#include "View/Histogram.h"
#include "View/Isovalue.h"

#include <vtkSMPTools.h>

#include <cstdio>

namespace
{

void Describe(const Volume& volume, const IsovalueChoice& isovalue, const Options& options)
{
  std::printf("Volume: %s, %s, values %g to %g\n", volume.Name.c_str(),
    DescriptionOf(volume).c_str(), isovalue.Range[0], isovalue.Range[1]);
  std::printf("Isovalue: %g%s\n", isovalue.Value,
    isovalue.IsChosen ? " (chosen from the histogram; give one after the volume)" : "");
  std::printf("Pictures: %d x %d pixels, %d threads\n", options.Width, options.Height,
    vtkSMPTools::GetEstimatedNumberOfThreads());
}

void Run(const Options& options)
{
  Volume volume = ReadVolume(options.Source);
  ChooseArray(volume, options.Source.Array, options.Isovalue);
  const IsovalueChoice isovalue =
    ChooseIsovalue(CountSamples(volume), options.Isovalue, Quoted(volume.Name));
  Describe(volume, isovalue, options);
  if (!volume.Remark.empty())
  {
    std::printf("%s\n", volume.Remark.c_str());
  }
  Scene scene(volume, isovalue, options);
  PictureBook book(options.OutputDirectory);
  const std::vector<FrameRecord> records = RunTour(scene, isovalue, options, book);
  book.WriteContactSheet();
  const Extraction extraction = TimeExtraction(volume, isovalue.Value);

  PrintTable(records);
  PrintGain(records, extraction);
  PrintMemory(volume);
  std::printf("Pictures: %d in %s, all at a glance in %s\n", book.NumberOfPictures(),
    Printable(options.OutputDirectory).c_str(), Printable(book.ContactSheet()).c_str());
}

}

int main(int argc, char* argv[])
{
  BeginTrials();
  return RunProgram("OrbitAndSweep",
    [&]
    {
      const Options options = ParseOptions(argc, argv);
      if (options.Help)
      {
        std::fputs(HelpText().c_str(), stdout);
        return;
      }
      Run(options);
    });
}
