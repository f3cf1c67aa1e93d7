// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTemporalCoherenceRefiner.h"

#include "vtkCommand.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSmartPointer.h"
#include "vtkTemporalCoherenceVolumeMapper.h"

#include <algorithm>

VTK_ABI_NAMESPACE_BEGIN
vtkStandardNewMacro(vtkTemporalCoherenceRefiner);

namespace
{

constexpr unsigned long Soon = 1;     ///< ms: events that wait come first
constexpr double MostStillRate = 0.1; ///< frames a second; applications ask for 0.002 and less
constexpr int MostVainFrames = 3;     ///< that bring nothing; then frames get no better

}

// Functions that tell others keep the refiner until they return: the others may release it.
using Keep = vtkSmartPointer<vtkTemporalCoherenceRefiner>;

//------------------------------------------------------------------------------
vtkTemporalCoherenceRefiner::~vtkTemporalCoherenceRefiner()
{
  this->Follow(nullptr, nullptr);
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceRefiner::SetInteractor(vtkRenderWindowInteractor* interactor)
{
  this->Follow(interactor, interactor ? interactor->GetRenderWindow() : nullptr);
  this->Modified();
}

//------------------------------------------------------------------------------
vtkRenderWindowInteractor* vtkTemporalCoherenceRefiner::GetInteractor()
{
  return this->Interactor;
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceRefiner::SetRenderWindow(vtkRenderWindow* window)
{
  this->Follow(nullptr, window);
  this->Modified();
}

//------------------------------------------------------------------------------
vtkRenderWindow* vtkTemporalCoherenceRefiner::GetRenderWindow()
{
  return this->Window;
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceRefiner::SetEnabled(vtkTypeBool enabled)
{
  if (this->Enabled == enabled)
  {
    return;
  }
  this->Enabled = enabled;
  this->Modified();
  if (enabled)
  {
    this->StartTimer();
  }
  else
  {
    this->StopTimer();
  }
}

//------------------------------------------------------------------------------
/// Observe a window instead of the one before, with the event loop of an interactor. Each may be
/// null.
void vtkTemporalCoherenceRefiner::Follow(
  vtkRenderWindowInteractor* interactor, vtkRenderWindow* window)
{
  this->StopTimer();
  this->Interactor = interactor;
  for (const unsigned long tag : this->WindowTags)
  {
    if (this->Window)
    {
      this->Window->RemoveObserver(tag);
    }
  }
  this->WindowTags.clear();
  this->Window = window;
  this->Progress = this->Least = 1.0;
  this->Vain = 0;
  if (window)
  {
    using Self = vtkTemporalCoherenceRefiner;
    this->WindowTags = { window->AddObserver(vtkCommand::StartEvent, this, &Self::OnFrameBegin),
      window->AddObserver(
        vtkTemporalCoherenceVolumeMapper::FrameProgressEvent, this, &Self::OnPicture),
      window->AddObserver(vtkCommand::EndEvent, this, &Self::OnFrameEnd) };
  }
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceRefiner::OnFrameBegin()
{
  this->Least = 1.0;
}

//------------------------------------------------------------------------------
/// A mapper has made a picture in this frame of the window.
void vtkTemporalCoherenceRefiner::OnPicture(vtkObject*, unsigned long, void* progress)
{
  this->Least = std::min(this->Least, *static_cast<double*>(progress));
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceRefiner::OnFrameEnd()
{
  const Keep self(this);
  if (!this->Window)
  {
    return;
  }
  ++this->Frames;
  // What a stopped frame shows is the frame before.
  const double before = this->Progress;
  const bool isStopped = this->Window->GetAbortRender() != 0;
  this->Progress = isStopped ? std::min(before, this->Least) : this->Least;
  const bool isVain = this->Rendering && !isStopped && this->Progress <= before;
  this->Vain = isVain ? this->Vain + 1 : this->Rendering && isStopped ? this->Vain : 0;
  if (this->Progress < 1.0 || before < 1.0)
  {
    double progress = this->Progress;
    this->InvokeEvent(vtkCommand::ProgressEvent, &progress);
  }
  this->StartTimer();
}

//------------------------------------------------------------------------------
/// True if the window's frames are to be made fast, as an interaction goes on.
bool vtkTemporalCoherenceRefiner::IsInteractive()
{
  vtkRenderWindowInteractor* interactor = this->Window->GetInteractor();
  const double still = interactor ? interactor->GetStillUpdateRate() : 0.0;
  return this->Window->GetDesiredUpdateRate() > std::max(still, MostStillRate);
}

//------------------------------------------------------------------------------
/// Ask for a timer if the pictures are not final and an event loop runs.
void vtkTemporalCoherenceRefiner::StartTimer()
{
  if (!this->Enabled || !this->Window || this->Progress >= 1.0 || this->Vain >= MostVainFrames ||
    this->IsInteractive())
  {
    return;
  }
  vtkRenderWindowInteractor* interactor =
    this->Interactor ? this->Interactor.GetPointer() : this->Window->GetInteractor();
  if (!interactor || !interactor->GetInitialized())
  {
    return;
  }
  if (interactor != this->TimerOwner)
  {
    this->StopTimer();
    this->TimerOwner = interactor;
    this->TimerTag =
      interactor->AddObserver(vtkCommand::TimerEvent, this, &vtkTemporalCoherenceRefiner::OnTimer);
  }
  if (this->Timer == 0)
  {
    this->Timer = interactor->CreateOneShotTimer(Soon);
  }
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceRefiner::StopTimer()
{
  if (this->TimerOwner)
  {
    if (this->Timer != 0)
    {
      this->TimerOwner->DestroyTimer(this->Timer);
    }
    this->TimerOwner->RemoveObserver(this->TimerTag);
  }
  this->TimerOwner = nullptr;
  this->Timer = 0;
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceRefiner::OnTimer(vtkObject*, unsigned long, void* timer)
{
  if (this->Timer != 0 && timer && *static_cast<int*>(timer) == this->Timer)
  {
    const Keep self(this);
    this->Timer = 0;
    // A frame that is being rendered, whose observers handle events, ends with another timer.
    if (this->Enabled && this->Window && this->Progress < 1.0 &&
      !this->Window->CheckInRenderStatus() && !this->IsInteractive())
    {
      this->RenderAgain(this->TimerOwner);
    }
  }
}

//------------------------------------------------------------------------------
/// Render the window, in a way that can be stopped.
/// \param interactor renders it; or null
void vtkTemporalCoherenceRefiner::RenderAgain(vtkRenderWindowInteractor* interactor)
{
  const vtkSmartPointer<vtkRenderWindow> window(this->Window);
  const unsigned long tag = window->AddObserver(
    vtkCommand::AbortCheckEvent, this, &vtkTemporalCoherenceRefiner::OnAbortCheck);
  this->Rendering = true;
  if (interactor)
  {
    interactor->Render(); // an application may render in a way of its own then
  }
  else
  {
    window->Render();
  }
  this->Rendering = false;
  window->RemoveObserver(tag);
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceRefiner::OnAbortCheck()
{
  const Keep self(this);
  this->InvokeEvent(vtkCommand::AbortCheckEvent);
  if (this->Window && this->Window->GetEventPending())
  {
    this->Window->SetAbortRender(1);
  }
}

//------------------------------------------------------------------------------
bool vtkTemporalCoherenceRefiner::Refine()
{
  if (!this->Window)
  {
    vtkErrorMacro(<< "Refine needs a window; call SetInteractor or SetRenderWindow.");
    return false;
  }
  const Keep self(this);
  const vtkSmartPointer<vtkRenderWindow> window(this->Window);
  const double rate = window->GetDesiredUpdateRate();
  const vtkTypeBool wasEnabled = this->Enabled;
  this->SetEnabled(false);
  window->SetDesiredUpdateRate(std::min(rate, MostStillRate));
  this->Vain = 0;
  bool isStopped = false;
  do
  {
    const int before = this->Frames;
    this->RenderAgain(nullptr);
    // A window that is being rendered begins no other frame.
    isStopped = window->GetAbortRender() != 0 || this->Window.GetPointer() != window.GetPointer() ||
      this->Frames == before;
  } while (this->Progress < 1.0 && !isStopped && this->Vain < MostVainFrames);
  window->SetDesiredUpdateRate(rate);
  this->SetEnabled(wasEnabled);
  return this->Progress >= 1.0 && !isStopped;
}

//------------------------------------------------------------------------------
void vtkTemporalCoherenceRefiner::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Interactor: " << this->Interactor.GetPointer() << endl;
  os << indent << "RenderWindow: " << this->Window.GetPointer() << endl;
  os << indent << "Enabled: " << this->Enabled << endl;
  os << indent << "Progress: " << this->Progress << endl;
}
VTK_ABI_NAMESPACE_END
