// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Scene_h
#define Scene_h

#include "View/Viewpoint.h"

#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkTemporalCoherenceVolumeMapper.h>
#include <vtkVolume.h>

#include <array>

struct IsovalueChoice;
struct Options;
struct Volume;

// One volume, one mapper, one camera.
class Scene
{
public:
  Scene(const Volume& source, const IsovalueChoice& isovalue, const Options& options);

  void SetIsovalue(double isovalue);

  // A colour for low values; bone for high ones.
  void SetLowColor(double red, double green, double blue);
  void SetDefaultColor() { this->SetLowColor(0.80, 0.52, 0.38); }

  // Walk around the volume: 0 degrees is where Options::From says.
  void SetAzimuth(double degrees);

  vtkNew<vtkTemporalCoherenceVolumeMapper> Mapper;
  vtkNew<vtkVolume> Actor;
  vtkNew<vtkRenderer> Renderer;

private:
  Viewpoint Around;
  std::array<double, 3> ColorValues; // values at which colours are given: low, middle, high
};

#endif
