// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LabelPictures.h"

#include "SampleMeshes.h"

#include <vtkColorTransferFunction.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkLookupTable.h>
#include <vtkMath.h>
#include <vtkPointData.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>

namespace LabelPictures
{
namespace
{

/// Labels 1 to 7 of a generated volume: rising values in steps.
vtkSmartPointer<vtkImageData> InSteps(vtkImageData* volume)
{
  vtkDataArray* const values = volume->GetPointData()->GetScalars();
  const double* const range = values->GetRange();
  auto labels = vtkSmartPointer<vtkImageData>::New();
  labels->CopyStructure(volume);
  labels->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const double share = (values->GetTuple1(i) - range[0]) / (range[1] - range[0]);
    labels->GetPointData()->GetScalars()->SetTuple1(i, std::floor(7.99 * share));
  }
  return labels;
}

/// Hues that lie far apart for labels in a row. Some labels are a veil, or hidden.
vtkSmartPointer<vtkLookupTable> Table(int most, int veil)
{
  constexpr double goldenRatio = 0.618033988749895;
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(most + 1);
  table->SetTableRange(0.0, most);
  for (int label = 0; label <= most; ++label)
  {
    const double hue = std::fmod(goldenRatio * label, 1.0);
    double color[3];
    vtkMath::HSVToRGB(hue, 0.55, 0.95, &color[0], &color[1], &color[2]);
    table->SetTableValue(label, color[0], color[1], color[2], label == veil ? 0.15 : 1.0);
  }
  return table;
}

/// The methane of a generated mesh: how far its points lie along an axis.
void AddMethane(vtkDataSet* mesh)
{
  vtkNew<vtkDoubleArray> along;
  along->SetName("CH4");
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point)
  {
    along->InsertNextValue(mesh->GetPoint(point)[0]);
  }
  mesh->GetPointData()->AddArray(along);
}

}

Shot Organs(GallerySettings& settings)
{
  constexpr int skeleton = 13;
  const Subject subject = FirstOf({ { "frogtissue.vti", "tissues of a frog 500x470x136", {},
                                      { { 0.25, -0.9, 1.0 }, { 0.0, -1.0, 0.0 }, 1.5 } },
                                    SpheresInstead({}) },
    settings);
  FeatureScene scene(settings, subject);
  vtkSmartPointer<vtkImageData> labels = subject.Image;
  if (labels->GetScalarType() != VTK_UNSIGNED_CHAR || settings.IsQuick)
  {
    labels = InSteps(subject.Image);
    scene.SetInput(labels, "steps of " + subject.Name, subject.View);
  }
  const auto most = static_cast<int>(labels->GetPointData()->GetScalars()->GetRange()[1]);
  scene.Mapper->SetBlendModeToIsoSurface();
  scene.Mapper->SetSurfaceModeToLabels();
  scene.Mapper->SetLabelRadius(2.5);
  scene.Mapper->SetLabelTable(Table(most, most > skeleton ? 0 : 1));
  scene.Volume->GetProperty()->ShadeOn();
  return scene.Take("labels", "Labels",
    "`SetSurfaceModeToLabels()` and `SetLabelRadius(2.5)`: each label in its colour of a "
    "`vtkLookupTable`; neighbours have one surface in common");
}

Shot Methane(GallerySettings& settings)
{
  vtkSmartPointer<vtkDataSet> mesh =
    settings.IsQuick ? nullptr : SampleMeshes::Load("disk_out_ref.ex2");
  const bool isReactor = mesh != nullptr;
  if (!isReactor)
  {
    settings.Replaced.insert("10368 tetrahedra in place of reactor, 7472 hexahedra");
    mesh = SampleMeshes::Load("tetrahedra12");
    AddMethane(mesh);
  }
  const Style::View view = { { -1.0, -1.6, 0.5 }, { 0.0, 0.0, 1.0 }, 1.4 };
  FeatureScene scene(settings, mesh, isReactor ? "reactor, 7472 hexahedra" : "10368 tetrahedra",
    isReactor ? view : Style::View());
  scene.Show({ { isReactor ? 330.0 : 0.6, Style::Steel, 1.0 } });
  double range[2];
  mesh->GetPointData()->GetArray("CH4")->GetRange(range);
  vtkNew<vtkColorTransferFunction> colors;
  colors->AddRGBPoint(range[0], 0.23, 0.3, 0.75);
  colors->AddRGBPoint(0.5 * (range[0] + range[1]), 0.87, 0.87, 0.87);
  colors->AddRGBPoint(range[1], 0.71, 0.02, 0.15);
  scene.Mapper->SmoothMeshNormalsOn();
  scene.Mapper->SetColorArrayName("CH4");
  scene.Mapper->SetColorTable(colors);
  return scene.Take("colors", "Colours of another array",
    "`SetColorArrayName(\"CH4\")`: the surface of a temperature, in the colours of the share of "
    "methane "
    "on it");
}

}
