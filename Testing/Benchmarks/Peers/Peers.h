// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_Peers_h
#define Benchmarks_Peers_h

#include "Stage.h"

#include <vtkProp3D.h>
#include <vtkSmartPointer.h>

#include <functional>
#include <string>

/// Props that show the stage's isosurface in a window, each by another mapper.
namespace Peers
{

struct Peer
{
  std::string Name;
  vtkSmartPointer<vtkProp3D> Prop;
  std::function<void(double)> SetIsovalue;
};

/// This mapper; every view is a cold frame.
Peer Ours(Stage& stage);

/// vtkFlyingEdges3D with normals, and vtkPolyDataMapper.
Peer Polygons(Stage& stage);

/// vtkFixedPointVolumeRayCastMapper with an opacity that is a step at the isovalue; one ray a
/// pixel, samples a voxel apart.
Peer FixedPoint(Stage& stage);

/// vtkGPUVolumeRayCastMapper with ISOSURFACE_BLEND, samples a voxel apart.
Peer Gpu(Stage& stage);

}

#endif
