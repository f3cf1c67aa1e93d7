// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Kinds/MeshKind.h"

#include "Mesh/Tracing/MeshBandTracer.h"
#include "Mesh/Tracing/MeshGradients.h"
#include "Mesh/Tracing/MeshPlaces.h"
#include "Mesh/Tracing/MeshTracer.h"
#include "Scene/CellBox.h"

#include <array>
#include <mutex>
#include <utility>

namespace TemporalCoherence
{
namespace
{

/// The tree's number of the lattice's leaf that begins at a cell.
std::int64_t LeafAt(const glm::ivec3& firstCell)
{
  return MeshTree::RankOf(firstCell) / MeshLattice::SizeOfBlock;
}

class MeshFieldKind final : public FieldKind
{
public:
  MeshFieldKind(std::shared_ptr<const MeshTree> tree, bool averagedGradients)
    : Tree(std::move(tree))
    , Boxes(*this->Tree)
    , Averaged(averagedGradients ? PointGradients::Make(*this->Tree) : nullptr)
  {
  }

  bool IsSame(const FieldShape& other) const override
  {
    const auto* const same = dynamic_cast<const MeshFieldKind*>(&other);
    return same && same->Tree == this->Tree &&
      (same->Averaged != nullptr) == (this->Averaged != nullptr);
  }

  FieldAbilities Abilities() const override
  {
    FieldAbilities abilities;
    abilities.Isomaps = true;
    abilities.IsMesh = true;
    abilities.HasVolume = this->Tree->HasVolume();
    return abilities;
  }

  glm::dvec2 RangeIn(const CellBox& cells) const override
  {
    const CellRange range = this->Tree->RangeOfLeaf(LeafAt(cells.First));
    return { range.Min, range.Max };
  }

  glm::dvec2 FiniteRangeIn(const CellBox& cells) const override
  {
    CellRange finite;
    this->Tree->RangeOfLeaf(LeafAt(cells.First), &finite);
    return { finite.Min, finite.Max };
  }

  std::uint64_t CellsIn(const CellBox& leaf, const std::vector<ValueBand>& bands) const override
  {
    return this->Tree->CellsIn(LeafAt(leaf.First), bands);
  }

  bool AreBlocksAlike() const override { return false; }

  IndexBox BoxOf(const CellBox& cells) const override { return this->Tree->BoxOf(cells); }

  /// Bend is the mean edge: few cells are much smaller.
  VoxelSize VoxelSizeIn(const IndexTransform& transform) const override
  {
    const glm::dmat3 edges(transform.WorldFromIndex);
    const double unit =
      (glm::length(edges[0]) + glm::length(edges[1]) + glm::length(edges[2])) / 3.0;
    const double perEdge = unit / this->Tree->Scale();
    const EdgeLengths& lengths = this->Tree->Edges();
    return { perEdge * lengths.Shortest, perEdge * lengths.Longest };
  }

  std::shared_ptr<const SurfaceTracer> MakeTracer(const TraceScene& scene) const override
  {
    return std::make_shared<MeshTracer>(
      scene, *this, *this->Tree, this->Boxes, this->PreparedFor(scene));
  }

  std::shared_ptr<const BandTracer> MakeBandTracer(const BandScene& scene) const override
  {
    return std::make_shared<MeshBandTracer>(scene, *this, *this->Tree, this->Boxes);
  }

  void FindGradients(const GradientQuery& query, const GradientTile& tile) const override
  {
    FindMeshGradients(*this->Tree, this->Averaged.get(), query, tile);
  }

  glm::dvec3 FaceNormal(const Field&, const CapPoint& cap, double& nearest) const override
  {
    return MeshFaceNormal(*this->Tree, cap, nearest);
  }

private:
  /// Prepared cells, and the surfaces that they serve.
  struct KeptCells
  {
    Surfaces Isosurfaces;
    glm::dvec2 FiniteRange{ 0.0 };
    std::shared_ptr<const PreparedLeaves> Prepared; ///< null: none
  };

  /// Prepare the cells of a scene, or re-use kept ones: most scenes differ in the view only. Two
  /// sets of surfaces are kept, because one frame may trace all of its surfaces and a subset.
  std::shared_ptr<const PreparedLeaves> PreparedFor(const TraceScene& scene) const
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    const auto isSame = [&](const KeptCells& kept)
    {
      return kept.Prepared && AreMetAlike(kept.Isosurfaces, scene.Isosurfaces) &&
        kept.FiniteRange == scene.FiniteRange;
    };
    if (!isSame(this->Last[0]))
    {
      std::swap(this->Last[0], this->Last[1]);
    }
    if (!isSame(this->Last[0]))
    {
      this->Last[0] = {};
      const bool isSolid = scene.Isosurfaces.Mode == SurfaceMode::Threshold;
      this->Last[0] = { scene.Isosurfaces, scene.FiniteRange,
        std::make_shared<PreparedLeaves>(*this->Tree, scene.Isosurfaces.Isovalues,
          scene.FiniteRange, isSolid ? CellPurpose::Solids : CellPurpose::Crossings) };
    }
    return this->Last[0].Prepared;
  }

  std::shared_ptr<const MeshTree> Tree;
  BoxLevels Boxes;
  mutable std::mutex Guard;
  mutable std::array<KeptCells, 2> Last;
  std::shared_ptr<const PointGradients> Averaged; ///< null: normals have facets
};

}

std::shared_ptr<const FieldKind> MeshKind(
  std::shared_ptr<const MeshTree> tree, bool averagedGradients)
{
  return std::make_shared<MeshFieldKind>(std::move(tree), averagedGradients);
}

Field MeshField(const MeshTree& tree, std::shared_ptr<const FieldShape> shape)
{
  const Mesh& mesh = tree.TheMesh();
  Field field;
  field.Type = ScalarType::Float64;
  field.Dimensions = tree.Dimensions();
  field.Stamp = mesh.ValueStamp;
  field.Shape = std::move(shape);
  return field;
}

}
