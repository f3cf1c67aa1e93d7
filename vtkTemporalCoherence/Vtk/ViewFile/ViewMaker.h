// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ViewMaker_h
#define TemporalCoherence_ViewMaker_h

#include "Acceleration/SurfaceHistogram.h"
#include "Isomap/KnotImage.h"
#include "Render/FrameRenderer.h"
#include "Scene/Progress.h"
#include "ViewFile/ViewDescription.h"

#include <string>
#include <vector>

namespace TemporalCoherence
{

/// Makes the knots of views of one scene. Kept isomaps of mappers stay as they are.
class ViewMaker
{
public:
  /// \param tolerance largest error of distances, in voxels
  explicit ViewMaker(double tolerance)
    : Tolerance(tolerance)
  {
  }

  /// Why the pictures of a frame cannot be written, and the remedy; empty if they can.
  static std::string WhyNot(const FrameKey& key);

  /// Where the surfaces of a frame's samples are.
  /// \throws std::bad_alloc
  SurfaceHistogram CountSurfaces(const FrameKey& key);

  /// Make the knots of a view.
  /// \param range  of isovalues; limited to the range of the samples
  /// \param report called with the progress; may stop it
  /// \param error  receives the mistake and its remedy; empty if the report stopped it
  /// \return false if they are not made
  /// \throws std::bad_alloc
  bool Make(const FrameKey& key, const ValueBand& range, const ReportProgress& report,
    KnotImage& knots, std::string& error);

  /// Make the picture of surfaces, lit as pages light them: without shadows.
  /// \param range to which isovalues are limited
  /// \throws std::bad_alloc
  const Frame& Draw(
    const FrameKey& key, const std::vector<ViewSurface>& surfaces, const ValueBand& range);

private:
  static FrameKey WithoutLook(const FrameKey& key, double isovalue);

  double Tolerance;
  FrameRenderer Renderer;
};

}

#endif
