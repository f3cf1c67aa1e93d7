// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/PeeledPicture.h"

#include <vtkInformation.h>
#include <vtkInformationObjectBaseKey.h>
#include <vtkObjectFactory.h>
#include <vtkRenderer.h>

#include <utility>

namespace TemporalCoherence
{

vtkStandardNewMacro(PeeledPicture);

vtkSmartPointer<PeeledPicture> PeeledPicture::Of(vtkRenderer* renderer)
{
  static vtkInformationObjectBaseKey* const key =
    vtkInformationObjectBaseKey::MakeKey("PEELED_PICTURE", "vtkTemporalCoherenceVolumeMapper");
  vtkSmartPointer<vtkInformation> about = renderer->GetInformation();
  if (!about)
  {
    about = vtkSmartPointer<vtkInformation>::New();
    renderer->SetInformation(about);
  }
  vtkSmartPointer<PeeledPicture> picture = PeeledPicture::SafeDownCast(about->Get(key));
  if (!picture)
  {
    picture = vtkSmartPointer<PeeledPicture>::New();
    about->Set(key, picture);
  }
  return picture;
}

void PeeledPicture::Add(const PeelingPass& pass, const void* who, const glm::ivec2& size,
  std::uint64_t number, std::shared_ptr<const PeeledLayers> layers)
{
  if (this->Pass != pass.Identity() || this->Time != pass.Time())
  {
    this->ReleaseLayers();
    this->Pass = pass.Identity();
    this->Time = pass.Time();
    this->Size = size;
    this->Identity = { static_cast<std::uint64_t>(size.x), static_cast<std::uint64_t>(size.y) };
  }
  this->Added.push_back(std::move(layers));
  this->Identity.push_back(number);
  this->Last = who;
}

const PeeledLayers& PeeledPicture::Merged()
{
  if (this->Added.size() == 1 && this->Added.front()->Size() == this->Size)
  {
    return *this->Added.front();
  }
  if (this->NumberMerged == 0)
  {
    this->All.Clear(this->Size);
  }
  for (; this->NumberMerged < this->Added.size(); ++this->NumberMerged)
  {
    this->All.Add(*this->Added[this->NumberMerged]);
  }
  return this->All;
}

void PeeledPicture::ReleaseLayers()
{
  this->Added.clear();
  this->All = PeeledLayers();
  this->NumberMerged = 0;
}

}
