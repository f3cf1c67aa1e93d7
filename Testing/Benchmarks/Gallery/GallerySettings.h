// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Gallery_GallerySettings_h
#define Gallery_GallerySettings_h

#include "Report.h"
#include "Style.h"

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <set>
#include <string>
#include <vector>

/// A volume that a picture may show, and how.
struct Candidate
{
  std::string File; ///< as Volumes::Load takes it
  std::string Name; ///< for readers
  std::vector<double> Isovalues;
  Style::View View;
};

/// A candidate that was found.
struct Subject : Candidate
{
  vtkSmartPointer<vtkImageData> Image;
};

struct GallerySettings
{
  int Size = 1024;      ///< pixels in each direction of what is drawn; pictures are smaller
  int Frames = 15;      ///< of each kind, of which times are the median
  bool IsQuick = false; ///< small volumes made by formula only
  std::string Output;   ///< folder
  std::vector<std::string> Only;  ///< names of pictures; none: all
  std::set<std::string> Replaced; ///< what is shown in place of what, found so far
};

/// Print what is shown in place of volumes that are not there.
void PrintReplaced(const GallerySettings& settings);

/// True if the picture of that name is asked for.
bool IsWanted(const std::string& name, const GallerySettings& settings);

/// The first candidate that is there. The last is always: it is made by formula. That another one
/// takes the place of the first is noted in the settings.
Subject FirstOf(const std::vector<Candidate>& candidates, GallerySettings& settings);

/// An MR head of Debian's package mricron-data.
Candidate MrHead(const std::vector<double>& isovalues,
  const Style::View& view = { { -0.5, 1.0, 0.15 }, { 0.0, 0.0, 1.0 }, 1.35 });

/// The four spheres, for where no real volume is.
Candidate SpheresInstead(const std::vector<double>& isovalues);

/// The picture as a file of the gallery, and the text that shows it on a page.
std::string Hang(vtkImageData* picture, const std::string& name, const std::string& words,
  const GallerySettings& settings);

#endif
