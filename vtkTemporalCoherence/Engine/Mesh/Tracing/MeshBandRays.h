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

/// Passage of a ray through a cell. Values are differences from the lowest isovalue of a band, in
/// the units of its scale.
struct MeshPassage
{
  double In, Out;     ///< where the ray enters the cell, and leaves it
  double AtIn, AtOut; ///< values where it enters, or begins in the cell, and where it leaves
  double Low, High;   ///< bounds of the values in between
  bool IsSimple;      ///< all values of the cell are finite, and the ray passes it only once
  bool BeginsHere;    ///< the ray begins in the cell, and AtIn is not known
  std::uint8_t Ray;
  CellIndex Place; ///< of the cell in the lattice
};

/// Progress of a tile's rays through a band of a mesh, and the resulting knots.
///
/// Cells come in any order. A ray takes note of cells before a distance up to which all cells are
/// known.
///
/// A ray that reached places below and above the band has passed all isovalues. Cells behind both
/// places do not matter.
///
/// Rays in two cells at once are given up: the other cell may hold a nearer crossing of an
/// isovalue. So are rays that only touch a cell at an edge, as the next cell may hold the same
/// surface, and rays that pass a cell twice: look-ups search the whole cell, and might find a
/// crossing behind other cells.
class MeshBandRays
{
public:
  MeshBandRays(const BandScene& scene, const RayBatch& rays);

  void Append(const MeshPassage& passage);

  /// Exclude a ray from look-ups, which could not find its first hit.
  void GiveUp(std::size_t ray);

  /// Distances at which rays have passed the whole band, or end.
  const RayBatch::Array<double>& Limits() const { return this->Ends; }

  /// Number of passages that were not noted yet.
  std::size_t NumberAhead() const { return this->Ahead.size(); }

  /// Take note of the passages before a distance along each ray.
  /// \return false if the knots take too much memory
  bool GoOnTo(const RayBatch::Array<double>& distances);

  /// Hand the knots over.
  /// \throws std::bad_alloc
  void HandOver(TileKnots& knots);

private:
  /// Progress of a ray.
  struct Progress
  {
    std::array<double, NumberOfDirections> Reached{};       ///< infinity: nothing ahead matters
    std::array<BandScale::Key, NumberOfDirections> Noted{}; ///< of the last knots
    double Came = -std::numeric_limits<double>::infinity(); ///< entry into the last cell
    double Left = -std::numeric_limits<double>::infinity(); ///< exit from all cells up to now
    bool HasEntered = false;
  };

  /// A passage, by its place in Ahead.
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
  std::vector<Entry> Order;       ///< of Ahead, by ray and along it
  std::vector<MeshPassage> Kept;  ///< memory for passages that stay ahead
  std::array<Progress, RayBatch::Capacity> OfRay;
  RayBatch::Array<double> Below, Above; ///< where each ray first is below and above the band
  RayBatch::Array<double> Ends;
  std::uint64_t Done = 0;
  std::vector<float> Entries;
  bool HasEntries = false;
};

}

#endif
