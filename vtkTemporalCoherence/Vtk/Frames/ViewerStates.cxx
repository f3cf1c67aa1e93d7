// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Frames/ViewerStates.h"

#include <algorithm>
#include <atomic>

namespace TemporalCoherence
{
namespace
{

bool AreSame(const Viewer& a, const Viewer& b)
{
  return a.Renderer == b.Renderer && a.Volume == b.Volume && a.Camera == b.Camera && a.Eye == b.Eye;
}

bool IsGoneInPart(const Viewer& viewer)
{
  return !viewer.Renderer || !viewer.Volume || !viewer.Camera;
}

/// True if two viewers differ only in objects that no longer exist.
bool IsSuccessor(const Viewer& next, const Viewer& before)
{
  return (!before.Renderer || before.Renderer == next.Renderer) &&
    (!before.Volume || before.Volume == next.Volume) &&
    (!before.Camera || before.Camera == next.Camera) && before.Eye == next.Eye;
}

}

std::uint64_t NewPictureNumber()
{
  static std::atomic<std::uint64_t> last(0);
  return ++last;
}

Viewer Viewer::Of(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const int eye = camera->GetLeftEye() ? 1 : 2;
  return { renderer, volume, camera, camera->GetStereo() ? eye : 0 };
}

std::shared_ptr<ViewerState> ViewerStates::Find(const Viewer& viewer) const
{
  const auto found = std::find_if(this->States.begin(), this->States.end(),
    [&](const std::shared_ptr<ViewerState>& state) { return AreSame(state->Of, viewer); });
  return found == this->States.end() ? nullptr : *found;
}

std::shared_ptr<ViewerState> ViewerStates::Serve(const Viewer& viewer)
{
  std::shared_ptr<ViewerState> served = this->Find(viewer);
  if (!served)
  {
    const auto before = std::find_if(this->States.begin(), this->States.end(),
      [&](const std::shared_ptr<ViewerState>& state)
      { return IsGoneInPart(state->Of) && IsSuccessor(viewer, state->Of); });
    served = before == this->States.end() ? this->MakeState() : *before;
    served->Of = viewer;
  }

  this->States.erase(std::remove_if(this->States.begin(), this->States.end(),
                       [&](const std::shared_ptr<ViewerState>& state)
                       { return state == served || IsGoneInPart(state->Of); }),
    this->States.end());
  this->States.insert(this->States.begin(), served);
  if (this->States.size() > Most)
  {
    this->States.pop_back();
  }
  return served;
}

void ViewerStates::ReleaseGraphicsResources(vtkWindow* window)
{
  for (const std::shared_ptr<ViewerState>& state : this->States)
  {
    state->Presenter.ReleaseGraphicsResources(window);
    state->Peels.ReleaseGraphicsResources(window);
  }
}

}
