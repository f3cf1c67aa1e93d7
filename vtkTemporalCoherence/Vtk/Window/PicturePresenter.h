// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TemporalCoherence_PicturePresenter_h
#define TemporalCoherence_PicturePresenter_h

#include "Window/PassOutput.h"
#include "Window/WindowPicture.h"
#include "vtkTemporalCoherenceCompatibility.h"

#include <cstdint>
#include <functional>
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

/// A frame that fills a viewport.
struct ShownFrame
{
  const Frame& Picture;
  const TemporalCoherence::View& View;
  glm::ivec2 Pixels;    ///< of the viewport, which may be more than rays, or fewer
  std::uint64_t Number; ///< differs whenever frame or view differ from the last ones
};

/// Draws a finished frame into the renderer's window: colour and depth as two textures on one quad,
/// so that surfaces and other props hide each other pixel by pixel. Only the rectangle that holds
/// hits is uploaded and drawn, and only a picture that differs from the last is uploaded.
///
/// Where there are more rays than pixels, each pixel shows the mean of its rays (WindowPicture).
/// Where some of them hit nothing, it is translucent.
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
  /// \param error   gets what is wrong if the result is false
  bool Present(
    vtkRenderer* renderer, vtkVolume* volume, const ShownFrame& shown, std::string& error);

  /// Draw other colours in place of those of the hits, as they are: no light, no blending.
  /// \param colorOf tells that of a ray with a hit; pixels without one are not drawn
  bool PresentColors(vtkRenderer* renderer, const ShownFrame& shown,
    const std::function<PixelColor(const glm::ivec2&)>& colorOf, std::string& error);

  /// Free what is held in the context of a window; in any, if it is null.
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Resources;
  bool Prepare(
    vtkRenderer* renderer, const ShownFrame& shown, PassOutput output, std::string& error);
  bool ClipLayers(const Frame& frame, const View& view);
  bool ClipColorsAt(const glm::ivec2& size, const Frame& frame, const View& view);
  void UploadNormals(const Frame& frame);
  void Draw(vtkTextureObject* color, bool isOpaque, bool isTranslucent);

  std::unique_ptr<Resources> OpenGL; ///< null while nothing is held in a context
  WindowPicture Shown;               ///< kept for its memory, as are these
  std::vector<float> Depths;
  std::vector<PixelColor> ClippedColors;
};

}

#endif
