// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTemporalCoherenceRefiner
 * @brief   renders a window again while that makes its pictures better
 *
 * A picture of vtkTemporalCoherenceVolumeMapper may get better from frame to frame, for example
 * while its light is found (see vtkTemporalCoherenceVolumeMapper::GetFrameIsFinal()). Give a
 * refiner an interactor or a render window, and keep the refiner as long as the window. Frames
 * follow until all pictures of the window are final.
 *
 * - In an event loop, each frame is started by a one-shot timer of the interactor, so events that
 *   wait come first. No function waits for anything. Qt's interactor serves as well as VTK's.
 * - Frames at an interactive rate start nothing: those with a desired update rate above the
 *   interactor's still update rate and above 0.1 a second. So an interaction ends the refinement,
 *   and the still frame after the interaction begins another one.
 * - The frames that the refiner renders can be stopped: when the window has a pending event (see
 *   vtkRenderWindow::GetEventPending()), or when an observer of the refiner's AbortCheckEvent calls
 *   vtkRenderWindow::SetAbortRender(1). The picture stays then, and another frame is started.
 * - Without an event loop, as in a window off screen, call Refine().
 *
 * ProgressEvent is invoked after each frame of the window whose pictures are not final, and after
 * the one that makes them final. Its data is GetProgress(), a double.
 *
 * The refiner hears of frames by FrameProgressEvent of the mapper at the window. Any number of
 * mappers, volumes and renderers may show something there. The refiner keeps neither the window nor
 * the interactor alive.
 *
 * @sa vtkTemporalCoherenceVolumeMapper
 */

#ifndef vtkTemporalCoherenceRefiner_h
#define vtkTemporalCoherenceRefiner_h

#include "vtkObject.h"
#include "vtkTemporalCoherenceCompatibility.h"
#include "vtkTemporalCoherenceModule.h" // For export macro
#include "vtkWeakPointer.h"             // For vtkWeakPointer

#include <vector> // For std::vector

VTK_ABI_NAMESPACE_BEGIN
class vtkRenderWindow;
class vtkRenderWindowInteractor;

class VTKTEMPORALCOHERENCE_EXPORT vtkTemporalCoherenceRefiner : public vtkObject
{
public:
  static vtkTemporalCoherenceRefiner* New();
  vtkTypeMacro(vtkTemporalCoherenceRefiner, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  //@{
  /**
   * Set/Get the window to refine: that of an interactor, or a window. The event loop is that of the
   * interactor or, if a window was set, of the window's interactor when a frame ends. Null ends the
   * refinement.
   */
  virtual void SetInteractor(vtkRenderWindowInteractor* interactor);
  vtkRenderWindowInteractor* GetInteractor();
  virtual void SetRenderWindow(vtkRenderWindow* window);
  vtkRenderWindow* GetRenderWindow();
  //@}

  //@{
  /**
   * Set/Get whether frames are started by timers (default: on). Off, a pending timer is destroyed.
   */
  virtual void SetEnabled(vtkTypeBool enabled);
  vtkGetMacro(Enabled, vtkTypeBool);
  vtkBooleanMacro(Enabled, vtkTypeBool);
  //@}

  /**
   * Render the window at a still rate, at least once, until all pictures in it are final.
   * @return false without a window, if a frame was stopped, or if frames get no better
   */
  bool Refine();

  /**
   * Get how far the window's pictures are: the least GetFrameProgress() in its last frame; 1 if all
   * are final, or if the window shows none.
   */
  vtkGetMacro(Progress, double);

  /** Get whether the refiner is rendering: then the frame shows what was seen before, but better.
   */
  vtkGetMacro(Rendering, bool);

protected:
  vtkTemporalCoherenceRefiner() = default;
  ~vtkTemporalCoherenceRefiner() override;

private:
  vtkTemporalCoherenceRefiner(const vtkTemporalCoherenceRefiner&) = delete;
  void operator=(const vtkTemporalCoherenceRefiner&) = delete;

  void Follow(vtkRenderWindowInteractor* interactor, vtkRenderWindow* window);
  void OnFrameBegin();
  void OnPicture(vtkObject* window, unsigned long event, void* progress);
  void OnFrameEnd();
  void OnTimer(vtkObject* interactor, unsigned long event, void* timer);
  void OnAbortCheck();
  bool IsInteractive();
  void StartTimer();
  void StopTimer();
  void RenderAgain(vtkRenderWindowInteractor* interactor);

  vtkWeakPointer<vtkRenderWindowInteractor> Interactor; ///< set by the user, or null
  vtkWeakPointer<vtkRenderWindow> Window;               ///< observed for frames
  vtkWeakPointer<vtkRenderWindowInteractor> TimerOwner; ///< observed for the timer
  unsigned long TimerTag = 0;
  std::vector<unsigned long> WindowTags;
  vtkTypeBool Enabled = 1;
  double Progress = 1.0;
  double Least = 1.0; ///< progress of the pictures of the frame that is being rendered
  int Timer = 0;      ///< the pending timer; or 0
  int Frames = 0;     ///< frames of the window that ended
  int Vain = 0;       ///< frames of this refiner, one after another, that brought nothing
  bool Rendering = false;
};
VTK_ABI_NAMESPACE_END

#endif
