// SPDX-FileCopyrightText: Copyright (c) the vtkTemporalCoherence authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Style.h"

#include <vtkObjectFactory.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkStringArray.h>

vtkStandardNewMacro(Style);

int Style::X() const
{
  return this->Interactor->GetEventPosition()[0];
}

int Style::Y() const
{
  return this->Interactor->GetRenderWindow()->GetSize()[1] - 1 -
    this->Interactor->GetEventPosition()[1];
}

bool Style::IsTaken(bool isRight)
{
  if (this->By->IsBusy())
  {
    return true;
  }
  this->IsPressed = true;
  this->LastX = this->X();
  this->LastY = this->Y();
  const Hands::Grip grip = this->By->Press(this->X(), this->Y(), isRight);
  // What the press began may have taken long: the button may be up again.
  this->Grip = this->IsPressed ? grip : Hands::Grip::None;
  return grip != Hands::Grip::None;
}

void Style::OnMouseMove()
{
  // An event may come again for the same place.
  const bool isNew = this->X() != this->LastX || this->Y() != this->LastY;
  this->LastX = this->X();
  this->LastY = this->Y();
  if (this->By->IsBusy() || !isNew)
  {
    return;
  }
  if (this->Grip == Hands::Grip::Held)
  {
    this->By->Drag(this->X(), this->Y());
  }
  else if (this->Grip == Hands::Grip::None)
  {
    this->Superclass::OnMouseMove();
  }
}

void Style::OnLeftButtonDown()
{
  if (!this->IsTaken(false))
  {
    this->Superclass::OnLeftButtonDown();
  }
}

void Style::OnLeftButtonUp()
{
  this->IsPressed = false;
  this->Grip = Hands::Grip::None;
  this->Superclass::OnLeftButtonUp();
}

void Style::OnRightButtonDown()
{
  if (!this->IsTaken(true))
  {
    this->Superclass::OnRightButtonDown();
  }
}

void Style::OnRightButtonUp()
{
  this->IsPressed = false;
  this->Grip = Hands::Grip::None;
  this->Superclass::OnRightButtonUp();
}

void Style::OnMiddleButtonDown()
{
  if (!this->By->IsBusy())
  {
    this->Superclass::OnMiddleButtonDown();
  }
}

void Style::OnMouseWheelForward()
{
  if (!this->By->IsBusy() && !this->By->Wheel(this->X(), this->Y(), 1))
  {
    this->Superclass::OnMouseWheelForward();
  }
}

void Style::OnMouseWheelBackward()
{
  if (!this->By->IsBusy() && !this->By->Wheel(this->X(), this->Y(), -1))
  {
    this->Superclass::OnMouseWheelBackward();
  }
}

void Style::OnKeyPress()
{
  const char* name = this->Interactor->GetKeySym();
  this->By->Key(
    name ? name : "", this->Interactor->GetKeyCode(), this->Interactor->GetShiftKey() != 0);
}

void Style::OnDropFiles(vtkStringArray* paths)
{
  std::vector<std::string> names;
  for (vtkIdType i = 0; i < paths->GetNumberOfValues(); ++i)
  {
    names.push_back(paths->GetValue(i));
  }
  if (!this->By->IsBusy())
  {
    this->By->Drop(names);
  }
}
