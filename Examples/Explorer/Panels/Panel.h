// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Panel_h
#define Panel_h

#include "Drawing/Canvas.h"
#include "Drawing/TexturedRectangle.h"

// A part of the window. It is drawn and sent to OpenGL anew only after Invalidate().
class Panel
{
public:
  explicit Panel(vtkRenderer* renderer);
  virtual ~Panel() = default;
  Panel(const Panel&) = delete;
  Panel& operator=(const Panel&) = delete;

  // An empty rectangle hides it.
  void Place(const Rect& rect, int windowHeight);
  const Rect& Placed() const { return this->Area; }

  void SetVisible(bool isVisible);
  bool IsVisible() const { return this->Visible && this->Area.Width > 0 && this->Area.Height > 0; }
  bool Contains(int x, int y) const { return this->IsVisible() && this->Area.Contains(x, y); }

  void Invalidate() { this->IsValid = false; }

  // What lies on the view is drawn in every frame; other panels stay in the window as they are.
  void SetLiesOnView() { this->LiesOnView = true; }

  // Before the window is drawn.
  void Refresh();

protected:
  // In coordinates of the panel.
  virtual void Draw(Canvas& canvas) = 0;

private:
  bool Visible = true;
  bool IsValid = false;
  bool LiesOnView = false;
  Rect Area;
  Canvas Drawn;
  TexturedRectangle Picture;
};

#endif
