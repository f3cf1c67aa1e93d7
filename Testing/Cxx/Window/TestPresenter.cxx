// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause

// The presenter hides, is hidden and shines through as arithmetic says. It leaves the state of
// OpenGL as it was, whatever that is, and works in other windows.

#include "Checks/Expect.h"
#include "Input/MatrixFromVtk.h"
#include "Window/PicturePresenter.h"

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
#include <functional>
#include <limits>
#include <string>

namespace
{

using namespace TemporalCoherence;

constexpr int Size = 64;
constexpr unsigned int GlBlend = 0x0BE2, GlDepthTest = 0x0B71;
constexpr unsigned int GlLess = 0x0201, GlAlways = 0x0207, GlOne = 1, GlZero = 0;

/// What a picture may find and has to leave.
struct DrawState
{
  static DrawState Of(vtkOpenGLState* state)
  {
    DrawState found;
    found.Blends = state->GetEnumState(GlBlend);
    found.TestsDepth = state->GetEnumState(GlDepthTest);
    state->vtkglGetBooleanv(0x0B72, &found.DepthMask);
    state->vtkglGetIntegerv(0x0B74, &found.DepthFunction);
    for (std::size_t i = 0; i < 4; ++i)
    {
      const std::array<unsigned int, 4> names{ 0x80C9, 0x80C8, 0x80CB, 0x80CA };
      state->vtkglGetIntegerv(names[i], &found.BlendFunction[i]);
    }
    state->vtkglGetIntegerv(0x0BA2, found.Viewport.data());
    return found;
  }

  bool operator==(const DrawState& other) const
  {
    return this->Blends == other.Blends && this->TestsDepth == other.TestsDepth &&
      this->DepthMask == other.DepthMask && this->DepthFunction == other.DepthFunction &&
      this->BlendFunction == other.BlendFunction && this->Viewport == other.Viewport;
  }

  bool Blends, TestsDepth;
  unsigned char DepthMask = 0;
  int DepthFunction = 0;
  std::array<int, 4> BlendFunction{}; ///< source and destination, of colours and of alpha
  std::array<int, 4> Viewport{};
};

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
      MatrixFromVtk(camera->GetProjectionTransformMatrix(1.0, -1.0, 1.0)), { 0.1, 2.0 },
      { Size, Size }, view);

    Frame frame;
    frame.Resize({ Size, Size });
    for (std::size_t i = 0; i < frame.Depth.size(); ++i)
    {
      const std::size_t x = i % Size, y = i / Size;
      const bool isHit = x >= 8 && x < 56 && y >= 8 && y < 56;
      frame.Depth[i] = isHit ? 1.0 : std::numeric_limits<double>::infinity();
      frame.Isovalues[i] = isHit ? SurfaceIndex(0) : Frame::NoSurface;
      frame.Colors[i] = !isHit ? PixelColor{} : x < 32 ? Opaque : Translucent;
    }

    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    vtkOpenGLState* state = window->GetState();
    vtkOpenGLState::ScopedglEnableDisable keepDepthTest(state, GlDepthTest);
    vtkOpenGLState::ScopedglEnableDisable keepBlend(state, GlBlend);
    vtkOpenGLState::ScopedglBlendFuncSeparate keepBlendFunction(state);
    vtkOpenGLState::ScopedglDepthFunc keepDepthFunction(state);
    vtkOpenGLState::ScopedglDepthMask keepDepthMask(state);
    this->Disturb(state);
    const DrawState before = DrawState::Of(state);
    std::string error;
    const bool isShown = this->Others.empty()
      ? this->Presenter.Present(renderer, nullptr, { frame, view, frame.Size, 1 }, error)
      : this->Presenter.PresentColors(
          renderer, { frame, view, frame.Size, 1 },
          [&](const glm::ivec2& ray)
          { return this->Others[static_cast<std::size_t>(ray.y * Size + ray.x)]; },
          error);
    Expect(isShown, "shown: " + error);
    Expect(before == DrawState::Of(state), "the state is as it was");
    return 1;
  }
  void ReleaseGraphicsResources(vtkWindow* window) override
  {
    this->Presenter.ReleaseGraphicsResources(window);
  }

  PicturePresenter Presenter;
  std::vector<PixelColor> Others; ///< shown in place of the picture's own colours
  std::function<void(vtkOpenGLState*)> Disturb = [](vtkOpenGLState*) {}; ///< called before
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

  /// True if the pixel has this colour and covers what is behind the window by `alpha`, within what
  /// rounding does.
  bool Shows(int x, int y, const std::array<double, 3>& color, double alpha = 255.0)
  {
    const std::array<double, 4> expected{ color[0], color[1], color[2], alpha };
    vtkNew<vtkUnsignedCharArray> pixel;
    this->Target->GetRGBACharPixelData(x, y, x, y, 0, pixel);
    for (int c = 0; c < 4; ++c)
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
struct Polygons : Window
{
  Polygons()
  {
    this->Renderer->SetBackground(0.0, 0.0, 1.0);
    this->Renderer->AddActor(Square(-1.0, -0.5, { 1.0, 1.0, 1.0 })); // behind, earlier
    this->Renderer->AddActor(Square(-0.5, 0.5, { 1.0, 1.0, 1.0 }));  // before, earlier
    this->Renderer->AddViewProp(this->Picture);
    this->Renderer->AddActor(Square(0.0, -0.5, { 1.0, 1.0, 1.0 })); // behind, later
  }

  void ExpectBlended(const std::string& what)
  {
    this->Target->Render();
    const std::array<double, 3> opaque{ 200, 40, 0 }, white{ 255, 255, 255 };
    const std::string is = what + ": ";
    Expect(this->Shows(16, 56, { 0, 0, 255 }, 0), is + "the background beside the picture");
    Expect(this->Shows(16, 52, opaque), is + "opaque over the background");
    Expect(
      this->Shows(48, 52, { 0, 60, 30 + 0.6 * 255 }, 102), is + "translucent over the background");
    Expect(this->Shows(16, 12, opaque), is + "opaque over a polygon behind");
    Expect(this->Shows(48, 12, { 153, 213, 183 }), is + "translucent over a polygon behind");
    Expect(
      this->Shows(16, 24, white) && this->Shows(48, 24, white), is + "hidden by a polygon before");
    Expect(this->Shows(16, 40, opaque), is + "opaque hides what is drawn behind it later");
    Expect(this->Shows(48, 40, white), is + "translucent leaves no depth");
  }

  vtkNew<PictureProp> Picture;
};

void TestBlending()
{
  Polygons scene;
  scene.ExpectBlended("as VTK draws");
}

/// Whatever was drawn before, and however, the picture is the same.
void TestDrawStates()
{
  Polygons scene;
  scene.Picture->Disturb = [](vtkOpenGLState* state)
  {
    state->vtkglDisable(GlDepthTest);
    state->vtkglDepthMask(0);
    state->vtkglEnable(GlBlend);
    state->vtkglBlendFuncSeparate(GlOne, GlOne, GlOne, GlOne);
  };
  scene.ExpectBlended("after light that is summed up");
  scene.Picture->Disturb = [](vtkOpenGLState* state)
  {
    state->vtkglEnable(GlDepthTest);
    state->vtkglDepthFunc(GlAlways);
    state->vtkglDepthMask(1);
    state->vtkglDisable(GlBlend);
    state->vtkglBlendFuncSeparate(GlZero, GlOne, GlOne, GlZero);
  };
  scene.ExpectBlended("after something drawn over everything");
  scene.Picture->Disturb = [](vtkOpenGLState* state) { state->vtkglDepthFunc(GlLess); };
  scene.ExpectBlended("after something strictly before");
}

/// Textures belong to a window: those of one are of no use in another, nor when it is opened again.
void TestOtherWindows()
{
  Polygons first;
  first.ExpectBlended("the first window");
  {
    Polygons second;
    second.Renderer->RemoveViewProp(second.Picture);
    second.Renderer->RemoveAllViewProps();
    second.Renderer->AddViewProp(first.Picture);
    second.Target->Render();
    Expect(second.Shows(16, 12, { 200, 40, 0 }) && second.Shows(48, 52, { 0, 60, 183 }, 102),
      "the same picture in a second window");
    first.ExpectBlended("the first window again");
    second.Target->Render();
    second.Renderer->RemoveAllViewProps();
  }
  first.ExpectBlended("after the second window is gone");
  first.Target->Finalize();
  first.ExpectBlended("the first window, closed and opened");
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
  Expect(window.Shows(48, 4, { 0, 0, 0 }, 0), "where there is a hit");
}

}

int TestPresenter(int, char*[])
{
  // The software rasteriser behind some windows divides by zero by itself.
  vtkFloatingPointExceptions::Disable();
  TestBlending();
  TestDrawStates();
  TestOtherWindows();
  TestOtherColors();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
