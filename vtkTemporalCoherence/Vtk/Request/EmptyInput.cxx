// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Request/EmptyInput.h"

#include <vtkCompositeDataSet.h>
#include <vtkDataObjectTree.h>
#include <vtkDataSet.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkRectilinearGrid.h>

#include <algorithm>
#include <vector>

namespace TemporalCoherence
{
namespace
{

bool IsOfSeveralPieces(vtkDataObject* data)
{
  vtkInformation* about = data->GetInformation();
  return about->Has(vtkDataObject::DATA_NUMBER_OF_PIECES()) &&
    about->Get(vtkDataObject::DATA_NUMBER_OF_PIECES()) > 1;
}

bool IsImage(vtkDataObject* data)
{
  return vtkImageData::SafeDownCast(data) || vtkRectilinearGrid::SafeDownCast(data);
}

std::string CountText(vtkIdType count, const char* what)
{
  return std::to_string(count) + ' ' + what + (count == 1 ? "" : "s");
}

}

bool MayBeEmpty(vtkDataObject* data)
{
  if (auto* tree = vtkDataObjectTree::SafeDownCast(data))
  {
    const std::vector<vtkDataSet*> blocks = vtkCompositeDataSet::GetDataSets<vtkDataSet>(tree);
    return IsOfSeveralPieces(data) || std::any_of(blocks.begin(), blocks.end(), IsImage);
  }
  return IsOfSeveralPieces(data) || IsImage(data);
}

std::string WhyThereIsNoVolume(vtkDataObject* data)
{
  const vtkIdType points = data->GetNumberOfElements(vtkDataObject::POINT);
  const vtkIdType cells = data->GetNumberOfElements(vtkDataObject::CELL);
  if (cells > 0 && points > 0)
  {
    return "The input has no cells with volume, but " + CountText(cells, "cell") +
      " of less than three dimensions; draw its contours with vtkContourFilter and "
      "vtkPolyDataMapper.";
  }
  return "The input has no cells" +
    (points > 0 ? ", but " + CountText(points, "point") : std::string()) +
    "; see that its source has data, or hide the vtkVolume with VisibilityOff.";
}

}
