// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Testing_Scene_h
#define Testing_Scene_h

#include "AreIdentical.h"
#include "BruteForceTracer.h"
#include "vtkTemporalCoherenceVolumeMapper.h"

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <string>
#include <vector>

/// A volume before a camera, without a window: what most tests render.
struct Scene
{
  /// \param data      may be null
  /// \param isovalues replace the property's list
  Scene(vtkDataSet* data, const std::vector<double>& isovalues);

  void SetIsovalues(const std::vector<double>& isovalues);

  /// Look at the whole volume from a direction (from the volume to the camera).
  void LookFrom(double x, double y, double z);

  /// RenderToImage into Color and Depth.
  bool Render(int width, int height);

  /// Colours and depths of the mapper's last frame.
  bool GetLastFrame(vtkImageData* color, vtkImageData* depth);

  float DepthAt(int x, int y) const
  {
    return *static_cast<float*>(Depth->GetScalarPointer(x, y, 0));
  }
  const unsigned char* ColorAt(int x, int y) const
  {
    return static_cast<unsigned char*>(Color->GetScalarPointer(x, y, 0));
  }

  vtkNew<vtkTemporalCoherenceVolumeMapper> Mapper;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkImageData> Color, Depth;
};

/// How a picture compares with the truth.
struct Agreement
{
  long Pixels = 0;
  long Hits = 0;          ///< of both
  long DifferentHits = 0; ///< a hit here, a miss there, or another isovalue
  long DistantHits = 0;   ///< hits of both that are more than 1e-3 voxel apart
  double MaxDistance = 0; ///< voxels

  /// The contract of a cold frame: hit or miss agrees for 99.99 % of the pixels, depths for 99.9 %
  /// of the hits.
  bool Holds() const
  {
    return 1e4 * static_cast<double>(DifferentHits) <= static_cast<double>(Pixels) &&
      1e3 * static_cast<double>(DistantHits) <= static_cast<double>(Hits);
  }
};

/// Hold the last picture of a scene against brute force, every `stride`-th pixel of every
/// `stride`-th row.
Agreement CompareWithTruth(const Scene& scene, const BruteForceTracer& truth, int stride = 1);

/// Render, compare, print one line; false if the contract is broken or nothing is hit.
bool AgreesWithTruth(const std::string& name, Scene& scene, const BruteForceTracer& truth,
  int width, int height, int stride = 1);

#endif
