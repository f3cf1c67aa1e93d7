// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PicturePresenter_h
#define TemporalCoherence_PicturePresenter_h

#include "Window/PassOutput.h"
#include "Window/WindowPicture.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <cstdint>
#include <memory>
#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkTextureObject;
class vtkVolume;
class vtkWindow;
VTK_ABI_NAMESPACE_END

namespace TemporalCoherence
{

/// Draws a finished frame into the renderer's window: colour and depth as two textures on one quad,
/// so that surfaces and other props hide each other pixel by pixel. Only the rectangle that holds
/// hits is uploaded and drawn, and only a picture that differs from the last is uploaded.
///
/// Opaque hits are drawn with their depths. Translucent ones are blended over what is in the
/// window, where that is not nearer, and leave no depth; where something in the window lies between
/// translucent layers, those before it.
class PicturePresenter
{
public:
  PicturePresenter();
  ~PicturePresenter();

  /// \param volume  what the frame shows, which render passes know; may be null
  /// \param picture a number that differs whenever frame or view differ from the last call
  /// \param error   gets what is wrong if the result is false
  bool Present(vtkRenderer* renderer, vtkVolume* volume, const Frame& frame, const View& view,
    std::uint64_t picture, std::string& error);

  /// Draw other colours in place of those of the hits, as they are: no light, no blending.
  /// \param colors one for each pixel of the frame; those without a hit are not drawn
  bool PresentColors(vtkRenderer* renderer, const Frame& frame, const View& view,
    std::uint64_t picture, const std::vector<PixelColor>& colors, std::string& error);

  /// Free what is held in the context of a window; in any, if it is null.
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Resources;
  bool Prepare(vtkRenderer* renderer, const Frame& frame, const View& view, std::uint64_t picture,
    PassOutput output, std::string& error);
  bool CutLayers(const Frame& frame, const View& view);
  void UploadNormals(const Frame& frame);
  void Draw(vtkTextureObject* color, bool isOpaque, bool isTranslucent);

  std::unique_ptr<Resources> OpenGL; ///< null while nothing is held in a context
  WindowPicture Shown;               ///< kept for its memory, as are these
  std::vector<float> Depths;
  std::vector<PixelColor> CutColors;
};

}

#endif
