// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_MeshBandRays_h
#define TemporalCoherence_MeshBandRays_h

#include "Isomap/BandTracer.h"
#include "Isomap/KnotCollector.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace TemporalCoherence
{

/// A ray in a cell: differences from the lowest isovalue of a band, in the units of its scale.
struct MeshPassage
{
  double In;          ///< where the ray enters the cell
  double AtIn, AtOut; ///< where it enters, or begins in the cell, and where it leaves
  double Low, High;   ///< bounds in between
  bool IsFinite;      ///< all values of the cell are
  bool BeginsHere;    ///< the ray begins in the cell, and AtIn is not known
  std::uint8_t Ray;
  CellIndex Place; ///< of the cell in the lattice
};

/// How far the rays of a tile have come through a band of a mesh, and the knots that follow.
///
/// Cells come in any order. A ray takes note of those that lie before a distance up to which all
/// are known.
class MeshBandRays
{
public:
  MeshBandRays(const BandScene& scene, const RayBatch& rays);

  void Append(const MeshPassage& passage) { this->Ahead.push_back(passage); }

  /// Take note of what lies before a distance along each ray.
  /// \return one bit for each ray that is done: nothing ahead of it matters
  std::uint64_t GoOnTo(const RayBatch::Array<double>& distances);

  /// Hand the knots over. \throws std::bad_alloc
  void HandOver(TileKnots& knots);

private:
  /// How far a ray has come.
  struct Progress
  {
    std::array<double, NumberOfDirections> Reached{};       ///< infinity: nothing ahead matters
    std::array<BandScale::Key, NumberOfDirections> Noted{}; ///< of the last knots
    bool HasEntered = false;
  };

  /// A passage, by its place among those that are ahead.
  struct Entry
  {
    double In;
    std::uint32_t At;
  };

  void Sort();
  void TakeNote(const MeshPassage& passage);
  bool Jumps(const MeshPassage& passage, double error) const;
  void Enter(const MeshPassage& passage, double error);
  void GiveUp(std::size_t ray);

  const BandScene& Scene;
  const RayBatch& Rays;
  BandScale Scale;
  bool IsSolid;
  KnotCollector Knots;
  std::vector<MeshPassage> Ahead; ///< not yet noted
  std::vector<Entry> Order;       ///< of these, by ray and along it
  std::vector<MeshPassage> Kept;  ///< room for those that stay ahead
  std::array<Progress, RayBatch::Capacity> OfRay;
  std::uint64_t Done = 0;
  std::vector<float> Entries;
  bool HasEntries = false;
};

}

#endif
