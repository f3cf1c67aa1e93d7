// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_BruteForceField_h
#define Testing_BruteForceField_h

#include "vtkTemporalCoherenceCompatibility.h"

#include <array>
#include <functional>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataArray;
class vtkDataSet;
class vtkImageData;
class vtkMatrix4x4;
class vtkRectilinearGrid;
class vtkVolume;
VTK_ABI_NAMESPACE_END

/// The field of a volume in double precision, without any code of the engine: its samples, their
/// positions, the interpolation between them, and hidden cells. Cells with a sample that is not a
/// number are hidden.
class BruteForceField
{
public:
  using Point = std::array<double, 3>;

  /// \param image     gives the positions of samples, and the ghost arrays that hide cells
  /// \param volume    its transform and the interpolation of its property
  /// \param component of the array
  /// \param cells     one tuple for each cell, at its centre; if null, the point scalars
  BruteForceField(vtkImageData* image, vtkVolume* volume, int component, vtkDataArray* cells);

  /// The same for a grid. In index space its samples lie at its coordinates.
  BruteForceField(vtkRectilinearGrid* grid, vtkVolume* volume, int component, vtkDataArray* cells);

  /// Transform a point, and a direction, from the world to index space.
  Point IndexOf(const Point& world) const;
  Point IndexDirectionOf(const Point& world) const;

  /// Shortest edge of a voxel in the world.
  double VoxelSize() const { return this->Voxel; }

  /// The positions of samples along an axis of index space, ascending from 0.
  const std::vector<double>& Planes(std::size_t axis) const { return this->PlanesAlong[axis]; }

  /// True for nearest interpolation, otherwise trilinear.
  bool IsNearest() const { return this->TakesNearest; }

  /// The field minus an isovalue at a point in index space.
  double DifferenceAt(const Point& index, double isovalue) const;

  /// Unit gradient in the world by central differences, one-sided at the boundary and beside a
  /// sample that is not a number; not oriented.
  Point WorldNormalAt(const Point& world) const;

  /// Also hide the cells of which no corner is a shown sample (i, j, k).
  void HideBySamples(const std::function<bool(int, int, int)>& isShown);

  /// True if the data has ghost arrays or samples that are not numbers, or cells are hidden by
  /// samples.
  bool HasHidden() const { return !this->Hidden.empty(); }

  /// True if a point in index space is in a hidden cell.
  bool IsHidden(const Point& index) const;

private:
  void SetSamples(vtkDataArray* array, int component, bool onCells);
  void HideAroundNaN();
  void SetTransform(vtkMatrix4x4* toVolume, vtkVolume* volume);
  void FindHidden(vtkDataSet* data, bool areSamplesCells);
  void HideAroundSamples();
  int CellOf(std::size_t axis, double at) const;
  std::array<int, 3> FindCell(const Point& index, Point& share) const;
  double Sample(int i, int j, int k) const;

  std::vector<double> Samples;
  std::array<std::vector<double>, 3> PlanesAlong;
  std::array<bool, 3> IsDescending{}; ///< the last sample lies in the first plane
  std::vector<bool> Hidden;           ///< of each cell; empty where nothing hides any
  std::array<int, 3> Dimensions;
  bool TakesNearest;
  std::array<double, 16> WorldFromIndex, IndexFromWorld;
  double Voxel;
};

#endif
