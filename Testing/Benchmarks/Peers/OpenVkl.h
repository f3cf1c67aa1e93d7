// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Benchmarks_OpenVkl_h
#define Benchmarks_OpenVkl_h

#include "Stage.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

/// The stage's isosurface by Intel's Open VKL: packets of 16 rays, its hit iterators and gradients,
/// one light in the camera, colour and depth written, all threads. Rays go through the centres of
/// the mapper's pixels.
class OpenVkl
{
public:
  /// Kinds of regular volumes to try: the one that Open VKL ships, and its older accelerator, which
  /// is there only in builds that register it by the name structuredRegularGrid.
  static std::vector<std::string> Kinds();

  /// Null if Open VKL is not built in, has no such kind, or cannot show the stage's volume; where
  /// that is not for lack of Open VKL, a sentence goes to the error stream.
  static std::unique_ptr<OpenVkl> Make(const Stage& stage, const std::string& kind);

  virtual ~OpenVkl() = default;
  OpenVkl(const OpenVkl&) = delete;
  OpenVkl& operator=(const OpenVkl&) = delete;

  virtual void SetIsovalues(const std::vector<double>& isovalues) = 0;
  void SetIsovalue(double isovalue) { this->SetIsovalues({ isovalue }); }

  /// The opacity of all surfaces: 1 unless it is set. Behind translucent ones the iterators go on,
  /// and each further hit is shaded and composited, until less than 1/512 of the light passes.
  virtual void SetOpacity(double opacity) = 0;

  /// Draw the stage's view; milliseconds.
  virtual double Draw(const Stage& stage) = 0;

  /// Surfaces that were shaded for the last picture.
  virtual std::int64_t NumberOfLayers() const = 0;

  /// Share in percent of the last picture's pixels that show a surface.
  virtual double PercentHit() const = 0;

protected:
  OpenVkl() = default;
};

#endif
