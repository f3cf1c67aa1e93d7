// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Input/MergedBlocks.h"

#include "Input/BlockCopy.h"
#include "Input/BlockName.h"
#include "Input/GhostArray.h"
#include "Input/SamplesOfArray.h"

#include <vtkAbstractMapper.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataObjectTree.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <sstream>

namespace TemporalCoherence
{
namespace
{

using Block = MergedBlocks::Block;

/// The merged image may be larger than its blocks by this factor, or by any factor if it is small.
constexpr double LargestGrowth = 4.0;
constexpr double SmallImage = 64.0 * (1 << 20); // bytes

/// The images with cells, in the order of the tree. Other data sets are ignored: they have no
/// volume, as otherwise the whole tree would be a mesh.
bool FindImages(vtkDataObjectTree* tree, std::vector<Block>& images, std::string& error)
{
  const auto leaf = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    vtkDataObject* object = leaf->GetCurrentDataObject();
    Block block;
    block.Image = vtkImageData::SafeDownCast(object);
    block.Name = NameOfLeaf(leaf);
    if (!vtkDataSet::SafeDownCast(object))
    {
      error = block.Name + " is a " + object->GetClassName() +
        ", but only blocks of images and of grids with cells can be drawn; leave it out with "
        "vtkExtractBlock.";
      return false;
    }
    const int* dimensions = block.Image ? block.Image->GetDimensions() : nullptr;
    if (block.Image && *std::min_element(dimensions, dimensions + 3) > 1)
    {
      images.push_back(block);
    }
  }
  return true;
}

/// Drop the blocks without the array.
bool FindArrays(const ScalarChoice& choice, std::vector<Block>& blocks, std::string& error)
{
  if (blocks.empty())
  {
    return true;
  }
  for (Block& block : blocks)
  {
    block.Array = FindScalars(block.Image, choice).Array;
    block.Stamp =
      std::max(block.Image->GetMTime(), block.Array ? block.Array->GetMTime() : vtkMTimeType(0));
  }
  blocks.erase(
    std::remove_if(blocks.begin(), blocks.end(), [](const Block& block) { return !block.Array; }),
    blocks.end());
  if (blocks.empty())
  {
    error = WhyThereAreNoScalars(choice);
    return false;
  }
  return true;
}

std::string Describe(vtkDataArray* array)
{
  return NameOf(array) + " of " + array->GetDataTypeAsString() + " with " +
    std::to_string(array->GetNumberOfComponents()) + " component(s)";
}

ArrayPlaces PlacesOf(const Block& block, bool areCells)
{
  return { block.Name, areCells, CountSamples(block.Image, areCells) };
}

/// Find the ghost arrays of a block.
/// \return false if their sizes are wrong
bool FindGhosts(Block& block, std::string& error)
{
  return FindFlags(block.Image->GetPointData(), PlacesOf(block, false), block.PointGhosts, error) &&
    FindFlags(block.Image->GetCellData(), PlacesOf(block, true), block.CellGhosts, error);
}

/// Compare a block's array with the first block's array.
bool FitsArray(
  const Block& first, const Block& block, const ScalarChoice& choice, std::string& error)
{
  const bool isByNumber = (choice.Mode == VTK_SCALAR_MODE_USE_POINT_FIELD_DATA ||
                            choice.Mode == VTK_SCALAR_MODE_USE_CELL_FIELD_DATA) &&
    !choice.IsByName;
  if (!CheckTuples(block.Array, PlacesOf(block, IsOnCells(choice)), error))
  {
    return false;
  }
  if (block.Array->GetDataType() != first.Array->GetDataType() ||
    block.Array->GetNumberOfComponents() != first.Array->GetNumberOfComponents())
  {
    error = block.Name + " has an array " + Describe(block.Array) + ", but " + first.Name +
      " has " + Describe(first.Array) +
      "; give all blocks arrays of one type and number of components.";
  }
  else if (isByNumber && NameOf(block.Array) != NameOf(first.Array))
  {
    error = block.Name + " has " + NameOf(block.Array) + " as array number " +
      std::to_string(choice.Number) + ", but " + first.Name + " has " + NameOf(first.Array) +
      "; choose the array by its name with SelectScalarArray.";
  }
  else
  {
    return true;
  }
  return false;
}

bool FitBlocks(
  const ScalarChoice& choice, std::vector<Block>& blocks, LatticeBox& whole, std::string& error)
{
  double samples = 0.0;
  for (Block& block : blocks)
  {
    std::string why;
    if (!FitsArray(blocks.front(), block, choice, error) || !FindGhosts(block, error))
    {
      return false;
    }
    if (!PlaceOnLattice(blocks.front().Image, block.Image, block.Place, why))
    {
      error = block.Name + " does not fit the points of " + blocks.front().Name + ": " + why +
        "; resample it with vtkResampleToImage or leave it out with vtkExtractBlock.";
      return false;
    }
    const bool isFirst = &block == &blocks.front();
    whole.First = isFirst ? block.Place.First : glm::min(whole.First, block.Place.First);
    whole.Last = isFirst ? block.Place.Last : glm::max(whole.Last, block.Place.Last);
    samples += static_cast<double>(block.Image->GetNumberOfPoints());
  }

  const glm::dvec3 points(whole.Points());
  const double all = points.x * points.y * points.z;
  vtkDataArray* array = blocks.front().Array;
  const double bytes = all * array->GetNumberOfComponents() * array->GetDataTypeSize();
  if (all > LargestGrowth * samples && bytes > SmallImage)
  {
    std::ostringstream what;
    what << "The blocks have " << samples << " points, but the image that covers them all has "
         << points.x << " x " << points.y << " x " << points.z
         << "; draw blocks so far apart with a vtkVolume and a mapper each, or choose fewer with "
            "vtkExtractBlock.";
    error = what.str();
    return false;
  }
  return true;
}

BlockSource MakeSource(const Block& block, vtkDataArray* array, const LatticeBox& whole)
{
  BlockSource source;
  source.First = block.Place.First - whole.First;
  source.Points = block.Place.Points();
  source.PointGhosts = block.PointGhosts;
  source.CellGhosts = block.CellGhosts;
  source.Components.resize(static_cast<std::size_t>(array->GetNumberOfComponents()));
  for (std::size_t c = 0; c < source.Components.size(); ++c)
  {
    source.Components[c] = SamplesOf(array, static_cast<int>(c));
  }
  return source;
}

/// An image without samples on the lattice of the blocks.
vtkSmartPointer<vtkImageData> MakeImage(vtkImageData* lattice, const LatticeBox& whole)
{
  const auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetOrigin(lattice->GetOrigin());
  image->SetSpacing(lattice->GetSpacing());
  image->SetDirectionMatrix(lattice->GetDirectionMatrix());
  const glm::ivec3 first(whole.First), last(whole.Last);
  image->SetExtent(first.x, last.x, first.y, last.y, first.z, last.z);
  return image;
}

bool AreSame(const std::vector<Block>& a, const std::vector<Block>& b)
{
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
    [](const Block& x, const Block& y)
    { return x.Image == y.Image && x.Array == y.Array && x.Stamp == y.Stamp; });
}

}

bool MergedBlocks::Merge(vtkDataObjectTree* tree, const ScalarChoice& choice, std::string& error)
{
  std::vector<Block> blocks;
  if (!FindImages(tree, blocks, error))
  {
    return false;
  }
  std::vector<vtkDataSet*> images;
  for (const Block& block : blocks)
  {
    images.push_back(block.Image);
  }
  const ScalarChoice same = ChoiceForAll(images, choice);
  if (!FindArrays(same, blocks, error))
  {
    return false;
  }
  const bool onCells = IsOnCells(same);
  if (this->Merged && this->Chosen.OnCells == onCells && AreSame(blocks, this->Blocks))
  {
    return true;
  }
  if (blocks.empty())
  {
    this->Release();
    this->Merged = vtkSmartPointer<vtkImageData>::New();
    this->Chosen.OnCells = onCells;
    return true;
  }
  LatticeBox whole;
  if (!FitBlocks(same, blocks, whole, error))
  {
    return false;
  }
  this->Copy(blocks, onCells, whole);
  return true;
}

void MergedBlocks::Copy(const std::vector<Block>& blocks, bool onCells, const LatticeBox& whole)
{
  std::vector<BlockSource> sources;
  ArraysInPlace arrays; // keeps copies during the merge
  for (const Block& block : blocks)
  {
    sources.push_back(MakeSource(block, arrays.Of(block.Array), whole));
  }
  this->Release(); // first, because both images may not fit into memory

  const auto image = MakeImage(blocks.front().Image, whole);
  vtkDataArray* model = blocks.front().Array;
  const auto array =
    vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(model->GetDataType()));
  array->SetName(model->GetName());
  array->SetNumberOfComponents(model->GetNumberOfComponents());
  array->SetNumberOfTuples(onCells ? image->GetNumberOfCells() : image->GetNumberOfPoints());
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(image->GetNumberOfCells());

  BlockTarget target;
  target.Points = whole.Points();
  target.OnCells = onCells;
  target.Samples = array->GetVoidPointer(0);
  target.CellGhosts = ghosts->GetPointer(0);
  if (CopyBlocks(sources, target))
  {
    image->GetCellData()->AddArray(ghosts);
  }
  this->Merged = image;
  this->Chosen.Array = array;
  this->Chosen.OnCells = onCells;
  this->Blocks = blocks;
  if (onCells)
  {
    image->GetCellData()->SetScalars(array);
  }
  else
  {
    image->GetPointData()->SetScalars(array);
  }
}

}
