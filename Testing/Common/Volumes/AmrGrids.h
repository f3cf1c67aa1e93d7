// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_AmrGrids_h
#define Testing_AmrGrids_h

#include <vtkAMRBox.h>
#include <vtkAMRUtilities.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkOverlappingAMR.h>
#include <vtkSmartPointer.h>
#include <vtkStructuredData.h>
#include <vtkUniformGrid.h>
#include <vtkVersionMacros.h>

#include <glm/glm.hpp>

#include <cstddef>
#include <functional>
#include <random>
#include <vector>

/// Boxes of cells on one level, both corners included.
struct AmrTestBox
{
  glm::ivec3 First, Last;
};

/// An adaptive grid as its boxes.
struct AmrTestLevels
{
  glm::dvec3 Origin{ 0.0 };
  glm::dvec3 Spacing{ 1.0 };                  ///< of level 0
  std::vector<int> Ratios;                    ///< between a level and the next one
  std::vector<std::vector<AmrTestBox>> Boxes; ///< of each level

  glm::dvec3 SpacingOf(std::size_t level) const
  {
    glm::dvec3 spacing = this->Spacing;
    for (std::size_t l = 0; l < level; ++l)
    {
      spacing /= static_cast<double>(this->Ratios[l]);
    }
    return spacing;
  }

  int RatioToFinest(std::size_t level) const
  {
    int ratio = 1;
    for (std::size_t l = level; l < this->Ratios.size(); ++l)
    {
      ratio *= this->Ratios[l];
    }
    return ratio;
  }
};

using AmrFunction = std::function<double(const glm::dvec3&)>;

/// Cells have the values of a function at their centres.
inline vtkSmartPointer<vtkOverlappingAMR> MakeAmr(
  const AmrTestLevels& levels, const AmrFunction& function)
{
  const auto amr = vtkSmartPointer<vtkOverlappingAMR>::New();
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  std::vector<unsigned int> counts;
  for (const auto& boxes : levels.Boxes)
  {
    counts.push_back(static_cast<unsigned int>(boxes.size()));
  }
  amr->Initialize(counts);
  amr->SetGridDescription(vtkStructuredData::VTK_STRUCTURED_XYZ_GRID);
#else
  std::vector<int> counts;
  for (const auto& boxes : levels.Boxes)
  {
    counts.push_back(static_cast<int>(boxes.size()));
  }
  amr->Initialize(static_cast<int>(counts.size()), counts.data());
  amr->SetGridDescription(VTK_XYZ_GRID);
#endif
  amr->SetOrigin(&levels.Origin.x);
  for (std::size_t l = 0; l < levels.Boxes.size(); ++l)
  {
    const auto level = static_cast<unsigned int>(l);
    const glm::dvec3 spacing = levels.SpacingOf(l);
    amr->SetSpacing(level, &spacing.x);
    if (l < levels.Ratios.size())
    {
      amr->SetRefinementRatio(level, levels.Ratios[l]);
    }
    for (std::size_t b = 0; b < levels.Boxes[l].size(); ++b)
    {
      const AmrTestBox& box = levels.Boxes[l][b];
      const glm::ivec3 cells = box.Last - box.First + 1;
      const glm::dvec3 origin = levels.Origin + glm::dvec3(box.First) * spacing;
      vtkNew<vtkUniformGrid> grid;
      grid->SetOrigin(&origin.x);
      grid->SetSpacing(&spacing.x);
      grid->SetDimensions(cells.x + 1, cells.y + 1, cells.z + 1);
      vtkNew<vtkDoubleArray> values;
      values->SetName("values");
      for (int c = 0; c < cells.x * cells.y * cells.z; ++c)
      {
        const glm::dvec3 cell(c % cells.x, c / cells.x % cells.y, c / cells.x / cells.y);
        values->InsertNextValue(function(origin + (cell + 0.5) * spacing));
      }
      grid->GetCellData()->SetScalars(values);
      amr->SetAMRBox(level, static_cast<unsigned int>(b), vtkAMRBox(&box.First.x, &box.Last.x));
      amr->SetDataSet(level, static_cast<unsigned int>(b), grid);
    }
  }
  return amr;
}

/// The grid of a block of MakeAmr.
inline vtkUniformGrid* GridAt(vtkOverlappingAMR* amr, unsigned int level, unsigned int block)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  return vtkUniformGrid::SafeDownCast(amr->GetDataSetAsImageData(level, block));
#else
  return amr->GetDataSet(level, block);
#endif
}

/// How many blocks a level has.
inline unsigned int BlocksAt(vtkOverlappingAMR* amr, unsigned int level)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  return amr->GetNumberOfBlocks(level);
#else
  return amr->GetNumberOfDataSets(level);
#endif
}

/// Cut a box into blocks.
inline std::vector<AmrTestBox> CutBox(const AmrTestBox& box, int size)
{
  std::vector<AmrTestBox> blocks;
  for (int z = box.First.z; z <= box.Last.z; z += size)
  {
    for (int y = box.First.y; y <= box.Last.y; y += size)
    {
      for (int x = box.First.x; x <= box.Last.x; x += size)
      {
        const glm::ivec3 first(x, y, z);
        blocks.push_back({ first, glm::min(first + (size - 1), box.Last) });
      }
    }
  }
  return blocks;
}

/// Two or three levels: a cube, and in it and in its parts a few boxes, which may touch the surface
/// of the cube and the boxes of other levels, or overlap.
inline AmrTestLevels RandomAmr(unsigned int seed)
{
  std::mt19937 engine(seed);
  const auto below = [&](int n)
  { return static_cast<int>(engine() % static_cast<unsigned int>(n)); };
  AmrTestLevels levels;
  levels.Origin = { -3.5, 10.0, 0.25 };
  levels.Spacing = { 1.0, 0.75, 2.0 };
  const int cells = 4 + below(4);
  levels.Boxes.push_back(CutBox({ glm::ivec3(0), glm::ivec3(cells - 1) }, 2 + below(4)));
  for (int level = 1; level <= 1 + below(2); ++level)
  {
    const int ratio = below(3) == 0 ? 4 : 2;
    std::vector<AmrTestBox> boxes;
    for (int b = 0; b <= below(3); ++b)
    {
      const auto& coarser = levels.Boxes.back();
      const AmrTestBox& in =
        coarser[static_cast<std::size_t>(below(static_cast<int>(coarser.size())))];
      AmrTestBox box;
      for (int axis = 0; axis < 3; ++axis)
      {
        const int length = in.Last[axis] - in.First[axis] + 1;
        const int first = below(length), last = first + below(length - first);
        box.First[axis] = (in.First[axis] + first) * ratio;
        box.Last[axis] = (in.First[axis] + last + 1) * ratio - 1;
      }
      boxes.push_back(box);
    }
    levels.Ratios.push_back(ratio);
    levels.Boxes.push_back(boxes);
  }
  return levels;
}

#endif
