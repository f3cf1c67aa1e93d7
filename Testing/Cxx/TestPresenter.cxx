// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// A picture made by hand, opaque at the left and translucent at the right, in a window between
// polygons: who hides whom, and what shines through by how much.

#include "Expect.h"
#include "MatrixFromVtk.h"
#include "PicturePresenter.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkFloatingPointExceptions.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkPlaneSource.h>
#include <vtkPolyDataMapper.h>
#include <vtkProp.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

namespace
{

using namespace TemporalCoherence;

constexpr int Size = 64;
constexpr unsigned int GlBlend = 0x0BE2, GlDepthTest = 0x0B71;

/// The camera is at z = 1 and looks down; the picture lies at z = 0.
constexpr PixelColor Opaque{ 200, 40, 0, 255 };
constexpr PixelColor Translucent{ 0, 60, 30, 102 }; ///< 40 %, premultiplied

/// Draws the picture as an opaque prop.
class PictureProp : public vtkProp
{
public:
  static PictureProp* New();
  vtkTypeMacro(PictureProp, vtkProp);

  int RenderOpaqueGeometry(vtkViewport* viewport) override
  {
    auto* renderer = static_cast<vtkRenderer*>(viewport);
    vtkCamera* camera = renderer->GetActiveCamera();
    View view;
    MakeView(MatrixFromVtk(camera->GetModelViewTransformMatrix()),
      MatrixFromVtk(camera->GetProjectionTransformMatrix(1.0, -1.0, 1.0)), true, { 0.1, 2.0 },
      { Size, Size }, view);

    Frame frame;
    frame.Resize({ Size, Size });
    for (std::size_t i = 0; i < frame.Depth.size(); ++i)
    {
      const std::size_t x = i % Size, y = i / Size;
      const bool isHit = x >= 8 && x < 56 && y >= 8 && y < 56;
      frame.Depth[i] = isHit ? 1.0 : std::numeric_limits<double>::infinity();
      frame.Isovalues[i] = isHit ? std::int16_t(0) : Frame::NoSurface;
      frame.Colors[i] = !isHit ? PixelColor{} : x < 32 ? Opaque : Translucent;
    }

    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    vtkOpenGLState* state = window->GetState();
    const bool blends = state->GetEnumState(GlBlend), tests = state->GetEnumState(GlDepthTest);
    std::array<int, 4> before{}, after{};
    state->vtkglGetIntegerv(0x0BA2, before.data());
    std::string error;
    const bool isShown = this->Others.empty()
      ? this->Presenter.Present(renderer, nullptr, frame, view, 1, error)
      : this->Presenter.PresentColors(renderer, frame, view, 1, this->Others, error);
    Expect(isShown, "shown: " + error);
    state->vtkglGetIntegerv(0x0BA2, after.data());
    Expect(blends == state->GetEnumState(GlBlend) && tests == state->GetEnumState(GlDepthTest) &&
        before == after,
      "the state is as it was");
    return 1;
  }
  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Presenter.ReleaseGraphicsResources(window);
  }

  PicturePresenter Presenter;
  std::vector<PixelColor> Others; ///< shown in place of the picture's own colours
};
vtkStandardNewMacro(PictureProp);

/// A square of one colour that covers rows y to y + 0.5 of the window's -1 to 1.
vtkNew<vtkActor> Square(double y, double z, const std::array<double, 3>& color)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-1.0, y, z);
  plane->SetPoint1(1.0, y, z);
  plane->SetPoint2(-1.0, y + 0.5, z);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  return actor;
}

struct Window
{
  Window()
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 0.0, 1.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->ParallelProjectionOn();
    camera->SetParallelScale(1.0);
    camera->SetClippingRange(0.1, 2.0);
    this->Target->SetMultiSamples(0);
    this->Target->SetSize(Size, Size);
    this->Target->AddRenderer(this->Renderer);
  }

  /// True if the pixel has this colour, within what rounding does.
  bool Shows(int x, int y, const std::array<double, 3>& expected)
  {
    vtkNew<vtkUnsignedCharArray> pixel;
    this->Target->GetRGBACharPixelData(x, y, x, y, 0, pixel);
    for (int c = 0; c < 3; ++c)
    {
      if (std::abs(pixel->GetValue(c) - expected[static_cast<std::size_t>(c)]) > 1.0)
      {
        std::cerr << "at " << x << ", " << y << ", channel " << c << ": " << +pixel->GetValue(c)
                  << " for " << expected[static_cast<std::size_t>(c)] << '\n';
        return false;
      }
    }
    return true;
  }

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Target;
};

/// Over a background, polygons before and behind that are drawn earlier or later.
void TestBlending()
{
  Window window;
  window.Renderer->SetBackground(0.0, 0.0, 1.0);
  vtkNew<PictureProp> picture;
  window.Renderer->AddActor(Square(-1.0, -0.5, { 1.0, 1.0, 1.0 })); // behind, earlier
  window.Renderer->AddActor(Square(-0.5, 0.5, { 1.0, 1.0, 1.0 }));  // before, earlier
  window.Renderer->AddViewProp(picture);
  window.Renderer->AddActor(Square(0.0, -0.5, { 1.0, 1.0, 1.0 })); // behind, later
  window.Target->Render();

  const std::array<double, 3> opaque{ 200, 40, 0 }, white{ 255, 255, 255 };
  Expect(window.Shows(16, 56, { 0, 0, 255 }), "the background beside the picture");
  Expect(window.Shows(16, 52, opaque), "opaque over the background");
  Expect(window.Shows(48, 52, { 0, 60, 30 + 0.6 * 255 }), "translucent over the background");
  Expect(window.Shows(16, 12, opaque), "opaque over a polygon behind");
  Expect(window.Shows(48, 12, { 153, 213, 183 }), "translucent over a polygon behind");
  Expect(window.Shows(16, 24, white) && window.Shows(48, 24, white), "hidden by a polygon before");
  Expect(window.Shows(16, 40, opaque), "opaque hides what is drawn behind it later");
  Expect(window.Shows(48, 40, white), "translucent leaves no depth");
}

/// Numbers in place of colours are drawn as they are, everywhere that there is a hit.
void TestOtherColors()
{
  Window window;
  vtkNew<PictureProp> picture;
  picture->Others.assign(Size * Size, PixelColor{ 7, 8, 9, 0 });
  window.Renderer->AddViewProp(picture);
  window.Renderer->AddActor(Square(0.0, -0.5, { 1.0, 1.0, 1.0 }));
  window.Target->Render();
  Expect(window.Shows(16, 12, { 7, 8, 9 }) && window.Shows(48, 12, { 7, 8, 9 }), "both halves");
  Expect(window.Shows(48, 40, { 7, 8, 9 }), "with depth");
  Expect(window.Shows(48, 4, { 0, 0, 0 }), "where there is a hit");
}

}

int TestPresenter(int, char*[])
{
  // The software rasteriser behind some windows divides by zero by itself.
  vtkFloatingPointExceptions::Disable();
  TestBlending();
  TestOtherColors();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
