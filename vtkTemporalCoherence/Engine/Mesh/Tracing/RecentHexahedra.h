// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_RecentHexahedra_h
#define TemporalCoherence_RecentHexahedra_h

#include "Mesh/Cells/HexahedronFunctions.h"
#include "Mesh/Cells/MeshCell.h"
#include "Mesh/Tiles/MeshDifference.h"
#include "Scene/Frame.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace TemporalCoherence
{

/// A searched hexahedron, prepared for one surface.
struct alignas(64) RecentHexahedron
{
  /// \return false if the surface does not pass it
  bool PrepareFor(std::size_t surface, const MeshDifference& difference)
  {
    if (this->Surface != surface)
    {
      this->Surface = surface;
      this->IsPassed = difference.Of(this->Cell, this->Differences);
      if (this->IsPassed)
      {
        this->Functions = MeshKernels::HexahedronFunctions(this->Cell, this->Differences);
      }
    }
    return this->IsPassed;
  }

  static constexpr std::size_t NoSurface = ~std::size_t(0);

  CellNumber Number;
  MeshCell Cell;
  std::size_t Surface = NoSurface; ///< for which the members below are prepared
  bool IsPassed;
  MeshKernels::CellDifferences Differences;
  MeshKernels::HexahedronFunctions Functions; ///< if it is passed
};

/// Hexahedra that a thread searched for a frame's surfaces not long ago: neighbouring tiles share
/// them. (Tetrahedra are read as fast as they are found here.)
class RecentHexahedra
{
public:
  RecentHexahedra() { this->Ranks.fill(NoRank); }

  /// Begin a search. Hexahedra that it finds or adds stay until the next search.
  void Begin() { ++this->Searches; }

  /// Find the hexahedron with a rank. Null: it is not there.
  RecentHexahedron* Find(std::uint32_t rank)
  {
    const std::size_t place = PlaceOf(rank);
    if (this->Ranks[place] != rank)
    {
      return nullptr;
    }
    this->Uses[place] = this->Searches;
    return &this->Cells[place];
  }

  /// \pre a search adds and finds no more than a batch has rays
  /// \throws std::bad_alloc
  RecentHexahedron& Add(std::uint32_t rank, CellNumber number, const MeshCell& cell)
  {
    this->Cells.resize(Capacity); // with the first hexahedron: many meshes have none
    std::size_t place = PlaceOf(rank);
    while (this->Uses[place] == this->Searches)
    {
      place = (place + 1) % Capacity;
    }
    this->Ranks[place] = rank;
    this->Uses[place] = this->Searches;
    RecentHexahedron& kept = this->Cells[place];
    kept.Number = number;
    kept.Cell = cell;
    kept.Surface = RecentHexahedron::NoSurface;
    return kept;
  }

private:
  static constexpr std::size_t Capacity = 1024; // much more than a search asks for

  /// The first bits of a product that spreads neighbours.
  static std::size_t PlaceOf(std::uint32_t rank)
  {
    return (rank * std::uint32_t(0x9E3779B1)) >> 22;
  }

  static constexpr std::uint32_t NoRank = ~std::uint32_t(0);

  std::array<std::uint32_t, Capacity> Ranks;
  std::array<std::uint64_t, Capacity> Uses{}; ///< number of the last search that used each place
  std::vector<RecentHexahedron> Cells;        ///< empty, or one for each place
  std::uint64_t Searches = 0;
};

}

#endif
