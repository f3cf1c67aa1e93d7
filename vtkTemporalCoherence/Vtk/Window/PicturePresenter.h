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

/// The part of a picture of opaque surfaces.
enum class PicturePart : std::uint8_t
{
  All,
  Inside, ///< all but edges
  Edges   ///< pixels that are covered in part
};

/// A frame that fills a viewport.
struct ShownFrame
{
  const Frame& Picture;
  const TemporalCoherence::View& View;
  glm::ivec2 Pixels;          ///< of the viewport; there may be more or fewer rays
  std::uint64_t Number;       ///< changes whenever the frame or the view does
  bool IsBlended = false;     ///< it shows a blended volume, not surfaces
  bool ComparesDepths = true; ///< false if its rays end at the window's props already
  PicturePart Part = PicturePart::All;
};

/// Draws a finished frame into the renderer's window: colour and depth as two textures on one quad,
/// so that surfaces and other props hide each other pixel by pixel. Only the rectangle that holds
/// hits is uploaded and drawn, and only a picture that differs from the last is uploaded.
///
/// If there are more rays than pixels, each pixel shows the mean of its rays (WindowPicture).
/// Pixels with missing rays are translucent.
///
/// Opaque hits are drawn with their depths. Translucent hits are blended over the contents of the
/// window, and write no depth. If another prop lies among translucent layers, the layers in front
/// of it are drawn. A blended volume is drawn like translucent hits, even where it is opaque. Its
/// depths are not compared if its rays end at other props.
class PicturePresenter
{
public:
  PicturePresenter();
  ~PicturePresenter();

  /// \param volume  the drawn prop, for render passes; may be null
  /// \param error   receives the mistake if the result is false
  bool Present(
    vtkRenderer* renderer, vtkVolume* volume, const ShownFrame& shown, std::string& error);

  /// Draw the hits in other colours, unchanged and unblended.
  /// \param colorOf returns the colour for a ray with a hit; other pixels are not drawn
  bool PresentColors(vtkRenderer* renderer, const ShownFrame& shown,
    const std::function<PixelColor(const glm::ivec2&)>& colorOf, std::string& error);

  /// Free resources in the context of a window; in any context if it is null.
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  struct Resources;
  bool Prepare(
    vtkRenderer* renderer, const ShownFrame& shown, PassOutput output, std::string& error);
  bool ClipLayers(const Frame& frame, const View& view);
  bool ClipColorsAt(const glm::ivec2& size, const Frame& frame, const View& view);
  void UploadNormals(const Frame& frame);

  /// The hits to draw, and the way to draw them.
  struct Parts
  {
    bool Opaque, Translucent;
    bool AreBlended = false;    ///< opaque hits are blended, too, and write no depth
    bool ComparesDepths = true; ///< with the window's depths
  };
  void Draw(vtkTextureObject* color, const Parts& parts);

  std::unique_ptr<Resources> OpenGL; ///< null without resources in a context
  WindowPicture Shown;               ///< a member to re-use its memory, like the next two
  std::vector<float> Depths;
  std::vector<PixelColor> ClippedColors;
};

}

#endif
