// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "World/World.h"

#include "World/Arrays.h"
#include "World/Inputs.h"
#include "vtkTemporalCoherenceVolume.h"

#include <vtkColorTransferFunction.h>
#include <vtkCompositeDataIterator.h>
#include <vtkCompositeDataSet.h>
#include <vtkContourValues.h>
#include <vtkDataObjectTree.h>
#include <vtkDataObjectTreeIterator.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointSet.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>

namespace Fuzz
{

World::World(std::vector<std::uint8_t> bytes)
  : From(std::move(bytes))
  , Subject(vtkSmartPointer<Mapper>::New())
{
  this->Subject->SetAntialiasingToOff();
  // No kept seed begins with a number of the labels: what the other seeds run stays as it was.
  constexpr int firstOfLabels = 128, endOfLabels = 140;
  constexpr int firstOfLayers = 144, firstOfMeshes = 160, firstOfLarge = 240;
  const int first = this->From.Pick(256);
  this->IsOfMeshes = first >= firstOfMeshes;
  this->IsOfLabels = first >= firstOfLabels && first < endOfLabels;
  this->IsLarge = first >= firstOfLarge;
  this->About = this->IsOfMeshes ? static_cast<Theme>((first - firstOfMeshes) % 7)
    : first >= firstOfLayers     ? Theme::Layers
                                 : static_cast<Theme>(first % 6);
  const int wildness[] = { 0, 0, 40, 12, 4 };
  this->From.Wildness = this->About == Theme::Wrecks ? 6 : this->From.OneOf(wildness);
  Story::Tell("theme ", static_cast<int>(this->About),
    this->IsOfMeshes     ? " of meshes"
      : this->IsOfLabels ? " of labels"
                         : "",
    ", wild once in ", this->From.Wildness);
  this->Volumes = { vtkSmartPointer<vtkVolume>::New(),
    vtkSmartPointer<vtkTemporalCoherenceVolume>::New() };
  for (std::size_t i = 0; i < 2; ++i)
  {
    this->Volumes[i]->SetMapper(this->Subject);
    this->Renderers[i] = vtkSmartPointer<vtkRenderer>::New();
    this->Renderers[i]->AddVolume(this->Volumes[i]);
  }
  this->MakeSane();
}

vtkImageData* World::Image() const
{
  vtkDataObject* data = this->Subject->GetDataObjectInput();
  auto* tree = vtkDataObjectTree::SafeDownCast(data);
  if (!tree)
  {
    return vtkImageData::SafeDownCast(data);
  }
  const auto leaves = vtkSmartPointer<vtkDataObjectTreeIterator>::Take(tree->NewTreeIterator());
  leaves->InitTraversal();
  return leaves->IsDoneWithTraversal() ? nullptr
                                       : vtkImageData::SafeDownCast(leaves->GetCurrentDataObject());
}

std::vector<vtkDataSet*> World::DataSets() const
{
  vtkDataObject* data = this->Subject->GetDataObjectInput();
  std::vector<vtkDataSet*> all;
  if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    const auto leaves = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
    for (leaves->InitTraversal(); !leaves->IsDoneWithTraversal(); leaves->GoToNextItem())
    {
      if (auto* leaf = vtkDataSet::SafeDownCast(leaves->GetCurrentDataObject()))
      {
        all.push_back(leaf);
      }
    }
  }
  else if (auto* alone = vtkDataSet::SafeDownCast(data))
  {
    all.push_back(alone);
  }
  return all;
}

bool World::IsMesh() const
{
  const std::vector<vtkDataSet*> all = this->DataSets();
  return std::any_of(all.begin(), all.end(),
    [](vtkDataSet* data)
    { return vtkPointSet::SafeDownCast(data) && !vtkPolyData::SafeDownCast(data); });
}

void World::MakeSane()
{
  Story::Tell("a sane scene");
  const int wildness = this->From.Wildness;
  this->From.Wildness = 0;
  this->IsTame = true;
  const bool isOfImages = this->From.Pick(4) != 0 || this->About == Theme::Sweep;
  vtkSmartPointer<vtkDataObject> data = this->IsOfMeshes ? Inputs::MakeMesh(*this)
    : this->IsOfLabels                                   ? Inputs::MakeLabels(*this)
    : isOfImages ? vtkSmartPointer<vtkDataObject>(Inputs::MakeImage(*this))
                 : Inputs::MakeAny(*this);
  Inputs::Show(*this, data);
  Mapper* mapper = this->Subject;
  mapper->SetBlendModeToIsoSurface();
  if (this->IsOfLabels)
  {
    mapper->SetSurfaceModeToLabels();
    mapper->SetLabelTable(nullptr);
    mapper->SetColorArrayName(nullptr);
    mapper->ColorArrayOpacityOff();
    mapper->SetMaskInput(nullptr);
  }
  mapper->SetScalarModeToDefault();
  mapper->SetVectorMode(Mapper::DISABLED);
  mapper->CroppingOff();
  mapper->RemoveAllClippingPlanes();
  mapper->SetReuseAccuracy(this->From.Pick(3) == 2 ? Mapper::PAPER : Mapper::EXACT);
  mapper->SetIsomapMemoryLimit(256);
  mapper->SetMeshMemoryLimit(MeshMemory);
  for (const auto& volume : this->Volumes)
  {
    vtkNew<vtkVolumeProperty> property;
    property->SetInterpolationTypeToLinear();
    property->SetShade(1);
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(0.0, 0.9, 0.8, 0.7);
    property->SetColor(color);
    volume->SetProperty(property);
    volume->SetUserMatrix(nullptr);
    volume->SetScale(1.0);
    volume->SetPosition(0.0, 0.0, 0.0);
    volume->SetOrigin(0.0, 0.0, 0.0);
    volume->SetOrientation(0.0, 0.0, 0.0);
  }
  for (const auto& renderer : this->Renderers)
  {
    renderer->RemoveAllLights();
    renderer->SetActiveCamera(vtkSmartPointer<vtkCamera>::New());
    renderer->AutomaticLightCreationOn();
  }
  const bool isLarge = this->IsOfMeshes && this->From.OneIn(4);
  this->Width = 8 + this->From.Pick(isLarge ? 90 : 33);
  this->Height = 8 + this->From.Pick(isLarge ? 90 : 33);
  if (this->IsLarge)
  {
    this->Width += 24;
    this->Height += 24;
  }
  Story::Tell("  ", this->Width, " x ", this->Height, " pixels");
  this->LookFrom(
    this->From.Between(-1.0, 1.0), this->From.Between(-1.0, 1.0), this->From.Between(-1.0, 1.0));
  if (this->From.OneIn(5))
  {
    this->Camera()->ParallelProjectionOn();
    Story::Tell("  parallel");
  }
  const int isovalues = this->About == Theme::Layers ? 1 + this->From.Pick(4) : 1;
  std::vector<double> list;
  for (int i = 0; i < isovalues; ++i)
  {
    list.push_back(this->Low + this->From.Between(0.1, 0.9) * (this->High - this->Low));
  }
  this->SetIsovalues(list);
  if (this->About == Theme::Layers)
  {
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(this->Low, this->From.Between(0.1, 0.9));
    opacity->AddPoint(this->High, this->From.Between(0.1, 0.9));
    this->Property()->SetScalarOpacity(opacity);
  }
  this->From.Wildness = wildness;
}

void World::LookFrom(double x, double y, double z)
{
  vtkCamera* camera = this->Camera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(x, y, z);
  const bool isVertical = std::abs(z) > 0.9 * std::sqrt(x * x + y * y + z * z);
  camera->SetViewUp(0.0, isVertical ? 1.0 : 0.0, isVertical ? 0.0 : 1.0);
  this->Renderer()->ResetCamera();
  Story::Tell("  seen from ", x, ", ", y, ", ", z);
}

void World::SetIsovalues(const std::vector<double>& isovalues)
{
  vtkContourValues* list = this->Property()->GetIsoSurfaceValues();
  list->SetNumberOfContours(static_cast<int>(isovalues.size()));
  for (std::size_t i = 0; i < isovalues.size(); ++i)
  {
    list->SetValue(static_cast<int>(i), isovalues[i]);
    if (i < 9)
    {
      Story::Tell("  isovalue ", isovalues[i]);
    }
  }
  Story::Tell("  ", isovalues.size(), " isovalues");
}

}
