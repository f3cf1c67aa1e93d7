// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Walks/ManyInputs.h"

#include "Truth/ImageBlocks.h"
#include "Volumes/Ghosts.h"
#include "Volumes/Grids.h"
#include "Volumes/Masks.h"

#include <vtkCellData.h>
#include <vtkDataSetAttributes.h>
#include <vtkFloatArray.h>
#include <vtkLookupTable.h>
#include <vtkPointData.h>
#include <vtkShortArray.h>

#include <algorithm>

using Mapper = vtkTemporalCoherenceVolumeMapper;

namespace
{

constexpr int N = 32; ///< samples along each axis

vtkDataArray* CoordinatesOf(vtkRectilinearGrid* grid, int axis)
{
  return axis == 0 ? grid->GetXCoordinates()
    : axis == 1    ? grid->GetYCoordinates()
                   : grid->GetZCoordinates();
}

}

ManyInputs::ManyInputs(Scene& scene, RandomViews& views)
  : Image(Volumes::Waves())
  , Of(scene)
  , Views(views)
{
  this->AddArrays();
  this->BendGrid();
  this->CutBlocks();
  this->Show(InImage, OfPoints);
}

/// Scalars of cells and vectors of points, beside the scalars of points.
void ManyInputs::AddArrays()
{
  vtkDataArray* waves = this->Image->GetPointData()->GetScalars();
  waves->SetName("waves");
  vtkNew<vtkShortArray> ofCells;
  ofCells->SetName("of cells");
  for (int k = 0; k < N - 1; ++k)
  {
    for (int j = 0; j < N - 1; ++j)
    {
      for (int i = 0; i < N - 1; ++i)
      {
        ofCells->InsertNextTuple1(waves->GetTuple1((k * N + j) * N + i));
      }
    }
  }
  this->Image->GetCellData()->AddArray(ofCells);
  vtkNew<vtkFloatArray> vectors;
  vectors->SetName("vectors");
  vectors->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < waves->GetNumberOfTuples(); ++i)
  {
    const double there = waves->GetTuple1((i * 17 + 5) % waves->GetNumberOfTuples());
    vectors->InsertNextTuple3(waves->GetTuple1(i), 0.5 * waves->GetTuple1(i) + 100.0, 0.05 * there);
  }
  this->Image->GetPointData()->AddArray(vectors);
}

/// Other coordinates; the arrays are the image's.
void ManyInputs::BendGrid()
{
  this->Grid = Grids::FromImage(this->Image, VTK_DOUBLE);
  for (int axis = 0; axis < 3; ++axis)
  {
    Grids::SetCoordinates(
      this->Grid, axis, Grids::Random(N, 3.0, static_cast<unsigned>(this->Views.Pick(1000))));
  }
  this->Grid->GetPointData()->ShallowCopy(this->Image->GetPointData());
  this->Grid->GetCellData()->ShallowCopy(this->Image->GetCellData());
}

/// 2 x 2 x 1 copies of parts of the image.
void ManyInputs::CutBlocks()
{
  const int first = this->Views.Between(0.0, 1.0) < 0.5 ? 11 : 16, last = N - 1;
  this->Blocks = ImageBlocks::Blocks(this->Image,
    { { 0, first, 0, 9, 0, last }, { first, last, 0, 9, 0, last }, { 0, first, 9, last, 0, last },
      { first, last, 9, last, 0, last } });
  this->IsBlockMissing = false;
}

void ManyInputs::Show(Holder holder, Scalars scalars)
{
  this->In = holder;
  this->Drawn = scalars;
  Mapper* mapper = this->Of.Mapper;
  mapper->SetInputDataObject(holder == InImage ? static_cast<vtkDataObject*>(this->Image)
      : holder == InGrid                       ? static_cast<vtkDataObject*>(this->Grid)
                                               : static_cast<vtkDataObject*>(this->Blocks));
  if (scalars == OfCells)
  {
    mapper->SetScalarModeToUseCellFieldData();
    mapper->SelectScalarArray("of cells");
  }
  else
  {
    mapper->SetScalarModeToUsePointFieldData();
    mapper->SelectScalarArray(scalars == OfPoints ? "waves" : "vectors");
  }
  if (holder == InBlocks)
  {
    mapper->SetMaskInput(nullptr); // which is refused for blocks
  }
  mapper->SetVectorMode(scalars == Lengths ? Mapper::MAGNITUDE
      : scalars == Components              ? Mapper::COMPONENT
                                           : Mapper::DISABLED);
}

bool ManyInputs::HidesCells() const
{
  const auto hasGhosts = [](vtkDataSet* data)
  {
    const char* name = vtkDataSetAttributes::GhostArrayName();
    return data && (data->GetCellData()->GetArray(name) || data->GetPointData()->GetArray(name));
  };
  if (this->Of.Mapper->GetMaskInput())
  {
    return true;
  }
  if (this->In != InBlocks)
  {
    return this->In == InGrid ? hasGhosts(this->Grid) : hasGhosts(this->Image);
  }
  bool areHidden = this->IsBlockMissing;
  for (unsigned i = 0; i < this->Blocks->GetNumberOfBlocks(); ++i)
  {
    areHidden = areHidden || hasGhosts(vtkDataSet::SafeDownCast(this->Blocks->GetBlock(i)));
  }
  return areHidden;
}

/// Of what is drawn.
void ManyInputs::ChangeSamples()
{
  vtkDataSet* data = this->In == InGrid ? static_cast<vtkDataSet*>(this->Grid) : this->Image;
  if (this->In == InBlocks)
  {
    const unsigned which = static_cast<unsigned>(this->Views.Pick(4));
    data = vtkDataSet::SafeDownCast(this->Blocks->GetBlock(which));
    if (!data)
    {
      return;
    }
  }
  vtkDataArray* array = this->Drawn == OfCells ? data->GetCellData()->GetArray("of cells")
    : this->Drawn == OfPoints                  ? data->GetPointData()->GetArray("waves")
                                               : data->GetPointData()->GetArray("vectors");
  const vtkIdType many = array->GetNumberOfTuples();
  const vtkIdType at = this->Views.Pick(static_cast<int>(many));
  for (vtkIdType i = at; i < std::min(at + 300, many); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      array->SetComponent(i, c, 1000.0 * this->Views.Pick(3) - 500.0);
    }
  }
  array->Modified();
}

/// One is not there, or all are there again.
void ManyInputs::ChangeBlock()
{
  if (this->IsBlockMissing)
  {
    this->CutBlocks();
  }
  else
  {
    this->Blocks->SetBlock(static_cast<unsigned>(this->Views.Pick(4)), nullptr);
    this->IsBlockMissing = true;
  }
  this->Show(this->In, this->Drawn);
}

/// A binary mask of what is drawn: of points, and with the name of the array of cells, of cells.
void ManyInputs::SetMask()
{
  const double chance = this->Views.Between(0.7, 0.97);
  const auto seed = static_cast<unsigned>(this->Views.Pick(1000));
  if (this->In == InBlocks)
  {
    return;
  }
  const int points[3] = { N, N, N }, cells[3] = { N - 1, N - 1, N - 1 };
  const auto mask = Masks::Make(points, VTK_UNSIGNED_CHAR, Masks::Random(chance, seed));
  const auto ofCells = Masks::Make(cells, VTK_SHORT, Masks::Random(chance, seed + 1));
  ofCells->GetPointData()->GetScalars()->SetName("of cells");
  mask->GetCellData()->AddArray(ofCells->GetPointData()->GetScalars());
  this->Of.Mapper->SetMaskTypeToBinary();
  this->Of.Mapper->SetMaskInput(mask);
}

/// Of surfaces, by an array or not.
void ManyInputs::ChooseColors()
{
  const char* const names[] = { nullptr, "waves", "vectors", "of cells" };
  const int array = this->Views.Pick(4);
  Mapper* const mapper = this->Of.Mapper;
  mapper->SetColorArrayName(names[array]);
  mapper->SetColorArrayOnCells(array == 3);
  mapper->SetColorArrayComponent(array == 2 ? this->Views.Pick(4) - 1 : 0);
  mapper->SetColorArrayOpacity(array > 0 && this->Views.Pick(3) == 0);
  vtkNew<vtkLookupTable> table;
  table->SetAlphaRange(this->Views.Between(0.0, 1.0), 1.0);
  table->SetTableRange(this->Views.Between(-600.0, 0.0), this->Views.Between(1.0, 600.0));
  table->Build();
  mapper->SetColorTable(table);
}

std::vector<Change> ManyInputs::Changes()
{
  RandomViews& views = this->Views;
  std::vector<Change> changes = {
    { true, [this] { this->ChangeSamples(); } },
    { true, [this] { this->ChangeBlock(); } },
    { true,
      [this, &views]
      { this->Show(static_cast<Holder>(views.Pick(3)), static_cast<Scalars>(views.Pick(5))); } },
    { true,
      [this, &views]
      {
        // Coordinates are read in every frame, told or not.
        vtkDataArray* along = CoordinatesOf(this->Grid, views.Pick(3));
        const int at = 1 + views.Pick(N - 2);
        const double s = views.Between(0.2, 0.8);
        along->SetTuple1(at, (1.0 - s) * along->GetTuple1(at - 1) + s * along->GetTuple1(at + 1));
      } },
    { true, [this, &views] { this->Of.Mapper->SetVectorComponent(views.Pick(3)); } },
    { true,
      [this, &views] {
        this->Of.Volume->GetProperty()->SetComponentWeight(views.Pick(3), views.Between(0.0, 1.0));
      } },
    { true, [this, &views] { this->Image->SetOrigin(views.Between(-1.2, -0.8), -1.0, -1.0); } },
    { true, [this] { this->ChooseColors(); } },
    { true, [this] { this->SetMask(); } },
    { true, [this] { this->Of.Mapper->SetMaskInput(nullptr); } },
  };
  for (const Change& ghosts : ChangesOfGhosts(this->Image, views))
  {
    // The arrays of the grid are the image's, those of blocks are copies.
    changes.push_back({ true,
      [this, ghosts]
      {
        ghosts.Make();
        this->Grid->GetPointData()->ShallowCopy(this->Image->GetPointData());
        this->Grid->GetCellData()->ShallowCopy(this->Image->GetCellData());
      } });
  }
  const Change noGhosts = changes.back();
  changes.back().Make = [this, noGhosts]
  {
    noGhosts.Make();
    this->Of.Mapper->SetMaskInput(nullptr);
  };
  return changes;
}
