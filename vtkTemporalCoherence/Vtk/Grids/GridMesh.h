// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_GridMesh_h
#define TemporalCoherence_GridMesh_h

#include "Adaptive/AmrGrids.h"
#include "Grids/GridCells.h"
#include "Grids/GridLeaves.h"
#include "Grids/GridPoints.h"
#include "Grids/GridValues.h"
#include "Grids/MadeFrom.h"
#include "Input/CellOrigins.h"
#include "Input/FieldSource.h"
#include "Mesh/Cells/Mesh.h"
#include "Shapes/SubdividedCells.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace TemporalCoherence
{

/// The mesh of some data sets. After changes, only the affected arrays are made again.
class GridMesh
{
public:
  /// Make the mesh, or bring it up to date.
  /// \param budget for making cells
  /// \param error  receives the mistake and its remedy; empty if the budget is too small or it was
  ///               stopped
  /// \return false on error. There is no mesh then.
  /// \throws std::bad_alloc
  bool See(const std::vector<GridLeaf>& leaves, const DrawnComponent& component,
    MakingBudget& budget, std::string& error);

  /// Make the mesh of an adaptive grid with several levels. Its cells lie between the grid's cells,
  /// and have no origins.
  bool See(AdaptiveGrid* amr, const ScalarChoice& choice, const DrawnComponent& component,
    MakingBudget& budget, std::string& error);

  /// The mesh, a new object after each change; null after an error.
  const std::shared_ptr<const Mesh>& Made() const { return this->OfLeaves; }

  /// The cells of data sets from which the mesh was made.
  const std::shared_ptr<const CellOrigins>& Origins() const { return this->OfCells; }

  /// The largest errors of divided cells in all data sets; 0 without divided cells.
  DivisionError ErrorOfDivision() const;

  /// Bytes of points, values and cells that are not read in place.
  std::size_t MemoryInBytes() const;

  void Release() { *this = GridMesh(); }

private:
  /// Made arrays of a part, which they must outlive.
  struct Makings
  {
    MadeFlags Flags;
    ArrayCopies Cells;
    MadePoints Points;
    PointValues Values;
  };

  /// A data set as a part.
  struct LeafPart
  {
    MeshPart Part;
    std::vector<std::uint8_t> Missing; ///< see FindMissingCells
    std::vector<MeshPart> Others;      ///< linear cells that replace cells left out of Part
    Makings Made;
    CellCensus Census;
    KeptDivision Kept;          ///< of Others, if they are kept
    DivisionError Error;        ///< of Others
    bool AreValuesMade = false; ///< values are not read from the data set in place
  };

  bool FindMissing(const std::vector<GridLeaf>& leaves, const DrawnComponent& component);
  static std::size_t MemoryOf(const MeshPart& made);
  static std::size_t MemoryOf(const LeafPart& made);
  bool SeeOthers(const GridLeaf& leaf, LeafPart& made, MakingBudget& budget, std::string& error);
  bool SeeLeaf(const GridLeaf& leaf, const DrawnComponent& component, LeafPart& made,
    MakingBudget& budget, std::string& error);
  void Assemble(const std::vector<GridLeaf>& leaves);
  void Stamp(Mesh& mesh);

  /// The input of a mesh.
  struct Provenance
  {
    MadeFrom Cells, Points, Values;
  };

  Provenance From;
  std::size_t Limit = 0;                                             ///< of memory, in bytes
  bool AreCellsNew = true, ArePointsNew = true, AreValuesNew = true; ///< during an update
  bool AreOthersNew = false;
  std::vector<LeafPart> Parts;
  std::uint64_t CellStamp = 0, PointStamp = 0, ValueStamp = 0;
  std::shared_ptr<const Mesh> OfLeaves;
  std::shared_ptr<const CellOrigins> OfCells;
};

}

#endif
