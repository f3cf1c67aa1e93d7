// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellRays_h
#define TemporalCoherence_CellRays_h

#include "Scene/RayBatch.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace TemporalCoherence
{
namespace MeshKernels
{

/// Rays in the coordinates of a mesh, as arrays over rays. A ray is Origin + t Direction, t the
/// world distance as in RayBatch. It counts from Begin to End, both included.
///
/// Prepare sets the members below: for each ray, the axis along which its direction is longest, and
/// the shear that maps the ray to this axis. A point p has the sheared coordinates
///   depth = p[axis] - o[axis], x = p[axis + 1] - o[axis + 1] - ShearX depth, y likewise,
/// axes modulo 3. The ray is x = y = 0, and t = depth PerDepth.
struct MeshRays
{
  static constexpr std::size_t Capacity = 64;

  std::size_t Count = 0;
  std::array<TileArray<double>, 3> Origin, Direction;
  TileArray<double> Begin, End;

  std::array<TileArray<double>, 3> Turned; ///< Origin along the axes axis + 1, axis + 2, axis
  TileArray<double> ShearX, ShearY, PerDepth;
  std::array<std::uint64_t, 3> Along; ///< rays with this axis, one bit each

  /// The axis of a ray.
  std::size_t AxisOf(std::size_t ray) const
  {
    return (this->Along[0] >> ray & 1u) != 0 ? 0 : (this->Along[1] >> ray & 1u) != 0 ? 1 : 2;
  }

  /// Prepare the first Count rays for the kernels.
  /// \pre directions are finite and not the zero vector
  void Prepare()
  {
    this->Along = {};
    for (std::size_t ray = 0; ray < this->Count; ++ray)
    {
      const std::array<double, 3> direction = { this->Direction[0][ray], this->Direction[1][ray],
        this->Direction[2][ray] };
      std::size_t axis = std::abs(direction[1]) > std::abs(direction[0]) ? 1 : 0;
      axis = std::abs(direction[2]) > std::abs(direction[axis]) ? 2 : axis;
      const std::size_t x = axis < 2 ? axis + 1 : 0, y = x < 2 ? x + 1 : 0;
      this->Along[axis] |= std::uint64_t(1) << ray;
      this->Turned[0][ray] = this->Origin[x][ray];
      this->Turned[1][ray] = this->Origin[y][ray];
      this->Turned[2][ray] = this->Origin[axis][ray];
      this->ShearX[ray] = direction[x] / direction[axis];
      this->ShearY[ray] = direction[y] / direction[axis];
      this->PerDepth[ray] = 1.0 / direction[axis];
    }
    this->FillUp();
  }

  /// Take a prepared ray of another batch.
  void Take(const MeshRays& from, std::size_t ray, std::size_t at)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Turned[a][at] = from.Turned[a][ray];
      this->Along[a] |= (from.Along[a] >> ray & 1u) << at;
    }
    this->ShearX[at] = from.ShearX[ray];
    this->ShearY[at] = from.ShearY[ray];
    this->PerDepth[at] = from.PerDepth[ray];
    this->Begin[at] = from.Begin[ray];
    this->End[at] = from.End[ray];
  }

  /// Repeat the last ray up to the end of the last vector, so that no lane is uninitialised.
  void FillUp()
  {
    for (std::size_t ray = this->Count; ray > 0 && ray < WholeVectors(this->Count); ++ray)
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        this->Turned[a][ray] = this->Turned[a][ray - 1];
      }
      this->Begin[ray] = this->Begin[ray - 1];
      this->End[ray] = this->End[ray - 1];
      this->ShearX[ray] = this->ShearX[ray - 1];
      this->ShearY[ray] = this->ShearY[ray - 1];
      this->PerDepth[ray] = this->PerDepth[ray - 1];
    }
  }
};

}
}

#endif
