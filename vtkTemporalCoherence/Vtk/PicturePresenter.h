// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PicturePresenter_h
#define TemporalCoherence_PicturePresenter_h

#include "WindowPicture.h"

#include <cstdint>
#include <memory>
#include <string>

class vtkRenderer;
class vtkWindow;

namespace TemporalCoherence
{

/// Draws a finished frame into the renderer's window: colour and depth as two textures on one quad,
/// so that surfaces and other props hide each other pixel by pixel. Only the rectangle that holds
/// hits is uploaded and drawn, and only a picture that differs from the last is uploaded.
class PicturePresenter
{
public:
  PicturePresenter();
  ~PicturePresenter();

  /// \param picture a number that differs whenever frame or view differ from the last call
  /// \param error   gets what is wrong if the result is false
  bool Present(vtkRenderer* renderer, const Frame& frame, const View& view, std::uint64_t picture,
    std::string& error);

  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Resources;
  std::unique_ptr<Resources> OpenGL; ///< null while nothing is held in a context
  WindowPicture Shown;               ///< kept for its memory
};

}

#endif
