// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_Figures_h
#define Benchmarks_Figures_h

#include "Report.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

/// The paper's figures, measured again. Each function prints its numbers as a table, adds them to
/// the report and writes its files into the output folder.
namespace Figures
{

/// A volume that figures show.
struct Subject
{
  std::string Name;
  vtkSmartPointer<vtkImageData> Image;
  double Isovalue = 0.0;
};

struct Settings
{
  int Size = 1024; ///< pixels of a picture in each direction
  int Frames = 20; ///< of which figure 5 shows the average
  int DriftFrames = 720;
  int Largest = 512;  ///< samples a side where growth ends
  std::string Output; ///< folder
  std::vector<Subject> Subjects;
};

/// The volumes of the paper: brain, the brain doubled, engine and four spheres; those that are not
/// there are left out.
std::vector<Subject> LoadSubjects();

/// Figure 5: the average time of a frame with the latest image as cache and without.
void AverageTimes(const Settings& settings, JsonWriter& json);

/// Figure 6: frame by frame, with a key image every seven frames.
void KeyImageTimes(const Settings& settings, JsonWriter& json);

/// Figure 8: pictures used as cache, and the next ones with the rays the cache did not serve in
/// yellow.
void AnswersInColor(const Settings& settings, JsonWriter& json);

/// How far pictures part from the cold ones over many frames: what the paper could not measure.
void DriftOverTime(const Settings& settings, JsonWriter& json);

}

#endif
