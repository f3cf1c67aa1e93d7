// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_Stage_h
#define Benchmarks_Stage_h

#include "Volumes/Volumes.h"
#include "vtkTemporalCoherenceVolumeMapper.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkVolume.h>

#include <string>
#include <vector>

/// How much of the picture the object fills.
struct Framing
{
  std::string Name;
  std::string Meaning; ///< a line of the help
  double Zoom;         ///< from where the whole volume is seen; 0: from farther away
};

/// "afar", "whole" and "close".
const std::vector<Framing>& AllFramings();

/// A volume in front of a camera that moves, without a window. Several mappers may look at it in
/// turn, so that each sees the same views.
class Stage
{
public:
  /// \param size pixels of the square picture in each direction
  Stage(
    vtkDataSet* data, double isovalue, int size, const Framing& framing = AllFramings().front());

  /// Back to the framing's view: from the front, a little from above.
  void ResetView();
  /// Around the volume.
  void Orbit(double degrees);
  /// Towards the volume: divide the distance by a factor.
  void Approach(double factor);
  /// To the right, camera and focal point, by a share of what the picture's width shows.
  void Pan(double share);

  /// Another isovalue, in the same colour.
  void SetIsovalue(double isovalue);
  double Isovalue() const;

  /// A share of the range of values, for example as a step from one isovalue to the next.
  double ShareOfRange(double share) const;

  /// By what isovalue `frame` of a sweep is above the first: small steps, one after the other.
  double SweepStep(int frame) const { return this->ShareOfRange(0.0005 * (1 + frame)); }

  /// The isovalue at a share of the range of values.
  double IsovalueAt(double share) const;

  /// The shortest distance between two samples of an image, in the world; of a mesh the mean edge
  /// of its cells, if they filled the box around them.
  double VoxelSize() const;

  const int Size;
  const Framing From;
  const vtkSmartPointer<vtkDataSet> Data;
  const vtkSmartPointer<vtkImageData> Image; ///< the same; null if it is none
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkRenderer> Renderer;

private:
  void FitClippingRange();
};

/// A mapper with its last picture.
struct Drawer
{
  explicit Drawer(const Stage& stage);

  /// Draw the stage; milliseconds.
  /// \throws Measuring::Failure if the mapper cannot
  double Draw(const Stage& stage);

  /// Draw the stage cold, with the isovalue's structures made anew, but not those of the data;
  /// milliseconds. This is what a new isovalue costs if nothing is known of the last one.
  /// \throws Measuring::Failure if the mapper cannot
  double DrawCold(Stage& stage);

  /// The name of the route that made the last picture.
  std::string Route() const { return this->Mapper->GetStatistics()->GetRouteAsString(); }

  double CpuMs = 0.0; ///< CPU time of all threads, of the last picture

  vtkNew<vtkTemporalCoherenceVolumeMapper> Mapper;
  vtkNew<vtkImageData> Color, Depth;
};

/// Share in percent of the last picture's pixels that show a surface.
double PercentHit(const Drawer& drawer);

/// Share in percent of the pixels that are hit in one picture and not in the other, or lie more
/// than a voxel apart.
double PercentDifferent(const Drawer& a, const Drawer& b, const Stage& stage);

/// The largest distance between surfaces that both pictures show at a pixel, in voxels.
double VoxelsApart(const Drawer& a, const Drawer& b, const Stage& stage);

/// True if two pictures are the same to the last bit, in colour and depth.
bool AreIdentical(const Drawer& a, const Drawer& b);

/// The volume of that name; if it is not there, null, and a sentence on the error stream.
vtkSmartPointer<vtkImageData> LoadOrTell(const std::string& name);

#endif
