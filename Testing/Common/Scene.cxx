// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene.h"

#include <vtkContourValues.h>
#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iostream>

Scene::Scene(vtkDataSet* data, const std::vector<double>& isovalues)
{
  this->Mapper->SetInputDataObject(data);
  this->Volume->SetMapper(this->Mapper);
  vtkVolumeProperty* property = this->Volume->GetProperty();
  property->SetInterpolationTypeToLinear();
  property->ShadeOn();
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0.0, 0.9, 0.8, 0.7);
  property->SetColor(color);
  this->SetIsovalues(isovalues);
  this->Renderer->AddVolume(this->Volume);
}

void Scene::SetIsovalues(const std::vector<double>& isovalues)
{
  vtkContourValues* list = this->Volume->GetProperty()->GetIsoSurfaceValues();
  list->SetNumberOfContours(static_cast<int>(isovalues.size()));
  for (std::size_t i = 0; i < isovalues.size(); ++i)
  {
    list->SetValue(static_cast<int>(i), isovalues[i]);
  }
}

void Scene::LookFrom(double x, double y, double z)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetPosition(x, y, z);
  const bool isVertical = std::abs(z) > 0.9 * std::hypot(x, y, z);
  camera->SetViewUp(0.0, isVertical ? 1.0 : 0.0, isVertical ? 0.0 : 1.0);
  this->Renderer->ResetCamera();
}

bool Scene::Render(int width, int height)
{
  return this->Mapper->RenderToImage(
    this->Renderer, this->Volume, width, height, this->Color, this->Depth);
}

bool Scene::GetLastFrame(vtkImageData* color, vtkImageData* depth)
{
  return this->Mapper->GetLastFrame(color, vtkTemporalCoherenceVolumeMapper::FRAME_COLOR) &&
    this->Mapper->GetLastFrame(depth, vtkTemporalCoherenceVolumeMapper::FRAME_DEPTH);
}

Agreement CompareWithTruth(const Scene& scene, const BruteForceTracer& truth, int stride)
{
  int dimensions[3];
  scene.Depth->GetDimensions(dimensions);
  // The camera computes its matrices on demand: once here, not in every thread.
  scene.Renderer->GetActiveCamera()->GetCompositeProjectionTransformMatrix(
    static_cast<double>(dimensions[0]) / dimensions[1], -1.0, 1.0);
  Agreement sum;
  for (int y = 0; y < dimensions[1]; y += stride)
  {
    for (int x = 0; x < dimensions[0]; x += stride)
    {
      const BruteForceTracer::Hit hit =
        truth.Trace(scene.Renderer, x, y, dimensions[0], dimensions[1]);
      int isovalue = -1;
      scene.Mapper->PickPixel(x, y, nullptr, nullptr, &isovalue);
      ++sum.Pixels;
      if (isovalue != hit.Isovalue)
      {
        ++sum.DifferentHits;
      }
      else if (isovalue >= 0)
      {
        double position[3];
        scene.Mapper->PickPixel(x, y, position, nullptr, nullptr);
        // The depth image is in single precision; what is picked is not.
        const double rounding = 1e-7 * hit.Distance;
        const double inDepth = std::abs(static_cast<double>(scene.DepthAt(x, y)) - hit.Distance);
        const double inPosition =
          std::sqrt(vtkMath::Distance2BetweenPoints(position, hit.Position.data()));
        const double distance = std::max(inDepth - rounding, inPosition) / truth.Field.VoxelSize();
        ++sum.Hits;
        sum.DistantHits += distance > 1e-3;
        sum.MaxDistance = std::max(sum.MaxDistance, distance);
      }
    }
  }
  return sum;
}

bool AgreesWithTruth(const std::string& name, Scene& scene, const BruteForceTracer& truth,
  int width, int height, int stride)
{
  scene.Mapper->ReleaseReuse(); // the contract is that of a cold frame
  if (!scene.Render(width, height))
  {
    std::cerr << name << ": not rendered\n";
    return false;
  }
  const Agreement agreement = CompareWithTruth(scene, truth, stride);
  const bool holds = agreement.Holds() && agreement.Hits > 0;
  (holds ? std::cout : std::cerr) << name << ": " << agreement.Pixels << " pixels, "
                                  << agreement.Hits << " hits of both, " << agreement.DifferentHits
                                  << " differ, " << agreement.DistantHits
                                  << " beyond 1e-3 voxel, largest " << agreement.MaxDistance
                                  << " voxel\n";
  return holds;
}
