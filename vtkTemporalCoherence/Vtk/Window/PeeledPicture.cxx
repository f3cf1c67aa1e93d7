// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Window/PeeledPicture.h"

#include <vtkInformation.h>
#include <vtkInformationObjectBaseKey.h>
#include <vtkObjectFactory.h>
#include <vtkRenderer.h>

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
  const Frame& frame, const View& view)
{
  if (this->Pass != pass.Identity() || this->Time != pass.Time())
  {
    this->Pass = pass.Identity();
    this->Time = pass.Time();
    this->Last = nullptr;
    this->All.Clear(size);
  }
  this->All.Add(frame, view);
  this->Last = who;
}

}
