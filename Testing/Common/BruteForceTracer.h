// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_BruteForceTracer_h
#define Testing_BruteForceTracer_h

#include <array>
#include <vector>

class vtkDataArray;
class vtkDataSet;
class vtkImageData;
class vtkMatrix4x4;
class vtkRectilinearGrid;
class vtkRenderer;
class vtkVolume;

/// The truth that pictures are held against: every cell on the way of every ray, in double
/// precision, with no structure and no code of the engine.
class BruteForceTracer
{
public:
  struct Hit
  {
    double Distance; ///< world distance along the ray; infinity if nothing is hit
    int Isovalue;    ///< position in the list; -1 if nothing is hit
    std::array<double, 3> Position;
  };

  /// \param image     where the samples lie, and the ghost arrays that hide cells
  /// \param volume    its transform and the interpolation of its property
  /// \param component of the array
  /// \param cells     one tuple for each cell, at its centre; if null, the point scalars
  BruteForceTracer(
    vtkImageData* image, vtkVolume* volume, int component = 0, vtkDataArray* cells = nullptr);

  /// The same for a grid, in whose index space samples lie at its coordinates.
  BruteForceTracer(
    vtkRectilinearGrid* grid, vtkVolume* volume, int component = 0, vtkDataArray* cells = nullptr);

  std::vector<double> Isovalues;
  bool IsThreshold = false; ///< THRESHOLD, otherwise CROSSING

  /// A piece of a line in the world.
  struct Line
  {
    std::array<double, 3> Origin, Direction; ///< the direction has unit length
    double Begin, End;                       ///< distances from the origin
  };

  /// The line of sight through the centre of pixel (x, y) of a picture of width x height, between
  /// the clipping planes of the renderer's camera. It starts at the eye, or on the plane through a
  /// parallel camera.
  static Line LineThrough(vtkRenderer* renderer, int x, int y, int width, int height);

  /// The first hit on a line.
  Hit Trace(const Line& line) const;

  /// A point of the world in index space.
  std::array<double, 3> IndexOf(const std::array<double, 3>& world) const;

  /// The hit seen at the centre of pixel (x, y) of a picture of width x height by the renderer's
  /// camera.
  Hit Trace(vtkRenderer* renderer, int x, int y, int width, int height) const;

  /// Shortest edge of a voxel in the world.
  double VoxelSize() const { return this->Voxel; }

  /// The field minus an isovalue at a point in index space.
  double DifferenceAt(const std::array<double, 3>& index, double isovalue) const;

  /// Unit gradient in the world by central differences, one-sided at the boundary; not oriented.
  std::array<double, 3> WorldNormalAt(const std::array<double, 3>& world) const;

private:
  void SetSamples(vtkDataArray* array, int component, bool onCells);
  void SetPlacement(vtkMatrix4x4* world);
  int CellOf(std::size_t axis, double at) const;
  void FindHidden(vtkDataSet* data, bool areSamplesCells);
  void HideAroundSamples();
  bool IsHidden(const std::array<double, 3>& index) const;
  int HighestInside(const std::array<double, 3>& index) const;
  double Sample(int i, int j, int k) const;
  bool CrossesIn(const std::array<double, 3>& origin, const std::array<double, 3>& direction,
    double begin, double end, double atBegin, double atEnd, double isovalue, double& t) const;

  std::vector<double> Samples;
  std::array<std::vector<double>, 3> Planes; ///< where samples lie in index space, ascending
  std::array<bool, 3> IsDescending{};        ///< the last sample lies in the first plane
  std::vector<bool> Hidden; ///< of each cell; empty where the image has no ghost arrays
  std::array<int, 3> Dimensions;
  bool IsNearest;
  std::array<double, 16> WorldFromIndex, IndexFromWorld;
  double Voxel;
};

#endif
