// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef VolumeView_h
#define VolumeView_h

#include "Files/VolumeReader.h"
#include "Model/Annotations.h"
#include "Model/ArrayColors.h"
#include "Model/Session.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTemporalCoherenceVolumeMapper.h>
#include <vtkVolume.h>

#include <array>
#include <functional>
#include <string>

// What takes long tells how far it is, and is stopped by the answer false.
using Progress = std::function<bool(double share)>;

// The volume, its mapper, light and camera, as a renderer shows them.
class VolumeView
{
public:
  using Mapping = vtkSmartPointer<vtkTemporalCoherenceVolumeMapper>;

  VolumeView();

  // A mapper that has set up all that depends on the data alone. It may be made beside others, in
  // any thread. Throws UserError if it was stopped.
  static Mapping Prepare(const Volume& volume, int component, double isovalue, const Progress&);

  // By the mapper that there is, or by a new one.
  void Show(
    const Volume& volume, int component, const std::array<double, 2>& range, const Mapping& by);
  void SetAreLabels(bool areLabels) { this->AreLabels = areLabels; } // if it is asked for
  bool CanShowCut() const { return this->Beside.CanShowCut(); }
  bool HasAnnotations() const { return this->Beside.HasAny(); }
  void Apply(Look& look); // tells the shading that it has, if that is the material's

  // With it, a tenth of what averages and sums show is nearly white, or brighter. 0: nothing is
  // seen, and it is to be fitted later.
  double FittingBrightness(Look look);

  // All of the volume is seen; the axes are those of the command line.
  void LookFrom(const std::string& from, const std::string& up);
  CameraState Camera() const;
  // Through the middle, slantwise: the volume is open to the viewer, and the plane can be seen.
  Plane MiddlePlane() const;
  void SetCamera(const CameraState& camera);

  // For all isovalues in this view. False if it was stopped, or if there can be none.
  bool BuildIsomap(const Progress& progress);

  // The view as it was drawn last, or final and with so many pixels, in any thread. Without a
  // background, a picture has an alpha. With several rays along each side of a pixel, it is their
  // mean. Both throw UserError.
  vtkSmartPointer<vtkImageData> LastFrame();
  vtkSmartPointer<vtkImageData> Picture(
    int width, int height, const Progress& progress = [](double) { return true; },
    bool hasBackground = true, int raysOfSide = 1);

  // What is seen at a pixel of the view, from its lower left corner.
  struct Seen
  {
    Point Place = {};
    double Value = 0.0;
    bool IsCut = false; // a sample on the clipping plane; else a surface
    std::string Label;  // the name of a label that is seen; else empty
  };
  std::optional<Seen> SeenAt(int x, int y);

  // A line with its length.
  void ShowRuler(const Point& from, const Point& to) { this->Beside.ShowRuler(from, to); }
  void HideRuler() { this->Beside.HideRuler(); }

  Rgb ColorOf(const Marker& marker) const;
  const std::array<double, 2>& ValueRange() const { return this->Range; }
  // As they were when it was shown: the mapper is not asked, which may be at work.
  const Box& DataBounds() const { return this->Bounds; }
  const Box& WorldBounds() const { return this->BoundsInWorld; }
  vtkMatrix4x4* Placement() const { return this->Actor->GetMatrix(); }
  bool IsMesh() const { return this->HasCells; }

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkVolume> Actor;
  Mapping Mapper;
  ArrayColors Colors; // by another array

private:
  void SetProjection(bool isParallel);
  void SetDensity(const Look& look, int drawing);
  void SetMarkers(const std::vector<Marker>& markers);
  void SetGreys(const std::vector<Marker>& ends);
  void SetLabels(const Look& look);
  std::optional<Seen> CutAt(int x, int y);
  vtkSmartPointer<vtkImageData> Finished(
    vtkSmartPointer<vtkImageData> frame, bool hasBackground, int raysOfSide);
  double LongestEdge() const;

  vtkNew<vtkPlane> Clip;
  std::array<double, 2> Range = { 0.0, 1.0 };
  Box Bounds = {}, BoundsInWorld = {};
  bool HasCells = false;
  bool AreLabels = false;            // samples may be labels
  std::vector<LabelLook> Labels;     // that are drawn; else none
  std::array<double, 3> Ground = {}; // the background, of 255
  Annotations Beside{ this->Renderer };
};

#endif
