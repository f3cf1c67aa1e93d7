// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GallerySettings.h"

#include "PngFile.h"
#include "Stage.h"

#include <algorithm>
#include <iostream>

bool IsWanted(const std::string& name, const GallerySettings& settings)
{
  return settings.Only.empty() ||
    std::find(settings.Only.begin(), settings.Only.end(), name) != settings.Only.end();
}

Subject FirstOf(const std::vector<Candidate>& candidates, GallerySettings& settings)
{
  Subject subject;
  for (const Candidate& candidate : candidates)
  {
    if (!settings.IsQuick || &candidate == &candidates.back())
    {
      static_cast<Candidate&>(subject) = candidate;
      subject.Image = LoadOrTell(candidate.File);
    }
    if (subject.Image)
    {
      break;
    }
  }
  const std::string& wanted = candidates.front().Name;
  if (subject.Name != wanted)
  {
    settings.Replaced.insert(subject.Name + " in place of " + wanted);
  }
  return subject;
}

void PrintReplaced(const GallerySettings& settings)
{
  const PagePart part("volumes");
  for (const std::string& text : settings.Replaced)
  {
    std::cout << "* " << text << '\n';
  }
  if (settings.Replaced.empty())
  {
    std::cout << "All volumes were there.\n";
  }
}

Candidate MrHead(const std::vector<double>& isovalues, const Style::View& view)
{
  return { "ch2.nii.gz", "MR head 181x217x181", isovalues, view };
}

Candidate SpheresInstead(const std::vector<double>& isovalues)
{
  Candidate spheres;
  spheres.File = "spheres128";
  spheres.Name = "four spheres 128^3";
  spheres.Isovalues = isovalues;
  return spheres;
}

std::string Hang(vtkImageData* picture, const std::string& name, const std::string& words,
  const GallerySettings& settings)
{
  const std::string file = "gallery-" + name + ".png";
  WritePng(picture, settings.Output + "/" + file);
  return "![" + words + "](Pictures/" + file + ")";
}
