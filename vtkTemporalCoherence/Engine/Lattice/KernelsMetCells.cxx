// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Lattice/KernelsMetCells.h"

// This file is compiled once for each kind of vectors, and what runs is chosen by the machine.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Lattice/KernelsMetCells.cxx"
#include <hwy/foreach_target.h>

#include "Lattice/CellCubics-inl.h"
#include "Lattice/KernelsSegment-inl.h"

HWY_BEFORE_NAMESPACE();
namespace TemporalCoherence
{
namespace BeamKernels
{
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;
namespace segments = SegmentKernels::HWY_NAMESPACE;

/// Call visit(i, cells) for the numbers of the cells of each vector of rays.
/// \return one bit for each ray with a cell
template <class DI, typename Visit>
HWY_INLINE std::uint64_t VisitCells(DI d, const CellNumbers& cells, const Visit& visit)
{
  std::uint64_t met = 0;
  const auto zero = hn::Zero(d), none = hn::Set(d, TileBeam::NoCell);
  for (std::size_t i = 0; i < RayBatch::Capacity; i += hn::Lanes(d))
  {
    const auto numbers = hn::LoadU(d, &cells[i]);
    met |= BitsIn(d, hn::Gt(numbers, none)) << i;
    visit(i, hn::Max(numbers, zero));
  }
  return met;
}

using Doubles = hn::CappedTag<double, WidestVector / 2>;
using Numbers = hn::Rebind<std::int32_t, Doubles>; ///< one for each double

template <typename Real>
HWY_INLINE std::uint64_t GatherAll(
  const OfReadCells<glm::ivec3>& places, const CellNumbers& cells, SegmentBatch<Real>& to)
{
  const Doubles d;
  const Numbers dn;
  return VisitCells(dn, cells,
    [&](std::size_t i, hn::Vec<Numbers> numbers) HWY_ATTR
    {
      const auto at = hn::Mul(numbers, hn::Set(dn, 3));
      for (int a = 0; a < 3; ++a)
      {
        const auto place = hn::GatherIndex(dn, &places[0][a], at);
        hn::StoreU(hn::PromoteTo(d, place), d, &to.Cell[static_cast<std::size_t>(a)][i]);
      }
    });
}

std::uint64_t PlacesForFloat(
  const OfReadCells<glm::ivec3>& places, const CellNumbers& cells, SegmentBatch<float>& to)
{
  return GatherAll(places, cells, to);
}

std::uint64_t PlacesForDouble(
  const OfReadCells<glm::ivec3>& places, const CellNumbers& cells, SegmentBatch<double>& to)
{
  return GatherAll(places, cells, to);
}

std::uint64_t Boxes(
  const OfReadCells<CellCorners>& boxes, const CellNumbers& cells, SegmentBatch<double>& to)
{
  const Doubles d;
  const hn::RebindToSigned<Doubles> di;
  return VisitCells(Numbers(), cells,
    [&](std::size_t i, hn::Vec<Numbers> numbers) HWY_ATTR
    {
      const auto number = hn::PromoteTo(di, numbers);
      const auto at =
        hn::Add(hn::ShiftLeft<2>(number), hn::ShiftLeft<1>(number)); // six numbers a cell
      for (int a = 0; a < 3; ++a)
      {
        const auto axis = static_cast<std::size_t>(a);
        hn::StoreU(hn::GatherIndex(d, &boxes[0][0][a], at), d, &to.Cell[axis][i]);
        hn::StoreU(hn::GatherIndex(d, &boxes[0][1][a], at), d, &to.Last[axis][i]);
      }
    });
}

void CornersOfFloat(
  const OfReadCells<Corners<float>>& differences, const CellNumbers& cells, SegmentBatch<float>& to)
{
  const Floats d;
  VisitCells(Integers(), cells,
    [&](std::size_t i, hn::Vec<Integers> numbers) HWY_ATTR
    {
      const auto at = hn::ShiftLeft<3>(numbers);
      for (std::size_t corner = 0; corner < 8 && segments::IsAnyWanted(to, i); ++corner)
      {
        hn::StoreU(hn::GatherIndex(d, &differences[0][corner], at), d, &to.Corners[corner][i]);
      }
    });
}

void CornersOfDouble(const OfReadCells<Corners<double>>& differences, const CellNumbers& cells,
  SegmentBatch<double>& to)
{
  const Doubles d;
  const hn::RebindToSigned<Doubles> di;
  VisitCells(Numbers(), cells,
    [&](std::size_t i, hn::Vec<Numbers> numbers) HWY_ATTR
    {
      const auto at = hn::ShiftLeft<3>(hn::PromoteTo(di, numbers));
      for (std::size_t corner = 0; corner < 8 && segments::IsAnyWanted(to, i); ++corner)
      {
        hn::StoreU(hn::GatherIndex(d, &differences[0][corner], at), d, &to.Corners[corner][i]);
      }
    });
}

}
}
}
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace TemporalCoherence
{
namespace BeamKernels
{
HWY_EXPORT(PlacesForFloat);
HWY_EXPORT(PlacesForDouble);
HWY_EXPORT(Boxes);
HWY_EXPORT(CornersOfFloat);
HWY_EXPORT(CornersOfDouble);
}

using namespace BeamKernels;

std::uint64_t GatherPlaces(
  const OfReadCells<glm::ivec3>& places, const CellNumbers& cells, SegmentBatch<float>& segments)
{
  return HWY_DYNAMIC_DISPATCH(PlacesForFloat)(places, cells, segments);
}

std::uint64_t GatherPlaces(
  const OfReadCells<glm::ivec3>& places, const CellNumbers& cells, SegmentBatch<double>& segments)
{
  return HWY_DYNAMIC_DISPATCH(PlacesForDouble)(places, cells, segments);
}

std::uint64_t GatherPlaces(
  const OfReadCells<CellCorners>& boxes, const CellNumbers& cells, SegmentBatch<double>& segments)
{
  return HWY_DYNAMIC_DISPATCH(Boxes)(boxes, cells, segments);
}

void GatherCorners(const OfReadCells<Corners<float>>& differences, const CellNumbers& cells,
  SegmentBatch<float>& segments)
{
  HWY_DYNAMIC_DISPATCH(CornersOfFloat)(differences, cells, segments);
}

void GatherCorners(const OfReadCells<Corners<double>>& differences, const CellNumbers& cells,
  SegmentBatch<double>& segments)
{
  HWY_DYNAMIC_DISPATCH(CornersOfDouble)(differences, cells, segments);
}

}
#endif
