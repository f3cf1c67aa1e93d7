// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_Figures_h
#define Benchmarks_Figures_h

#include "Report.h"
#include "Style.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class Stage;

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
  Style::View View;       ///< of pictures; times are taken from the view of Stage
  bool IsPictured = true; ///< false if it looks like another one
};

struct Settings
{
  int Size = 1024;    ///< pixels of a picture in each direction
  int Frames = 20;    ///< of which figure 5 shows the average
  std::string Output; ///< folder
  std::vector<Subject> Subjects;
};

/// Light a stage, show the subject as a picture does, and fill the picture with it.
void SetUp(Stage& stage, const Subject& subject, const Style::Color& color);

/// The volumes of the paper: brain, the brain doubled, engine and four spheres; those that are not
/// there are left out.
/// \param onlySmall just small spheres, to see that all works
std::vector<Subject> LoadSubjects(bool onlySmall);

/// Figure 5: the average time of a frame with the latest image as cache and without; and beside
/// the paper's own numbers.
void AverageTimes(const Settings& settings, JsonWriter& json);

/// Figure 6: frame by frame, with a key image every seven frames.
void KeyImageTimes(const Settings& settings, JsonWriter& json);

/// Figure 8: pictures used as cache, and the next ones with the rays the cache did not serve in
/// yellow.
void AnswersInColor(const Settings& settings, JsonWriter& json);

}

#endif
