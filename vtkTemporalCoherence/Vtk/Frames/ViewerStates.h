// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_ViewerStates_h
#define TemporalCoherence_ViewerStates_h

#include "Acceleration/FieldStructures.h"
#include "Render/FrameRenderer.h"
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
#include <utility>
#include <vector>

VTK_ABI_NAMESPACE_BEGIN
class vtkWindow;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Who sees what: each viewer has a picture of its own, which changes little from frame to frame.
struct Viewer
{
  /// The viewer that a renderer's active camera stands for.
  static Viewer Of(vtkRenderer* renderer, vtkVolume* volume);

  vtkWeakPointer<vtkRenderer> Renderer;
  vtkWeakPointer<vtkVolume> Volume;
  vtkWeakPointer<vtkCamera> Camera;
  int Eye = 0; ///< 0 both, 1 left, 2 right
};

/// What is kept for a viewer from frame to frame.
struct ViewerState
{
  explicit ViewerState(std::shared_ptr<FieldStructures> shared)
    : Engine(std::move(shared))
  {
  }

  /// The last frame, to be presented.
  ShownFrame Shown() const
  {
    return { this->Engine.LastFrame(), this->Engine.LastKey().View, this->PictureSize,
      this->PictureNumber };
  }

  Viewer Of;
  FrameRenderer Engine;
  PicturePresenter Presenter;
  PeelPresenter Peels;
  std::vector<int> IsovaluePlaces; ///< position in the property's list of each isovalue drawn
  glm::ivec2 PictureSize{ 0 };     ///< pixels that the last frame fills
  std::uint64_t PictureNumber = 0; ///< counts the different pictures
};

/// The states of the viewers that were served last. Which state serves whom is a matter of speed
/// alone, never of the picture: a state compares the whole key of a frame with that of its last.
class ViewerStates
{
public:
  /// More viewers than this lose their state to one another: the least recently served first.
  static constexpr std::size_t Most = 4;

  /// The state of a viewer, if there is one.
  std::shared_ptr<ViewerState> Find(const Viewer& viewer) const;

  /// The state of a viewer, or one whose viewer is gone in part and else the same (as where a
  /// renderer gets a new camera for each frame), or a new one.
  /// \throws std::bad_alloc
  std::shared_ptr<ViewerState> Serve(const Viewer& viewer);

  /// A state that nobody is served with yet.
  std::shared_ptr<ViewerState> MakeState() const
  {
    return std::make_shared<ViewerState>(this->Shared);
  }

  /// Free what is held in the context of a window; of all, if it is null.
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  std::shared_ptr<FieldStructures> Shared = std::make_shared<FieldStructures>();
  std::vector<std::shared_ptr<ViewerState>> States; ///< most recently served first
};

}

#endif
