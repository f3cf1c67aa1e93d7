// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_HexahedronRoots_h
#define TemporalCoherence_HexahedronRoots_h

#include "Mesh/Cells/CornerPoints.h"
#include "Mesh/Cells/KernelsCells.h"

#include <array>
#include <cstddef>

namespace TemporalCoherence
{
namespace MeshKernels
{

/// A hexahedron as one ray sees it: at each corner the sheared coordinates x and y, the difference,
/// and the distance along the ray.
struct SeenHexahedron
{
  std::array<double, 8> X, Y, Difference, T;
};

/// A hexahedron in the sheared coordinates of one ray, with the distance behind t as its
/// difference.
inline SeenHexahedron SeeFrom(const MeshCell& cell, const MeshRays& rays, std::size_t ray, double t)
{
  const std::array<glm::length_t, 3> axes = TurnedAxes(rays.AxisOf(ray));
  SeenHexahedron seen;
  for (std::size_t corner = 0; corner < 8; ++corner)
  {
    const glm::dvec3& point = cell.Points[corner];
    const double depth = point[axes[2]] - rays.Turned[2][ray];
    seen.X[corner] = (point[axes[0]] - rays.Turned[0][ray]) - rays.ShearX[ray] * depth;
    seen.Y[corner] = (point[axes[1]] - rays.Turned[1][ray]) - rays.ShearY[ray] * depth;
    seen.T[corner] = depth * rays.PerDepth[ray];
    seen.Difference[corner] = seen.T[corner] - t;
  }
  return seen;
}

/// A place in the cell with x = y = difference = 0.
struct HexahedronRoot
{
  std::array<double, 3> At; ///< in the cell, from -1 to 1
  double T;
  bool Rises; ///< the difference rises along the ray
};

/// Roots of one ray. Uninitialised: batches reserve this for every ray, and most rays use none.
struct HexahedronRoots
{
  std::size_t Count;
  std::array<HexahedronRoot, Crossings::MostInCell> Roots;
};

/// Find all roots in a cell, one ray at a time: halve boxes until each holds no root, or one.
///
/// Boxes whose roots cannot be told apart are halved down to SmallestBox, and then taken as one
/// root; at most MostBoxes are looked at. So the search also ends for whole lines or faces of
/// roots.
void FindRoots(const SeenHexahedron& cell, HexahedronRoots& roots);

constexpr double SmallestBox = 1e-10; ///< of the cell's edge
constexpr int MostBoxes = 4096;

/// Rounding errors of values, where the largest value at a corner is 1.
constexpr double ValueError = 4e-15;

/// How far outside of a cell roots still count, in the cell's coordinates, beyond rounding errors.
constexpr double Margin = 1e-12;

/// Systems with larger rounding errors of roots are too ill-conditioned for Newton's method.
constexpr double MostError = 0.03;

/// If the slopes of a preconditioned system's nonlinear parts are below this, the box holds at most
/// one root, and Newton's method finds it.
constexpr double MostNonlinear = 1.0 / 3.0;

/// Systems with a smaller determinant are taken for singular.
constexpr double LeastDeterminant = 1e-60;

/// Newton's method ends after MostNewtonSteps; with a step below LastStep, whose square no longer
/// matters; or with a move below LastMove, where the box stops it.
constexpr int MostNewtonSteps = 16;
constexpr double LastStep = 2e-8, LastMove = 1e-16;

/// Limit of Newton steps in vectors, where other lanes wait. Unfinished lanes go on with smaller
/// boxes.
constexpr int MostStepsOfVectors = 8;

/// In vectors, rays whose systems have larger rounding errors are searched alone, and boxes whose
/// roots have larger errors are halved. A root counts up to MostOfErrors times its error outside of
/// the cell.
constexpr double MostErrorOfSystem = 1e-6, MostErrorOfRoot = 1e-3, MostOfErrors = 4.0;

/// Smallest determinant of a regular system, as a share of the product of its rows' lengths. Slack
/// widens the bounds of roots; it exceeds the error of a regular system's inverse.
constexpr double LeastSpan = 0x1p-20, Slack = 0x1p-20;

/// A system has at most one root if its bends' slopes have a smaller spectral radius.
constexpr double MostSlope = 0.9;

/// Newton's method follows roots beyond a box, up to this share of its half size. Their place then
/// shows that the box holds no root.
constexpr double MostAround = 0.125;

/// Boxes cut to less than this share along an axis are not halved.
constexpr double EnoughCut = 0.6;

/// Shortest edge of a cut box, as a share of its longest edge.
constexpr double Thinnest = 0x1p-14;

/// How often boxes of vectors are cut or halved before a ray is searched alone.
constexpr int MostRounds = 12;

}
}

#endif
