// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "MeshPictures.h"

#include "SampleMeshes.h"

#include <vtkActor.h>
#include <vtkDataSetSurfaceFilter.h>
#include <vtkProperty.h>

namespace MeshPictures
{
namespace
{

/// A mesh that a picture may show, and how.
struct Candidate
{
  std::string File; ///< as SampleMeshes::Load takes it
  std::string Name; ///< for readers
  std::vector<double> Isovalues;
  Style::View View;
};

/// Shells of the field of generated meshes, of which the outer ones are seen through.
const std::vector<double> Shells = { 0.3, 0.6, 1.0 };

/// The edges of the cells at the mesh's boundary, faint.
void AddEdges(Studio& room, vtkDataSet* mesh)
{
  vtkNew<vtkDataSetSurfaceFilter> surface;
  surface->SetInputData(mesh);
  vtkProperty* property = room.AddPolygons(surface, Style::Lines)->GetProperty();
  property->SetRepresentationToWireframe();
  property->LightingOff();
  property->SetOpacity(0.12);
}

Shot TakeOf(const Candidate& wanted, const Candidate& instead, const std::string& name,
  const std::string& title, const std::string& how, GallerySettings& settings)
{
  Candidate shown = wanted;
  vtkSmartPointer<vtkDataSet> mesh = settings.IsQuick ? nullptr : SampleMeshes::Load(wanted.File);
  if (!mesh)
  {
    settings.Replaced.insert(instead.Name + " in place of " + wanted.Name);
    shown = instead;
    mesh = SampleMeshes::Load(instead.File);
  }
  FeatureScene scene(settings, mesh, shown.Name, shown.View);
  scene.Show({ { shown.Isovalues[0], Style::Steel, 0.25 }, { shown.Isovalues[1], Style::Gold, 0.5 },
    { shown.Isovalues[2], Style::Coral, 1.0 } });
  scene.Mapper->SmoothMeshNormalsOn();
  AddEdges(scene.Room, mesh);
  return scene.Take(name, title, how);
}

}

Shot Unstructured(GallerySettings& settings)
{
  return TakeOf({ "disk_out_ref.ex2", "reactor, 7472 hexahedra", { 400.0, 600.0, 800.0 },
                  { { -1.0, -1.6, 0.5 }, { 0.0, 0.0, 1.0 }, 1.05 } },
    { "tetrahedra12", "10368 tetrahedra", Shells, {} }, "unstructured", "Unstructured grids",
    "a `vtkUnstructuredGrid` as input: rays meet the cells themselves, nothing is resampled; three "
    "temperatures, two of them translucent",
    settings);
}

Shot Curvilinear(GallerySettings& settings)
{
  return TakeOf({ "bluntfinxyz.bin", "air at a blunt fin, 40x32x32", { 1.3, 2.0, 3.5 },
                  { { -1.6, 1.3, 0.9 }, { 0.0, 0.0, 1.0 }, 1.35 } },
    { "curvilinear16", "a curvilinear grid 17^3", Shells, {} }, "curvilinear", "Curvilinear grids",
    "a `vtkStructuredGrid` as input, whose cells are stretched up to 1:100; three densities, two "
    "of them translucent",
    settings);
}

}
