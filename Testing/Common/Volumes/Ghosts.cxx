// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Volumes/Ghosts.h"

#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <random>

namespace Ghosts
{
namespace
{

using Attributes = vtkDataSetAttributes;

/// Give points or cells a ghost array.
void AddGhosts(vtkDataSetAttributes* attributes, const int count[3], const ChooseFlag& flag)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(Attributes::GhostArrayName());
  for (int k = 0; k < count[2]; ++k)
  {
    for (int j = 0; j < count[1]; ++j)
    {
      for (int i = 0; i < count[0]; ++i)
      {
        ghosts->InsertNextValue(static_cast<unsigned char>(flag(i, j, k)));
      }
    }
  }
  attributes->AddArray(ghosts);
}

}

void FlagCells(vtkImageData* image, const ChooseFlag& flag)
{
  int count[3];
  image->GetDimensions(count);
  std::for_each(count, count + 3, [](int& n) { --n; });
  AddGhosts(image->GetCellData(), count, flag);
}

void FlagPoints(vtkImageData* image, const ChooseFlag& flag)
{
  AddGhosts(image->GetPointData(), image->GetDimensions(), flag);
}

void HideCells(vtkImageData* image, double chance, unsigned seed)
{
  std::mt19937 engine(seed);
  const int hiding[] = { Attributes::HIDDENCELL, Attributes::REFINEDCELL,
    Attributes::DUPLICATECELL };
  const int others[] = { Attributes::HIGHCONNECTIVITYCELL, Attributes::LOWCONNECTIVITYCELL,
    Attributes::EXTERIORCELL, 0 };
  FlagCells(image,
    [&](int, int, int)
    {
      const bool isHidden = static_cast<double>(engine() % 1000u) < 1000.0 * chance;
      return others[engine() % 4u] | (isHidden ? hiding[engine() % 3u] : 0);
    });
}

void HidePoints(vtkImageData* image, double chance, unsigned seed)
{
  std::mt19937 engine(seed);
  FlagPoints(image,
    [&](int, int, int)
    {
      const bool isHidden = static_cast<double>(engine() % 1000u) < 1000.0 * chance;
      const bool isDuplicate = engine() % 2u == 0;
      return (isHidden ? Attributes::HIDDENPOINT : 0) |
        (isDuplicate ? Attributes::DUPLICATEPOINT : 0);
    });
}

void AddFlags(vtkDataSetAttributes* attributes, vtkIdType count)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(Attributes::GhostArrayName());
  ghosts->SetNumberOfTuples(count);
  ghosts->FillValue(0);
  attributes->AddArray(ghosts);
}

void Remove(vtkImageData* image)
{
  image->GetCellData()->RemoveArray(Attributes::GhostArrayName());
  image->GetPointData()->RemoveArray(Attributes::GhostArrayName());
}

}
