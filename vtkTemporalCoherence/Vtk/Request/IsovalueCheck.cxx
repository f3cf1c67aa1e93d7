// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Request/IsovalueCheck.h"

#include "Input/GhostArray.h"

#include <vtkAlgorithm.h>
#include <vtkCellData.h>
#include <vtkCompositeDataSet.h>
#include <vtkContourValues.h>
#include <vtkDataObjectTree.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkDataSet.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkPointData.h>
#include <vtkRectilinearGrid.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkVolume.h>
#include <vtkVolumeCollection.h>
#include <vtkVolumeMapper.h>

#include <algorithm>
#include <exception>
#include <iomanip>
#include <limits>
#include <sstream>

namespace TemporalCoherence
{
namespace
{

bool HasFlag(vtkUnsignedCharArray* ghosts, int flag)
{
  return ghosts &&
    std::any_of(ghosts->GetPointer(0), ghosts->GetPointer(ghosts->GetNumberOfValues()),
      [=](unsigned char value) { return (value & flag) != 0; });
}

/// True if a data object is marked as one of several.
bool IsPiece(vtkDataObject* data)
{
  auto* dataSet = vtkDataSet::SafeDownCast(data);
  return dataSet &&
    (HasFlag(GhostsOf(dataSet->GetCellData()), vtkDataSetAttributes::DUPLICATECELL) ||
      HasFlag(GhostsOf(dataSet->GetPointData()), vtkDataSetAttributes::DUPLICATEPOINT));
}

/// True if blocks of a tree are missing, or are marked as some of several.
bool HasPieces(vtkDataObjectTree* tree)
{
  const auto leaf = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
  leaf->SkipEmptyNodesOff();
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    vtkDataObject* block = leaf->GetCurrentDataObject();
    if (!block || IsPiece(block))
    {
      return true;
    }
  }
  return false;
}

/// True if the pipeline has more data than this image or grid.
bool IsPartOfPipeline(vtkInformation* pipeline, vtkDataObject* data)
{
  using Keys = vtkStreamingDemandDrivenPipeline;
  auto* image = vtkImageData::SafeDownCast(data);
  auto* grid = vtkRectilinearGrid::SafeDownCast(data);
  if (!pipeline->Has(Keys::WHOLE_EXTENT()) || (!image && !grid))
  {
    return false;
  }
  const int* extent = image ? image->GetExtent() : grid->GetExtent();
  const int* whole = pipeline->Get(Keys::WHOLE_EXTENT());
  for (int axis = 0; axis < 3; ++axis)
  {
    if (extent[2 * axis] > whole[2 * axis] || extent[2 * axis + 1] < whole[2 * axis + 1])
    {
      return true;
    }
  }
  return false;
}

bool IsPropertyShared(vtkVolume* volume, vtkRenderer* renderer)
{
  vtkVolumeCollection* const volumes = renderer->GetVolumes();
  vtkCollectionSimpleIterator at;
  volumes->InitTraversal(at);
  while (vtkVolume* other = volumes->GetNextVolume(at))
  {
    if (other != volume && other->GetProperty() == volume->GetProperty())
    {
      return true;
    }
  }
  return false;
}

/// All isovalues of a list. Those with opacity 0 are mistakes, too, if no sample can meet any.
/// VTK's default 0 is one if the opacity function was made for another blend mode.
std::vector<double> ValuesOf(vtkContourValues* list)
{
  std::vector<double> isovalues;
  for (int i = 0; i < list->GetNumberOfContours(); ++i)
  {
    isovalues.push_back(list->GetValue(i));
  }
  return isovalues;
}

/// True if there can be a surface: some samples are inside and others are not.
bool IsMet(double isovalue, SurfaceMode mode, const glm::dvec2& range)
{
  // If all samples are inside a THRESHOLD solid, its caps are visible.
  return isovalue <= range.y && (isovalue > range.x || mode == SurfaceMode::Threshold);
}

bool AreMet(const std::vector<double>& isovalues, SurfaceMode mode, const glm::dvec2& range)
{
  return std::any_of(isovalues.begin(), isovalues.end(),
    [&](double isovalue) { return IsMet(isovalue, mode, range); });
}

/// Why isovalues separate no samples, and what to do: the end of a message.
void Explain(const ValueRangePyramid& ranges, std::ostringstream& what)
{
  const glm::dvec2 &finite = ranges.FiniteRange(), &all = ranges.WholeRange();
  if (all.x == all.y)
  {
    what << "all of them are " << all.x
         << ", so there is no isosurface; see whether this is the array that you want, which the "
            "mapper's SelectScalarArray chooses.";
    return;
  }
  const glm::dvec2& range = finite.x < finite.y ? finite : all;
  what << "they range from " << range.x << " to " << range.y
       << ", so there is no isosurface; set an isovalue above " << range.x << " and up to "
       << range.y << " with GetIsoSurfaceValues()->SetValue(0, isovalue) of the volume's property.";
}

}

bool MaySeePartOnly(const DrawnVolume& drawn)
{
  vtkDataObject* data = drawn.Mapper->GetDataObjectInput();
  auto* tree = vtkDataObjectTree::SafeDownCast(data);
  // A mapper of blocks has its own mapper for each block.
  auto* owner = drawn.Volume->GetMapper();
  const bool isBlock = !tree && owner && owner != drawn.Mapper &&
    vtkCompositeDataSet::SafeDownCast(owner->GetDataObjectInput());
  return !data || isBlock || IsPiece(data) || (tree && HasPieces(tree)) ||
    IsPartOfPipeline(drawn.Mapper->GetInputInformation(0, 0), data) ||
    IsPropertyShared(drawn.Volume, drawn.Renderer);
}

IsovalueCheck::Story& IsovalueCheck::StoryOf(vtkVolume* volume)
{
  for (Story& story : this->Stories)
  {
    if (story.Of == volume)
    {
      return story;
    }
  }
  this->Stories.erase(std::remove_if(this->Stories.begin(), this->Stories.end(),
                        [](const Story& story) { return !story.Of; }),
    this->Stories.end());
  this->Stories.emplace_back();
  this->Stories.back().Of = volume;
  return this->Stories.back();
}

std::string IsovalueCheck::Check(
  const DrawnVolume& drawn, const FrameRequest& request, const ValueRangePyramid& ranges)
{
  const Surfaces& surfaces = request.Key.Isosurfaces;
  return surfaces.Isovalues.empty() ? this->CheckTransparent(drawn, request)
                                    : this->Check(drawn, surfaces.Isovalues, surfaces.Mode, ranges);
}

std::string IsovalueCheck::CheckTransparent(const DrawnVolume& drawn, const FrameRequest& request)
{
  const std::vector<double> isovalues = ValuesOf(request.IsovalueList);
  Story& story = this->StoryOf(drawn.Volume);
  vtkDataObject* data = drawn.Mapper->GetDataObjectInput();
  if (isovalues.empty() || story.IsTold ||
    (story.TransparentIn == data && story.Transparent == isovalues))
  {
    return "";
  }
  story.Transparent = isovalues;
  story.TransparentIn = data;
  ValueRangePyramid ranges; // the frame needed no ranges
  try
  {
    ranges.Build(request.Key.Samples);
  }
  catch (const std::exception&) // no memory: no warning
  {
    return "";
  }
  const glm::dvec2 finite = ranges.FiniteRange();
  const SurfaceMode mode = request.Key.Isosurfaces.Mode;
  if (!AreMet(isovalues, mode, ranges.WholeRange()))
  {
    return this->Check(drawn, isovalues, mode, ranges);
  }
  // A surface may fade out. But nobody chose the 0 that VTK constructs a property with.
  const bool isUntouched = isovalues.size() == 1 && isovalues[0] == 0.0;
  if (!isUntouched || !story.Met.empty() || !(finite.x < finite.y) || MaySeePartOnly(drawn))
  {
    return "";
  }
  story.IsTold = true;
  std::ostringstream what;
  what << std::setprecision(std::numeric_limits<float>::max_digits10)
       << "Isovalue 0 has a scalar opacity of 0, so there is no isosurface. The samples range from "
       << finite.x << " to " << finite.y << "; set an isovalue above " << finite.x << " and up to "
       << finite.y
       << " with GetIsoSurfaceValues()->SetValue(0, isovalue) of the volume's property, and its "
          "opacity with GetScalarOpacity()->AddPoint.";
  return what.str();
}

std::string IsovalueCheck::Check(const DrawnVolume& drawn, const std::vector<double>& isovalues,
  SurfaceMode mode, const ValueRangePyramid& ranges)
{
  const glm::dvec2& all = ranges.WholeRange();
  if (all.x > all.y) // no sample is a number: EmptyPicture tells
  {
    return "";
  }
  Story& story = this->StoryOf(drawn.Volume);
  vtkDataObject* data = drawn.Mapper->GetDataObjectInput();
  if (AreMet(isovalues, mode, all))
  {
    story.IsTold = false;
    if (story.Met != isovalues || story.MetBy != data)
    {
      story.Met = isovalues;
      story.MetBy = data;
    }
    return "";
  }
  const bool wereMet = story.MetBy && story.MetBy == data && story.Met == isovalues;
  if (story.IsTold || wereMet || MaySeePartOnly(drawn))
  {
    return "";
  }
  story.IsTold = true;
  const auto [least, largest] = std::minmax_element(isovalues.begin(), isovalues.end());
  std::ostringstream what;
  what << std::setprecision(std::numeric_limits<float>::max_digits10);
  if (isovalues.size() == 1)
  {
    what << "Isovalue " << *least << " separates no samples";
  }
  else
  {
    what << "None of the " << isovalues.size() << " isovalues (" << *least << " to " << *largest
         << ") separates any samples";
  }
  what << ": ";
  Explain(ranges, what);
  return what.str();
}

}
