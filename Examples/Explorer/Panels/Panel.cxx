// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Panels/Panel.h"

Panel::Panel(vtkRenderer* renderer)
  : Picture(renderer)
{
}

void Panel::Place(const Rect& rect, int windowHeight)
{
  this->Area = rect;
  if (rect.Width > 0 && rect.Height > 0)
  {
    this->Drawn.Resize(rect.Width, rect.Height);
    this->Picture.Place(rect, windowHeight);
  }
  this->SetVisible(this->Visible);
}

void Panel::SetVisible(bool isVisible)
{
  this->Visible = isVisible;
  this->Invalidate();
}

void Panel::Refresh()
{
  const bool isChanged = this->IsVisible() && !this->IsValid;
  if (isChanged)
  {
    this->Draw(this->Drawn);
    this->Picture.SetImage(this->Drawn.Image());
    this->IsValid = true;
  }
  this->Picture.SetVisible(this->IsVisible() && (isChanged || this->LiesOnView));
}
