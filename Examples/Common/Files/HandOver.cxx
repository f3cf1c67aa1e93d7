// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Files/HandOver.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkRectilinearGrid.h>
#include <vtkStructuredGrid.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <type_traits>

namespace
{

// Passes things on to a file, or takes them from it: both in one order, which is told once.
class Parcel
{
public:
  Parcel(const std::string& path, bool isRead)
    : IsRead(isRead)
    , File(std::fopen(path.c_str(), isRead ? "rb" : "wb"), &std::fclose)
    , IsGood(this->File != nullptr)
  {
  }

  const bool IsRead;

  // What was written may be kept back until the file is closed.
  bool EndWell()
  {
    this->IsGood = this->IsGood && std::fflush(this->File.get()) == 0;
    return this->IsGood;
  }
  bool IsWhole() const { return this->IsGood; }

  void PassBytes(void* bytes, std::size_t size)
  {
    if (this->IsGood && size > 0)
    {
      this->IsGood = (this->IsRead ? std::fread(bytes, 1, size, this->File.get())
                                   : std::fwrite(bytes, 1, size, this->File.get())) == size;
    }
  }

  template <typename T>
  void Pass(T& value)
  {
    static_assert(std::is_trivially_copyable_v<T>);
    this->PassBytes(&value, sizeof(value));
  }

  void Pass(std::string& text)
  {
    std::size_t size = text.size();
    this->Pass(size);
    text.resize(this->IsGood ? size : 0);
    this->PassBytes(text.data(), text.size());
  }

  // Null stays null.
  vtkSmartPointer<vtkDataArray> PassArray(vtkSmartPointer<vtkDataArray> array)
  {
    bool isThere = array != nullptr;
    this->Pass(isThere);
    if (!isThere || !this->IsGood)
    {
      return nullptr;
    }
    std::string name = array && array->GetName() ? array->GetName() : "";
    int type = array ? array->GetDataType() : 0, components = 1;
    vtkIdType tuples = 0;
    if (!this->IsRead)
    {
      components = array->GetNumberOfComponents();
      tuples = array->GetNumberOfTuples();
    }
    this->Pass(name);
    this->Pass(type);
    this->Pass(components);
    this->Pass(tuples);
    if (this->IsRead && this->IsGood)
    {
      array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
      array->SetName(name.empty() ? nullptr : name.c_str());
      array->SetNumberOfComponents(components);
      array->SetNumberOfTuples(tuples);
    }
    const auto values = static_cast<std::size_t>(array ? tuples * components : 0);
    this->PassBytes(values > 0 ? array->GetVoidPointer(0) : nullptr,
      values * static_cast<std::size_t>(array ? array->GetDataTypeSize() : 0));
    return array;
  }

private:
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> File;
  bool IsGood;
};

// Arrays of numbers; nobody draws others.
void PassAttributes(Parcel& parcel, vtkDataSetAttributes* attributes)
{
  int count = attributes->GetNumberOfArrays();
  parcel.Pass(count);
  for (int i = 0; i < count && parcel.IsWhole(); ++i)
  {
    vtkDataArray* array = parcel.IsRead ? nullptr : attributes->GetArray(i);
    const bool isPassed = array && array->GetDataType() != VTK_BIT;
    int attribute = parcel.IsRead ? -1 : attributes->IsArrayAnAttribute(i);
    parcel.Pass(attribute);
    const auto passed = parcel.PassArray(isPassed ? array : nullptr);
    if (parcel.IsRead && passed)
    {
      const int at = attributes->AddArray(passed);
      if (attribute >= 0)
      {
        attributes->SetActiveAttribute(at, attribute);
      }
    }
  }
}

void PassImage(Parcel& parcel, vtkImageData* image)
{
  std::array<int, 6> extent{};
  std::array<double, 3> origin{}, spacing{};
  std::array<double, 9> direction{};
  image->GetExtent(extent.data());
  image->GetOrigin(origin.data());
  image->GetSpacing(spacing.data());
  std::copy_n(image->GetDirectionMatrix()->GetData(), 9, direction.begin());
  parcel.Pass(extent);
  parcel.Pass(origin);
  parcel.Pass(spacing);
  parcel.Pass(direction);
  if (parcel.IsRead)
  {
    image->SetExtent(extent.data());
    image->SetOrigin(origin.data());
    image->SetSpacing(spacing.data());
    image->SetDirectionMatrix(direction.data());
  }
}

void PassPoints(Parcel& parcel, vtkPointSet* set)
{
  const auto points = parcel.PassArray(set->GetPoints() ? set->GetPoints()->GetData() : nullptr);
  if (parcel.IsRead && points)
  {
    vtkNew<vtkPoints> made;
    made->SetData(points);
    set->SetPoints(made);
  }
}

template <typename Grid>
void PassExtent(Parcel& parcel, Grid* grid)
{
  std::array<int, 6> extent{};
  grid->GetExtent(extent.data());
  parcel.Pass(extent);
  if (parcel.IsRead)
  {
    grid->SetExtent(extent.data());
  }
}

void PassGrid(Parcel& parcel, vtkRectilinearGrid* grid)
{
  PassExtent(parcel, grid);
  const auto x = parcel.PassArray(grid->GetXCoordinates());
  const auto y = parcel.PassArray(grid->GetYCoordinates());
  const auto z = parcel.PassArray(grid->GetZCoordinates());
  if (parcel.IsRead)
  {
    grid->SetXCoordinates(x);
    grid->SetYCoordinates(y);
    grid->SetZCoordinates(z);
  }
}

void PassCells(Parcel& parcel, vtkUnstructuredGrid* grid)
{
  vtkCellArray* cells = grid->GetCells();
  const vtkIdType count = cells ? cells->GetNumberOfCells() : 0;
  vtkNew<vtkUnsignedCharArray> types;
  types->SetNumberOfValues(count);
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    types->SetValue(cell, static_cast<unsigned char>(grid->GetCellType(cell)));
  }
  const auto typesPassed = parcel.PassArray(types.Get());
  const auto offsets = parcel.PassArray(cells ? cells->GetOffsetsArray() : nullptr);
  const auto points = parcel.PassArray(cells ? cells->GetConnectivityArray() : nullptr);
  if (parcel.IsRead && offsets && points)
  {
    vtkNew<vtkCellArray> made;
    made->SetData(offsets, points);
    grid->SetCells(vtkUnsignedCharArray::SafeDownCast(typesPassed), made);
  }
}

// Faces of polyhedra are kept in other ways by each version of VTK.
bool HasPolyhedra(vtkUnstructuredGrid* grid)
{
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (grid->GetCellType(cell) == VTK_POLYHEDRON)
    {
      return true;
    }
  }
  return false;
}

// The type of a data set that is handed over; -1 for others.
int TypeOf(vtkDataObject* data)
{
  auto* mesh = vtkUnstructuredGrid::SafeDownCast(data);
  return vtkImageData::SafeDownCast(data)    ? VTK_IMAGE_DATA
    : vtkRectilinearGrid::SafeDownCast(data) ? VTK_RECTILINEAR_GRID
    : vtkStructuredGrid::SafeDownCast(data)  ? VTK_STRUCTURED_GRID
    : mesh && !HasPolyhedra(mesh)            ? VTK_UNSTRUCTURED_GRID
                                             : -1;
}

vtkSmartPointer<vtkDataSet> MakeOf(int type)
{
  switch (type)
  {
    case VTK_IMAGE_DATA:
      return vtkSmartPointer<vtkImageData>::New();
    case VTK_RECTILINEAR_GRID:
      return vtkSmartPointer<vtkRectilinearGrid>::New();
    case VTK_STRUCTURED_GRID:
      return vtkSmartPointer<vtkStructuredGrid>::New();
    default:
      return vtkSmartPointer<vtkUnstructuredGrid>::New();
  }
}

void PassData(Parcel& parcel, vtkDataSet* set)
{
  if (auto* image = vtkImageData::SafeDownCast(set))
  {
    PassImage(parcel, image);
  }
  else if (auto* rectilinear = vtkRectilinearGrid::SafeDownCast(set))
  {
    PassGrid(parcel, rectilinear);
  }
  else if (auto* structured = vtkStructuredGrid::SafeDownCast(set))
  {
    PassExtent(parcel, structured);
    PassPoints(parcel, structured);
  }
  else if (auto* mesh = vtkUnstructuredGrid::SafeDownCast(set))
  {
    PassPoints(parcel, mesh);
    PassCells(parcel, mesh);
  }
  PassAttributes(parcel, set->GetPointData());
  PassAttributes(parcel, set->GetCellData());
}

void PassWords(Parcel& parcel, Volume& volume)
{
  for (std::string* text : { &volume.Name, &volume.From, &volume.Remark, &volume.Array.Name })
  {
    parcel.Pass(*text);
  }
  parcel.Pass(volume.Array.IsOnCells);
  parcel.Pass(volume.TimeSteps);
  bool hasPlacement = volume.Placement != nullptr;
  std::array<double, 16> placement{};
  if (volume.Placement)
  {
    std::copy_n(volume.Placement->GetData(), 16, placement.begin());
  }
  parcel.Pass(hasPlacement);
  parcel.Pass(placement);
  if (parcel.IsRead && hasPlacement)
  {
    volume.Placement = vtkSmartPointer<vtkMatrix4x4>::New();
    volume.Placement->DeepCopy(placement.data());
  }
}

}

bool WriteHandOver(const Volume& volume, const std::string& path)
{
  int type = TypeOf(volume.Data);
  if (type < 0)
  {
    return false;
  }
  Parcel parcel(path, false);
  Volume copy = volume;
  parcel.Pass(type);
  PassWords(parcel, copy);
  PassData(parcel, vtkDataSet::SafeDownCast(copy.Data));
  return parcel.EndWell();
}

std::optional<Volume> ReadHandOver(const std::string& path)
{
  Parcel parcel(path, true);
  int type = -1;
  parcel.Pass(type);
  Volume volume;
  PassWords(parcel, volume);
  const vtkSmartPointer<vtkDataSet> set = MakeOf(type);
  PassData(parcel, set);
  volume.Data = set;
  return parcel.IsWhole() ? std::optional<Volume>(volume) : std::nullopt;
}
