// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ViewerStates_h
#define TemporalCoherence_ViewerStates_h

#include "Input/CellOrigins.h"
#include "Render/FrameRenderer.h"
#include "Render/RayBudget.h"
#include "Window/PeelPresenter.h"
#include "Window/PicturePresenter.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <vtkCamera.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkWeakPointer.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkWindow;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Identifies a viewer: renderer, volume, camera and eye. Each viewer has its own picture, which
/// changes little from frame to frame.
struct Viewer
{
  /// The viewer of a renderer's active camera.
  static Viewer Of(vtkRenderer* renderer, vtkVolume* volume);

  vtkWeakPointer<vtkRenderer> Renderer;
  vtkWeakPointer<vtkVolume> Volume;
  vtkWeakPointer<vtkCamera> Camera;
  int Eye = 0; ///< 0 both, 1 left, 2 right
};

/// The state of a viewer between frames.
struct ViewerState
{
  explicit ViewerState(const SharedByViewers& shared)
    : Engine(shared)
  {
  }

  /// The last frame, for a presenter.
  ShownFrame Shown() const
  {
    return { this->Engine.LastFrame(), this->Engine.LastKey().View, this->PictureSize,
      this->PictureNumber, this->Engine.LastKey().IsBlended(), this->ComparesDepths };
  }

  /// Learn how long rays took in the last frame, unless it used known ones.
  /// \param allowed, kind see RayBudget
  void LearnTimes(double allowed, int kind)
  {
    const FrameStatistics& last = this->Engine.Statistics();
    if (last.Made == Route::Cold || last.Made == Route::FewerRays)
    {
      this->Budget.Learn(last, !this->Engine.IsLastBetweenRays(), allowed, kind);
    }
  }

  Viewer Of;
  FrameRenderer Engine;
  RayBudget Budget; ///< of frames for windows
  PicturePresenter Presenter;
  PeelPresenter Peels;
  std::vector<int> IsovaluePlaces; ///< position in the property's list, for each isovalue drawn
  std::shared_ptr<const CellOrigins> Cells; ///< origins of the drawn mesh's cells; or null
  glm::ivec2 PictureSize{ 0 };              ///< pixels that the last frame fills
  bool ComparesDepths = true;               ///< ShownFrame::ComparesDepths
  std::uint64_t PictureNumber = 0;          ///< differs for different pictures in the process
};

/// A new number, unique among all pictures of this process.
std::uint64_t NewPictureNumber();

/// The states of the last viewers. Which state serves a viewer affects speed only, never the
/// picture: a state compares the whole key of a frame with that of its last one.
class ViewerStates
{
public:
  /// The most states. For more viewers, the least recently used state is re-used.
  static constexpr std::size_t Most = 4;

  /// The state of a viewer; null if none exists.
  std::shared_ptr<ViewerState> Find(const Viewer& viewer) const;

  /// The state of a viewer; else a state whose viewer differs only in objects that no longer exist
  /// (as when a renderer gets a new camera for each frame); else a new one.
  /// \throws std::bad_alloc
  std::shared_ptr<ViewerState> Serve(const Viewer& viewer);

  /// A new state without a viewer.
  std::shared_ptr<ViewerState> MakeState() const
  {
    return std::make_shared<ViewerState>(this->Shared);
  }

  /// Free resources in the context of a window; in all contexts if it is null.
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  SharedByViewers Shared;
  std::vector<std::shared_ptr<ViewerState>> States; ///< most recently used first
};

}

#endif
