// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "DistributedPart.h"

#include "DividedGrid.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkGenericCell.h"
#include "vtkGhostCellsGenerator.h"
#include "vtkImageData.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkOverlappingAMR.h"
#include "vtkPointData.h"
#include "vtkRectilinearGrid.h"
#include "vtkStructuredGrid.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>

namespace
{

constexpr const char* DescriptionName = "TemporalIsosurfacePart";

using Extent = std::array<int, 6>;

vtkUnsignedCharArray* GhostsOf(vtkDataSetAttributes* attributes)
{
  return vtkUnsignedCharArray::SafeDownCast(
    attributes->GetArray(vtkDataSetAttributes::GhostArrayName()));
}

bool HasGhostCells(vtkDataSet* dataSet)
{
  vtkUnsignedCharArray* ghosts = GhostsOf(dataSet->GetCellData());
  for (vtkIdType i = 0; ghosts && i < ghosts->GetNumberOfTuples(); ++i)
  {
    if (ghosts->GetValue(i) & vtkDataSetAttributes::DUPLICATECELL)
    {
      return true;
    }
  }
  return false;
}

bool IsMesh(vtkDataSet* dataSet)
{
  return !vtkImageData::SafeDownCast(dataSet) && !vtkRectilinearGrid::SafeDownCast(dataSet);
}

/// Points of an image or grid; false for anything else and where there are no cells.
bool FindExtent(vtkDataSet* dataSet, Extent& extent)
{
  auto* image = vtkImageData::SafeDownCast(dataSet);
  auto* grid = vtkRectilinearGrid::SafeDownCast(dataSet);
  if ((!image && !grid) || dataSet->GetNumberOfCells() == 0)
  {
    return false;
  }
  const int* found = image ? image->GetExtent() : grid->GetExtent();
  std::copy_n(found, 6, extent.begin());
  return extent[0] < extent[1] && extent[2] < extent[3] && extent[4] < extent[5];
}

/// The cells of an extent, one after the other as they lie in arrays.
template <typename Function>
void ForEachCell(const Extent& extent, Function&& function)
{
  vtkIdType cell = 0;
  for (int k = extent[4]; k < extent[5]; ++k)
  {
    for (int j = extent[2]; j < extent[3]; ++j)
    {
      for (int i = extent[0]; i < extent[1]; ++i, ++cell)
      {
        function(cell, std::array<int, 3>{ { i, j, k } });
      }
    }
  }
}

/// The smallest box that holds all cells of this process; false if it has none.
bool FindOwned(vtkUnsignedCharArray* ghosts, const Extent& extent, Extent& owned)
{
  owned = { { extent[1], extent[0], extent[3], extent[2], extent[5], extent[4] } };
  ForEachCell(extent,
    [&](vtkIdType cell, const std::array<int, 3>& at)
    {
      if (!(ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL))
      {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          owned[2 * axis] = std::min(owned[2 * axis], at[axis]);
          owned[2 * axis + 1] = std::max(owned[2 * axis + 1], at[axis] + 1);
        }
      }
    });
  return owned[0] < owned[1];
}

bool IsIn(const Extent& box, const std::array<int, 3>& cell)
{
  return cell[0] >= box[0] && cell[0] < box[1] && cell[1] >= box[2] && cell[1] < box[3] &&
    cell[2] >= box[4] && cell[2] < box[5];
}

/// True if ghost arrays say: all cells in a box are there, and all others of another process.
bool IsAllSaidByBox(vtkDataSet* dataSet, const Extent& extent, const Extent& owned)
{
  vtkUnsignedCharArray* const cells = GhostsOf(dataSet->GetCellData());
  bool isBox = true;
  if (cells)
  {
    ForEachCell(extent,
      [&](vtkIdType cell, const std::array<int, 3>& at)
      {
        const int wanted = IsIn(owned, at) ? 0 : vtkDataSetAttributes::DUPLICATECELL;
        isBox = isBox && cells->GetValue(cell) == wanted;
      });
  }
  vtkUnsignedCharArray* const points = GhostsOf(dataSet->GetPointData());
  for (vtkIdType i = 0; points && isBox && i < points->GetNumberOfTuples(); ++i)
  {
    isBox = !(points->GetValue(i) & vtkDataSetAttributes::HIDDENPOINT);
  }
  return isBox;
}

/// Where a box of an image or grid lies along its axes, that is, with no regard to an image's
/// directions, and in the world.
void FindPlace(vtkDataSet* dataSet, const Extent& extent, const Extent& box,
  vtkBoundingBox& alongAxes, vtkBoundingBox& inWorld)
{
  double first[3], last[3];
  if (auto* grid = vtkRectilinearGrid::SafeDownCast(dataSet))
  {
    vtkDataArray* coordinates[3] = { grid->GetXCoordinates(), grid->GetYCoordinates(),
      grid->GetZCoordinates() };
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      first[axis] = coordinates[axis]->GetTuple1(box[2 * axis] - extent[2 * axis]);
      last[axis] = coordinates[axis]->GetTuple1(box[2 * axis + 1] - extent[2 * axis]);
    }
    alongAxes.AddPoint(first);
    alongAxes.AddPoint(last);
    inWorld = alongAxes;
    return;
  }
  auto* image = vtkImageData::SafeDownCast(dataSet);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    first[axis] = image->GetOrigin()[axis] + box[2 * axis] * image->GetSpacing()[axis];
    last[axis] = image->GetOrigin()[axis] + box[2 * axis + 1] * image->GetSpacing()[axis];
  }
  alongAxes.AddPoint(first);
  alongAxes.AddPoint(last);
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    double point[3];
    image->TransformIndexToPhysicalPoint(
      box[corner & 1], box[2 + (corner >> 1 & 1)], box[4 + (corner >> 2)], point);
    inWorld.AddPoint(point);
  }
}

/// What of a data set this process draws.
struct OwnedBox
{
  vtkBoundingBox AlongAxes, InWorld;
  bool IsAllSaid = false; ///< ghost arrays, if there are any, say nothing else
};

OwnedBox FindOwnedBox(vtkDataSet* dataSet)
{
  OwnedBox box;
  Extent extent, owned;
  vtkUnsignedCharArray* const ghosts = GhostsOf(dataSet->GetCellData());
  if (!FindExtent(dataSet, extent))
  {
    box.InWorld.AddBounds(dataSet->GetBounds());
    return box;
  }
  owned = extent;
  if (ghosts &&
    (ghosts->GetNumberOfTuples() != dataSet->GetNumberOfCells() ||
      !FindOwned(ghosts, extent, owned)))
  {
    return box;
  }
  FindPlace(dataSet, extent, owned, box.AlongAxes, box.InWorld);
  box.IsAllSaid = IsAllSaidByBox(dataSet, extent, owned);
  return box;
}

double VolumeOf(const vtkBoundingBox& box)
{
  double lengths[3];
  box.GetLengths(lengths);
  return lengths[0] * lengths[1] * lengths[2];
}

/// What this process draws. If that is a box, and ghost arrays say nothing else, they are taken
/// away. Meshes are not cut: their cells say what is hidden.
void FindOwnedPart(const std::vector<vtkDataSet*>& dataSets, bool haveMeshes, DistributedPart& part)
{
  constexpr double rounding = 1e-10;
  bool isAllSaid = !haveMeshes, hasGhosts = false;
  double volume = 0.0;
  for (vtkDataSet* dataSet : dataSets)
  {
    if (dataSet->GetNumberOfCells() > 0)
    {
      const OwnedBox box = FindOwnedBox(dataSet);
      part.Owned.AddBox(box.InWorld);
      part.Crop.AddBox(box.AlongAxes);
      volume += box.AlongAxes.IsValid() ? VolumeOf(box.AlongAxes) : 0.0;
      isAllSaid = isAllSaid && box.IsAllSaid;
      hasGhosts = hasGhosts || GhostsOf(dataSet->GetCellData());
    }
  }
  // Parts do not overlap: if their volumes are that of the box around them, they fill it.
  part.IsCut = isAllSaid && hasGhosts && part.Crop.IsValid() &&
    volume >= (1.0 - rounding) * VolumeOf(part.Crop);
  for (vtkDataSet* dataSet : dataSets)
  {
    if (part.IsCut)
    {
      dataSet->GetCellData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
      dataSet->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
    }
  }
}

/// Let cells that another process draws serve as samples. The mapper hides all that is between a
/// hidden cell and its neighbours: between processes there would be a gap.
void ShowDuplicates(vtkDataSet* dataSet)
{
  vtkUnsignedCharArray* const ghosts = GhostsOf(dataSet->GetCellData());
  if (!ghosts)
  {
    return;
  }
  vtkNew<vtkUnsignedCharArray> shown; // the other one is shared with the input
  shown->DeepCopy(ghosts);
  for (vtkIdType i = 0; i < shown->GetNumberOfValues(); ++i)
  {
    const int others = ghosts->GetValue(i) & ~vtkDataSetAttributes::DUPLICATECELL;
    shown->SetValue(i, static_cast<unsigned char>(others));
  }
  dataSet->GetCellData()->AddArray(shown);
}

void AddRanges(vtkDataArray* array, DistributedPart& part)
{
  const auto merge = [](DistributedPart::Interval& to, const double from[2])
  {
    if (from[0] <= from[1])
    {
      const bool isFirst = to[0] > to[1];
      to[0] = isFirst ? from[0] : std::min(to[0], from[0]);
      to[1] = isFirst ? from[1] : std::max(to[1], from[1]);
    }
  };
  const auto components = static_cast<std::size_t>(array->GetNumberOfComponents());
  if (part.Ranges.size() < components)
  {
    part.Ranges.resize(components, DistributedPart::Nothing);
  }
  double range[2];
  for (std::size_t c = 0; c < components; ++c)
  {
    array->GetFiniteRange(range, static_cast<int>(c));
    merge(part.Ranges[c], range);
  }
  array->GetFiniteRange(range, -1);
  merge(part.Lengths, range);
}

/// True if an array could name parts of a data set. Labels are drawn of images only.
bool CouldBeLabels(vtkDataArray* array, vtkDataSet* dataSet)
{
  const int type = array->GetDataType();
  return vtkImageData::SafeDownCast(dataSet) && type != VTK_FLOAT && type != VTK_DOUBLE;
}

/// Put together what all processes know: the bounds and ranges of the whole.
void Reduce(DistributedPart& part, vtkMultiProcessController* controller)
{
  int components = static_cast<int>(part.Ranges.size()), most = components;
  controller->AllReduce(&components, &most, 1, vtkCommunicator::MAX_OP);
  part.Ranges.resize(static_cast<std::size_t>(most), DistributedPart::Nothing);

  // The largest of numbers is the smallest of negative numbers, so that one message does.
  std::vector<double> mine, all;
  const auto put = [&](double least, double largest)
  {
    mine.push_back(least <= largest ? least : VTK_DOUBLE_MAX);
    mine.push_back(least <= largest ? -largest : VTK_DOUBLE_MAX);
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    put(part.Owned.GetBound(2 * axis), part.Owned.GetBound(2 * axis + 1));
  }
  part.Ranges.push_back(part.Lengths);
  for (const auto& range : part.Ranges)
  {
    put(range[0], range[1]);
  }
  mine.push_back(part.HoldsLabels ? 1.0 : 0.0);
  all = mine;
  controller->AllReduce(
    mine.data(), all.data(), static_cast<vtkIdType>(mine.size()), vtkCommunicator::MIN_OP);

  const auto get = [&](std::size_t i) -> DistributedPart::Interval
  {
    const bool isThere = all[2 * i] < VTK_DOUBLE_MAX;
    return isThere ? DistributedPart::Interval{ { all[2 * i], -all[2 * i + 1] } }
                   : DistributedPart::Nothing;
  };
  part.Whole = vtkBoundingBox(get(0)[0], get(0)[1], get(1)[0], get(1)[1], get(2)[0], get(2)[1]);
  for (std::size_t r = 0; r < part.Ranges.size(); ++r)
  {
    part.Ranges[r] = get(3 + r);
  }
  part.Lengths = part.Ranges.back();
  part.Ranges.pop_back();
  part.HoldsLabels = all.back() > 0.0;
}

}

constexpr DistributedPart::Interval DistributedPart::Nothing;

void DistributedPart::WriteTo(vtkDataObject* data) const
{
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName(DescriptionName);
  for (const vtkBoundingBox* box : { &this->Owned, &this->Whole, &this->Crop })
  {
    for (int i = 0; i < 6; ++i)
    {
      numbers->InsertNextValue(box->GetBound(i));
    }
  }
  numbers->InsertNextValue(this->IsCut ? 1.0 : 0.0);
  numbers->InsertNextValue(this->Lengths[0]);
  numbers->InsertNextValue(this->Lengths[1]);
  numbers->InsertNextValue(this->HoldsLabels ? 1.0 : 0.0);
  for (const Interval& range : this->Ranges)
  {
    numbers->InsertNextValue(range[0]);
    numbers->InsertNextValue(range[1]);
  }
  data->GetFieldData()->AddArray(numbers);
}

DistributedPart DistributedPart::ReadFrom(vtkDataObject* data)
{
  DistributedPart part;
  auto* numbers =
    data ? vtkDoubleArray::SafeDownCast(data->GetFieldData()->GetArray(DescriptionName)) : nullptr;
  constexpr vtkIdType fixedNumbers = 22;
  if (!numbers || numbers->GetNumberOfTuples() < fixedNumbers)
  {
    return part;
  }
  const double* number = numbers->GetPointer(0);
  const auto boxAt = [&](int first)
  {
    vtkBoundingBox box;
    if (number[first] <= number[first + 1])
    {
      box.SetBounds(number + first);
    }
    return box;
  };
  part.Owned = boxAt(0);
  part.Whole = boxAt(6);
  part.Crop = boxAt(12);
  part.IsCut = number[18] != 0.0;
  part.Lengths = { { number[19], number[20] } };
  part.HoldsLabels = number[21] != 0.0;
  for (vtkIdType i = fixedNumbers; i + 1 < numbers->GetNumberOfTuples(); i += 2)
  {
    part.Ranges.push_back({ { number[i], number[i + 1] } });
  }
  return part;
}

bool HasVolume(vtkDataSet* dataSet)
{
  if (auto* curvilinear = vtkStructuredGrid::SafeDownCast(dataSet))
  {
    return curvilinear->GetDataDimension() == 3;
  }
  auto* grid = vtkUnstructuredGrid::SafeDownCast(dataSet);
  if (!grid || grid->GetNumberOfCells() == 0)
  {
    return dataSet->GetNumberOfCells() > 0 && dataSet->GetNumberOfPoints() > 0;
  }
  std::array<bool, VTK_NUMBER_OF_CELL_TYPES> isThere{};
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    isThere[static_cast<std::size_t>(grid->GetCellType(i)) % isThere.size()] = true;
  }
  vtkNew<vtkGenericCell> cell;
  for (int type = 0; type < VTK_NUMBER_OF_CELL_TYPES; ++type)
  {
    if (isThere[static_cast<std::size_t>(type)])
    {
      cell->SetCellType(type);
      if (cell->GetCellDimension() == 3)
      {
        return true;
      }
    }
  }
  return false;
}

NeededData WithGhostCells(vtkDataObject* input, int layers, vtkMultiProcessController* controller)
{
  const std::vector<vtkDataSet*> dataSets = DataSetsOf(input);
  const auto has = [&](bool (*what)(vtkDataSet*))
  { return std::any_of(dataSets.begin(), dataSets.end(), what) ? 1 : 0; };
  const int mine[3] = { has([](vtkDataSet* set) { return set->GetNumberOfCells() > 0; }),
    has(HasGhostCells), has(IsMesh) };
  int all[3] = { mine[0], mine[1], mine[2] };
  controller->AllReduce(mine, all, 3, vtkCommunicator::SUM_OP);

  const bool isSplit = all[0] > 1, isLayered = all[1] > 0, hasMeshes = all[2] > 0;
  auto* amr = vtkOverlappingAMR::SafeDownCast(input);
  if (amr && all[0] > 0 && controller->GetNumberOfProcesses() > 1)
  {
    const DividedGrid divided = Divide(amr, controller);
    return { divided.Blocks, divided.Box, false };
  }
  const auto copy = vtkSmartPointer<vtkDataObject>::Take(input->NewInstance());
  if (!isSplit || isLayered)
  {
    copy->ShallowCopy(input);
    return { copy, {}, hasMeshes };
  }
  // The pipeline gave none, so processes exchange them here.
  vtkNew<vtkGhostCellsGenerator> generator;
  generator->SetController(controller);
  generator->BuildIfRequiredOff();
  generator->SetNumberOfGhostLayers(layers);
  generator->SetInputDataObject(input);
  generator->Update();
  copy->ShallowCopy(generator->GetOutputDataObject(0));
  return { copy, {}, hasMeshes };
}

DistributedPart Describe(
  const NeededData& needed, const ArrayChoice& choice, vtkMultiProcessController* controller)
{
  DistributedPart part;
  const std::vector<vtkDataSet*> dataSets = DataSetsOf(needed.Data);
  // The levels of an adaptive grid tell themselves what is hidden.
  const bool isAdaptive = vtkOverlappingAMR::SafeDownCast(needed.Data) != nullptr;
  if (needed.Box.IsValid())
  {
    part.Owned = part.Crop = needed.Box;
    part.IsCut = true;
  }
  else
  {
    FindOwnedPart(dataSets, isAdaptive || needed.HasMeshes, part);
  }
  for (vtkDataSet* dataSet : dataSets)
  {
    if (vtkDataArray* array = choice.In(dataSet))
    {
      AddRanges(array, part);
      part.HoldsLabels = part.HoldsLabels && !isAdaptive && CouldBeLabels(array, dataSet);
    }
    if (choice.IsOnCells && !IsMesh(dataSet) && !isAdaptive)
    {
      ShowDuplicates(dataSet);
    }
  }
  Reduce(part, controller);
  return part;
}
