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
  double In, Out;     ///< where the ray enters the cell, and leaves it
  double AtIn, AtOut; ///< where it enters, or begins in the cell, and where it leaves
  double Low, High;   ///< bounds in between
  bool IsSimple;      ///< all values of the cell are finite, and the ray passes it only once
  bool BeginsHere;    ///< the ray begins in the cell, and AtIn is not known
  std::uint8_t Ray;
  CellIndex Place; ///< of the cell in the lattice
};

/// How far the rays of a tile have come through a band of a mesh, and the knots that follow.
///
/// Cells come in any order. A ray takes note of those that lie before a distance up to which all
/// are known.
///
/// Where a ray was below the whole band and above it, it has passed all of its isovalues: what lies
/// behind both places does not matter, whatever lies between them.
///
/// Rays that are in two cells at once are given up: an isovalue that is known to be met in one may
/// be met nearer in the other. So are rays that only touch a cell, at an edge, as it may hold the
/// same surface as the next one, and rays that pass a cell twice: look-ups search it as a whole,
/// and might find what lies behind other cells.
class MeshBandRays
{
public:
  MeshBandRays(const BandScene& scene, const RayBatch& rays);

  void Append(const MeshPassage& passage);

  /// A look-up would not know what a ray meets.
  void GiveUp(std::size_t ray);

  /// Where each ray has passed the whole band, or ends.
  const RayBatch::Array<double>& Limits() const { return this->Ends; }

  /// Passages that were not taken note of.
  std::size_t NumberAhead() const { return this->Ahead.size(); }

  /// Take note of what lies before a distance along each ray.
  /// \return false if the knots take too much memory
  bool GoOnTo(const RayBatch::Array<double>& distances);

  /// Hand the knots over. \throws std::bad_alloc
  void HandOver(TileKnots& knots);

private:
  /// How far a ray has come.
  struct Progress
  {
    std::array<double, NumberOfDirections> Reached{};       ///< infinity: nothing ahead matters
    std::array<BandScale::Key, NumberOfDirections> Noted{}; ///< of the last knots
    double Came = -std::numeric_limits<double>::infinity(); ///< into the last cell
    double Left = -std::numeric_limits<double>::infinity(); ///< the cells up to now
    bool HasEntered = false;
  };

  /// A passage, by its place among those that are ahead.
  struct Entry
  {
    double In;
    std::uint32_t At;
  };

  double ErrorOf(const MeshPassage& passage) const;
  void Narrow(const MeshPassage& passage, double error);
  void Sort();
  void TakeNote(const MeshPassage& passage);
  bool Overlaps(const MeshPassage& passage) const;
  bool Jumps(const MeshPassage& passage, double error) const;
  void Enter(const MeshPassage& passage, double error);

  const BandScene& Scene;
  const RayBatch& Rays;
  BandScale Scale;
  bool IsSolid;
  KnotCollector Knots;
  std::vector<MeshPassage> Ahead; ///< not yet noted
  std::vector<Entry> Order;       ///< of these, by ray and along it
  std::vector<MeshPassage> Kept;  ///< room for those that stay ahead
  std::array<Progress, RayBatch::Capacity> OfRay;
  RayBatch::Array<double> Below, Above; ///< where each ray first is beside the band
  RayBatch::Array<double> Ends;
  std::uint64_t Done = 0;
  std::vector<float> Entries;
  bool HasEntries = false;
};

}

#endif
