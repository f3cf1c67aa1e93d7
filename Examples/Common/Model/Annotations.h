// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Annotations_h
#define Annotations_h

#include "Files/Volume.h"
#include "Model/Settings.h"

#include <vtkAxesActor.h>
#include <vtkColorTransferFunction.h>
#include <vtkImageData.h>
#include <vtkImageResliceMapper.h>
#include <vtkImageSlice.h>
#include <vtkLeaderActor2D.h>
#include <vtkLegendScaleActor.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOutlineSource.h>
#include <vtkPlane.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

// What a picture has beside the volume: samples on the clipping plane, the outline of the box,
// axes, a scale bar and a colour bar.
class Annotations
{
public:
  explicit Annotations(vtkRenderer* renderer);

  // Of a volume in its place, with the bounds of its data.
  void Show(const Volume& volume, int component, const Box& bounds);
  // What the colour bar shows, if not the colours of the values that are drawn.
  struct ColorKey
  {
    vtkSmartPointer<vtkColorTransferFunction> Colors; // null: those
    std::string Title;
  };
  void Apply(const Look& look, vtkColorTransferFunction* colors, const ColorKey& key);

  // In any picture until it is hidden, or until other data are shown.
  void ShowRuler(const Point& from, const Point& to);
  void HideRuler() { this->Ruler->VisibilityOff(); }

  // Samples at points of an image.
  bool CanShowCut() const { return this->HasSamples; }
  bool HasAny() const;
  bool ShowsCut() const { return this->Cut->GetVisibility() != 0; }

  // The sample at a place in the world by the interpolant; none beside the data.
  std::optional<double> SampleAt(const Point& place) const;

  // Lays them over a picture that the mapper made as the renderer's camera sees it, with Color and
  // Depth: as large as they are in the view. In any thread.
  void DrawOver(vtkImageData* picture) const;

private:
  void ShowAs(const Annotations& other);
  void TakeSamples();
  void PlaceCut();
  void PlaceCrop();

  vtkRenderer* Renderer;
  vtkNew<vtkImageSlice> Cut;
  vtkNew<vtkImageResliceMapper> CutMapper;
  vtkNew<vtkPlane> CutPlane;
  vtkNew<vtkColorTransferFunction> Greys;
  vtkNew<vtkOutlineSource> Outline;
  vtkNew<vtkPolyDataMapper> OutlineMapper;
  vtkNew<vtkActor> OutlineActor;
  vtkNew<vtkAxesActor> Axes;
  vtkNew<vtkLegendScaleActor> ScaleBar;
  vtkNew<vtkScalarBarActor> ColorBar;
  vtkNew<vtkTextActor> TitleOfBar;
  vtkNew<vtkLeaderActor2D> Ruler;
  Volume Shown;
  int Component = 0;
  Box Bounds = {};
  Look Applied;
  vtkSmartPointer<vtkColorTransferFunction> Colors;
  ColorKey Key;
  vtkNew<vtkMatrix4x4> Placement; // from the data's space to the world
  bool HasSamples = false;
  // One component along its own axes, from the first time on that the plane shows it.
  vtkSmartPointer<vtkImageData> Samples;
  vtkNew<vtkMatrix4x4> SamplesToWorld;
};

#endif
