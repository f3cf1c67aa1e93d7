// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_CellBeam_h
#define TemporalCoherence_CellBeam_h

#include "Lattice/KernelsBeam.h"
#include "Lattice/KernelsCellValues.h"
#include "Lattice/KernelsMetCells.h"
#include "Lattice/SurfaceTracer.h"
#include "Lattice/TracedCells.h"
#include "Scene/Difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <vector>

#include <hwy/base.h>

namespace TemporalCoherence
{

/// The isovalues of a scene in the form that beams test. All tiles share them.
/// \tparam T type of which differences from isovalues are taken
template <typename T>
struct BeamLevels
{
  explicit BeamLevels(const TraceScene& scene)
  {
    const std::vector<double>& isovalues = scene.Isosurfaces.Isovalues;
    // Differences from an isovalue far from all samples would lose precision.
    const double middle = 0.5 * scene.FiniteRange.x + 0.5 * scene.FiniteRange.y;
    const auto base = std::min_element(isovalues.begin(), isovalues.end(),
      [&](double a, double b) { return std::abs(a - middle) < std::abs(b - middle); });
    const IsovalueScale scale = IsovalueScale::For<T>({ *base, *base }, scene.FiniteRange);
    const double largest = scale.LargestFrom(*base, scene.FiniteRange);
    this->Base = static_cast<std::size_t>(base - isovalues.begin());
    this->Unit = sizeof(RealOf<T>) == sizeof(double) && largest > 0.0
      ? std::ldexp(1.0, std::min(-std::ilogb(largest), 1000))
      : 1.0;
    for (const double isovalue : isovalues)
    {
      // Beyond the difference of any sample: unscaled in float, in units of the largest in double.
      constexpr double most = sizeof(RealOf<T>) == sizeof(float) ? 4e30 : 1e12;
      const double offset = (scale.Scaled(isovalue) - scale.Scaled(*base)) * this->Unit;
      this->Isovalues.push_back(static_cast<float>(std::min(std::max(offset, -most), most)));
    }
  }

  /// True if a cell's differences from the base serve all isovalues. The difference of a non-finite
  /// sample depends on the isovalue.
  /// \tparam Sample type of the samples
  template <typename Sample>
  bool AreTold(const std::array<Sample, 8>& samples) const
  {
    return this->AreAlwaysTold<Sample>() ||
      std::all_of(samples.begin(), samples.end(),
        [](Sample sample) { return std::isfinite(static_cast<double>(sample)); });
  }

  /// True if AreTold holds for all cells.
  template <typename Sample>
  bool AreAlwaysTold() const
  {
    return !std::is_floating_point_v<Sample> || this->Isovalues.size() == 1;
  }

  std::size_t Base;             ///< position of the isovalue that differences are taken from
  double Unit;                  ///< factor of all differences
  std::vector<float> Isovalues; ///< as scaled differences from the base
};

/// Finds the first hits of a tile's rays by a beam. Base class for each kind of field.
///
/// The beam only skips cells: cells that a ray does not pass, cells where single precision proves a
/// miss, and cells behind a *certain hit*, a hit that single precision proves. Other cells are
/// searched with the arithmetic of a walk, and the first cell with a surface holds the hit, as on a
/// walk. (Entry distances order cells along a ray: planes separate cells, so their intervals share
/// at most an end point.)
///
/// \tparam Geometry of the cells, as for TracedCells
template <typename T, typename Geometry>
class CellBeam : protected BeamScene
{
public:
  using Real = typename Geometry::Real;
  using Traced = TracedCells<T, Geometry, Interpolation::Linear>;
  using Levels = BeamLevels<typename Geometry::Value>;

  CellBeam(const Traced& cells, const Levels& levels, const RayBatch& rays, HitBatch& hits)
    : Cells(cells)
    , Given(levels)
    , Rays(rays)
    , Hits(hits)
  {
  }

  /// Find the hits of some rays, one bit each.
  /// \param grid coordinates of samples; null: they lie at integers
  /// \return false if they must walk
  bool Trace(std::uint64_t wanted, const GridCoordinates* grid = nullptr)
  {
    TileBeam beam;
    if (!SetUpBeam(this->Rays, wanted, this->Cells.Count, beam))
    {
      return false;
    }
    this->FirstEnter.fill(std::numeric_limits<double>::infinity());
    const BeamTask task{ this->Given.Isovalues, *this->Cells.Scene.Active,
      this->Cells.Rules.IsSolid(), grid };
    SearchBeam(task, *this, beam);
    this->Hits.CellsRead += beam.CellsPassed;
    return true;
  }

protected:
  std::uint64_t CellsOf(std::int64_t node, const glm::ivec3& cell) const final
  {
    return this->Cells.Scene.Active->CellsOf(this->Cells.Samples.All(), node, cell);
  }

  std::int32_t Read(const glm::ivec3& cell, CellValues& values) final
  {
    const auto number = static_cast<std::size_t>(this->NumberOfRead);
    Corners<Real>& differences = this->FromBase[number];
    this->Places[number] = cell;
    this->TakeDifferences(cell, differences, values);
    if (!(this->Given.template AreAlwaysTold<T>() ||
          this->Given.AreTold(this->Cells.Samples.Read(cell))))
    {
      values.SetUnknown();
    }
    return this->NumberOfRead++;
  }

  /// Set up one segment for each ray with a certain hit, in the cell of that hit.
  /// \param places of the cells that were read
  /// \return one bit for each ray with a certain hit
  template <typename Where>
  std::uint64_t TakeMet(
    const OfReadCells<Where>& places, const TileBeam& beam, SegmentBatch<Real>& segments)
  {
    segments.All = &this->Rays;
    segments.Count = this->Rays.Count;
    const std::uint64_t met = GatherPlaces(places, beam.Cell, segments);
    if (this->Given.Isovalues.size() > 1)
    {
      std::fill_n(this->MetBy.begin(), this->CountOfRead(), std::uint64_t(0));
      for (std::uint64_t left = met; left != 0; left &= left - 1)
      {
        const std::size_t ray = hwy::Num0BitsBelowLS1Bit_Nonzero64(left);
        this->MetBy[static_cast<std::size_t>(beam.Cell[ray])] |= std::uint64_t(1) << ray;
      }
    }
    return met;
  }

  /// Set the corners of the segments, as differences from an isovalue.
  /// \param met rays with a certain hit, one bit each
  /// \return true if any segment may cross the isovalue; segments.Wanted has one bit for each
  bool SetCorners(const TileBeam& beam, std::uint64_t met, std::size_t isovalue,
    SegmentBatch<Real>& segments) const
  {
    segments.Wanted = met;
    if (this->Given.Isovalues.size() == 1)
    {
      GatherCorners(this->FromBase, beam.Cell, segments);
      return met != 0;
    }
    OfReadCells<Corners<Real>> differences;
    segments.Wanted = 0;
    for (std::size_t i = 0; i < this->CountOfRead(); ++i)
    {
      if (this->MetBy[i] != 0)
      {
        differences[i] = isovalue == this->Given.Base
          ? this->FromBase[i]
          : this->Cells.Differ(this->Cells.Samples.Read(this->Places[i]), isovalue);
        segments.Wanted |= this->Cells.CanHold(differences[i]) ? this->MetBy[i] : 0;
      }
    }
    if (segments.Wanted != 0)
    {
      GatherCorners(differences, beam.Cell, segments);
    }
    return segments.Wanted != 0;
  }

  /// Call visit(ray, cell) for each open cell in front of its ray's certain hit, and clear the
  /// list.
  template <typename Visitor>
  void VisitOpen(OpenCells& open, const TileBeam& beam, const Visitor& visit)
  {
    for (std::size_t i = 0; i < open.Count; ++i)
    {
      const std::size_t ray = open.Ray[i];
      if (open.Enter[i] < beam.Behind[ray])
      {
        visit(ray, this->Places[static_cast<std::size_t>(open.Cell[i])]);
      }
    }
    open.Count = 0;
  }

  /// A ray has a hit in the cell that it enters at `enter`: skip all cells that it enters later.
  static void HideBehind(double enter, std::size_t ray, TileBeam& beam)
  {
    beam.Behind[ray] = std::min(beam.Behind[ray], beam.DistanceOf(enter) + beam.Margin);
  }

  std::size_t CountOfRead() const { return static_cast<std::size_t>(this->NumberOfRead); }

  /// Forget the cells read so far, and the certain hits in them.
  void ForgetCells(TileBeam& beam)
  {
    beam.Cell.fill(TileBeam::NoCell);
    this->NumberOfRead = 0;
  }

  const Traced& Cells;
  const Levels& Given;
  const RayBatch& Rays;
  HitBatch& Hits;
  RayBatch::Array<double> FirstEnter; ///< t at which rays enter the cells of their hits
  OfReadCells<glm::ivec3> Places;     ///< of the cells that are read

private:
  /// Compute a cell's differences from the base, in full precision and for the beam.
  void TakeDifferences(const glm::ivec3& cell, Corners<Real>& differences, CellValues& values) const
  {
    const T* const sample = this->Cells.Samples.All().At(cell);
    const glm::i64vec3& s = this->Cells.Samples.All().Strides;
    const std::array<std::int64_t, 4> rows = { 0, s.y, s.z, s.y + s.z };
    const auto& difference = this->Cells.Differences[this->Given.Base];
    if constexpr (std::is_floating_point_v<T>)
    {
      if (s.x == 1)
      {
        const CellRows<T> from = { sample, sample + rows[1], sample + rows[2], sample + rows[3] };
        FindCellValues(from, difference.InDouble(), this->Given.Unit, differences, values);
        return;
      }
    }
    const auto single = [&](Real value)
    {
      return static_cast<float>(
        sizeof(Real) == sizeof(float) ? value : value * static_cast<Real>(this->Given.Unit));
    };
    for (std::size_t row = 0; row < 4; ++row) // in one loop: measured faster than in three
    {
      const T* const from = sample + rows[row];
      const Real low = difference(static_cast<typename Geometry::Value>(from[0]));
      const Real high = difference(static_cast<typename Geometry::Value>(from[s.x]));
      differences[2 * row] = low;
      differences[2 * row + 1] = high;
      values.Set(row, single(low), single(high));
    }
  }

  OfReadCells<Corners<Real>> FromBase; ///< differences from the base at the corners of cells read
  /// Rays with a certain hit in each cell read, one bit each. Set only for several isovalues.
  OfReadCells<std::uint64_t> MetBy;
  std::int32_t NumberOfRead = 0;
};

}

#endif
