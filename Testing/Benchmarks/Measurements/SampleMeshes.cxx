// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SampleMeshes.h"

#include "Volumes/Volumes.h"

#include <vtkCellArray.h>
#include <vtkCompositeDataIterator.h>
#include <vtkFloatArray.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkSMPTools.h>
#include <vtkStructuredGrid.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnstructuredGrid.h>
#include <vtkUnstructuredGridReader.h>
#include <vtksys/SystemTools.hxx>

#ifdef BENCHMARK_HAS_IOExodus
#include <vtkExodusIIReader.h>
#endif
#ifdef BENCHMARK_HAS_IOParallel
#include <vtkMultiBlockPLOT3DReader.h>
#endif

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <vector>

namespace SampleMeshes
{
namespace
{

constexpr float Jitter = 0.2f; ///< of an edge; more would fold cells
constexpr vtkIdType Grain = 4096;

/// Cubes a side of a generated mesh; 0 if the name is not of that kind.
int SizeBehind(const std::string& kind, const std::string& name)
{
  constexpr int most = 400;
  const std::string digits = name.rfind(kind, 0) == 0 ? name.substr(kind.size()) : "";
  const bool isNumber = !digits.empty() && digits.size() <= 3 &&
    digits.find_first_not_of("0123456789") == std::string::npos;
  const int size = isNumber ? std::atoi(digits.c_str()) : 0;
  return size >= 2 && size <= most ? size : 0;
}

/// From -1 to 1, the same for the same number.
float RandomOf(std::uint64_t number)
{
  number = (number ^ (number >> 30)) * 0xbf58476d1ce4e5b9u;
  number = (number ^ (number >> 27)) * 0x94d049bb133111ebu;
  number ^= number >> 31;
  return static_cast<float>(number >> 40) / static_cast<float>(1 << 23) - 1.0f;
}

/// Corners of n^3 cubes, x fastest, and the field there.
struct Corners
{
  vtkNew<vtkPoints> Points;
  vtkNew<vtkFloatArray> Values;

  explicit Corners(int n)
  {
    const vtkIdType side = n + 1, count = side * side * side;
    vtkNew<vtkFloatArray> points;
    points->SetNumberOfComponents(3);
    points->SetNumberOfTuples(count);
    this->Values->SetName("shells");
    this->Values->SetNumberOfTuples(count);
    const float edge = 2.0f / static_cast<float>(n);
    vtkSMPTools::For(0, count, Grain,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (vtkIdType i = begin; i < end; ++i)
        {
          const std::array<vtkIdType, 3> at = { i % side, i / side % side, i / side / side };
          float* point = points->GetPointer(3 * i);
          for (std::size_t axis = 0; axis < 3; ++axis)
          {
            const bool isInner = at[axis] > 0 && at[axis] < n;
            const auto number = 3 * static_cast<std::uint64_t>(i) + axis + 1;
            const float shift = isInner ? Jitter * RandomOf(number * 0x9e3779b97f4a7c15u) : 0.0f;
            point[axis] = (static_cast<float>(at[axis]) + shift) * edge - 1.0f;
          }
          this->Values->SetValue(i,
            static_cast<float>(ValueAt(static_cast<double>(point[0]), static_cast<double>(point[1]),
              static_cast<double>(point[2]))));
        }
      });
    this->Points->SetData(points);
  }
};

using CellsOfCube = std::vector<std::array<int, 8>>; ///< corner x + 2 y + 4 z each

/// Six tetrahedra around a diagonal of the cube: neighbouring cubes share their faces' diagonals.
const CellsOfCube SixTetrahedra = { { 0, 1, 3, 7 }, { 0, 3, 2, 7 }, { 0, 2, 6, 7 }, { 0, 6, 4, 7 },
  { 0, 4, 5, 7 }, { 0, 5, 1, 7 } };
const CellsOfCube OneHexahedron = { { 0, 1, 3, 2, 4, 5, 7, 6 } };

vtkSmartPointer<vtkDataSet> MakeUnstructured(int n, const CellsOfCube& cells, int type, int size)
{
  const Corners corners(n);
  const vtkIdType cubes = static_cast<vtkIdType>(n) * n * n, side = n + 1;
  const auto each = static_cast<vtkIdType>(cells.size());
  vtkNew<vtkTypeInt64Array> connectivity, offsets;
  connectivity->SetNumberOfTuples(cubes * each * size);
  offsets->SetNumberOfTuples(cubes * each + 1);
  vtkSMPTools::For(0, cubes, Grain,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType cube = begin; cube < end; ++cube)
      {
        const vtkIdType first = cube % n + (cube / n % n) * side + cube / n / n * side * side;
        vtkTypeInt64* id = connectivity->GetPointer(cube * each * size);
        for (const std::array<int, 8>& cell : cells)
        {
          for (int i = 0; i < size; ++i)
          {
            const int corner = cell[static_cast<std::size_t>(i)];
            *id++ = first + (corner & 1) + (corner >> 1 & 1) * side + (corner >> 2) * side * side;
          }
        }
        for (vtkIdType i = cube * each; i < (cube + 1) * each; ++i)
        {
          offsets->SetValue(i, i * size);
        }
      }
    });
  offsets->SetValue(cubes * each, cubes * each * size);
  vtkNew<vtkCellArray> array;
  array->SetData(offsets.Get(), connectivity.Get());
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(corners.Points);
  grid->SetCells(type, array);
  grid->GetPointData()->SetScalars(corners.Values);
  return grid;
}

vtkSmartPointer<vtkDataSet> MakeCurvilinear(int n)
{
  const Corners corners(n);
  auto grid = vtkSmartPointer<vtkStructuredGrid>::New();
  grid->SetDimensions(n + 1, n + 1, n + 1);
  grid->SetPoints(corners.Points);
  grid->GetPointData()->SetScalars(corners.Values);
  return grid;
}

#if defined(BENCHMARK_HAS_IOExodus) || defined(BENCHMARK_HAS_IOParallel)
/// The first data set of a composite, with the scalars of that name.
vtkSmartPointer<vtkDataSet> FirstOf(vtkCompositeDataSet* composite, const char* scalars)
{
  const auto leaves = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  leaves->InitTraversal();
  vtkSmartPointer<vtkDataSet> first = leaves->IsDoneWithTraversal()
    ? nullptr
    : vtkDataSet::SafeDownCast(leaves->GetCurrentDataObject());
  if (first)
  {
    first->GetPointData()->SetActiveScalars(scalars);
  }
  return first;
}
#endif

vtkSmartPointer<vtkDataSet> ReadExodus(const std::string& path)
{
#ifdef BENCHMARK_HAS_IOExodus
  vtkNew<vtkExodusIIReader> reader;
  reader->SetFileName(path.c_str());
  reader->UpdateInformation();
  reader->SetAllArrayStatus(vtkExodusIIReader::NODAL, 1);
  reader->Update();
  return FirstOf(reader->GetOutput(), "Temp");
#else
  (void)path;
  return nullptr;
#endif
}

vtkSmartPointer<vtkDataSet> ReadPlot3D(const std::string& path)
{
#ifdef BENCHMARK_HAS_IOParallel
  std::string values = path;
  values.replace(values.rfind("xyz"), 3, "q");
  vtkNew<vtkMultiBlockPLOT3DReader> reader;
  reader->AutoDetectFormatOn();
  reader->SetXYZFileName(path.c_str());
  reader->SetQFileName(values.c_str());
  reader->Update();
  return FirstOf(reader->GetOutput(), "Density");
#else
  (void)path;
  return nullptr;
#endif
}

vtkSmartPointer<vtkDataSet> ReadLegacy(const std::string& path)
{
  vtkNew<vtkUnstructuredGridReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

}

double ValueAt(double x, double y, double z)
{
  return std::cos(8.0 * std::sqrt(x * x + y * y + z * z)) +
    0.2 * (std::cos(5.0 * x) + std::cos(6.0 * y) + std::cos(7.0 * z));
}

vtkSmartPointer<vtkImageData> Image(int n)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  const double spacing = 2.0 / (n - 1);
  image->SetDimensions(n, n, n);
  image->SetOrigin(-1.0, -1.0, -1.0);
  image->SetSpacing(spacing, spacing, spacing);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* samples = static_cast<float*>(image->GetScalarPointer());
  vtkSMPTools::For(0, n,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType k = begin; k < end; ++k)
      {
        for (vtkIdType i = 0; i < static_cast<vtkIdType>(n) * n; ++i)
        {
          const auto at = [&](vtkIdType index)
          { return static_cast<double>(index) * spacing - 1.0; };
          samples[k * n * n + i] = static_cast<float>(ValueAt(at(i % n), at(i / n), at(k)));
        }
      }
    });
  return image;
}

bool IsGenerated(const std::string& name)
{
  return SizeBehind("tetrahedra", name) > 0 || SizeBehind("hexahedra", name) > 0 ||
    SizeBehind("curvilinear", name) > 0;
}

vtkSmartPointer<vtkDataSet> Load(const std::string& name)
{
  if (const int n = SizeBehind("tetrahedra", name))
  {
    return MakeUnstructured(n, SixTetrahedra, VTK_TETRA, 4);
  }
  if (const int n = SizeBehind("hexahedra", name))
  {
    return MakeUnstructured(n, OneHexahedron, VTK_HEXAHEDRON, 8);
  }
  if (const int n = SizeBehind("curvilinear", name))
  {
    return MakeCurvilinear(n);
  }
  const std::string path = Volumes::DataDirectory() + "/" + name;
  if (!vtksys::SystemTools::FileExists(path, true))
  {
    return nullptr;
  }
  const std::string suffix = vtksys::SystemTools::GetFilenameLastExtension(name);
  const vtkSmartPointer<vtkDataSet> mesh = suffix == ".ex2" ? ReadExodus(path)
    : suffix == ".bin"                                      ? ReadPlot3D(path)
                                                            : ReadLegacy(path);
  return mesh && mesh->GetNumberOfCells() > 0 && mesh->GetPointData()->GetScalars() ? mesh
                                                                                    : nullptr;
}

}
