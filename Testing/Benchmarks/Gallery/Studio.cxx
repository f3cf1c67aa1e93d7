// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Studio.h"

#include "FigurePictures.h"

#include "vtkTemporalCoherenceRefiner.h"

#include <vtkActor.h>
#include <vtkAlgorithm.h>
#include <vtkOutlineSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

#include <algorithm>
#include <sstream>

namespace
{

constexpr int PixelsToOne = 2; ///< of the window to one of the photograph, along each axis

}

Studio::Studio(int size)
{
  const auto& ground = FigurePictures::Ground;
  this->Renderer->SetBackground(ground[0] / 255.0, ground[1] / 255.0, ground[2] / 255.0);
  Style::AddLights(this->Renderer);
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(size, size);
  this->Window->AddRenderer(this->Renderer);
}

vtkActor* Studio::AddPolygons(vtkAlgorithm* source, const Style::Color& color)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetAmbient(0.15);
  actor->GetProperty()->SetDiffuse(0.8);
  this->Renderer->AddActor(actor);
  return actor;
}

void Studio::AddBox(const double bounds[6], const Style::Color& color)
{
  vtkNew<vtkOutlineSource> box;
  box->SetBounds(bounds);
  vtkProperty* property = this->AddPolygons(box, color)->GetProperty();
  property->LightingOff();
  property->SetLineWidth(2.0F);
}

vtkSmartPointer<vtkImageData> Studio::Photograph()
{
  this->Window->Render();
  return FigurePictures::Shrunk(FigurePictures::Grabbed(this->Window), PixelsToOne);
}

vtkSmartPointer<vtkImageData> Studio::PhotographFinal()
{
  vtkNew<vtkTemporalCoherenceRefiner> refiner;
  refiner->SetRenderWindow(this->Window);
  refiner->Refine();
  return this->Photograph();
}

std::string Studio::DrawnBy()
{
  this->Window->Render();
  std::istringstream capabilities(this->Window->ReportCapabilities());
  const std::string label = "OpenGL renderer string:";
  for (std::string line; std::getline(capabilities, line);)
  {
    if (line.rfind(label, 0) == 0)
    {
      const std::size_t begin = line.find_first_not_of(' ', label.size());
      return line.substr(std::min(begin, line.size()));
    }
  }
  return "OpenGL";
}
