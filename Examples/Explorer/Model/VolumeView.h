// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef VolumeView_h
#define VolumeView_h

#include "Files/VolumeReader.h"
#include "Model/Choices.h"
#include "Model/Session.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTemporalCoherenceVolumeMapper.h>
#include <vtkVolume.h>

#include <array>
#include <functional>
#include <string>

class vtkColorTransferFunction;

// What the last frame was like.
struct FrameFacts
{
  std::string Route;
  double Ms = 0.0;     // of the mapper
  double Misses = 0.0; // shares of all rays
  double Hits = 0.0;
  double PossibleHits = 0.0;
  double Traced = 0.0;
  double SamplesPerRay = 0.0;
  double IsomapMiB = 0.0;
};

// The volume, its mapper, light and camera, as a renderer shows them.
class VolumeView
{
public:
  VolumeView();

  void Show(const Volume& volume, const std::array<double, 2>& range);
  void SetIsovalue(double isovalue);
  void Apply(const Chosen& choices);

  // All of the volume is seen; the axes are those of the command line.
  void LookFrom(const std::string& from, const std::string& up);
  CameraState Camera() const;
  void SetCamera(const CameraState& camera);

  // For all isovalues in this view. False if it was stopped by the answer of `progress`, or if
  // there can be none.
  bool BuildIsomap(const std::function<bool(double share)>& progress);

  // The view without panels: as the window shows it, or so many times as large. Throws UserError.
  vtkSmartPointer<vtkImageData> Picture(int scale);

  // The last frame as it is. Throws UserError.
  vtkSmartPointer<vtkImageData> LastFrame();

  FrameFacts Facts();
  vtkColorTransferFunction* Colors() const;

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkTemporalCoherenceVolumeMapper> Mapper;

private:
  vtkNew<vtkVolume> Actor;
  std::array<double, 2> Range = { 0.0, 1.0 };
};

#endif
