// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_GridMesh_h
#define TemporalCoherence_GridMesh_h

#include "Adaptive/AmrGrids.h"
#include "Grids/CellOrigins.h"
#include "Grids/GridCells.h"
#include "Grids/GridLeaves.h"
#include "Grids/GridPoints.h"
#include "Grids/GridValues.h"
#include "Grids/MadeFrom.h"
#include "Input/FieldSource.h"
#include "Mesh/Mesh.h"
#include "Shapes/SubdividedCells.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace TemporalCoherence
{

/// The mesh of some data sets. It is made once, and of what changes, only that is made again.
class GridMesh
{
public:
  /// Make the mesh, or bring it up to date.
  /// \param budget of cells that are made
  /// \param error  gets what is wrong and what to do about it; empty if the budget does not do or
  ///               it was stopped
  /// \return false on error. There is no mesh then.
  /// \throws std::bad_alloc
  bool See(const std::vector<GridLeaf>& leaves, const DrawnComponent& component,
    MakingBudget& budget, std::string& error);

  /// The same of an adaptive grid with several levels. Its cells are made of those of the grid, and
  /// have no origins.
  bool See(AdaptiveGrid* amr, const ScalarChoice& choice, const DrawnComponent& component,
    MakingBudget& budget, std::string& error);

  /// The mesh, another one after each change; null if there is none.
  const std::shared_ptr<const Mesh>& Made() const { return this->OfLeaves; }

  /// Which cells of the data sets those of the mesh are.
  const std::shared_ptr<const CellOrigins>& Origins() const { return this->OfCells; }

  /// The largest errors of cells that were divided, of all data sets; 0 where none was.
  DivisionError ErrorOfDivision() const;

  /// Bytes of points, values and cells that had to be made.
  std::size_t MemoryInBytes() const;

  void Release() { *this = GridMesh(); }

private:
  /// What was made for a part, and keeps its arrays alive.
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
    std::vector<std::uint8_t> Missing; ///< see MissingCells.h
    std::vector<MeshPart> Others;      ///< made of cells that Part leaves out
    Makings Made;
    CellCensus Census;
    KeptDivision Kept;          ///< of Others, if it is
    DivisionError Error;        ///< of Others
    bool AreValuesMade = false; ///< they are not those of the data set
  };

  bool FindMissing(const std::vector<GridLeaf>& leaves, const DrawnComponent& component);
  static std::size_t MemoryOf(const MeshPart& made);
  static std::size_t MemoryOf(const LeafPart& made);
  bool SeeOthers(const GridLeaf& leaf, LeafPart& made, MakingBudget& budget, std::string& error);
  bool SeeLeaf(const GridLeaf& leaf, const DrawnComponent& component, LeafPart& made,
    MakingBudget& budget, std::string& error);
  void Assemble(const std::vector<GridLeaf>& leaves);
  void Stamp(Mesh& mesh);

  /// What a mesh was made from, and the stamps of that.
  struct Provenance
  {
    MadeFrom Cells, Points, Values;
  };

  Provenance From;
  std::size_t Limit = 0;                                             ///< of memory
  bool AreCellsNew = true, ArePointsNew = true, AreValuesNew = true; ///< as they are made
  bool AreOthersNew = false;
  std::vector<LeafPart> Parts;
  std::uint64_t CellStamp = 0, PointStamp = 0, ValueStamp = 0;
  std::shared_ptr<const Mesh> OfLeaves;
  std::shared_ptr<const CellOrigins> OfCells;
};

}

#endif
