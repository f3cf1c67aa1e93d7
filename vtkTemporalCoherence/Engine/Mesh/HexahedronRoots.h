// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_HexahedronRoots_h
#define TemporalCoherence_HexahedronRoots_h

#include "Mesh/KernelsCells.h"

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

/// Where x, y and the difference are 0.
struct HexahedronRoot
{
  std::array<double, 3> At; ///< in the cell, from -1 to 1
  double T;
  bool Rises; ///< the difference rises along the ray
};

/// Nothing is set at first: whole batches of rays have room for roots, and most find none here.
struct HexahedronRoots
{
  std::size_t Count;
  std::array<HexahedronRoot, Crossings::MostInCell> Roots;
};

/// Find all roots in a cell, one ray at a time: halve boxes until each holds no root, or one.
///
/// Boxes whose roots cannot be told apart are halved down to SmallestBox, and then taken as one
/// root; at most MostBoxes are looked at. So whole lines or faces of roots end the search, too.
void FindRoots(const SeenHexahedron& cell, HexahedronRoots& roots);

constexpr double SmallestBox = 1e-10; ///< of the cell's edge
constexpr int MostBoxes = 4096;

/// Rounding errors of values, where the largest value at a corner is 1.
constexpr double ValueError = 4e-15;

/// How far outside of a cell roots still count, in the cell's coordinates, beyond rounding errors.
constexpr double Margin = 1e-12;

/// Rounding errors of roots for which a system is too ill-conditioned to be solved at once.
constexpr double MostError = 0.03;

/// Slopes of the nonlinear parts of a preconditioned system, below which it has one root at most in
/// the box, and Newton's method in the box finds it.
constexpr double MostNonlinear = 1.0 / 3.0;

/// Systems with a smaller determinant are taken for singular.
constexpr double LeastDeterminant = 1e-60;

/// Newton's method ends after so many steps; with so short a step, whose square no longer matters;
/// or where the box keeps it from moving.
constexpr int MostNewtonSteps = 16;
constexpr double LastStep = 2e-8, LastMove = 1e-16;

/// In vectors, it is left to smaller boxes after so many steps, as others wait.
constexpr int MostStepsOfVectors = 8;

/// In vectors, systems with larger rounding errors are searched alone, roots with larger ones in
/// smaller boxes. A root in a cell may lie beyond it by so many times its rounding error.
constexpr double MostErrorOfSystem = 1e-6, MostErrorOfRoot = 1e-3, MostOfErrors = 4.0;

/// By the lengths of the slopes of a system, the smallest volume that they may span; and how much
/// farther than bends and rounding errors say roots may lie from those of the linear part: more
/// than the inverse of such slopes is inexact.
constexpr double LeastSpan = 0x1p-20, Slack = 0x1p-20;

/// A system has one root at most if the spectral radius of its slopes is less.
constexpr double MostSlope = 0.9;

/// So far beyond a box, by its size, roots are found, too: then it is known that they lie outside.
constexpr double MostAround = 0.125;

/// Boxes of which no more than this remains along an axis are not halved.
constexpr double EnoughCut = 0.6;

/// The shortest edge of a box that was cut, by its longest one.
constexpr double Thinnest = 0x1p-14;

/// How often boxes of vectors are cut or halved before a ray is searched alone.
constexpr int MostRounds = 12;

}
}

#endif
