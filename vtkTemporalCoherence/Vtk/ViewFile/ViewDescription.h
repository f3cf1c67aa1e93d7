// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ViewDescription_h
#define TemporalCoherence_ViewDescription_h

#include "Isomap/KnotImage.h"
#include "Scene/Appearance.h"
#include "Scene/Field.h"
#include "Scene/FieldShape.h"
#include "Scene/View.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace TemporalCoherence
{

/// What people read about the views of a file.
struct ViewTexts
{
  std::string Title, Caption, Citation, Array, Units;
};

/// A surface that is shown at first.
struct ViewSurface
{
  double Isovalue = 0.0;
  glm::dvec3 Color{ 1.0 };
  double Opacity = 1.0;
};

/// How views look at first.
struct ViewLook
{
  std::vector<ViewSurface> Surfaces;
  std::vector<glm::dvec4> Colors; ///< by isovalue: value, red, green, blue; ascending
  Appearance Light;               ///< material and lights
  glm::dvec3 Background{ 0.0 };
  std::optional<glm::dvec3> Background2; ///< at the top
};

/// How many samples have values in equal parts of a range.
struct ViewHistogram
{
  glm::dvec2 Range{ 0.0 };
  std::vector<std::int64_t> Counts;
};

/// The camera of a view, to tell people.
struct ViewCamera
{
  bool Parallel = false;
  glm::dvec3 Position{ 0.0 }, FocalPoint{ 0.0 }, ViewUp{ 0.0 };
  double ViewAngle = 30.0, ParallelScale = 1.0;
  glm::dvec2 ClippingRange{ 0.0 };
};

/// One view, without its knots.
struct ViewGeometry
{
  std::string Name;
  double Tolerance = 0.0, Voxel = 1.0; ///< in voxels; in the world
  ViewCamera Camera;
  View Rays;
  glm::dmat4 WorldFromIndex{ 1.0 };
  IndexBox Box{ glm::dvec3(0.0), glm::dvec3(0.0) };
  std::vector<glm::dvec4> Planes; ///< normal and offset in the world; the side >= 0 is kept
  std::vector<Light> Lights;      ///< instead of those of the file; empty: those of the file
};

/// Everything in a file but the knots.
struct ViewDescription
{
  ViewTexts Texts;
  ViewLook Look;
  ViewHistogram Histogram;
};

}

#endif
