// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_KnotCollector_h
#define TemporalCoherence_KnotCollector_h

#include "Isomap/KnotFit.h"
#include "Isomap/KnotGrid.h"
#include "Isomap/Knots.h"
#include "Scene/Field.h"
#include "Scene/RayBatch.h"
#include "Shade/FieldNormals.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// The form in which knots are stored.
struct KnotForm
{
  double Tolerance = 0.0; ///< largest error of a distance; 0: knots are cells. Only fields with
                          ///< linear interpolation are fitted
  bool HasNormals = false;
  std::uint16_t LargestProgress = 65535; ///< of fitted knots (KnotGrid)
};

inline bool operator==(const KnotForm& a, const KnotForm& b)
{
  return a.Tolerance == b.Tolerance && a.HasNormals == b.HasNormals &&
    a.LargestProgress == b.LargestProgress;
}

/// Where the normals of knots come from.
struct KnotNormalSource
{
  const Field& Samples;
  const FieldNormals* Normals; ///< null if knots have none
  glm::dvec2 FiniteRange;      ///< smallest and largest finite sample
  const IndexTransform& Transform;
};

/// Collects the knots of the rays of a tile in any order of rays, and hands them over ray by ray.
class KnotCollector
{
public:
  KnotCollector(const RayBatch& rays, const KnotForm& form, const BandScale& scale);

  bool IsFitted() const { return this->Form.Tolerance > 0.0; }

  /// Add the next cell that raises a ray's progress.
  /// \param distance at which its normal is taken
  void AddCell(std::size_t direction, std::size_t ray, BandScale::Key key, const CellIndex& cell,
    double distance)
  {
    std::vector<CellKnots::Row>& cells = this->Cells[direction];
    if (cells.size() == cells.capacity())
    {
      cells.reserve(std::max(FirstRoom, 2 * cells.size()));
    }
    cells.push_back({ static_cast<std::uint8_t>(ray), { key, cell } });
    if (this->Form.HasNormals)
    {
      this->AddPlace(direction, ray, static_cast<float>(distance - this->Rays.Begin[ray]));
    }
  }

  /// Fit the path of a ray through its next cell.
  /// \param progress along the path from `enter` to `leave`, by Bernstein coefficients
  void Follow(std::size_t direction, std::size_t ray, const Cubic<double>& progress, double enter,
    double leave);

  /// Bytes that the knots so far will take, without normals.
  std::size_t MemoryInBytes() const
  {
    std::size_t bytes = 0;
    for (std::size_t direction = 0; direction < NumberOfDirections; ++direction)
    {
      bytes += this->Cells[direction].size() * CellKnots::BytesPerRow +
        this->Fitted[direction].size() * FittedKnots::BytesPerRow;
    }
    return bytes;
  }

  /// Mark a ray as unresolved.
  void GiveUp(std::size_t ray) { this->Unresolved |= std::uint64_t(1) << ray; }

  /// Hand over all knots. The collector must not be used afterwards.
  /// \throws std::bad_alloc
  void HandOver(const KnotNormalSource& source, TileKnots& knots);

private:
  /// Where to take the normal of a knot: the distance along its ray.
  struct Place
  {
    std::uint8_t Ray;
    float Distance;
  };

  /// Initial capacity in knots: most tiles need no more.
  static constexpr std::size_t FirstRoom = 4 * RayBatch::Capacity;

  void AddPlace(std::size_t direction, std::size_t ray, float distance)
  {
    this->Places[direction].push_back({ static_cast<std::uint8_t>(ray), distance });
  }
  void AddKnot(std::size_t direction, std::size_t ray, const Knot& knot, const KnotPlaces& places);
  void FindNormals(const Place* places, std::size_t count, const KnotNormalSource& source,
    std::vector<KnotNormals::Row>& normals) const;

  const RayBatch& Rays;
  KnotForm Form;
  BandScale Scale;
  std::array<std::vector<CellKnots::Row>, NumberOfDirections> Cells;
  KnotGrid Grid;
  std::vector<KnotFit> Fits; ///< of each ray in each direction
  std::array<std::vector<FittedKnots::Row>, NumberOfDirections> Fitted;
  std::array<std::vector<Place>, NumberOfDirections> Places;
  std::uint64_t Unresolved = 0;
};

}

#endif
